// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver_run.hpp"

namespace twum::optim {

/// Bookkeeping of one solve: the budget shared by stages, counters, stage numbers, and the clock.
class StageRunner {
 public:
  /// Keeps references. A nested runner takes the clock of its outer solve.
  StageRunner(const Problem& problem, const SolveOptions& options, const Deadline& deadline);

  /// Computes scale factors at the start. If it cannot be evaluated, takes the first low-discrepancy point that can
  /// as the start. False if none can, or if the budget is used up.
  bool scale();

  /// One attempt on the plain problem in its own stage.
  SolverRun run(const Optimizer& optimizer, std::span<const double> unit_start, bool last_word);
  /// @param most  evaluations that it may use, at most those left
  SolverRun run(const Optimizer& optimizer, const Formulation& formulation,
                std::span<const double> start, std::size_t most = static_cast<std::size_t>(-1));

  /// The same solver from several starts, in parallel if the options say so; in order of starts.
  std::vector<SolverRun> run_all(const Optimizer& optimizer,
                                 const std::vector<std::vector<double>>& starts);

  /// Allows a stage `wanted` more calls, or as many as are left in the budget.
  void allow(SolverRun& run, std::size_t wanted);

  /// Certifies and polishes within the reserve.
  void finish(SolverRun& run);

  /// Adds the calls of a stage to the counters and the report; may be called again after further calls.
  void book(SolverRun& run);

  /// Adds a nested solve.
  void book(const Result& nested);

  bool exhausted() const;
  StopReason stop_reason() const;

  /// Outcome if no design could be evaluated.
  Outcome without_design() const;
  std::size_t left() const;
  const Problem& problem() const { return problem_; }
  const SolveOptions& options() const { return options_; }
  const Deadline& deadline() const { return deadline_; }
  const Scaling& scaling() const { return scaling_; }
  const Counters& counters() const { return counters_; }
  const std::vector<StageReport>& stages() const { return stages_; }
  std::uint64_t next_stage() const { return next_stage_; }
  std::uint64_t take_stage() { return next_stage_++; }
  std::vector<double> unit_start() const { return scaling_.to_unit(start_); }

 private:
  std::size_t reserve() const;
  void note_stop(StopReason reason);

  const Problem& problem_;
  const SolveOptions& options_;
  const Deadline& deadline_;
  Scaling scaling_;
  std::vector<double> start_;
  Counters counters_;
  std::vector<StageReport> stages_;
  std::uint64_t next_stage_;
  StopReason stop_{StopReason::finished};
};

}  // namespace twum::optim
