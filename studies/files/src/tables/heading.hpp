// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace twum::studies {

/// A column's heading: "thickness [mm]" has the name "thickness" and the unit "mm". Views into the text.
struct Heading {
  std::string_view name;
  std::string_view unit;
  bool has_unit;
};

Heading split_heading(std::string_view text);

}  // namespace twum::studies
