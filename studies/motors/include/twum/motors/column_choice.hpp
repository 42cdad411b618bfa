// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace twum::inline v0_1::motors {

/// Where a quantity stands in a table whose headings do not say so.
struct ColumnChoice {
  std::string quantity;  ///< as in a heading: "speed", "torque_sd", a metric, a parameter
  std::string
      heading{};  ///< of its column as typed, with its unit or without; empty: given by its number
  std::size_t number{0};  ///< of the column, from 1; 0: given by its heading
  std::string unit{};     ///< of its cells; empty: that of the heading
  bool reversed{false};   ///< values count with the other sign

  friend bool operator==(const ColumnChoice&, const ColumnChoice&) = default;  ///< all equal
};

}  // namespace twum::inline v0_1::motors
