// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

namespace twum::studies {

/// What stands where there is no value.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A column of stored rows: a flat parameter name or a metric as typed, in SI.
struct Column {
  std::string name;  ///< flat name of a parameter, or a metric as typed
  std::string unit;  ///< SI unit, "1" if dimensionless
};

/// A value with its name, in SI.
struct NamedValue {
  std::string name;  ///< flat name of a parameter, or a metric as typed
  std::string unit;  ///< SI unit, "1" if dimensionless
  double value;      ///< kNoValue: none
};

}  // namespace twum::studies
