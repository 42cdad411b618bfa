// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/shape.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twum::inline v0_1::motors {

/// The parameter with a name or symbol.
/// @throws ValueError with the nearest names if there is none.
Parameter parse_parameter(std::string_view name);

/// Shape of a parameter's value in a file: a number with its unit, or `auto` for radial_slices.
Shape<double> parameter_shape(const ParameterInfo& parameter);

/// Motor::radial_slices() as a file has it: "8", "auto", or "auto 10" for auto with ten slices a panel.
/// @{
std::string slices_text(int slices);
/// Of the latter two; nothing for other texts.
std::optional<int> automatic_slices(std::string_view text);
/// @}

/// A parameter's value in SI with the unit that suits it, or as slices_text().
std::string parameter_text(std::string_view name, double value, std::string_view unit);

/// Reads "thickness=0.3 mm": a name or symbol, and a value with its unit.
/// @throws ValueError if the name is unknown, or the value has a wrong unit or is out of range.
ParameterValue parse_setting(std::string_view text);

/// The design with "NAME=VALUE" settings applied. The last of several for one parameter counts.
/// @throws InputError with everything that is wrong, one line each.
MotorDesign with_settings(const MotorDesign& design, std::span<const std::string> settings);

}  // namespace twum::inline v0_1::motors
