// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solvers/optimizer.hpp"

#include <functional>

namespace twum::inline v0_1::optim {

/// One side of a constraint row in the form of solvers: sign * (c - limit) <= 0, or = 0.
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
  /// @param tolerance  at the end, largest violation and largest multiplier over penalty of a limit with slack
  AugmentedLagrangian(std::vector<OneSide> limits, double tolerance);

  bool empty() const { return limits_.empty(); }
  double value(const NlpValue& v) const;
  std::vector<double> gradient(const NlpValue& v) const;

  /// Computes the first penalty from the start; later calls change nothing.
  void begin(const NlpValue& start);

  /// Updates the multipliers at the minimum of the current Lagrangian, and increases the penalty if the violation has
  /// not halved. False if another minimization is of no use.
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

/// The inner solver as the outer loop uses it.
struct InnerSearch {
  /// minimizes the current Lagrangian from z
  std::function<RunReport(std::vector<double> z)> minimize;
  /// Returns values and, for inner solvers with derivatives, gradients; null if they cannot be evaluated.
  std::function<const NlpValue*(std::span<const double> z)> look;
  /// called after each search and each evaluation; true ends the loop
  std::function<bool()> halted;
};

/// Minimizes and advances the Lagrangian alternately, at most 50 times. If a run is restarted after a failed
/// evaluation, the Lagrangian keeps its multipliers and penalty.
RunReport minimize(AugmentedLagrangian& lagrangian, const InnerSearch& inner,
                   std::vector<double> z);

}  // namespace twum::inline v0_1::optim
