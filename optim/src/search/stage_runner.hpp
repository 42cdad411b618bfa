// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/first_design.hpp"
#include "search/solver_run.hpp"

namespace twum::inline v0_1::optim {

/// Bookkeeping of one solve: the budget shared by stages, counters, stage numbers, and the clock.
class StageRunner {
 public:
  /// Keeps references. A nested runner takes the clock of its outer solve.
  StageRunner(const Problem& problem, const SolveOptions& options, const Deadline& deadline);

  /// What scaling() is made of: the ranges of the variables, or their magnitudes at the start.
  enum class Frame : std::uint8_t { range, point };

  /// Computes scaling() at the start. If it cannot be evaluated, takes the first low-discrepancy point that can as the
  /// start. False if none can, or if the budget is used up.
  bool scale(Frame frame = Frame::range);

  /// One attempt on the plain problem in its own stage, scaled at the design it starts from.
  SolverRun run(const Optimizer& optimizer, const std::vector<double>& design, bool last_word);
  /// @param most  evaluations that it may use, at most those left
  SolverRun run(const Optimizer& optimizer, const Formulation& formulation,
                std::span<const double> start, std::size_t most = static_cast<std::size_t>(-1));

  /// The same solver from several starts, in parallel if the options say so; in order of starts.
  /// @param known  design of an optimum; a run that comes to it ends there. May be empty.
  std::vector<SolverRun> run_all(const Optimizer& optimizer,
                                 const std::vector<std::vector<double>>& starts,
                                 std::span<const double> known);

  /// Whether objective and limits at an optimum, at the start and at these designs agree with a convex problem. Costs an
  /// evaluation with Jacobian for each of the designs.
  bool looks_convex(const Certified& optimum, const std::vector<std::vector<double>>& designs);

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
  const std::vector<double>& start() const { return start_; }
  std::vector<double> unit_start() const { return scaling_.to_unit(start_); }
  /// The ranges of the variables as [0, 1], responses scaled at the start.
  Scaling ranges() const;
  /// Largest violation of a limit, scaled at the start: ranks designs that break limits.
  double excess(const std::vector<double>& values) const;

 private:
  std::size_t reserve() const;
  void note_stop(StopReason reason);

  const Problem& problem_;
  const SolveOptions& options_;
  const Deadline& deadline_;
  Scaling scaling_;
  std::vector<double> start_;
  Evaluation first_;
  Counters counters_;
  std::vector<StageReport> stages_;
  std::uint64_t next_stage_;
  StopReason stop_{StopReason::finished};
};

}  // namespace twum::inline v0_1::optim
