// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/centres.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/robust.hpp>

#include <memory>
#include <mutex>

namespace twum::inline v0_1::optim {

/// A solved round: its problem and its result.
struct SolvedRound {
  std::shared_ptr<const RobustRound> round;
  Result result;

  bool feasible() const {
    return result.outcome == Outcome::optimal || result.outcome == Outcome::feasible;
  }
};

/// Wanted risks of the yield targets; for a goal, a risk so small that its indices are free up to 6.
std::vector<double> wanted_risks(const RobustProblem& problem);
/// The smaller risks to aim at, U5.4.
std::vector<double> aimed_risks(const RobustProblem& problem);
/// U5.4: the risks to aim at next, after an independent sample.
std::vector<double> backed_off(const RobustProblem& problem, std::vector<double> risks,
                               const Verification& seen);
/// The verdict on the target or the limited statistic with the worst result, U5.3, U5.7.
YieldVerdict worst_verdict(const RobustProblem& problem, const Verification& seen);
/// Whether the intervals of all yields show less than half of the risk that is allowed: more products would not change
/// the verdict, U5.3a. False if a yield is a goal.
bool all_far_above_wanted(const RobustProblem& problem, const std::vector<YieldEstimate>& yields);
/// Number of independent products needed for the rarest of these risks, U5.1.
std::uint64_t products_for_rarest(const std::vector<double>& risks);

/// The rounds of a robust search: solved from several starts, corrected by samples.
class RobustSearch {
 public:
  RobustSearch(const RobustProblem& problem, const RobustOptions& options);

  /// Solves U3.1 from every start and returns the best answer.
  SolvedRound first_round(const std::vector<RobustObjective>& goals,
                          const std::vector<double>& risks);
  /// The same round from one start.
  SolvedRound solve(std::shared_ptr<const RobustRound> round, std::span<const double> y);
  /// Solves for goals under these risks, starting from a solved round and with its correction.
  SolvedRound solve_again(const SolvedRound& from, const std::vector<RobustObjective>& goals,
                          const std::vector<double>& risks);
  /// The same with other shifts of the limited statistics, U5.8.
  SolvedRound solve_again(const SolvedRound& from, const std::vector<RobustObjective>& goals,
                          const std::vector<double>& risks, std::vector<double> shifts);
  /// The shifts with which the next independent sample is likely to confirm the limited statistics.
  std::vector<double> shifts_after(const SolvedRound& solved, const Verification& seen) const;
  /// U4.5: alternates samples and rounds until the sampled risk equals the one aimed at.
  SolvedRound corrected(SolvedRound solved);
  /// Whether a limit that scatters holds the goal back at a solved round, so that the answer rests on its risk.
  bool risks_bind(const SolvedRound& solved) const;
  /// One correction with a sample of this size, followed by one round.
  SolvedRound correct_once(const SolvedRound& solved, std::uint64_t products,
                           std::uint64_t replicate);
  /// One search of a problem derived from that of a round, from y.
  Result search(const Problem& problem, std::span<const double> y);
  /// The front of a round with several goals, from a design.
  Front front(const RobustRound& round, std::size_t points, std::span<const double> x);
  /// U4.4
  Correction correction(const SolvedRound& solved, const SamplePlan& plan);
  std::vector<double> risks_of(const RobustRound& round) const;
  /// The certificate of a solved round, computed without the caller's stored evaluations.
  Certificate certified(const SolvedRound& solved) const;
  /// An independent sample of products of a solved round's design; `attempt` selects the random numbers. If a yield
  /// above 99.99 % is wanted, importance samples decide.
  Verification verified(const SolvedRound& solved, std::uint64_t products, std::uint64_t run) const;
  /// The goal of the robust problem at a solved round, which may have another goal; NaN if it has no value.
  double goal_at(const SolvedRound& solved) const;
  /// p_any of the first target at a solved round, by the last sample drawn; and its standard error.
  const SampledRisk& last_risk() const noexcept { return last_risk_; }

  bool stopped() const { return options_.solve.stop.stop_requested(); }
  SamplePlan plan(std::uint64_t products, std::uint64_t replicate) const;
  const RobustTerms& terms() const noexcept { return terms_; }
  const std::vector<RobustRoundReport>& reports() const noexcept { return reports_; }
  const Counters& counters() const noexcept { return counters_; }
  /// Rounds and stages from these numbers on are unused.
  std::uint64_t next_round() const noexcept { return next_round_; }
  std::uint64_t next_stage() const noexcept { return next_stage_; }
  std::span<const double> design(const SolvedRound& solved) const {
    return std::span(solved.result.design).first(problem_.design.variables.size());
  }

 private:
  std::vector<std::vector<double>> starts() const;
  bool risks_bind(const RobustRound& round, const Certificate& certificate) const;
  double clearance(const ImportanceSample& sample, std::size_t term) const;
  void correct_law(const SolvedRound& solved, std::size_t term, double margin, InversePoint at,
                   Correction& next) const;
  Correction first_correction(const std::vector<RobustObjective>& goals,
                              const std::vector<double>& risks);
  Centres centres(const SolvedRound& solved) const;
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

}  // namespace twum::inline v0_1::optim
