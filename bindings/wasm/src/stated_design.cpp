// SPDX-License-Identifier: Apache-2.0
#include "wasm/src/stated_design.hpp"

#include <twum/core/parameters.hpp>

#include <cmath>
#include <vector>

namespace twum::inline v0_1::wasm {
namespace {

double number(std::span<const double> numbers, StatedNumber place) {
  return numbers[kParameterCount + static_cast<std::size_t>(place)];
}

// A design with the parts that numbers may be set in.
MotorDesign frame_of(std::span<const double> numbers) {
  const auto stated = [&](Parameter p) { return !std::isnan(numbers[index_of(p)]); };
  MotorDesign design;
  Stator& stator = design.stator;
  stator.branch = number(numbers, StatedNumber::branch) == 1 ? Branch::dead : Branch::running;
  const auto rows = static_cast<std::size_t>(number(numbers, StatedNumber::table_rows));
  const std::size_t begin = kParameterCount + static_cast<std::size_t>(StatedNumber::count);
  for (std::size_t i = 0; i < rows; ++i)
    stator.radial_shape.table.emplace_back(numbers[begin + 2 * i], numbers[begin + 2 * i + 1]);
  if (!stated(Parameter::substrate_thickness)) return design;
  stator.geometry.emplace();
  stator.geometry->support =
      static_cast<stator::InnerEdge>(static_cast<int>(number(numbers, StatedNumber::inner_edge)));
  if (stated(Parameter::web_thickness)) stator.geometry->web.emplace();
  if (stated(Parameter::teeth_height)) stator.geometry->teeth.emplace();
  return design;
}

}  // namespace

MotorDesign design_of(std::span<const double> numbers) {
  std::vector<ParameterValue> values;
  for (const ParameterInfo& row : parameter_table()) {
    const double value = numbers[index_of(row.parameter)];
    if (!std::isnan(value)) values.emplace_back(row.parameter, value);
  }
  return with(frame_of(numbers), values);
}

}  // namespace twum::inline v0_1::wasm
