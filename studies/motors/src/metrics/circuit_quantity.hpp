// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>

#include <optional>
#include <string_view>

namespace twum::inline v0_1::motors {

/// Readings of an impedance analyser at a phase of the free stator, with the other phase shorted, at the design's
/// frequency (D4.4).
enum class CircuitPart : unsigned char {
  conductance,
  susceptance,
  impedance,
  impedance_phase,
  resistance,
  reactance
};
inline constexpr std::size_t kCircuitParts = 6;

/// Name and SI unit.
struct CircuitPartInfo {
  std::string_view name;
  std::string_view unit;
};
const CircuitPartInfo& info(CircuitPart part);
/// Whether the two are real and imaginary part of one complex number, or the same.
bool same_number(CircuitPart a, CircuitPart b);
std::optional<CircuitPart> find_circuit_part(std::string_view name);

/// Its value, with exact derivatives by every parameter; the status is `undefined` for a design without modal data.
MetricDerivative differentiate(const MotorDesign& design, CircuitPart part,
                               bool fixed_static_friction);

}  // namespace twum::inline v0_1::motors
