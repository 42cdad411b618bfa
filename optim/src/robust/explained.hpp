// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/robust_search.hpp"

namespace twum::inline v0_1::optim {

/// Sensitivities of a solved round to limits and tolerances, U6.1 to U6.5. What follows from the distribution of the failing
/// products is missing with measured rows, whose failures are not those of their normal law (U1.11).
class Explained {
 public:
  /// Keeps references to both.
  Explained(const RobustProblem& problem, const SolvedRound& solved);

  std::vector<RiskShare> risks(const Verification& verified) const;
  /// U6.2, U6.3, U6.5. If the goal is a yield, the gains are those of the yield; if it is a standard deviation, those
  /// of the standard deviation.
  std::vector<TolerancePrice> prices() const;
  /// U6.4
  double price_of_yield() const;
  /// Derivative of the goal with respect to the round's objective, which is ln R for a yield and the variance for a
  /// standard deviation.
  double per_objective() const;

 private:
  bool fail_by_law() const { return problem_.measured.empty(); }
  double multiplier(const std::string& name) const;
  double multiplier(std::size_t term) const;
  double by_spread(std::size_t term, std::size_t input) const;
  double gain_of_margins(std::size_t input) const;
  double gain_of_statistics(std::size_t input) const;

  const RobustProblem& problem_;
  const RobustRound& round_;
  const Certificate& certificate_;
  const std::vector<double>& y_;
  std::vector<InversePoint> points_;
  std::vector<double> beta_;
  std::vector<Moment> statistics_;
};

}  // namespace twum::inline v0_1::optim
