// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/study_file.hpp>

#include "entries/choice_shape.hpp"
#include "entries/motion_checks.hpp"
#include "entries/never_defined.hpp"
#include "entries/plate_derivatives.hpp"
#include "entries/study_kinds.hpp"
#include "entries/tolerance_shape.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/core/frequency_response.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>
#include <twum/motors/parameter_set.hpp>
#include <twum/motors/settings.hpp>
#include <twum/motors/varied_parameters.hpp>
#include <twum/studies/motor_problem.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

namespace fs = std::filesystem;

// Adds one error for a motor file given instead of a study, in place of a list of missing entries.
bool refuse_motor(const YamlNode& root, Diagnostics& diagnostics) {
  const YamlNode* motor = root.find("motor");
  const bool is_motor =
      root.find("study") == nullptr && motor != nullptr && motor->kind == YamlNode::Kind::mapping;
  if (is_motor) {
    diagnostics.add({1, 1}, "study", "found a motor file without 'study:'",
                    "expected a study file; 'twum init optimize' writes one to start from");
  }
  return is_motor;
}

// Adds an error for a study file that names its motor, but lacks `study:`. Where its question stands under a mistyped name,
// the reader of the entries says what was meant.
bool refuse_unasked(const YamlNode& root, Diagnostics& diagnostics) {
  const bool mistyped =
      std::any_of(root.entries.begin(), root.entries.end(), [](const YamlEntry& entry) {
        return entry.value.kind == YamlNode::Kind::mapping && entry.value.find("kind") != nullptr;
      });
  if (root.find("study") != nullptr || mistyped || !names_motor_file(root)) return false;
  diagnostics.add({1, 1}, "study",
                  "missing, but this looks like a study, since 'motor' names a file",
                  "add 'study:' with its 'kind:'; 'twum init optimize' shows how");
  return true;
}

// The motor that a study names. Errors of that file are thrown as a FileError.
std::optional<MotorFile> named_motor(const std::string& name, const YamlNode& node,
                                     const std::string& folder, Diagnostics& diagnostics) {
  if (name.empty()) return {};
  try {
    return read_motor_file((fs::path(folder) / name).string());
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    diagnostics.add(node.mark, "motor", error.what(),
                    "expected the path of a motor file, relative to the folder of this file");
    return {};
  }
}

void apply(const std::vector<shapes::Override>& overrides, const YamlNode& node, MotorFile& motor,
           Diagnostics& diagnostics) {
  std::vector<ParameterValue> values;
  for (const shapes::Override& one : overrides) values.emplace_back(one.parameter, one.value);
  try {
    motor.design = with(motor.design, values);
  } catch (const InputError& error) {
    diagnostics.add(node.mark, "set", error.what(), "change one of them");
  }
}

// The motor of a study; nothing if there is none, or if it is wrong, which adds errors.
std::optional<MotorFile> motor_of(const YamlNode& root, const std::string& folder, StudyText text,
                                  Diagnostics& diagnostics) {
  const YamlNode* node = root.find("motor");
  if (node == nullptr) return {};
  auto* given = std::get_if<MotorFile>(&text.motor);
  std::optional<MotorFile> motor =
      given != nullptr ? std::optional<MotorFile>(std::move(*given))
                       : named_motor(std::get<std::string>(text.motor), *node, folder, diagnostics);
  const YamlNode* set = root.find("set");
  if (motor && set != nullptr) apply(text.set, *set, *motor, diagnostics);
  return motor;
}

// Checks tolerances relative to the motor's values. For a motor found by an earlier study, this is done when the study
// runs.
void check_all_tolerances(const Study& asked_study, const MotorDesign& design, const YamlNode& root,
                          Diagnostics& diagnostics) {
  const YamlNode* study = root.find("study");
  if (study == nullptr) return;
  const auto check = [&](const auto& asked, const std::vector<Tolerance>& list, const char* entry) {
    const YamlNode* given = study->find(entry);
    bool own_motor = true;
    if constexpr (requires { asked.start; }) own_motor = asked.start.empty();
    if (given != nullptr && own_motor)
      shapes::check_tolerances(list, design, *given, std::string("study.") + entry, diagnostics);
  };
  std::visit(
      [&](const auto& asked) {
        if constexpr (requires { asked.quantiles; })
          check(asked, asked.variables, "variables");
        else if constexpr (requires { asked.tolerances; })
          check(asked, asked.tolerances, "tolerances");
      },
      asked_study);
}

// A sweep of the frequency needs a motor whose wave follows from it.
void check_drive(const Study& study, const MotorDesign& motor, const YamlNode& root,
                 Diagnostics& diagnostics) {
  const auto* sweep = std::get_if<FrequencyStudy>(&study);
  if (sweep == nullptr) return;
  const bool family = sweep->family.has_value();
  if (family && sweep->family->parameter == Parameter::amplitude) {
    const YamlNode* node = root.find("study")->find("family");
    diagnostics.add(node->mark, "study.family",
                    "a family over the amplitude, which follows from the frequency",
                    "expected another parameter, such as voltage or preload");
  }
  if (motor.stator.voltage && !family) {
    try {
      FrequencyResponse::check(motor, sweep->from, sweep->to);
    } catch (const InputError& error) {
      diagnostics.add(root.find("study")->mark, "study", error.what(), "");
    }
  }
  if (motor.stator.voltage || (family && sweep->family->parameter == Parameter::voltage)) return;
  diagnostics.add(root.find("motor")->mark, "motor", "the amplitude of this motor is given",
                  "expected a motor with a voltage, whose wave follows from its frequency, such as "
                  "'twum init motor --driven' writes");
}

// Checks that derived parameters fit the varied ones and the motor.
void check_derived(const Study& study, const MotorDesign& motor, const YamlNode& root,
                   Diagnostics& diagnostics) {
  const auto check = [&](const auto& asked) {
    if constexpr (requires { asked.derived; }) {
      if (asked.derived.empty()) return;
      try {
        VariedParameters(motor, parameters_of(asked.variables), asked.derived);
      } catch (const ValueError& error) {
        const YamlNode* node = root.find("study")->find("derived");
        diagnostics.add(node->mark, "study.derived", error.found(), error.expected());
      }
    }
  };
  std::visit(check, study);
}

// Reads the sets that `choose` names, and collects the errors in their files.
class SetReader {
 public:
  SetReader(const std::string& folder, Diagnostics& diagnostics)
      : folder_(folder), diagnostics_(diagnostics) {}

  // Reads the files of all sets. The values are kept only if the study has no error.
  void read(StudyText& text, YamlNode& root) {
    const auto study = std::find_if(root.entries.begin(), root.entries.end(),
                                    [](const YamlEntry& entry) { return entry.key == "study"; });
    if (study == root.entries.end()) return;
    std::vector<DesignChoice>* choices = choices_of(text.study);
    const bool right = diagnostics_.empty();
    for (const shapes::SetFile& file : shapes::set_files(study->value)) {
      std::vector<ParameterValue> values = values_of(file);
      if (right && choices != nullptr)
        choices->at(file.choice).sets.at(file.set).values = std::move(values);
    }
  }

  const std::optional<FileError>& errors() const noexcept { return errors_; }

 private:
  static std::vector<DesignChoice>* choices_of(Study& study) {
    return std::visit(
        [](auto& asked) -> std::vector<DesignChoice>* {
          if constexpr (requires { asked.choose; })
            return &asked.choose;
          else
            return nullptr;
        },
        study);
  }

  std::vector<ParameterValue> values_of(const shapes::SetFile& file) {
    const std::string path = (fs::path(folder_) / file.path->scalar).string();
    try {
      return read_parameter_set(read_source(path));
    } catch (const FileError& error) {
      errors_ = errors_ ? FileError(*errors_, error) : error;
    } catch (const InputError& error) {
      diagnostics_.add(file.path->mark, "study." + file.entry, error.what(),
                       "expected the path of a file, relative to the folder of this file");
    }
    return {};
  }

  const std::string& folder_;
  Diagnostics& diagnostics_;
  std::optional<FileError> errors_;
};

// Place in the study of a complaint about a choice.
std::pair<SourceMark, std::string> place_of(const ChoiceComplaint& complaint, YamlNode& study) {
  for (const char* list : {"variables", "derived"}) {
    const YamlNode* entries = study.find(list);
    for (std::size_t i = 0; complaint.other && entries != nullptr && i < entries->entries.size();
         ++i) {
      const YamlEntry& entry = entries->entries[i];
      if (find_parameter(entry.key) == complaint.other)
        return {entry.key_mark, std::string("study.") + list + "." + entry.key};
    }
  }
  for (const shapes::SetFile& file : shapes::set_files(study))
    if (file.choice == complaint.choice && file.set == complaint.set)
      return {file.item->mark, "study." + file.entry};
  const YamlEntry& choice = study.find("choose")->entries.at(complaint.choice);
  return {choice.key_mark, "study.choose." + choice.key};
}

// The entry of a parameter in a list of a study that has it.
const YamlEntry& parameter_entry(const YamlNode& study, const char* list, Parameter parameter) {
  const std::vector<YamlEntry>& entries = study.find(list)->entries;
  return *std::find_if(entries.begin(), entries.end(), [=](const YamlEntry& entry) {
    return find_parameter(entry.key) == parameter;
  });
}

// Checks that the choices of a search, and the friction that it varies, fit the rest of the study.
void check_choices(const Study& study, const MotorDesign& motor, YamlNode& root,
                   Diagnostics& diagnostics) {
  const auto check = [&](const auto& asked) {
    if constexpr (requires { asked.choose; }) {
      const DesignProblem problem{motor, asked.variables, {}, {}, asked.derived, asked.choose};
      YamlNode& node =
          std::find_if(root.entries.begin(), root.entries.end(), [](const auto& entry) {
            return entry.key == "study";
          })->value;
      for (const ChoiceComplaint& complaint : choice_complaints(problem)) {
        const auto [mark, path] = place_of(complaint, node);
        diagnostics.add(mark, path, complaint.found, complaint.expected);
      }
      try {
        require_ordered_friction(problem);
      } catch (const ValueError& error) {
        const YamlEntry& derived = parameter_entry(node, "derived", Parameter::kinetic_friction);
        const YamlEntry& varied = parameter_entry(node, "variables", Parameter::static_friction);
        diagnostics.add({derived.key_mark, "study.derived." + derived.key, error.found(),
                         error.expected(), varied.key_mark, "varied here"});
      }
    }
  };
  std::visit(check, study);
}

// Checks of a question that need its motor. Each kind of check assumes that those before it found nothing.
// @param root       the file in which errors are placed
// @param sets_read  whether the sets of `choose` have their values
void check_with_motor(const Study& study, const MotorDesign& motor, YamlNode& root, bool sets_read,
                      Diagnostics& diagnostics) {
  check_all_tolerances(study, motor, root, diagnostics);
  if (diagnostics.empty()) check_drive(study, motor, root, diagnostics);
  if (diagnostics.empty()) check_motion(study, motor, root, diagnostics);
  if (diagnostics.empty()) check_derived(study, motor, root, diagnostics);
  if (diagnostics.empty() && sets_read) check_choices(study, motor, root, diagnostics);
  if (diagnostics.empty() && sets_read) check_defined(study, motor, root, diagnostics);
  if (diagnostics.empty()) check_plate_derivatives(study, motor, root, diagnostics);
}

// The errors of a study that is not a file: "study.variables.preload: ...; ...", one line each.
std::string without_places(const FileError& error) {
  std::string text;
  for (const Diagnostic& one : error.diagnostics()) {
    text += (text.empty() ? "" : "\n") + (one.entry.empty() ? "" : one.entry + ": ") + one.found;
    if (!one.expected.empty()) text += "; " + one.expected;
  }
  return text;
}

// The study's errors, then those of the files that it names.
void throw_all(const Diagnostics& diagnostics, const std::vector<FileError>& files) {
  std::optional<FileError> all;
  const auto add = [&](const FileError& one) { all = all ? FileError(*all, one) : one; };
  try {
    diagnostics.throw_if_any();
  } catch (const FileError& study) {
    add(study);
  }
  for (const FileError& file : files) add(file);
  if (all) throw FileError(*all);
}

}  // namespace

bool is_study(const Source& source) {
  Diagnostics ignored(source);
  const YamlNode root = load_yaml(ignored);
  return root.find("study") != nullptr || names_motor_file(root);
}

StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings) {
  Diagnostics diagnostics(source);
  YamlNode root = load_yaml(diagnostics);
  StudyText text;
  if (!refuse_motor(root, diagnostics) && !refuse_unasked(root, diagnostics))
    study_file_shape().read(text, root, {{}, {1, 1}}, diagnostics);
  std::vector<FileError> files;
  SetReader sets(folder, diagnostics);
  sets.read(text, root);
  std::optional<MotorFile> motor;
  try {
    motor = motor_of(root, folder, text, diagnostics);
  } catch (const FileError& error) {
    files.push_back(error);
  }
  if (sets.errors()) files.push_back(*sets.errors());
  if (motor) {
    motor->design = with_settings(motor->design, settings);
    check_with_motor(text.study, motor->design, root, files.empty(), diagnostics);
  }
  throw_all(diagnostics, files);
  TWUM_ASSERT(motor.has_value());
  return {std::move(*motor), std::move(text.study), *root.find("study"), folder, source.name()};
}

void validate(const StudyFile& file) {
  const YamlNode asked = study_shape(file.kind()).write(file.asked);
  const Source source("study", "twum: 1\nmotor: given\nstudy:\n" + yaml_text(asked, 1));
  Diagnostics diagnostics(source);
  try {
    require_motor(file.motor.design);
    const KnownMetrics known(own_metrics(file.asked));
    YamlNode root = load_yaml(diagnostics);
    StudyText text;
    study_file_shape(file.kind()).read(text, root, {{}, {1, 1}}, diagnostics);
    diagnostics.throw_if_any();
    check_with_motor(file.asked, file.motor.design, root, true, diagnostics);
    diagnostics.throw_if_any();
  } catch (const FileError& error) {
    throw InputError(without_places(error));
  }
}

StudyFile read_study_file(const std::string& path, std::span<const std::string> settings) {
  const std::string folder = path == "-" ? "" : fs::path(path).parent_path().string();
  StudyFile file = read_study(read_source(path), folder, settings);
  file.path = path;
  return file;
}

}  // namespace twum::inline v0_1::studies
