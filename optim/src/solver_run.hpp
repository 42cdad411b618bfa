// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certify.hpp"
#include "optimizer.hpp"

#include <memory>

namespace twum::optim {

/// One run of one solver from one start, with what it found. Its session stays open so that the
/// finish (polish, certificate) can go on within the same stage.
struct SolverRun {
  const SolverInfo* solver{nullptr};
  std::unique_ptr<Session> session;
  RunReport report;
  std::optional<Candidate> best;
  std::vector<double> design;  ///< of `best`
  std::optional<Certified> certified;
  Counters booked;  ///< what of this stage the solve's counters hold already
  bool reported{false};
};

struct SolverPlan {
  const Optimizer* optimizer{nullptr};
  std::uint64_t stage{0};
  std::size_t quota{0};
  std::vector<double> start;  ///< unit box, then extra unknowns
};

/// Runs a solver on a formulation. @throws what the evaluator throws, InputError
SolverRun run_solver(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                     const Scaling& scaling, const Formulation& formulation,
                     const SolverPlan& plan);

/// Certifies the attempt's best design, lets Newton steps finish it if it is nearly optimal, and
/// keeps whichever of the two is better. For formulations of one objective in plain form.
void finish_run(SolverRun& run, const Scaling& scaling);

}  // namespace twum::optim
