// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <cstring>
#include <string>
#include <vector>

namespace twum::test {

/// The numbers behind a text in base64 (RFC 4648), little-endian.
template <typename Number>
std::vector<Number> numbers(const studies::Json& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text.get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(held) & 0xFFU);
  }
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
  return values;
}

}  // namespace twum::test
