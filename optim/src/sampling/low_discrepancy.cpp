// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/random.hpp>

#include <bit>
#include <boost/random/sobol.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::size_t kMostDimensions = 3667;  // of the direction numbers that Boost carries
constexpr std::size_t kBits = 40;              // of an index: 10^12 points

std::size_t checked(std::size_t dimension) {
  if (dimension == 0 || dimension > kMostDimensions)
    throw InputError("Sobol sequence: dimension " + std::to_string(dimension) +
                     " is outside 1 to 3667");
  return dimension;
}

// Point 2^b of the sequence is the sum modulo 2 of the directions of the bits of its Gray code, b and
// b - 1; so the points 1, 2, 4, ... contain all directions.
std::vector<std::vector<std::uint64_t>> directions(std::size_t dimension) {
  boost::random::sobol engine(dimension);
  std::vector<std::vector<std::uint64_t>> table(kBits, std::vector<std::uint64_t>(dimension));
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    engine.seed((std::uint64_t{1} << bit) - 1);  // Boost's sequence begins behind the origin
    for (std::size_t j = 0; j < dimension; ++j)
      table[bit][j] = engine() ^ (bit > 0 ? table[bit - 1][j] : 0);
  }
  return table;
}

}  // namespace

SobolSequence::SobolSequence(std::size_t dimension, std::uint64_t seed)
    : directions_(directions(checked(dimension))), shift_(dimension) {
  Random random(seed, 0x50B01, 0);
  for (double& s : shift_) s = random.uniform();
}

void SobolSequence::point(std::uint64_t index, std::span<double> point) const {
  if (index >> kBits != 0) throw InputError("Sobol sequence: an index beyond 10^12");
  const std::uint64_t gray = index ^ (index >> 1U);
  for (std::size_t j = 0; j < shift_.size(); ++j) {
    std::uint64_t digits = 0;
    for (std::uint64_t rest = gray; rest != 0; rest &= rest - 1)
      digits ^= directions_[static_cast<std::size_t>(std::countr_zero(rest))][j];
    const double sum = static_cast<double>(digits) * 0x1.0p-64 + shift_[j];
    point[j] = sum >= 1.0 ? sum - 1.0 : sum;
  }
}

std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count,
                                              std::uint64_t seed) {
  const SobolSequence sequence(dimension, seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
  for (std::size_t i = 0; i < count; ++i) sequence.point(i, points[i]);
  return points;
}

}  // namespace twum::inline v0_1::optim
