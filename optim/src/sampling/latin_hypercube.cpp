// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/random.hpp>

#include <bit>
#include <string>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 30U;
constexpr std::uint64_t kFeistelRounds = 6;    // Luby and Rackoff: four make it pseudorandom
constexpr std::uint64_t kRoundStage = 0x7A71;  // streams apart from those of other uses of a seed
constexpr std::uint64_t kPlaceStage = 0x7A72;
constexpr double kPlaces = 0x1.0p20;  // within a stratum; with 30 bits of stratum exact in a double

}  // namespace

LatinHypercube::LatinHypercube(std::size_t dimension, std::uint64_t count, std::uint64_t seed)
    : dimension_(dimension),
      count_(count),
      seed_(seed),
      half_bits_((static_cast<unsigned>(std::bit_width(count > 0 ? count - 1 : 0)) + 1) / 2) {
  if (dimension == 0) throw InputError("Latin hypercube: a dimension of 0");
  if (count == 0 || count > kMostPoints)
    throw InputError("Latin hypercube: " + std::to_string(count) +
                     " points are outside 1 to 2^30 = 1073741824");
}

// A Feistel network permutes 0 .. 4^half_bits - 1, at most four times the range wanted; following it
// from an index until it comes back into 0 .. count - 1 permutes these.
std::uint64_t LatinHypercube::stratum(std::uint64_t index, std::size_t coordinate) const {
  const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
  std::uint64_t value = index;
  do {
    std::uint64_t left = value >> half_bits_;
    std::uint64_t right = value & mask;
    for (std::uint64_t round = 0; round < kFeistelRounds; ++round) {
      Random mix(seed_, kRoundStage + coordinate * 0x10000, (round << 32U) | right);
      const std::uint64_t mixed = left ^ (mix.bits() & mask);
      left = right;
      right = mixed;
    }
    value = (left << half_bits_) | right;
  } while (value >= count_);
  return value;
}

void LatinHypercube::point(std::uint64_t index, std::span<double> point) const {
  Random random(seed_, kPlaceStage, index);
  for (std::size_t j = 0; j < dimension_; ++j) {
    // The middle of one of 2^20 places: never on the border of a stratum, not even after rounding.
    const double place = (static_cast<double>(random.below(1U << 20U)) + 0.5) / kPlaces;
    point[j] = (static_cast<double>(stratum(index, j)) + place) / static_cast<double>(count_);
  }
}

}  // namespace twum::inline v0_1::optim
