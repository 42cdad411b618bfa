// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/robust_front.hpp"

#include "kinds/robust/built_motors.hpp"
#include "kinds/robust/front_points.hpp"
#include "kinds/robust/robust_log.hpp"
#include "kinds/robust/robust_report.hpp"

#include <twum/optim/robust_front.hpp>

#include <algorithm>

namespace twum::inline v0_1::studies {
namespace {

// The values of the goals: metrics of the design, statistics by new random motors.
std::vector<double> front_goals(const optim::RobustFrontPoint& point,
                                const std::vector<Goal>& goals,
                                const std::vector<NamedValue>& statistics) {
  std::vector<double> values = point.goals;
  for (std::size_t k = 0; k < goals.size(); ++k)
    for (const NamedValue& one : statistics)
      if (one.name == goals[k].metric) values[k] = one.value;
  return values;
}

ParetoResult front_result(const RobustFrontBeginning& beginning, const optim::RobustProblem& posed,
                          const optim::RobustFront& front) {
  const RobustQuestion& question = beginning.question;
  ParetoResult result;
  for (const DesignObjective& goal : question.design.objectives)
    result.goals.push_back({goal.text(), goal.unit(), goal.maximize});
  for (const optim::RobustFrontPoint& point : front.points) {
    DesignReport report =
        beginning.reports.report(point.design, design_certificate(point.certificate, posed));
    report.statistics = wanted_statistics(question, posed, point.verification);
    std::vector<double> goals = front_goals(point, result.goals, report.statistics);
    result.front.push_back(
        {std::move(goals), std::move(report), yields_of(posed, point.verification)});
  }
  if (!result.front.empty()) {
    result.ends = ends_of(result);
    result.knee = knee_of(result);
  }
  result.hypervolume = front.hypervolume;
  result.reference_point = front.reference;
  const std::vector<RobustYield> largest = yields_of(posed, front.largest);
  if (!largest.empty()) result.largest_yield = largest.front();
  return result;
}

}  // namespace

KindAnswer robust_front(const RobustFrontBeginning& beginning, RunContext& context) {
  const optim::RobustProblem posed =
      shared_robust_problem(beginning.question, {}, context.executor);
  RobustLog log(beginning.asked, {}, 0, context);
  const optim::RobustOptions options = log.options(beginning.options);
  const optim::RobustFront front = optim::solve_robust_front(posed, beginning.points, options);
  context.store.flush();
  return {context.stop.stop_requested() ? StudyOutcome::interrupted : outcome_of(front.outcome),
          front_result(beginning, posed, front)};
}

}  // namespace twum::inline v0_1::studies
