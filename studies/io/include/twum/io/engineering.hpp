// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// An SI value with an engineering prefix: "1.6 um", "3 GPa", "100 rpm" (speeds [rad/s] in rpm), "0.35".
/// @param digits  significant ones, 1 to 17
std::string engineering(double value, std::string_view si_unit, int digits = 4);

/// The unit in which a column of values is shown, and what to divide SI values by.
struct DisplayUnit {
  std::string text;  ///< "rpm", "mN.m"; empty if dimensionless
  double divisor;    ///< SI value of one such unit
};

/// The units in which values of an SI unit are shown, largest first: all prefixes, or a single unit where a prefix
/// would be wrong or unusual.
std::vector<DisplayUnit> display_units(std::string_view si_unit);

/// Unit in which a value of this size has one to three digits before the decimal point.
DisplayUnit display_unit(double size, std::string_view si_unit);

/// engineering() as books print it: "1.6 µm".
std::string printed_engineering(double value, std::string_view si_unit, int digits = 4);

/// A unit as books print it: "µm", "N·m", "W/m²" for um, N.m, W/m^2.
std::string printed_unit(std::string_view unit);

}  // namespace twum::inline v0_1::io
