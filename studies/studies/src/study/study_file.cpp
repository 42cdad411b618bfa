// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/study/study_file.hpp>

#include "study/entry_shapes.hpp"
#include "study/study_kinds.hpp"

#include <twum/studies/motor/settings.hpp>
#include <twum/studies/schema/validate.hpp>
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
std::optional<MotorFile> named_motor(const YamlNode& name, const std::string& folder,
                                     Diagnostics& diagnostics) {
  const std::string path = (fs::path(folder) / name.scalar).string();
  try {
    return read_motor_file(path);
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    diagnostics.add(name.mark, "motor", error.what(),
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

std::optional<MotorFile> motor_of(const YamlNode& root, const std::string& folder,
                                  const std::vector<shapes::Override>& overrides,
                                  Diagnostics& diagnostics) {
  const YamlNode* node = root.find("motor");
  if (node == nullptr) return {};
  std::optional<MotorFile> motor = node->kind == YamlNode::Kind::scalar
                                       ? named_motor(*node, folder, diagnostics)
                                       : motor_from(*node, "motor", diagnostics);
  const YamlNode* set = root.find("set");
  if (motor && set != nullptr) apply(overrides, *set, *motor, diagnostics);
  return motor;
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

namespace {

// What a study file says beside its motor.
struct Entries {
  std::vector<shapes::Override> overrides;
  std::optional<Study> asked;
};

Entries read_entries(const YamlNode& root, Diagnostics& diagnostics) {
  static const auto overrides = shapes::overrides();
  const Schema& schema = study_file_schema();
  const Spot top{{}, {1, 1}};
  Entries read;
  if (root.kind != YamlNode::Kind::mapping) {
    say_wrong_kind(root, schema, top, diagnostics);
    return read;
  }
  for (const auto& [number, entry] : given_entries(root, schema, top, diagnostics)) {
    const SchemaEntry& known = schema.entries[number];
    const Spot spot = top.entry(entry->key, entry->key_mark);
    if (known.name == "set") {
      overrides.read(read.overrides, entry->value, spot, diagnostics);
    } else if (known.name == "study") {
      const auto kind = alternative_of(entry->value, known.schema, spot, diagnostics);
      Study study;
      if (kind &&
          study_shape(static_cast<StudyKind>(*kind)).read(study, entry->value, spot, diagnostics))
        read.asked = std::move(study);
    } else {
      validate(entry->value, known.schema, spot, diagnostics);
    }
  }
  return read;
}

}  // namespace

StudyFile read_study(const Source& source, const std::string& folder,
                     std::span<const std::string> settings) {
  Diagnostics diagnostics(source);
  YamlNode root = load_yaml(diagnostics);
  Entries entries;
  if (!refuse_motor(root, diagnostics)) entries = read_entries(root, diagnostics);
  std::optional<MotorFile> motor;
  try {
    motor = motor_of(root, folder, entries.overrides, diagnostics);
  } catch (const FileError& error) {
    throw_both(diagnostics, error);
  }
  diagnostics.throw_if_any();
  TWUM_ASSERT(motor.has_value() && entries.asked.has_value());
  motor->design = with_settings(motor->design, settings);
  return {std::move(*motor), std::move(*entries.asked), *root.find("study"), folder, source.name()};
}

StudyFile read_study_file(const std::string& path, std::span<const std::string> settings) {
  const std::string folder = path == "-" ? "" : fs::path(path).parent_path().string();
  StudyFile file = read_study(read_source(path), folder, settings);
  file.path = path;
  return file;
}

}  // namespace twum::studies
