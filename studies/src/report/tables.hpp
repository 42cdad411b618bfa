// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/core/motor_design.hpp>

#include <string>
#include <string_view>

/// Tables of parameters, metrics, units and materials for pages; internal.
namespace twum::inline v0_1::studies {

/// {name: {"symbol", "unit", "text", "integer", "absolute", "entry": in the motor file, "min", "max" [SI],
/// "required": in a motor file, "alternative": the parameter that may be given instead, or null}}. What is of heat and wear, which a
/// page does not compute, stands there only if a text names it.
Json parameters_json(std::string_view text);

/// {name: {"unit", "text", "argument": "none", "speed", "torque" or "speed or torque", "share": shown in per cent,
/// "modes", "geometry", "absent": of heat, wear or radial motion, which a page does not compute}}; likewise
Json metrics_json(std::string_view text);

/// [{"name", "text", "shown"}] of metrics of heat and wear that the design has and a page does not compute: those of the whole
/// motor.
Json left_out_metrics_json(const MotorDesign& design);

/// {word: what it means} of missing answers
Json reasons_json();

/// What the efficiencies of a curve count: {name: meaning}
Json efficiencies_json();

/// {SI unit: {unit that one may type: SI value of it}} for the units of parameters and metrics.
Json units_json();

/// {SI unit: [{"text": "kN·m", "typed": "kN.m", "divisor": SI value of it}, largest first]} for the units of parameters and
/// metrics, those that scripts name, and those in the data of a page: its entries "unit" and "units".
Json display_units_json(const Json& page);

/// {material: {property: SI value}}
Json materials_json();

/// A motor in the form of the interactive designer page: {"name", "values": {parameter: SI value} of what is stated,
/// "branch", "inner_edge", "table": rows of the radial shape, "besides": {entry of the motor file: its text} of what the page keeps
/// without reading it}
Json stated_motor_json(const std::string& name, const MotorDesign& design);

}  // namespace twum::inline v0_1::studies
