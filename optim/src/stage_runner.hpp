// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver_run.hpp"

namespace twum::optim {

/// The book-keeping of one solve: budget shared between stages, counters, stage numbers, clock.
class StageRunner {
 public:
  /// Keeps references. A nested runner gives the clock of the solve it belongs to.
  StageRunner(const Problem& problem, const SolveOptions& options, const Deadline& deadline);

  /// Finds scale factors from the start or, where it cannot be evaluated, from the first of some
  /// low-discrepancy points that can, which then is the start. False if none can or nothing is left of the
  /// budget.
  bool scale();

  /// One attempt on the plain problem in its own stage.
  SolverRun run(const Optimizer& optimizer, std::span<const double> unit_start, bool last_word);
  /// @param most  evaluations it may use, of those left
  SolverRun run(const Optimizer& optimizer, const Formulation& formulation,
                std::span<const double> start, std::size_t most = static_cast<std::size_t>(-1));

  /// The same solver from several starts, in parallel if the options say so; in order of starts.
  std::vector<SolverRun> run_all(const Optimizer& optimizer,
                                 const std::vector<std::vector<double>>& starts);

  /// Lets a stage make as many more calls as are wanted, or as the budget has left.
  void allow(SolverRun& run, std::size_t wanted);

  /// Certifies and polishes within the reserve.
  void finish(SolverRun& run);

  /// Adds what a stage used to the counters and the report; may be called again after more use.
  void book(SolverRun& run);

  /// Adds a nested solve.
  void book(const Result& nested);

  bool exhausted() const;
  StopReason stop_reason() const;

  /// What to say where no design could be looked at.
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
