// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/inverse_form.hpp"
#include "robust/joint_risk.hpp"
#include "robust/moments.hpp"

namespace twum::inline v0_1::optim {

/// One margin of the search. That of a yield target has a reliability index among the variables, that of a quantile a
/// fixed one.
struct RobustTerm {
  std::string name;
  Margin margin;
  std::optional<std::size_t> target;     ///< position of its yield target
  std::optional<std::size_t> statistic;  ///< position of its quantile
  double fixed_beta{0.0};                ///< of a quantile
};

/// The margins of a search: those of the targets, then those of the quantiles.
struct RobustTerms {
  explicit RobustTerms(const RobustProblem& problem);

  std::vector<RobustTerm> terms;
  std::vector<std::vector<std::size_t>> of_target;  ///< terms of each yield target
  std::size_t statistics{0};                        ///< of the problem

  /// Index of a term: a variable of the search, or fixed.
  double beta(std::span<const double> y, std::size_t variables, std::size_t term) const;
};

/// Corrections that a round holds fixed, U4.4; zero in the first round.
struct Correction {
  std::vector<double> delta;                   ///< of each term
  std::vector<double> kappa;                   ///< of each yield target
  std::vector<std::vector<Overlap>> overlaps;  ///< of each target, positions within it
  /// start directions of U3.2, one for each term; may be empty
  std::vector<std::vector<double>> directions;
  std::vector<double> shifts;  ///< of each statistic where it is limited, U5.8
  /// of each term, added to its index: where the normal law of measured rows has the margin that the rows have, U4.4a
  std::vector<double> offsets;

  static Correction none(const RobustTerms& terms);
};

/// A row of an objective or constraint over y = (x, beta).
struct LineOf {
  std::vector<double> slope;
  double value{0.0};
  std::string failure{};
};

/// The problem of one round, U3.1, in the design and the reliability indices y = (x, beta).
class RobustRound {
 public:
  /// @param risks  for each yield target, the share of products that may fail; not used for a goal
  /// @param seed   of the fixed sample of means and standard deviations
  RobustRound(const RobustProblem& problem, std::vector<RobustObjective> goals,
              std::vector<double> risks, Correction correction, std::uint64_t seed = 1);

  /// Its constraints: those of the design, G_j + delta_j >= 0 of each term of a target, the risk lines, the statistics.
  Problem problem() const;
  /// y of a design, with the same share of the risk for every limit.
  std::vector<double> start(std::span<const double> x) const;
  /// Solutions of U3.2 at y, one for each term.
  std::vector<InversePoint> points(std::span<const double> y) const;
  std::vector<double> betas(std::span<const double> y) const;
  /// ln R of a target at y.
  double log_risk(std::span<const double> y, std::size_t target) const;

  const RobustTerms& terms() const noexcept { return terms_; }
  const Correction& correction() const noexcept { return correction_; }
  const std::vector<RobustObjective>& goals() const noexcept { return goals_; }
  /// Whether the share of a yield target is a goal.
  bool is_goal(std::size_t target) const;
  /// Whether its only goal is a largest yield.
  bool seeks_yield() const { return goals_.size() == 1 && goals_[0].kind == RobustGoal::yield; }
  /// The value of a goal from the value of its row in the problem.
  double goal_value(double objective, std::size_t goal = 0) const;
  /// A statistic at y, whose points() are these.
  Moment statistic(std::span<const double> y, std::size_t statistic,
                   const std::vector<InversePoint>& worst) const;
  double risk(std::size_t target) const { return risks_[target]; }
  /// Name of the constraint of U3.1 that limits a target's risk.
  std::string risk_line(std::size_t target) const;

 private:
  Evaluation evaluate(std::span<const double> y, bool gradient) const;
  LineOf design_row(std::span<const double> y, const Evaluation& design,
                    std::size_t response) const;
  LineOf margin_row(std::span<const double> y, const InversePoint& worst, std::size_t term) const;
  LineOf log_risk_row(std::span<const double> y, std::size_t target) const;
  LineOf statistic_row(std::span<const double> y, std::size_t index,
                       const std::vector<InversePoint>& worst) const;
  LineOf limited_statistic_row(std::span<const double> y, std::size_t index,
                               const std::vector<InversePoint>& worst) const;
  LineOf goal_row(std::span<const double> y, const RobustObjective& goal, const Evaluation& design,
                  const std::vector<InversePoint>& worst) const;
  std::size_t variables() const { return problem_.design.variables.size(); }

  const RobustProblem& problem_;
  std::vector<RobustObjective> goals_;
  RobustTerms terms_;
  std::vector<double> risks_;
  Correction correction_;
  std::vector<std::vector<double>> sample_;  // of means and standard deviations
};

}  // namespace twum::inline v0_1::optim
