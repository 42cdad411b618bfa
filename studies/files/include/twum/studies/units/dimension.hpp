// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace twum::studies {

/// What a quantity measures, as powers of the base units m, kg, s, rad, A and K. The radian counts, as everywhere here: a
/// torque is no energy, and an angular speed no frequency. Powers need not be whole: sqrt of a length has 1/2.
class Dimension {
 public:
  /// Of a number without unit.
  Dimension() = default;
  /// Of a known unit such as "N.m"; "1" for a number without unit. Safe from any number of threads.
  explicit Dimension(std::string_view unit);

  /// Dimension of a product, of a quotient, of a power.
  /// @{
  Dimension times(const Dimension& other) const;
  Dimension over(const Dimension& other) const;
  Dimension power(double exponent) const;
  /// @}

  /// True for a number without unit.
  bool none() const { return *this == Dimension(); }
  /// True if they are the same but for the radian, which only one of them has or in another power.
  bool differs_by_angle_only(const Dimension& other) const;
  /// Equal up to rounding of powers such as 1/3.
  bool operator==(const Dimension& other) const;

  /// SI unit: the usual one if there is one ("N.m", "W/m^2"), its square ("W^2"), otherwise of base units; "1" for a number.
  std::string unit() const;

 private:
  std::array<double, 6> powers_{};
};

/// A number with its unit, in SI.
struct Measure {
  double value{0};      ///< SI
  Dimension dimension;  ///< of its unit
};

/// Reads a number with a unit of whatever dimension, or without one: "5 kW/m^2", "0.1", "3 %".
/// @throws ValueError naming what was found, such as an unknown unit, with its position
Measure parse_measure(std::string_view text);

}  // namespace twum::studies
