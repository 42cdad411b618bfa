// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/shape.hpp>
#include <twum/io/yaml_node.hpp>

#include <string>

namespace twum::inline v0_1::motors {

/// Version of the file formats that this program reads and writes: `twum: 1`.
inline constexpr int kFileVersion = 1;

/// A motor of a file.
struct MotorFile {
  std::string name{};    ///< name in the file; may be empty
  MotorDesign design{};  ///< SI
};

/// Shape of a value of one parameter: unit, range and example of the parameter table.
Schema parameter_schema(const ParameterInfo& parameter);

/// `twum: 1`, which every file begins with.
template <typename T>
Field<T> version_field() {
  return selector<T>("twum", "version of the file format", std::to_string(kFileVersion));
}

/// What stands below `motor:`, made from the parameter table; static lifetime.
const Shape<MotorFile>& motor_shape();

/// A motor file; static lifetime.
const Shape<MotorFile>& motor_file_shape();

/// True if `motor:` of a document is the path of a file, as only a study file has it.
bool names_motor_file(const YamlNode& root);

/// Reads a motor file; "-" is standard input.
/// @throws FileError with everything that is wrong in it; InputError if it cannot be read.
MotorFile read_motor_file(const std::string& path);

/// Reads the text of a motor file.
/// @throws FileError with everything that is wrong in it.
MotorFile read_motor(const Source& source);

/// A motor as the text of a motor file, with SI values to the last digit. Of alternatives, the one in use is written.
std::string motor_text(const MotorFile& motor);

}  // namespace twum::inline v0_1::motors
