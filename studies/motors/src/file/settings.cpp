// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/settings.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/motor_file.hpp>

#include <vector>

namespace twum::inline v0_1::motors {

Parameter parse_parameter(std::string_view name) {
  name = trimmed(name);
  if (const auto parameter = find_parameter(name)) return *parameter;
  std::vector<std::string_view> names;
  for (const ParameterInfo& row : parameter_table()) {
    names.push_back(row.name);
    if (name == row.file_entry)  // typed as in a motor file
      throw ValueError("unknown parameter " + quoted(name),
                       "did you mean '" + std::string(row.name) + "'?");
  }
  throw ValueError("unknown parameter " + quoted(name),
                   nearest(name, names).empty() ? "'twum parameters' lists the parameters"
                                                : did_you_mean(name, names));
}

std::string slices_text(int slices) {
  if (slices > kAutoSlices) return std::to_string(slices);
  return slices == kAutoSlices ? "auto" : "auto " + std::to_string(-slices);
}

std::optional<int> automatic_slices(std::string_view text) {
  constexpr std::string_view kAuto = "auto";
  if (text.substr(0, kAuto.size()) != kAuto) return {};
  if (text.size() == kAuto.size()) return kAutoSlices;
  const std::optional<double> nodes = parse_number(trimmed(text.substr(kAuto.size())));
  const bool count = nodes && *nodes >= 1 && complaint(Parameter::radial_slices, -*nodes).empty();
  return count ? std::optional(-static_cast<int>(*nodes)) : std::nullopt;
}

std::string parameter_text(std::string_view name, double value, std::string_view unit) {
  const bool slices = name == info(Parameter::radial_slices).name;
  if (slices) return slices_text(static_cast<int>(value));
  constexpr double kZero = 273.15;  // 0 degC [K]
  const auto parameter = find_parameter(name);
  const bool absolute = parameter && info(*parameter).absolute;
  return absolute ? engineering(value - kZero, "degC") : engineering(value, unit);
}

ParameterValue parse_setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    throw ValueError(quoted(text) + " has no '='", "expected NAME=VALUE such as 'preload=140 N'");
  }
  const Parameter parameter = parse_parameter(text.substr(0, equals));
  const std::string_view value = trimmed(text.substr(equals + 1));
  if (parameter == Parameter::radial_slices)
    if (const std::optional<int> slices = automatic_slices(value)) return {parameter, *slices};
  return {parameter, read_number(value, parameter_schema(info(parameter)))};
}

MotorDesign with_settings(const MotorDesign& design, std::span<const std::string> settings) {
  std::vector<ParameterValue> values;
  std::string wrong;
  for (const std::string& setting : settings) {
    try {
      values.push_back(parse_setting(setting));
    } catch (const ValueError& error) {
      const std::string name(trimmed(std::string_view(setting).substr(0, setting.find('='))));
      wrong += (wrong.empty() ? "--set " : "\n--set ") + printable(name) + ": " + error.what();
    }
  }
  if (!wrong.empty()) throw InputError(wrong);
  try {
    return with(design, values);
  } catch (const InputError& error) {
    throw InputError(std::string("--set: ") + error.what());
  }
}

}  // namespace twum::inline v0_1::motors
