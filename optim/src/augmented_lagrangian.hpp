// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer.hpp"

#include <functional>

namespace twum::optim {

/// One side of a row, as solvers want it: sign * (c - limit) <= 0, or = 0.
struct OneSide {
  std::size_t row{0};
  double sign{1.0};
  double limit{0.0};
  bool equality{false};

  double of(const NlpValue& value) const { return without_dust(sign * (value.c[row] - limit)); }
};

/// The Lagrangian of Powell, Hestenes and Rockafellar for limits g <= 0 and h = 0,
///
///   L = f + rho/2 [ sum (h + lambda/rho)^2 + sum max(0, g + mu/rho)^2 ],
///
/// with the rules of Birgin & Martinez (Practical Augmented Lagrangian Methods, SIAM 2014, algorithm
/// 4.1; Conn, Gould & Toint, SIAM Journal on Numerical Analysis 28, 1991) for multipliers and penalty. Bounds stay
/// bounds of the inner search.
class AugmentedLagrangian {
 public:
  /// @param tolerance  largest violation, and multiplier over penalty of a limit with slack, at the end
  AugmentedLagrangian(std::vector<OneSide> limits, double tolerance);

  bool empty() const { return limits_.empty(); }
  double value(const NlpValue& v) const;
  std::vector<double> gradient(const NlpValue& v) const;

  /// Takes the first penalty from the start; later calls change nothing.
  void begin(const NlpValue& start);

  /// Takes the minimum of the present Lagrangian: new multipliers, and a larger penalty where the
  /// violation did not fall to half. False when there is no use in another minimization.
  bool advance(const NlpValue& minimum);

 private:
  double violation(std::size_t i, double g) const;

  std::vector<OneSide> limits_;
  std::vector<double> multipliers_;
  double tolerance_;
  double penalty_{10.0};
  double before_{kInfinity};
  double least_{kInfinity};
  int stalled_{0};
  bool begun_{false};
};

/// What the outer loop needs of the inner solver.
struct InnerSearch {
  std::function<RunReport(std::vector<double> z)> minimize;  ///< the present Lagrangian, from z
  /// Values and, for inner solvers with derivatives, gradients; null where there are none.
  std::function<const NlpValue*(std::span<const double> z)> look;
  std::function<bool()> halted;  ///< asked after each search and each look
};

/// Minimizes the Lagrangian and advances it, in turns, at most 50 times. Where a run is begun again
/// (after a failed evaluation) the Lagrangian goes on where it was.
RunReport minimize(AugmentedLagrangian& lagrangian, const InnerSearch& inner,
                   std::vector<double> z);

}  // namespace twum::optim
