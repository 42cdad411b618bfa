// SPDX-License-Identifier: Apache-2.0
#include "certificate/limits_report.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// Change of the objective's value per unit of improvement: +1 when maximizing.
double improvement_sign(const Problem& problem) {
  return problem.objectives[0].sense == Sense::maximize ? 1.0 : -1.0;
}

double one_percent(double limit, double span) {
  return 0.01 * (limit != 0.0 ? std::abs(limit) : span);
}

// "Pa per N.m"; nothing unless both units are known.
std::string price_unit(const Problem& problem, const std::string& unit) {
  const std::string& goal = problem.objectives[0].unit;
  if (goal.empty() || unit.empty()) return "";
  return unit == "1" ? goal : goal + " per " + unit;
}

Activity constraint_activity(const Problem& problem, const Scaling& scaling, const KktPoint& point,
                             const Limit& limit) {
  const Constraint& c = problem.constraints[limit.constraint];
  const std::size_t r = problem.objectives.size() + limit.constraint;
  Activity a;
  a.name = c.name;
  a.unit = c.unit;
  a.price_unit = price_unit(problem, c.unit);
  a.side = limit.side;
  a.value = point.evaluation.values[r];
  a.limit = limit.side == Side::upper ? c.upper : c.lower;
  a.violation = limit.excess / scaling.factor(r);
  a.tolerance = limit.tolerance / scaling.factor(r);
  return a;
}

// Largest change of a response over the range of one variable, to first order.
double span_of(const Problem& problem, const KktPoint& point, std::size_t response) {
  const Scaling ranges(problem);
  double span = 0.0;
  for (std::size_t k = 0; k < ranges.size(); ++k)
    span = std::max(span, std::abs(ranges.derivative(point.evaluation, response, k, point.design)));
  return span;
}

void set_multiplier(Activity& a, double lambda, double objective_factor, double limit_factor,
                    double span, const Problem& problem) {
  a.active = true;
  // Scaled: d f / d c = lambda. An equality's target raised moves along +c, where f grows by lambda.
  const double per_unit = lambda * limit_factor / objective_factor;
  a.multiplier = a.side == Side::equal ? -per_unit : per_unit;
  a.gain_per_percent = improvement_sign(problem) * a.multiplier * one_percent(a.limit, span);
}

Activity bound_activity(const Problem& problem, const Scaling& scaling, const KktPoint& point,
                        Eigen::Index k, double lambda) {
  const auto at = static_cast<std::size_t>(k);
  const Variable& v = problem.variables[scaling.variable(at)];
  Activity a;
  a.name = v.name;
  a.unit = v.unit;
  a.price_unit = price_unit(problem, v.unit);
  a.is_bound = true;
  a.side = point.nearer[at];
  a.value = point.design[scaling.variable(at)];
  a.limit = a.side == Side::lower ? v.lower : v.upper;
  set_multiplier(a, lambda, scaling.factor(0), 1.0 / scaling.slope(at, point.design),
                 v.upper - v.lower, problem);
  return a;
}

}  // namespace

std::vector<Activity> report_limits(const Problem& problem, const Scaling& scaling,
                                    const KktPoint& point, const Multipliers& multipliers) {
  std::vector<Activity> report;
  const auto worth = [&](std::size_t i) { return multipliers.worth[static_cast<Eigen::Index>(i)]; };
  for (const Limit& limit : point.limits)
    report.push_back(constraint_activity(problem, scaling, point, limit));
  for (std::size_t i = 0; i < multipliers.limits.size(); ++i) {
    const std::size_t at = multipliers.limits[i];
    const std::size_t r = problem.objectives.size() + point.limits[at].constraint;
    set_multiplier(report[at], worth(i), scaling.factor(0), scaling.factor(r),
                   span_of(problem, point, r), problem);
  }
  for (std::size_t i = 0; i < multipliers.bounds.size(); ++i)
    report.push_back(bound_activity(problem, scaling, point, multipliers.bounds[i],
                                    worth(multipliers.limits.size() + i)));
  return report;
}

}  // namespace twum::inline v0_1::optim
