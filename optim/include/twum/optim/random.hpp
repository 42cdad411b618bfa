// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::inline v0_1::optim {

/// Random numbers without hidden state: the k-th number of stream (seed, stage, index) is a function of these four
/// integers alone (Philox 2x64 with ten rounds; Salmon et al. 2011). An object counts the numbers drawn, so each
/// thread needs its own. Never throws.
class Random {
 public:
  /// The stream of a seed, a stage and an index, at its first number.
  Random(std::uint64_t seed, std::uint64_t stage, std::uint64_t index) noexcept
      : key_(seed), high_(stage * 0x9E3779B97F4A7C15ULL + index) {}

  /// The next 64 bits of the stream.
  std::uint64_t bits() noexcept;

  /// Uniform in [0, 1), 53 bits.
  double uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

  /// Uniform in {0, ..., count - 1} up to a bias below count / 2^64; count > 0.
  std::uint64_t below(std::uint64_t count) noexcept { return bits() % count; }

 private:
  std::uint64_t key_;
  std::uint64_t high_;
  std::uint64_t counter_{0};
};

}  // namespace twum::inline v0_1::optim
