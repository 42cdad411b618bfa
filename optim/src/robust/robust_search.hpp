// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

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

/// The rounds of a robust search: solved from several starts, corrected by samples.
class RobustSearch {
 public:
  RobustSearch(const RobustProblem& problem, const RobustOptions& options);

  /// U3.1 from every start; the best answer.
  SolvedRound first_round(RobustGoal goal, const std::vector<double>& risks);
  /// The same round from one start.
  SolvedRound solve(std::shared_ptr<const RobustRound> round, std::span<const double> y);
  /// The goal under these risks, from a solved round and with its correction.
  SolvedRound solve_again(const SolvedRound& from, RobustGoal goal,
                          const std::vector<double>& risks);
  /// U4.5: samples and rounds until the sampled risk is the one aimed at.
  SolvedRound corrected(SolvedRound solved);
  /// One correction with a sample of this size, and the round after it.
  SolvedRound correct_once(const SolvedRound& solved, std::uint64_t products,
                           std::uint64_t replicate);
  /// p_any of the first target at a solved round, by the last sample drawn; and its standard error.
  const SampledRisk& last_risk() const noexcept { return last_risk_; }

  bool stopped() const { return options_.solve.stop.stop_requested(); }
  SamplePlan plan(std::uint64_t products, std::uint64_t replicate) const;
  const RobustTerms& terms() const noexcept { return terms_; }
  const std::vector<RobustRoundReport>& reports() const noexcept { return reports_; }
  const Counters& counters() const noexcept { return counters_; }
  std::span<const double> design(const SolvedRound& solved) const {
    return std::span(solved.result.design).first(problem_.design.variables.size());
  }

 private:
  std::vector<std::vector<double>> starts() const;
  Result search(const RobustRound& round, std::uint64_t number, std::span<const double> y,
                const std::string& solver, std::uint64_t stage);
  bool better(const Result& a, const Result& b) const;
  Correction correction(const SolvedRound& solved, const SamplePlan& plan);
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
