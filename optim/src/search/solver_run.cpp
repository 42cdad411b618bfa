// SPDX-License-Identifier: Apache-2.0
#include "search/solver_run.hpp"

#include "certificate/polish.hpp"

#include <cmath>

namespace twum::inline v0_1::optim {
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

void take(SolverRun& run, Certified&& better) {
  run.design = better.point.design;
  run.best->values = better.point.evaluation.values;
  run.best->violation = better.certificate.infeasibility;
  run.certified = std::move(better);
}

void polish_from(SolverRun& run, const Scaling& scaling, std::span<const double> design) {
  const auto polished = polish(*run.session, scaling, design);
  if (!polished) return;
  auto certified = certify_in(*run.session, scaling, *polished);
  if (certified && improves(*run.certified, *certified)) take(run, std::move(*certified));
}

RunSettings settings_for(const SolverInfo& solver, const SolveOptions& options, const Nlp& nlp,
                         std::uint64_t stage) {
  RunSettings settings;
  settings.seed = options.seed + 1000003 * stage;
  settings.max_calls = local_calls(solver, nlp.size());
  if (options.solver == solver.name) settings.options = &options.solver_options;
  return settings;
}

// The start is looked at first: limits are scaled and tolerated by what is seen there, and a solver that refuses the
// problem leaves it in the archive.
void run_in(SolverRun& run, const Scaling& scaling, const Formulation& formulation,
            const SolverPlan& plan) {
  require_available(plan.optimizer->info);
  Nlp nlp(*run.session, scaling, formulation);
  if (!plan.known.empty()) nlp.expect(plan.known);
  try {
    nlp.at(plan.start, true);
    run.report.word = "nothing to vary";
    if (scaling.size() > 0)
      run.report = plan.optimizer->run(
          plan.optimizer->info, nlp, plan.start,
          settings_for(plan.optimizer->info, run.session->options(), nlp, plan.stage));
  } catch (const Stop& s) {
    run.report.stop = s.reason;
  }
  // The solver only knows that it was stopped.
  if (run.report.stop == StopReason::evaluations) run.report.word = "max_evaluations";
  run.best = nlp.best();
  if (run.best) run.design = nlp.design(run.best->z);
  if (!run.report.z.empty()) run.final_design = nlp.design(run.report.z);
}

SolverRun opened(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                 const SolverPlan& plan) {
  SolverRun run;
  run.solver = &plan.optimizer->info;
  run.session = std::make_unique<Session>(problem, options, deadline, plan.stage, plan.quota);
  return run;
}

}  // namespace

SolverRun run_solver(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                     const Scaling& scaling, const Formulation& formulation,
                     const SolverPlan& plan) {
  SolverRun run = opened(problem, options, deadline, plan);
  run_in(run, scaling, formulation, plan);
  return run;
}

SolverRun run_solver_from(const Problem& problem, const SolveOptions& options,
                          const Deadline& deadline, const SolverPlan& plan,
                          const std::vector<double>& design, const Known& known) {
  SolverRun run = opened(problem, options, deadline, plan);
  if (known.evaluation != nullptr && plan.quota > 0)
    run.session->remember(known.design, *known.evaluation);
  Scaling scaling(problem, search_sizes(problem, design));
  try {
    const Evaluation& e = run.session->at(design, true);
    if (e.ok()) scaling.scale_responses(design, e);
  } catch (const Stop& s) {
    run.report.stop = s.reason;
    return run;
  }
  SolverPlan own = plan;
  own.start = scaling.to_unit(design);
  run_in(run, scaling, plain_formulation(problem, scaling), own);
  return run;
}

void finish_run(SolverRun& run, const Scaling& scaling) {
  if (!run.best) return;
  try {
    run.certified = certify_in(*run.session, scaling, run.design);
    if (!run.certified || !run.session->options().polish) return;
    if (good_enough(run.certified->certificate)) return;
    polish_from(run, scaling, run.design);
    if (run.certified->certificate.passed || run.final_design.empty()) return;
    if (run.final_design != run.design) polish_from(run, scaling, run.final_design);
  } catch (const Stop& s) {
    run.report.stop = s.reason;
  }
}

}  // namespace twum::inline v0_1::optim
