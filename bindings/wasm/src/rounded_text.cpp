// SPDX-License-Identifier: Apache-2.0
#include <twum/io/number.hpp>

#include <cstdio>

namespace twum::inline v0_1::io {

// Replaces the function of the library, which writes the same with std::to_chars, whose tables would be an eighth of
// the module. WebAssembly has one locale only.
std::string rounded_text(double value, int digits) {
  char buffer[64];
  const int size = std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return {buffer, static_cast<std::size_t>(size)};
}

}  // namespace twum::inline v0_1::io
