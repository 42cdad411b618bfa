// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

namespace twum::inline v0_1::optim {

/// One design of a Pareto front.
struct FrontPoint {
  std::vector<double> design{};  ///< user units
  Evaluation evaluation{};       ///< of that design
  /// Pareto stationarity; its weights are the trade-off between the objectives
  Certificate certificate{};
};

/// Options of pareto_front().
struct ParetoOptions {
  SolveOptions solve{};  ///< starts, tolerances, seed, budget, stop, observer; `solver` is not used
  std::size_t points{100};  ///< largest number of points; >= 1
  /// reference point of the hypervolume, user units; empty: a tenth of the front's span beyond its worst values
  std::vector<double> reference{};
  /// number of points that are searched from several starts, to find disconnected pieces of the front
  std::size_t coarse{12};
  std::size_t coarse_starts{3};  ///< low-discrepancy starts for each of them
  /// Basin hopping for an end of the front stops after this many random steps in a row without success. It is used
  /// where the starts lead to different optima.
  std::size_t hops{200};
  /// If > 0, so many evaluations are spent on nsga2() first, in at least one population of 100. Its front then
  /// provides starts.
  std::size_t population_evaluations{0};
};

/// A Pareto front of two or three objectives.
struct Front {
  Outcome outcome{Outcome::failed};  ///< optimal: every point certified; feasible: some were not
  std::vector<FrontPoint> points{};  ///< nondominated points in order of the first objective
  std::vector<double> reference{};   ///< user units
  double hypervolume{0.0};           ///< in the product of the objectives' units
  Infeasibility infeasibility{};     ///< filled when no design is feasible
  Counters counters{};               ///< of all stages
  StopReason stop{StopReason::finished};  ///< why it ended
  double seconds{0.0};                    ///< wall time
  std::uint64_t stages_used{0};  ///< the next solve may begin with stage first_stage + stages_used
};

/// Computes the Pareto front of two or three objectives with gradients.
///
/// The ends of the front are found first, each as a lexicographic optimum. Every other point solves
///
///     min t   with   F_k(x) - n_k t <= m_k  for every objective k
///
/// (Pascoletti and Serafini), started from its neighbours. With two objectives, m and n follow the widest gap between
/// neighbours, which finds the ends of disconnected pieces exactly. Twice the requested number of points is computed,
/// and those with the largest hypervolume are kept. With three objectives, n runs over a lattice of directions from
/// the ideal point. The test problems of docs/optimization.md take 22 to 89 evaluations for each point. With integer
/// variables, each of their combinations (at most 64) has a front of its own and an equal share of the budget. The
/// result holds the points that no other point dominates, certified with the integers fixed. Threads and
/// reproducibility are as for solve().
///
/// @throws InputError if validate() refuses the problem, for one or more than three objectives, for no points, and
///         for more than 64 combinations of integers.
Front pareto_front(const Problem& problem, const ParetoOptions& options = {});

/// Options of NSGA-II.
struct Nsga2Options {
  std::size_t population{100};  ///< even, >= 4
  /// each costs `population` evaluations, and so does the initial population
  std::size_t generations{250};
  double crossover{0.9};         ///< probability, simulated binary crossover
  double crossover_index{15.0};  ///< a larger index keeps children nearer to their parents
  double mutation_index{
      20.0};  ///< polynomial mutation; its probability is 1 over the number of variables
  std::vector<double> reference{};  ///< as in ParetoOptions
  /// Used are seed, budget, stop, observer, and feasibility_tolerance, which is relative to 1 + |limit| here.
  SolveOptions solve{};
};

/// Deb's NSGA-II with constraint domination. It needs no gradients and shares no code with pareto_front(), so that
/// one checks the other. Failed designs rank behind all others. Points carry no certificate; the outcome is feasible,
/// infeasible, budget or failed.
/// @throws InputError as pareto_front(), except that integer variables are allowed here
Front nsga2(const Problem& problem, const Nsga2Options& options = {});

}  // namespace twum::inline v0_1::optim
