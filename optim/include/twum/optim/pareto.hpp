// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

namespace twum::optim {

/// One design of a front.
struct FrontPoint {
  std::vector<double> design;  ///< user units
  Evaluation evaluation;       ///< of that design
  Certificate certificate;     ///< Pareto stationarity; its weights say how the objectives trade
};

/// How to find a front.
struct ParetoOptions {
  SolveOptions solve;  ///< starts, tolerances, seed, budget, stop, observer; `solver` is not used
  std::size_t points{100};  ///< of the front, at most; >= 1
  std::vector<double>
      reference;  ///< of the hypervolume, user units; empty: a tenth of the front's span beyond its worst
  std::size_t coarse{
      12};  ///< points searched from several starts, to find pieces of the front far apart
  std::size_t coarse_starts{3};  ///< low-discrepancy starts for each of them
  std::size_t hops{200};  ///< kicks in a row without success that end the search for an end of the
                          ///< front, where its starts lead to different places
  /// If > 0, spent on nsga2() first, in whole populations of 100, one at least; its front then gives
  /// starts.
  std::size_t population_evaluations{0};
};

/// A trade-off.
struct Front {
  Outcome outcome{Outcome::failed};  ///< optimal: every point certified; feasible: some were not
  std::vector<FrontPoint> points;    ///< none dominated; in order of the first objective
  std::vector<double> reference;     ///< user units
  double hypervolume{0.0};           ///< product of the objectives' units
  Infeasibility infeasibility;       ///< filled when no design is feasible
  Counters counters;                 ///< of all stages
  StopReason stop{StopReason::finished};  ///< why it ended
  double seconds{0.0};                    ///< wall time
  std::uint64_t stages_used{0};           ///< first_stage + stages_used is free for the next solve
};

/// The trade-off between two or three objectives, from gradients.
///
/// The ends are found first, each as a lexicographic optimum. Every other point solves
///
///     min t   with   F_k(x) - n_k t <= m_k  for every objective k
///
/// (Pascoletti and Serafini), warm-started from its neighbours. With two objectives m and n follow
/// the widest gap between neighbours, which finds the ends of disconnected pieces exactly; of twice
/// the points asked for, those with the largest hypervolume stay. With three, n runs over a lattice
/// of directions from the ideal point. On the test problems of docs/optimization.md it takes 22 to 89
/// evaluations a point. With integer variables each of their combinations, at most 64, is a front of its own with an equal
/// share of the budget; the answer holds what no other point dominates, certified with its integers held. What solve() says of threads and of the answer's causes holds here.
///
/// @throws InputError for a problem that cannot be posed, one or more than three objectives, no
///         points, more than 64 combinations of integers.
Front pareto_front(const Problem& problem, const ParetoOptions& options = {});

/// How NSGA-II searches.
struct Nsga2Options {
  std::size_t population{100};   ///< even, >= 4
  std::size_t generations{250};  ///< each costs `population` evaluations, as the first one does
  double crossover{0.9};         ///< probability, simulated binary crossover
  double crossover_index{15.0};  ///< larger: children nearer to their parents
  double mutation_index{
      20.0};  ///< polynomial mutation; its probability is 1 over the number of variables
  std::vector<double> reference;  ///< as in ParetoOptions
  /// Of these seed, budget, stop, observer, and feasibility_tolerance: here relative to 1 + |limit|.
  SolveOptions solve;
};

/// Deb's NSGA-II with constraint domination: a second way to a front that shares nothing with the
/// first and needs no gradients. Failed designs rank behind all others. Points carry no
/// certificate; the outcome is feasible, infeasible, budget or failed.
/// @throws InputError as pareto_front(), except that integer variables are allowed here
Front nsga2(const Problem& problem, const Nsga2Options& options = {});

}  // namespace twum::optim
