// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/random.hpp>
#include <twum/optim/scrambled_sobol.hpp>

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>
#include <string>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::size_t kDimensions = 3667;      // of the direction numbers that Boost carries
constexpr std::size_t kDigits = 52;            // of a coordinate
constexpr std::uint64_t kStream = 0x5C8A3B1E;  // apart from the other random numbers of a seed

using Matrix =
    std::array<std::uint64_t, kDigits>;  // row i makes digit i, the first one the highest

// Ones on the diagonal, random below it: maps evenly spread digits to evenly spread ones.
Matrix random_lower_triangle(Random& random) {
  Matrix rows{};
  for (std::size_t i = 0; i < kDigits; ++i) {
    const std::uint64_t diagonal = std::uint64_t{1} << (63 - i);
    const std::uint64_t left = ~(diagonal | (diagonal - 1));
    rows[i] = (random.bits() & left) | diagonal;
  }
  return rows;
}

std::uint64_t product(const Matrix& rows, std::uint64_t digits) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < kDigits; ++i) {
    const auto parity = static_cast<std::uint64_t>(std::popcount(rows[i] & digits)) & 1U;
    result |= parity << (63 - i);
  }
  return result;
}

// Direction k of every dimension. Boost's point i combines the directions in the Gray code of i + 1. The Gray code of
// 2^k has the bits k and k - 1, so this point combined with direction k - 1 gives direction k.
std::vector<std::uint64_t> next_directions(boost::random::sobol& engine, std::size_t k,
                                           const std::vector<std::uint64_t>& previous) {
  engine.seed((std::uint64_t{1} << k) - 1);
  std::vector<std::uint64_t> directions(previous.size());
  for (std::size_t j = 0; j < directions.size(); ++j) directions[j] = engine() ^ previous[j];
  return directions;
}

}  // namespace

ScrambledSobol::ScrambledSobol(std::size_t dimension, std::uint64_t seed, std::uint64_t replicate) {
  if (dimension == 0 || dimension > kDimensions)
    throw InputError("Sobol sequence: dimension " + std::to_string(dimension) +
                     " is outside 1 to 3667");
  std::vector<Matrix> matrices;
  for (std::size_t j = 0; j < dimension; ++j) {
    Random random(seed, kStream + replicate, j);
    matrices.push_back(random_lower_triangle(random));
    shift_.push_back(random.bits());
  }
  boost::random::sobol engine(dimension);
  columns_.resize(dimension * kIndexBits);
  std::vector<std::uint64_t> directions(dimension, 0);
  for (std::size_t k = 0; k < kIndexBits; ++k) {
    directions = next_directions(engine, k, directions);
    for (std::size_t j = 0; j < dimension; ++j)
      columns_[j * kIndexBits + k] = product(matrices[j], directions[j]);
  }
}

void ScrambledSobol::point(std::uint64_t index, std::span<double> x) const {
  TWUM_ASSERT(x.size() == dimension() && index >> kIndexBits == 0);
  for (std::size_t j = 0; j < shift_.size(); ++j) {
    const std::uint64_t* columns = &columns_[j * kIndexBits];
    std::uint64_t digits = shift_[j];
    for (std::uint64_t rest = index; rest != 0; rest &= rest - 1)
      digits ^= columns[std::countr_zero(rest)];
    // The middle of the cell that the digits name, so that no quantile function meets 0 or 1.
    x[j] = (static_cast<double>(digits >> (64 - kDigits)) + 0.5) * 0x1.0p-52;
  }
}

}  // namespace twum::inline v0_1::optim
