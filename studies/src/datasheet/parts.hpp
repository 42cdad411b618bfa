// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/motor.hpp>
#include <twum/studies/telling.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The parts of a data sheet; internal.
namespace twum::studies::datasheet {

/// Text that may stand anywhere in HTML or SVG.
std::string escaped(std::string_view text);

/// A coordinate or a length in a drawing, with two decimals.
std::string place(double value);

/// An SVG element with attributes in their order and its content, unchanged.
std::string element(std::string_view name,
                    std::initializer_list<std::pair<std::string_view, std::string>> attributes,
                    std::string_view content = "");

/// A name with its value.
using Line = std::pair<telling::Phrase, telling::Phrase>;

/// A list of names and values; empty without lines.
std::string list(const std::vector<Line>& lines);

/// A value; efficiencies in per cent.
telling::Part shown(double value, std::string_view unit, std::string_view name = {});

/// The motor cut along its axis, to scale, with the names of its parts.
std::string section(const MotorDesign& design);

/// Torque, output power and efficiency over speed up to no-load; the rated point marked if there is one with an answer.
std::string curves(const Motor& motor, const std::optional<OperatingPoint>& rated);

/// Numbers of the motor as a whole, those that need modal data apart.
/// @{
std::vector<Line> performance(const Motor& motor);
std::vector<Line> electrical(const Motor& motor);
/// @}

/// The numbers of the motor at its rated point.
std::vector<Line> rated_point(const MotorDesign& design, const OperatingPoint& rated);

/// Time and revolutions until the end of the life, and what ends it; nothing for a motor without wear.
/// @param load  none: the operation of the design
std::vector<Line> lifetime(const MotorDesign& design, const std::optional<LoadPoint>& load);

/// Every parameter in use.
std::vector<Line> parameters(const MotorDesign& design);

}  // namespace twum::studies::datasheet
