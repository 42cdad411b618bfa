// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/certify.hpp"
#include "solvers/optimizer.hpp"

#include <memory>

namespace twum::inline v0_1::optim {

/// One run of one solver from one start, with its result. Its session stays open, so that polish and certificate can
/// follow within the same stage.
struct SolverRun {
  const SolverInfo* solver{nullptr};
  std::unique_ptr<Session> session;
  RunReport report;
  std::optional<Candidate> best;
  std::vector<double> design;        ///< of `best`
  std::vector<double> final_design;  ///< where the solver itself ended; may be empty
  std::optional<Certified> certified;
  Counters booked;  ///< counts of this stage that are already in the solve's counters
  bool reported{false};
  bool slackened{false};  ///< limits have slacks, which `best->violation` leaves out
};

struct SolverPlan {
  const Optimizer* optimizer{nullptr};
  std::uint64_t stage{0};
  std::size_t quota{0};
  std::vector<double> start;        ///< unit box, then extra unknowns
  std::span<const double> known{};  ///< design of an optimum beside which the run ends, or nothing
};

/// Runs a solver on a formulation. @throws what the evaluator throws, InputError
SolverRun run_solver(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                     const Scaling& scaling, const Formulation& formulation,
                     const SolverPlan& plan);

/// An evaluation that is known already.
struct Known {
  std::span<const double> design;
  const Evaluation* evaluation{nullptr};
};

/// Runs a solver on the plain problem, scaled at the design it starts from.
/// @param plan  without a start
SolverRun run_solver_from(const Problem& problem, const SolveOptions& options,
                          const Deadline& deadline, const SolverPlan& plan,
                          const std::vector<double>& design, const Known& known = {});

/// Certifies the best design of the run, polishes it if it is nearly optimal, and keeps the better of the two. For
/// plain formulations with one objective.
void finish_run(SolverRun& run, const Scaling& scaling);

}  // namespace twum::inline v0_1::optim
