// SPDX-License-Identifier: Apache-2.0
#include <twum/io/number.hpp>

#include <cmath>

namespace twum::inline v0_1::io {

std::string about(double value) {
  constexpr double kWhole = 1e15;  // limit up to which all digits of a whole number are exact
  const double size = std::fabs(value);
  return size < 99.5 || !(size < kWhole) ? rounded_text(value, 2)
                                         : std::to_string(std::llround(value));
}

}  // namespace twum::inline v0_1::io
