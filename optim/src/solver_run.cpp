// SPDX-License-Identifier: Apache-2.0
#include "solver_run.hpp"

#include "polish.hpp"

#include <cmath>

namespace twum::optim {
namespace {

// Calls after which a local search is given up, within the quota.
std::size_t local_calls(const SolverInfo& solver, std::size_t n) {
  if (solver.global) return static_cast<std::size_t>(-1);
  return (solver.gradient ? 1000 : 3000) + 300 * n;
}

// Newton steps are not worth their evaluations if the design is already accurate to many digits.
bool good_enough(const Certificate& c) {
  return c.passed && c.stationarity <= 1e-8 && c.infeasibility <= 1e-10;
}

// Whether b may replace a: it is not worse in anything that decides the outcome.
bool improves(const Certified& a, const Certified& b) {
  if (b.certificate.passed != a.certificate.passed) return b.certificate.passed;
  return std::max(b.certificate.stationarity, b.certificate.infeasibility) <
         std::max(a.certificate.stationarity, a.certificate.infeasibility);
}

void take(SolverRun& run, const Scaling& scaling, Certified&& better) {
  run.design = better.point.design;
  run.best->z = scaling.to_unit(run.design);
  run.best->violation = better.point.infeasibility;
  const Problem& problem = run.session->problem();
  const double sign = problem.objectives[0].sense == Sense::maximize ? -1.0 : 1.0;
  run.best->f = sign * scaling.factor(0) * better.point.evaluation.values[0];
  run.certified = std::move(better);
}

void polish_from(SolverRun& run, const Scaling& scaling, std::span<const double> design) {
  const auto polished = polish(*run.session, scaling, design);
  if (!polished) return;
  auto certified = certify_in(*run.session, scaling, *polished);
  if (certified && improves(*run.certified, *certified)) take(run, scaling, std::move(*certified));
}

}  // namespace

SolverRun run_solver(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                     const Scaling& scaling, const Formulation& formulation,
                     const SolverPlan& plan) {
  SolverRun run;
  run.solver = &plan.optimizer->info;
  run.session = std::make_unique<Session>(problem, options, deadline, plan.stage, plan.quota);
  Nlp nlp(*run.session, scaling, formulation);
  require_available(plan.optimizer->info);
  RunSettings settings;
  settings.seed = options.seed + 1000003 * plan.stage;
  settings.max_calls = local_calls(plan.optimizer->info, nlp.size());
  if (options.solver == plan.optimizer->info.name) settings.options = &options.solver_options;
  if (scaling.size() == 0) {
    try {
      nlp.at(plan.start, true);
    } catch (const Stop& s) {
      run.report.stop = s.reason;
    }
    run.report.word = "nothing to vary";
  } else {
    run.report = plan.optimizer->run(plan.optimizer->info, nlp, plan.start, settings);
  }
  // The solver only knows that it was stopped.
  if (run.report.stop == StopReason::evaluations) run.report.word = "max_evaluations";
  run.best = nlp.best();
  if (run.best) run.design = nlp.design(run.best->z);
  return run;
}

void finish_run(SolverRun& run, const Scaling& scaling) {
  if (!run.best) return;
  try {
    run.certified = certify_in(*run.session, scaling, run.design);
    if (!run.certified || !run.session->options().polish) return;
    if (good_enough(run.certified->certificate)) return;
    polish_from(run, scaling, run.design);
    if (run.certified->certificate.passed || run.report.z.empty()) return;
    const auto own = scaling.to_design(std::span<const double>(run.report.z).first(scaling.size()));
    if (own != run.design) polish_from(run, scaling, own);
  } catch (const Stop& s) {
    run.report.stop = s.reason;
  }
}

}  // namespace twum::optim
