// SPDX-License-Identifier: Apache-2.0
// The entry that libFuzzer calls, of one target.
#include "fuzz/targets.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const twum::fuzz::Target& target = twum::fuzz::target(TWUM_FUZZ_TARGET);
  target.feed({reinterpret_cast<const char*>(data), size});
  return 0;
}
