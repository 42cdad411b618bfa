// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include "yaml/yaml_text.hpp"

#include <twum/studies/text/number.hpp>

namespace twum::studies {
namespace {

std::string value_text(double value, const ParameterInfo& row) {
  return number_text(value) + (row.unit == "1" ? "" : " " + std::string(row.unit));
}

}  // namespace

std::string motor_text(const MotorFile& motor) {
  std::string text = "twum: " + std::to_string(kFileVersion) + "\nmotor:\n";
  if (!motor.name.empty()) text += "  name: " + double_quoted(motor.name) + "\n";
  std::string_view section;
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(motor.design, row.parameter)) continue;
    const std::size_t dot = row.file_entry.find('.');
    const std::string_view own =
        dot == std::string_view::npos ? std::string_view() : row.file_entry.substr(0, dot);
    if (own != section && !own.empty()) text += "  " + std::string(own) + ":\n";
    section = own;
    const std::string_view name = own.empty() ? row.file_entry : row.file_entry.substr(dot + 1);
    text += std::string(own.empty() ? 2 : 4, ' ') + std::string(name) + ": " +
            value_text(get(motor.design, row.parameter), row) + "\n";
  }
  return text;
}

}  // namespace twum::studies
