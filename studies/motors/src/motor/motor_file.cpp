// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include <twum/studies/yaml/loader.hpp>

namespace twum::studies {
namespace {

bool refuse_study(const YamlNode& root, Diagnostics& diagnostics) {
  if (root.find("study") == nullptr) return false;
  diagnostics.add({1, 1}, "study", "a study file",
                  "expected a motor file; a study is run with 'twum run'");
  return true;
}

}  // namespace

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

}  // namespace twum::studies
