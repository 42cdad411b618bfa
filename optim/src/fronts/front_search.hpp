// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fronts/front.hpp"
#include "search/stage_runner.hpp"

namespace twum::inline v0_1::optim {

/// One design of a front under construction.
struct Solved {
  std::vector<double> unit;
  std::vector<double> scaled;  ///< objectives, minimized and scaled by their gradients
  std::vector<double> y;       ///< the same, scaled between ideal (0) and nadir (1) of the ends
  Evaluation evaluation;
  std::vector<double> design;
};

/// Searches that fronts of two and three objectives share: the ends, and single points between them.
class FrontSearch {
 public:
  FrontSearch(const Problem& problem, const SolveOptions& solve, const ParetoOptions& options,
              const Deadline& deadline)
      : runner_(problem, solve, deadline), options_(options) {}

  StageRunner& runner() { return runner_; }

  /// Finds the lexicographic optimum of every objective, from the default starts and the given ones. False if one of
  /// them has no feasible design.
  bool find_ends(std::vector<std::vector<double>> starts);

  /// Solves min t, F - n t <= m in normalized objectives, from the first start that succeeds; with `all`, from every
  /// start, and returns the best.
  std::optional<Solved> scalarize(const std::vector<double>& m, const std::vector<double>& n,
                                  const std::vector<std::vector<double>>& starts, bool all);

  /// The same from one start, holding the variables that are at the same bound in both neighbours. Nothing if there
  /// are no such variables.
  std::optional<Solved> scalarize_within(const std::vector<double>& m, const std::vector<double>& n,
                                         const std::vector<double>& start, const Solved& a,
                                         const Solved& b);

  /// The same, holding the variables that are equal in both neighbours, since usually few vary along a front. Nothing
  /// unless the point is Pareto stationary in all variables.
  std::optional<Solved> scalarize_predicted(const std::vector<double>& m,
                                            const std::vector<double>& n, const Solved& a,
                                            const Solved& b);

  /// Adds a design to start from; before find_ends().
  void add_to_pool(const std::vector<double>& unit, const Evaluation& evaluation);

  /// The pool's unit design nearest to a point in normalized objectives; empty without a pool.
  std::vector<double> from_pool(const std::vector<double>& y) const;

  const std::vector<Solved>& ends() const { return ends_; }
  /// Whether nothing is left to search with, but for the certificates of the points.
  bool exhausted() const { return runner_.exhausted() || left() == 0; }

 private:
  std::size_t left() const;
  std::optional<Solved> best_of(const Formulation& formulation,
                                const std::vector<std::vector<double>>& starts,
                                std::vector<double> extra_start, bool all);
  Formulation ray(const std::vector<double>& m, const std::vector<double>& n) const;
  std::optional<Solved> best_alone(std::size_t objective,
                                   const std::vector<std::vector<double>>& starts);
  Solved improved_by_hops(std::size_t objective, Solved from);
  std::optional<std::pair<double, std::vector<double>>> stationarity(SolverRun& run,
                                                                     const Solved& s) const;
  bool make_stationary(SolverRun& run, Solved& s);
  std::optional<Solved> solved(SolverRun& run);
  bool fill(SolverRun& run, Solved& s);
  void snap_to_bounds(SolverRun& run, Solved& s);
  Formulation lexicographic(std::size_t objective, const Solved& first) const;
  void normalize(Solved& s) const;
  double sign(std::size_t k) const;

  StageRunner runner_;
  const ParetoOptions& options_;
  std::vector<Solved> ends_;
  std::vector<Solved> pool_;
  std::vector<double> ideal_;
  std::vector<double> span_;
};

/// The points of a front, in order of the first objective, not yet certified.
std::vector<Solved> two_objective_front(FrontSearch& search, const ParetoOptions& options);
std::vector<Solved> three_objective_front(FrontSearch& search, const ParetoOptions& options);

}  // namespace twum::inline v0_1::optim
