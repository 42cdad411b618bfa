// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <twum/base/namespaces.hpp>
#include <twum/base/no_value.hpp>
#include <vector>

namespace twum::inline v0_1::io {

/// A column of stored rows: a flat parameter name or a metric as typed, in SI.
struct StoredColumn {
  std::string name;  ///< flat name of a parameter, or a metric as typed
  std::string unit;  ///< SI unit, "1" if dimensionless
  /// meaning of its values 1, 2, ...; empty: the values are numbers
  std::vector<std::string> words{};

  /// The word for a value; null if there is none.
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

}  // namespace twum::inline v0_1::io
