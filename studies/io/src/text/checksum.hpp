// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace twum::inline v0_1::io {

/// FNV-1a hash of some bytes, 64 bits. Detects accidents, not attacks.
/// @param before  hash of the bytes before them
constexpr std::uint64_t checksum(std::string_view bytes,
                                 std::uint64_t before = 0xcbf29ce484222325U) {
  for (const char c : bytes) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return before;
}

}  // namespace twum::inline v0_1::io
