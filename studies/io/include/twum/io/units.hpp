// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// Conversion of numbers in a unit to SI: multiplication by `factor`, which is 10^power for decimal units; of absolute
/// temperatures in degC the addition of 273.15.
class Scale {
 public:
  /// A number that is in SI already.
  Scale() = default;
  /// A number whose unit is `factor` SI units, > 0.
  explicit Scale(double factor);
  /// An absolute temperature in degC.
  static Scale celsius();

  /// What a number is multiplied by.
  double factor() const noexcept { return factor_; }
  /// A number without unit, in SI; decimal units round once, so "26.5" in mm is exactly 0.0265. Nothing if it is not
  /// a finite number. Thread-safe.
  std::optional<double> read(std::string_view number) const noexcept;

 private:
  double factor_{1};
  std::optional<int> power_{0};
  double offset_{0};
};

/// Unit that a quantity should have.
struct Expected {
  std::string_view unit;     ///< SI unit, "1" if dimensionless
  std::string_view example;  ///< as a user types it, such as "0.3 mm"
  bool absolute{false};      ///< an absolute temperature, which may be given in degC
};

/// A quantity, and which of the expected units it has.
struct Quantity {
  double value;       ///< in the SI unit
  std::size_t which;  ///< index into the expected ones
};

/// Reads a number with a unit, such as "1.6 um", "100 rpm" or "5 kW/m^2"; a bare number (or a
/// percentage) where a dimensionless one is expected.
///
/// Units are those of UDUNITS-2 in a unit system in which the radian is a base unit and the joule is N m rad: an
/// angular speed is not a frequency, and a torque is not an energy. degC is read for an absolute temperature only. Thread-safe.
/// @throws ValueError naming what was found, its dimension, and the dimension that is right.
double parse_quantity(std::string_view text, const Expected& expected);
/// The same where several dimensions are admissible, such as a speed or a torque.
/// @throws ValueError likewise, naming all of them.
Quantity parse_quantity(std::string_view text, std::span<const Expected> expected);

/// Scale of a unit such as "mm", which must have the dimension of `expected`.
/// @throws ValueError as parse_quantity().
Scale parse_unit(std::string_view unit, const Expected& expected);

/// True for the unit of absolute temperatures beside K: "degC", or the sign for it.
bool is_celsius(std::string_view unit);

/// "length", "torque", ... for an SI unit such as "m", "N.m"; empty if it has no common name. Static lifetime.
std::string_view dimension_name(std::string_view si_unit);

/// Name of a dimension in error texts: "a length [m]", "a number without unit".
std::string dimension_phrase(std::string_view si_unit);

}  // namespace twum::inline v0_1::io
