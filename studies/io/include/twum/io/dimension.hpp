// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <array>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// Dimension of a quantity as powers of the base units m, kg, s, rad, A and K. The radian is a base unit, so a torque
/// is not an energy and an angular speed is not a frequency. Powers may be fractions, such as 1/2 for the square root
/// of a length.
class Dimension {
 public:
  /// The dimension of a number without unit.
  Dimension() = default;
  /// The dimension of a known unit such as "N.m"; "1" for a number without unit. Thread-safe.
  explicit Dimension(std::string_view unit);

  /// Dimension of a product, of a quotient, of a power.
  /// @{
  Dimension times(const Dimension& other) const;
  Dimension over(const Dimension& other) const;
  Dimension power(double exponent) const;
  /// @}

  /// True for a number without unit.
  bool none() const { return *this == Dimension(); }
  /// True if they differ only in the power of the radian.
  bool differs_by_angle_only(const Dimension& other) const;
  /// Equal up to rounding of powers such as 1/3.
  bool operator==(const Dimension& other) const;

  /// SI unit: a usual one ("N.m", "W/m^2") or its square ("W^2") if there is one, otherwise a product of base units;
  /// "1" for a number without unit.
  std::string unit() const;

 private:
  std::array<double, 6> powers_{};
};

/// A number with its unit, in SI.
struct Measure {
  double value{0};      ///< SI
  Dimension dimension;  ///< of its unit
};

/// Reads a number with any unit, or without one: "5 kW/m^2", "0.1", "3 %".
/// @throws ValueError naming what was found, such as an unknown unit, with its position
Measure parse_measure(std::string_view text);

}  // namespace twum::inline v0_1::io
