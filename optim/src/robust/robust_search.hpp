// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/robust.hpp>

#include <memory>
#include <mutex>

namespace twum::optim {

/// A solved round: its problem, and what was found.
struct SolvedRound {
  std::shared_ptr<const RobustRound> round;
  Result result;

  bool feasible() const {
    return result.outcome == Outcome::optimal || result.outcome == Outcome::feasible;
  }
};

/// Risks that are wanted of the yield targets; of a goal one that leaves its indices free up to 6.
std::vector<double> wanted_risks(const RobustProblem& problem);
/// The smaller ones to aim at, U5.4.
std::vector<double> aimed_risks(const RobustProblem& problem);
/// U5.4: the risks to aim at next after fresh products.
std::vector<double> backed_off(const RobustProblem& problem, std::vector<double> risks,
                               const Verification& seen);
/// The verdict on the target that fares worst, U5.3.
YieldVerdict worst_verdict(const RobustProblem& problem, const Verification& seen);
/// How many fresh products tell the rarest of these risks, U5.1.
std::uint64_t products_for_rarest(const std::vector<double>& risks);

/// The rounds of a robust search: solved from several starts, corrected by samples.
class RobustSearch {
 public:
  RobustSearch(const RobustProblem& problem, const RobustOptions& options);

  /// U3.1 from every start; the best answer.
  SolvedRound first_round(const std::vector<RobustObjective>& goals,
                          const std::vector<double>& risks);
  /// The same round from one start.
  SolvedRound solve(std::shared_ptr<const RobustRound> round, std::span<const double> y);
  /// The goals under these risks, from a solved round and with its correction.
  SolvedRound solve_again(const SolvedRound& from, const std::vector<RobustObjective>& goals,
                          const std::vector<double>& risks);
  /// U4.5: samples and rounds until the sampled risk is the one aimed at.
  SolvedRound corrected(SolvedRound solved);
  /// One correction with a sample of this size, and the round after it.
  SolvedRound correct_once(const SolvedRound& solved, std::uint64_t products,
                           std::uint64_t replicate);
  /// One search of a problem made of a round's, from y.
  Result search(const Problem& problem, std::span<const double> y);
  /// The front of a round with several goals, from a design.
  Front front(const RobustRound& round, std::size_t points, std::span<const double> x);
  /// U4.4
  Correction correction(const SolvedRound& solved, const SamplePlan& plan);
  std::vector<double> risks_of(const RobustRound& round) const;
  /// The certificate of a solved round, measured anew without the caller's memory.
  Certificate certified(const SolvedRound& solved) const;
  /// Fresh products of a solved round's design; `attempt` names their stream. Where a yield above 99.99 % is wanted, weighted
  /// ones decide.
  Verification verified(const SolvedRound& solved, std::uint64_t products, std::uint64_t run) const;
  /// The goal of the problem at a solved round, whatever its own goal is; NaN where it has no value.
  double goal_at(const SolvedRound& solved) const;
  /// p_any of the first target at a solved round, by the last sample drawn; and its standard error.
  const SampledRisk& last_risk() const noexcept { return last_risk_; }

  bool stopped() const { return options_.solve.stop.stop_requested(); }
  SamplePlan plan(std::uint64_t products, std::uint64_t replicate) const;
  const RobustTerms& terms() const noexcept { return terms_; }
  const std::vector<RobustRoundReport>& reports() const noexcept { return reports_; }
  const Counters& counters() const noexcept { return counters_; }
  /// Rounds and stages from here on are free.
  std::uint64_t next_round() const noexcept { return next_round_; }
  std::uint64_t next_stage() const noexcept { return next_stage_; }
  std::span<const double> design(const SolvedRound& solved) const {
    return std::span(solved.result.design).first(problem_.design.variables.size());
  }

 private:
  std::vector<std::vector<double>> starts() const;
  Result search(const Problem& problem, std::uint64_t number, std::span<const double> y,
                const std::string& solver, std::uint64_t stage);
  SolveOptions options_for(std::uint64_t number, std::uint64_t stage);
  Problem remembered(Problem problem, std::uint64_t number) const;
  bool better(const Result& a, const Result& b) const;
  double moved(const SolvedRound& from, const SolvedRound& to) const;
  void book(const Result& result);

  const RobustProblem& problem_;
  const RobustOptions& options_;
  RobustTerms terms_;
  std::vector<RobustRoundReport> reports_;
  SampledRisk last_risk_;
  Counters counters_;
  std::uint64_t next_stage_;
  std::uint64_t next_round_{0};
  std::mutex observing_;
};

}  // namespace twum::optim
