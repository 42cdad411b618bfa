// SPDX-License-Identifier: Apache-2.0
#include "attempt.hpp"

#include "polish.hpp"

#include <cmath>

namespace twum::optim {
namespace {

// Calls after which a local search that still runs is taken to be lost; the quota rules as well.
std::size_t local_calls(const SolverInfo& solver, std::size_t n) {
  if (solver.global) return static_cast<std::size_t>(-1);
  return (solver.gradient ? 1000 : 3000) + 300 * n;
}

// Newton steps are worth their evaluations unless the design is right to many digits already.
bool good_enough(const Certificate& c) {
  return c.passed && c.stationarity <= 1e-8 && c.infeasibility <= 1e-10;
}

// Whether b may replace a: no worse in anything that the outcome rests on.
bool improves(const Certified& a, const Certified& b) {
  if (b.certificate.passed != a.certificate.passed) return b.certificate.passed;
  return std::max(b.certificate.stationarity, b.certificate.infeasibility) <
         std::max(a.certificate.stationarity, a.certificate.infeasibility);
}

void take(Attempt& attempt, const Scaling& scaling, Certified&& better) {
  attempt.design = better.point.design;
  attempt.best->z = scaling.to_unit(attempt.design);
  attempt.best->violation = better.point.infeasibility;
  const Problem& problem = attempt.session->problem();
  const double sign = problem.objectives[0].sense == Sense::maximize ? -1.0 : 1.0;
  attempt.best->f = sign * scaling.factor(0) * better.point.evaluation.values[0];
  attempt.certified = std::move(better);
}

void polish_from(Attempt& attempt, const Scaling& scaling, std::span<const double> design) {
  const auto polished = polish(*attempt.session, scaling, design);
  if (!polished) return;
  auto certified = certify_in(*attempt.session, scaling, *polished);
  if (certified && improves(*attempt.certified, *certified))
    take(attempt, scaling, std::move(*certified));
}

}  // namespace

Attempt make_attempt(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                     const Scaling& scaling, const Formulation& formulation,
                     const AttemptPlan& plan) {
  Attempt attempt;
  attempt.solver = &plan.optimizer->info;
  attempt.session = std::make_unique<Session>(problem, options, deadline, plan.stage, plan.quota);
  Nlp nlp(*attempt.session, scaling, formulation);
  require_available(plan.optimizer->info);
  RunSettings settings;
  settings.seed = options.seed + 1000003 * plan.stage;
  settings.max_calls = local_calls(plan.optimizer->info, nlp.size());
  if (options.solver == plan.optimizer->info.name) settings.options = &options.solver_options;
  if (scaling.size() == 0) {
    try {
      nlp.at(plan.start, true);
    } catch (const Stop& s) {
      attempt.report.stop = s.reason;
    }
    attempt.report.word = "nothing to vary";
  } else {
    attempt.report = plan.optimizer->run(plan.optimizer->info, nlp, plan.start, settings);
  }
  attempt.best = nlp.best();
  if (attempt.best) attempt.design = nlp.design(attempt.best->z);
  return attempt;
}

void finish_attempt(Attempt& attempt, const Scaling& scaling) {
  if (!attempt.best) return;
  try {
    attempt.certified = certify_in(*attempt.session, scaling, attempt.design);
    if (!attempt.certified || !attempt.session->options().polish) return;
    if (good_enough(attempt.certified->certificate)) return;
    polish_from(attempt, scaling, attempt.design);
    if (attempt.certified->certificate.passed || attempt.report.z.empty()) return;
    const auto own =
        scaling.to_design(std::span<const double>(attempt.report.z).first(scaling.size()));
    if (own != attempt.design) polish_from(attempt, scaling, own);
  } catch (const Stop& s) {
    attempt.report.stop = s.reason;
  }
}

}  // namespace twum::optim
