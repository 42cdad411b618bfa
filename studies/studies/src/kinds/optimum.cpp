// SPDX-License-Identifier: Apache-2.0
#include "kinds/optimum.hpp"

#include "problem/multi_start.hpp"

namespace twum::studies {

KindAnswer OptimumRun::run(RunContext& context) {
  SearchLog log(problem(), context);
  const optim::Result found = solve_from_starts(log.problem(), options(log, context));
  context.store.flush();
  const DesignReporter reports = reporter();
  OptimizeResult result;
  result.goal = reports.goals().front();
  result.before_design = reports.design_of(before());
  result.before_metrics = reports.metrics_of(before());
  result.solver = found.solver;
  result.stages = found.stages;
  result.found = !found.design.empty();
  if (result.found) {
    result.best = reports.report(found.design, found.certificate);
    result.whole_ends = reports.whole_ends(found.design);
    result.idle = reports.idle(found.evaluation, result.best);
  }
  if (found.outcome == optim::Outcome::infeasible)
    result.explanation = reports.explanation(found.infeasibility);
  return {outcome(found.outcome, context), std::move(result)};
}

}  // namespace twum::studies
