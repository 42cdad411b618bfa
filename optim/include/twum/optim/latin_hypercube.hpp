// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace twum::inline v0_1::optim {

/// A Latin hypercube (McKay, Beckman and Conover 1979): of `count` points in [0, 1)^dimension each of the `count`
/// equal strata of every coordinate holds exactly one. Each point is computed independently, so a design of any size
/// takes no memory. Any number of threads may use one object.
class LatinHypercube {
 public:
  /// @throws InputError for a dimension of 0 or a count outside 1 to 2^30.
  LatinHypercube(std::size_t dimension, std::uint64_t count, std::uint64_t seed);

  /// Coordinates of a point.
  std::size_t dimension() const noexcept { return dimension_; }
  /// Number of points.
  std::uint64_t count() const noexcept { return count_; }
  /// Stratum 0 .. count - 1 of a coordinate in which point `index` < count lies.
  std::uint64_t stratum(std::uint64_t index, std::size_t coordinate) const;
  /// Writes point `index` < count() to `point`, which has dimension() entries.
  void point(std::uint64_t index, std::span<double> point) const;

 private:
  std::size_t dimension_;
  std::uint64_t count_;
  std::uint64_t seed_;
  unsigned half_bits_;  // bits of each half of the Feistel permutation
};

}  // namespace twum::inline v0_1::optim
