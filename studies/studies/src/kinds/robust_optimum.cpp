// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust_optimum.hpp"

#include "kinds/robust_log.hpp"
#include "kinds/robust_report.hpp"

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

constexpr std::uint64_t kNominalProducts = 20000;  // its yield within 0.7 %
constexpr std::uint64_t kNominalStream = 100;      // apart from those that decide

optim::RobustOptions options_of(const RobustBeginning& beginning, RobustLog& log) {
  optim::RobustOptions options;
  options.solve = beginning.options;
  options.solve.observer = {};
  options.solve.first_stage = kRobustStages;
  const auto x =
      std::span(beginning.nominal.design).first(beginning.question.design.variables.size());
  options.starts = {{x.begin(), x.end()}};
  options.recall = [&log](std::uint64_t round, std::span<const double> y, bool gradient,
                          const optim::Evaluator& evaluate) {
    return log.recall(round, y, gradient, evaluate);
  };
  options.observer = [&log](std::uint64_t round, const optim::Observation& observation) {
    log.observe(round, observation);
  };
  return options;
}

// 20,000 motors of another design: the optimum without tolerances, or the motor as it was.
optim::Verification others(const optim::RobustProblem& posed, std::span<const double> design,
                           const optim::RobustOptions& options) {
  return optim::verify_design(posed, design, kNominalProducts, options, kNominalStream);
}

// The motors of the file.
optim::Verification motors_before(const RobustBeginning& beginning,
                                  const optim::RobustOptions& options) {
  RobustQuestion question = beginning.question;
  question.design.motor = beginning.before;
  std::vector<double> design;
  for (const DesignVariable& variable : question.design.variables)
    design.push_back(get(beginning.before, variable.parameter));
  return others(robust_problem(question), design, options);
}

NominalMotors compared_with(const RobustBeginning& beginning, const OptimizeResult& plain,
                            const optim::RobustProblem& posed,
                            const optim::RobustOptions& options) {
  const DesignProblem& asked = beginning.question.design;
  if (!has_nominal_value(asked.objectives.front()))
    return {kNoValue, plain.before_design, motors_before(beginning, options)};
  const auto design = std::span(beginning.nominal.design).first(asked.variables.size());
  return {beginning.nominal.evaluation.values.front(), plain.best.design,
          others(posed, design, options)};
}

double objective_of(const OptimizeResult& result) {
  if (!result.best.statistics.empty()) return result.best.statistics.front().value;
  for (const NamedValue& metric : result.best.metrics)
    if (metric.name == result.goal.metric) return metric.value;
  return kNoValue;
}

}  // namespace

KindAnswer robust_optimum(const RobustBeginning& beginning, OptimizeResult plain,
                          RunContext& context) {
  const RobustQuestion& question = beginning.question;
  const DesignObjective& goal = question.design.objectives.front();
  const bool comparable = has_nominal_value(goal);
  const optim::RobustProblem posed = robust_problem(question);
  // Whole numbers and sets are those of the optimum without tolerances.
  const auto free = static_cast<std::ptrdiff_t>(question.design.variables.size());
  const std::vector<double>& start = beginning.nominal.design;
  const std::vector<double> chosen(start.begin() + free, start.end());
  RobustLog log(beginning.asked, chosen, context);
  const optim::RobustOptions options = options_of(beginning, log);
  const optim::RobustResult found = optim::solve_robust(posed, options);
  context.store.flush();
  const NominalMotors nominal = compared_with(beginning, plain, posed, options);
  if (goal.statistic)
    plain.before_statistics = wanted_statistic(
        question, posed, comparable ? motors_before(beginning, options) : nominal.seen);
  if (context.stop.stop_requested()) return {"interrupted", std::move(plain)};

  plain.solver = found.last.solver;
  plain.stages = found.last.stages;
  plain.found = !found.design.empty();
  if (plain.found) {
    std::vector<double> design = found.design;
    design.insert(design.end(), chosen.begin(), chosen.end());
    plain.best = beginning.reports.report(design, design_certificate(found, goal.maximize, posed));
    plain.best.statistics = wanted_statistic(question, posed, found.verification);
    plain.whole_ends = beginning.reports.whole_ends(design);
  }
  plain.robust = robust_report(question, posed, found, nominal);
  plain.robust->objective = objective_of(plain);
  return {optim::to_string(found.outcome), std::move(plain)};
}

}  // namespace twum::studies
