// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/random.hpp>

namespace twum::inline v0_1::optim {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kMultiplier = 0xD2B74407B1CE6E93ULL;
constexpr std::uint64_t kWeyl = 0x9E3779B97F4A7C15ULL;
constexpr int kRounds = 10;

}  // namespace

std::uint64_t Random::bits() noexcept {
  std::uint64_t left = counter_++;
  std::uint64_t right = high_;
  std::uint64_t key = key_;
  for (int round = 0; round < kRounds; ++round, key += kWeyl) {
    const Wide product = Wide{kMultiplier} * left;
    left = static_cast<std::uint64_t>(product >> 64U) ^ key ^ right;
    right = static_cast<std::uint64_t>(product);
  }
  return left;
}

}  // namespace twum::inline v0_1::optim
