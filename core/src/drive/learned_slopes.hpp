// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace twum::inline v0_1::core {

using Pair = std::array<double, 2>;

/// Inverse Jacobian of two residuals in two unknowns, learned from steps (Broyden's inverse update). It starts as if
/// each residual fell as its own unknown rises.
class LearnedSlopes {
 public:
  Pair step(const Pair& f) const {
    return {k_[0][0] * f[0] + k_[0][1] * f[1], k_[1][0] * f[0] + k_[1][1] * f[1]};
  }
  /// Updates after a step s that has reduced the residuals by y.
  void learn(const Pair& s, const Pair& y) {
    const Pair told = step(y),
               back{s[0] * k_[0][0] + s[1] * k_[1][0], s[0] * k_[0][1] + s[1] * k_[1][1]};
    const double scale = s[0] * told[0] + s[1] * told[1];
    if (scale == 0) return;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) k_[i][j] += (s[i] - told[i]) * back[j] / scale;
  }
  /// How the second residual falls with its own unknown.
  double second() const { return k_[0][0] / (k_[0][0] * k_[1][1] - k_[0][1] * k_[1][0]); }

 private:
  double k_[2][2]{{1, 0}, {0, 1}};
};

}  // namespace twum::inline v0_1::core
