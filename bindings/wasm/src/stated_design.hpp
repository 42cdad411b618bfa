// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <span>

/// A design as a list of numbers, the form that the page uses; internal.
namespace twum::inline v0_1::wasm {

/// Positions of the numbers that follow the parameters.
enum class StatedNumber : unsigned char {
  branch,      ///< 0 running, 1 dead
  inner_edge,  ///< of the geometry: 0 free, 1 clamped, 2 supported
  table_rows,  ///< rows of the radial shape that follow, radius [m] and R each
  count
};

/// The design of numbers [SI]: every parameter in the order of its table, NaN for one that is not stated; the numbers of
/// StatedNumber; the rows of the table. A geometry, its web and its teeth are there if their thickness or height is stated.
/// @throws InputError if values are not admissible or are not those of a valid motor
MotorDesign design_of(std::span<const double> numbers);

}  // namespace twum::inline v0_1::wasm
