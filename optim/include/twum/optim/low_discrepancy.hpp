// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// The Sobol sequence (Joe and Kuo's directions, Gray code order) in [0, 1)^dimension, with no points skipped,
/// shifted modulo 1 by a random vector that depends on the seed. Each point is computed independently, so a sequence
/// of any length takes no memory. Any number of threads may use one object.
class SobolSequence {
 public:
  /// @throws InputError for a dimension of 0 or beyond 3667.
  SobolSequence(std::size_t dimension, std::uint64_t seed);

  /// Coordinates of a point.
  std::size_t dimension() const noexcept { return shift_.size(); }
  /// Writes point `index` = 0, 1, ... to `point`, which has dimension() entries.
  /// @throws InputError for an index beyond 10^12.
  void point(std::uint64_t index, std::span<double> point) const;

 private:
  std::vector<std::vector<std::uint64_t>> directions_;  // [bit][dimension]
  std::vector<double> shift_;
};

/// The first `count` points of SobolSequence, each in [0, 1)^dimension.
/// @throws InputError for a dimension of 0 or beyond 3667.
std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count,
                                              std::uint64_t seed);

}  // namespace twum::inline v0_1::optim
