// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/own_solver.hpp>

#include "solvers/optimizer.hpp"

namespace twum::inline v0_1::optim {
namespace {

ScaledProblem scaled_problem(Nlp& nlp, std::span<const double> start, const RunSettings& settings) {
  ScaledProblem problem;
  problem.lower = nlp.lower();
  problem.upper = nlp.upper();
  for (std::size_t i = 0; i < nlp.rows(); ++i) {
    problem.row_lower.push_back(nlp.row(i).lower);
    problem.row_upper.push_back(nlp.row(i).upper);
  }
  problem.start.assign(start.begin(), start.end());
  problem.seed = settings.seed;
  problem.evaluate = [&nlp, left = settings.max_calls](
                         std::span<const double> z,
                         bool gradient) mutable -> std::optional<ScaledValues> {
    if (left-- == 0) throw Stop{StopReason::finished};
    const NlpValue* value = nlp.at(z, gradient);
    if (value == nullptr) return std::nullopt;
    if (!gradient) return ScaledValues{value->f, value->c, {}, {}};
    return ScaledValues{value->f, value->c, value->df, value->dc};
  };
  return problem;
}

}  // namespace

Optimizer own_optimizer(SolverInfo info, OwnSolver solver) {
  return {std::move(info),
          [solver = std::move(solver)](const SolverInfo&, Nlp& nlp, std::span<const double> start,
                                       const RunSettings& settings) {
            require_known_options(settings, {});
            solver(scaled_problem(nlp, start, settings));
            return RunReport{.word = "returned", .z = {}};
          }};
}

}  // namespace twum::inline v0_1::optim
