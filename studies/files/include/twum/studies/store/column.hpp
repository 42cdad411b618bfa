// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace twum::studies {

/// What stands where there is no value.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A column of stored rows: a flat parameter name or a metric as typed, in SI.
struct StoredColumn {
  std::string name;  ///< flat name of a parameter, or a metric as typed
  std::string unit;  ///< SI unit, "1" if dimensionless
  std::vector<std::string>
      words{};  ///< what its values 1, 2, ... stand for; empty: they are numbers

  /// The word of a value; null if it has none.
  const std::string* word(double value) const {
    const bool known = value >= 1 && value <= static_cast<double>(words.size());
    return known ? &words[static_cast<std::size_t>(value) - 1] : nullptr;
  }
};

/// A value with its name, in SI.
struct NamedValue {
  std::string name;  ///< flat name of a parameter, or a metric as typed
  std::string unit;  ///< SI unit, "1" if dimensionless
  double value;      ///< kNoValue: none
};

}  // namespace twum::studies
