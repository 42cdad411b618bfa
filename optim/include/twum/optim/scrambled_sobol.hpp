// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// A randomized Sobol sequence (Joe and Kuo's directions) with random access: its digits are scrambled by random
/// lower triangular matrices and a random digital shift (Matousek 1998). Each point by itself is uniformly
/// distributed, and the first 2^m points are as evenly spread as those of the sequence itself. Replicates are
/// independent of each other, so that their scatter measures the error of a mean. Immutable, safe for any number of
/// threads.
class ScrambledSobol {
 public:
  /// @param replicate  selects the randomization together with the seed
  /// @throws InputError for a dimension of 0 or beyond 3667.
  ScrambledSobol(std::size_t dimension, std::uint64_t seed, std::uint64_t replicate);

  /// Coordinates of a point.
  std::size_t dimension() const noexcept { return shift_.size(); }

  /// Point `index` < 2^40 in (0, 1)^dimension; neither 0 nor 1 ever occurs. `x` has dimension() entries. Takes about
  /// 2 ns for each coordinate and binary digit of the index.
  void point(std::uint64_t index, std::span<double> x) const;

 private:
  static constexpr std::size_t kIndexBits = 40;

  std::vector<std::uint64_t> columns_;  // scrambled directions, kIndexBits for each dimension
  std::vector<std::uint64_t> shift_;
};

}  // namespace twum::inline v0_1::optim
