// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// Two inputs whose normal numbers are correlated.
struct CorrelatedPair {
  std::size_t a{0};       ///< position of one input
  std::size_t b{0};       ///< position of another
  double coefficient{0};  ///< in (-1, 1)
};

/// A normal copula, U1.9: y = L z has the wanted correlations if z is independent and standard normal. The marginal
/// distributions stay as they are. Independent inputs cost nothing.
class Correlation {
 public:
  /// Independent inputs.
  Correlation() = default;
  /// @throws InputError naming the positions of the pair at which wrong_pair() finds that no matrix has all of them
  Correlation(std::size_t inputs, std::span<const CorrelatedPair> pairs);

  /// A pair that was given before or is of one input with itself; or where the matrix is not positive definite, the last pair of
  /// the first input for which it is not. Pairs that are not given have the coefficient 0.
  static std::optional<std::size_t> wrong_pair(std::size_t inputs,
                                               std::span<const CorrelatedPair> pairs);

  /// Whether no pair was given.
  bool independent() const noexcept { return factor_.empty(); }
  /// y = L z.
  std::vector<double> correlated(std::vector<double> z) const;
  /// L^T g: the slopes in z of a function with the slopes g in y.
  std::vector<double> slopes(std::vector<double> g) const;
  /// (L z)_k (L^-T z)_k of each input, z_k^2 for independent ones; the sum is |z|^2, U1.10.
  std::vector<double> parts(std::span<const double> z) const;

 private:
  std::size_t inputs_{0};
  std::vector<double> factor_;  // L, column by column
};

}  // namespace twum::inline v0_1::optim
