// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/heat.hpp>
#include <twum/studies/heat_result.hpp>
#include <twum/studies/telling.hpp>

#include <array>
#include <limits>
#include <optional>
#include <string>

/// The parts of a motor in what is told of its temperatures; internal.
namespace twum::inline v0_1::studies::telling {

/// A part of the motor and its name.
struct HeatedPart {
  twum::Part part;
  const char* name;
};
inline constexpr std::array kHeated{
    HeatedPart{twum::Part::stator, "stator"}, HeatedPart{twum::Part::rotor, "rotor"},
    HeatedPart{twum::Part::housing, "housing"}, HeatedPart{twum::Part::contact, "contact"}};

/// How many have a temperature of their own: of one node the first alone.
std::size_t parts_of(const HeatResult::Member& motor);
std::string part_name(const HeatResult::Member& motor, std::size_t i);
/// Of one node the lowest limit counts.
std::optional<double> limit_of(const HeatResult::Member& motor, std::size_t i);

/// The part that is nearest to its limit; an infinite margin without one.
struct Nearest {
  std::size_t part{0};
  double margin{std::numeric_limits<double>::infinity()};
};
Nearest nearest_limit(const HeatResult::Member& motor, const PartTemperatures& temperatures);

/// True if there is a steady state, or a cycle that returns.
/// @{
bool is_steady(const HeatResult::Member& motor);
bool has_cycle(const HeatResult::Member& motor);
/// @}

/// "voltage 80 V"; the motor alone has no name.
Phrase heated_phrase(const HeatResult& answer, const HeatResult::Member& motor);

}  // namespace twum::inline v0_1::studies::telling
