// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/motor_file.hpp>

#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>

#include <string_view>

namespace twum::inline v0_1::motors {
namespace {

bool refuse_study(const YamlNode& root, Diagnostics& diagnostics) {
  if (root.find("study") != nullptr) {
    diagnostics.add({1, 1}, "study", "found a study file",
                    "expected a motor file; a study is run with 'twum run'");
    return true;
  }
  if (!names_motor_file(root)) return false;
  const YamlNode& motor = *root.find("motor");
  diagnostics.add(
      motor.mark, "motor",
      quoted(motor.scalar) +
          " is the path of a file, so this looks like a study that lacks 'study:'",
      "add 'study:' and run it with 'twum run', or give this command the file of the motor");
  return true;
}

}  // namespace

bool names_motor_file(const YamlNode& root) {
  const YamlNode* motor = root.find("motor");
  if (motor == nullptr || motor->kind != YamlNode::Kind::scalar) return false;
  const std::string_view text = motor->scalar;
  return text.ends_with(".yaml") || text.ends_with(".yml") ||
         text.find('/') != std::string_view::npos;
}

MotorFile read_motor(const Source& source) {
  Diagnostics diagnostics(source);
  const YamlNode root = load_yaml(diagnostics);
  MotorFile motor;
  if (!refuse_study(root, diagnostics))
    motor_file_shape().read(motor, root, {{}, {1, 1}}, diagnostics);
  diagnostics.throw_if_any();
  return motor;
}

MotorFile read_motor_file(const std::string& path) { return read_motor(read_source(path)); }

}  // namespace twum::inline v0_1::motors
