// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/study/study_file.hpp>

#include "study/study_kinds.hpp"
#include "study/tolerance_shape.hpp"

#include <twum/studies/metrics/varied_parameters.hpp>
#include <twum/studies/motor/settings.hpp>
#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/yaml/loader.hpp>

#include <filesystem>

namespace twum::studies {
namespace {

namespace fs = std::filesystem;

// A motor file is no study, and says so better than a list of missing entries.
bool refuse_motor(const YamlNode& root, Diagnostics& diagnostics) {
  const YamlNode* motor = root.find("motor");
  const bool is_motor =
      root.find("study") == nullptr && motor != nullptr && motor->kind == YamlNode::Kind::mapping;
  if (is_motor) {
    diagnostics.add({1, 1}, "study", "a motor file without a study",
                    "expected a study file; 'twum init optimize' writes one to start from");
  }
  return is_motor;
}

// The motor that a study names, without the errors of that file: those come out as a FileError.
std::optional<MotorFile> named_motor(const std::string& name, const YamlNode& node,
                                     const std::string& folder, Diagnostics& diagnostics) {
  if (name.empty()) return {};
  try {
    return read_motor_file((fs::path(folder) / name).string());
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    diagnostics.add(node.mark, "motor", error.what(),
                    "expected the path of a motor file, from the folder of this file");
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

// Nothing if there is none, or if what stands there is wrong, which is said.
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

// What only shows once the motor is known: tolerances follow its values. Those of a motor that an earlier study found are
// looked at when the study runs.
void check_with_motor(const StudyText& text, const MotorDesign& design, const YamlNode& root,
                      Diagnostics& diagnostics) {
  const auto* asked = std::get_if<UncertaintyStudy>(&text.study);
  const YamlNode* study = root.find("study");
  if (asked == nullptr || !asked->start.empty() || study == nullptr) return;
  if (const YamlNode* given = study->find("variables"))
    shapes::check_tolerances(asked->variables, design, *given, "study.variables", diagnostics);
}

// Whether what is derived goes together with what is varied, and with the motor.
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

// Both the study's errors and those of the motor file it names.
[[noreturn]] void throw_both(const Diagnostics& diagnostics, const FileError& motor) {
  try {
    diagnostics.throw_if_any();
  } catch (const FileError& study) {
    throw FileError(study, motor);
  }
  throw motor;
}

}  // namespace

bool is_study(const Source& source) {
  Diagnostics ignored(source);
  return load_yaml(ignored).find("study") != nullptr;
}

StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings) {
  Diagnostics diagnostics(source);
  YamlNode root = load_yaml(diagnostics);
  StudyText text;
  if (!refuse_motor(root, diagnostics))
    study_file_shape().read(text, root, {{}, {1, 1}}, diagnostics);
  std::optional<MotorFile> motor;
  try {
    motor = motor_of(root, folder, text, diagnostics);
  } catch (const FileError& error) {
    throw_both(diagnostics, error);
  }
  if (motor) {
    motor->design = with_settings(motor->design, settings);
    check_with_motor(text, motor->design, root, diagnostics);
    if (diagnostics.empty()) check_derived(text.study, motor->design, root, diagnostics);
  }
  diagnostics.throw_if_any();
  TWUM_ASSERT(motor.has_value());
  return {std::move(*motor), std::move(text.study), *root.find("study"), folder, source.name()};
}

StudyFile read_study_file(const std::string& path, std::span<const std::string> settings) {
  const std::string folder = path == "-" ? "" : fs::path(path).parent_path().string();
  StudyFile file = read_study(read_source(path), folder, settings);
  file.path = path;
  return file;
}

}  // namespace twum::studies
