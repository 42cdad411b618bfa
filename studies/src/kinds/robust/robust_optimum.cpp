// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/robust_optimum.hpp"

#include "kinds/robust/built_motors.hpp"
#include "kinds/robust/robust_log.hpp"
#include "kinds/robust/robust_report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kNominalProducts = 20000;
// of the interval of its yield; 20,000 products are enough for any
constexpr double kNominalWidth = 0.014;
constexpr std::uint64_t kNominalStream = 100;  // random numbers separate from those of the decision

constexpr std::size_t kVerifiedCandidates = 3;
constexpr std::size_t kMostValleys = 3;  // starts at other local optima

std::size_t variables_of(const RobustBeginning& beginning) {
  return beginning.asked.variables.size();
}

// Starts at the optimum without tolerances and at other local optima, with the integers of the candidate.
std::vector<std::vector<double>> starts_of(const RobustBeginning& beginning,
                                           const RobustCandidate& candidate) {
  const auto free = static_cast<std::ptrdiff_t>(variables_of(beginning));
  std::vector<std::vector<double>> list{
      {candidate.design.begin(), candidate.design.begin() + free}};
  for (const std::vector<double>& valley : beginning.starts) {
    if (list.size() > kMostValleys) break;
    list.emplace_back(valley.begin(), valley.begin() + free);
    for (std::size_t k = 0; k < list.back().size(); ++k)
      if (info(beginning.asked.variables[k].parameter).integer)
        list.back()[k] = candidate.design[k];
  }
  return list;
}

// A search of one candidate, with a log of its own.
template <typename Solve>
optim::RobustResult searched(const RobustBeginning& beginning, std::size_t candidate,
                             std::uint64_t number, RunContext& context, Solve solve) {
  const RobustCandidate& one = beginning.candidates[candidate];
  const auto free = static_cast<std::ptrdiff_t>(variables_of(beginning));
  RobustLog log(beginning.asked, {one.design.begin() + free, one.design.end()}, number, context);
  optim::RobustOptions options = log.options(beginning.options);
  options.starts = starts_of(beginning, one);
  return solve(shared_robust_problem(one.question, {one.design}, context.executor), options);
}

// Smaller is better: outcome first, then the objective of the last round, or the largest yield there is.
std::pair<int, double> merit_of(const optim::RobustResult& found, bool maximize) {
  const int rank = static_cast<int>(found.outcome);
  if (found.last.evaluation.values.empty()) return {rank, HUGE_VAL};
  if (std::isfinite(found.largest_yield)) return {rank, -found.largest_yield};
  return {rank, (maximize ? -1 : 1) * found.last.evaluation.values.front()};
}

struct FoundCandidate {
  std::size_t candidate;
  optim::RobustResult found;
};

// The best three candidates by first-order estimates; a single candidate needs none.
std::vector<std::size_t> likely_candidates(const RobustBeginning& beginning, bool maximize,
                                           RunContext& context) {
  std::vector<std::pair<std::pair<int, double>, std::size_t>> list;
  for (std::size_t i = 0; i < beginning.candidates.size(); ++i) {
    std::pair<int, double> merit{0, 0};
    if (beginning.candidates.size() > 1)
      merit = merit_of(searched(beginning, i, 1 + i, context, optim::solve_form), maximize);
    list.emplace_back(merit, i);
  }
  std::sort(list.begin(), list.end());
  list.resize(std::min(list.size(), kVerifiedCandidates));
  std::vector<std::size_t> best;
  for (const auto& [ignored, i] : list) best.push_back(i);
  return best;
}

FoundCandidate best_candidate(const RobustBeginning& beginning, RunContext& context) {
  const DesignObjective& goal = beginning.candidates.front().question.design.objectives.front();
  // Rounds for a yield or a standard deviation minimize.
  const bool maximize = goal.maximize && has_nominal_value(goal);
  const std::vector<std::size_t> likely = likely_candidates(beginning, maximize, context);
  std::vector<FoundCandidate> list;
  for (std::size_t k = 0; k < likely.size(); ++k) {
    const std::uint64_t number = likely.size() == 1 ? 0 : 1 + beginning.candidates.size() + k;
    list.push_back(
        {likely[k], searched(beginning, likely[k], number, context, optim::solve_robust)});
  }
  return *std::min_element(list.begin(), list.end(), [&](const auto& a, const auto& b) {
    return merit_of(a.found, maximize) < merit_of(b.found, maximize);
  });
}

// A sample of motors of another design: the optimum without tolerances, or the motor before the search.
optim::Verification others(const optim::RobustProblem& posed, std::span<const double> design,
                           const optim::RobustOptions& options) {
  return optim::verify_design(posed, design, kNominalProducts, options, kNominalStream,
                              kNominalWidth);
}

// The motors of the file.
optim::Verification motors_before(const RobustBeginning& beginning,
                                  const optim::RobustOptions& options, Executor& executor) {
  const RobustCandidate& first = beginning.candidates.front();
  const RobustQuestion question = question_before(first.question, beginning.before);
  std::vector<double> design;
  for (const DesignVariable& variable : question.design.variables)
    design.push_back(get(beginning.before, variable.parameter));
  return others(shared_robust_problem(question, {first.design, true}, executor), design, options);
}

NominalMotors compared_with(const RobustBeginning& beginning, const OptimizeResult& plain,
                            const optim::RobustOptions& options, Executor& executor) {
  const RobustCandidate& first = beginning.candidates.front();
  if (!has_nominal_value(first.question.design.objectives.front()))
    return {kNoValue, plain.before_design, motors_before(beginning, options, executor)};
  const auto design = std::span(beginning.nominal.design).first(variables_of(beginning));
  return {beginning.nominal.evaluation.values.front(), plain.best.design,
          others(shared_robust_problem(first.question, {first.design}, executor), design, options)};
}

double objective_of(const OptimizeResult& result) {
  if (!result.best.statistics.empty()) return result.best.statistics.front().value;
  for (const NamedValue& metric : result.best.metrics)
    if (metric.name == result.goal.metric) return metric.value;
  return kNoValue;
}

}  // namespace

RobustQuestion question_before(RobustQuestion question, const MotorDesign& before) {
  question.design.motor = before;
  return question;
}

KindAnswer robust_optimum(const RobustBeginning& beginning, OptimizeResult plain,
                          RunContext& context) {
  const auto [candidate, found] = best_candidate(beginning, context);
  context.store.flush();
  const RobustQuestion& question = beginning.candidates[candidate].question;
  const DesignObjective& goal = question.design.objectives.front();
  const optim::RobustProblem posed = robust_problem(question);
  optim::RobustOptions options;
  options.solve = beginning.options;
  options.sampled = [&context](std::uint64_t made, std::uint64_t most) {
    if (context.progress)
      context.progress(progress_of_sample(context.store.rows() + made, made, most));
  };
  const NominalMotors nominal = compared_with(beginning, plain, options, context.executor);
  if (goal.statistic)
    plain.before_statistics = wanted_statistics(
        question, posed,
        has_nominal_value(goal) ? motors_before(beginning, options, context.executor)
                                : nominal.seen);
  if (context.stop.stop_requested()) return {StudyOutcome::interrupted, std::move(plain)};

  plain.solver = found.last.solver;
  plain.stages = found.last.stages;
  plain.slices_of_stages.clear();  // all of the same
  plain.found = !found.design.empty();
  if (plain.found) {
    std::vector<double> design = found.design;
    const std::vector<double>& held = beginning.candidates[candidate].design;
    design.insert(design.end(), held.begin() + static_cast<std::ptrdiff_t>(design.size()),
                  held.end());
    plain.best = beginning.reports.report(design, goal_certificate(found, goal.maximize, posed));
    plain.best.statistics = wanted_statistics(question, posed, found.verification);
    plain.whole_ends = beginning.reports.whole_ends(design);
  }
  plain.robust = robust_report(question, posed, found, nominal);
  plain.robust->objective = objective_of(plain);
  return {outcome_of(found.outcome), std::move(plain)};
}

}  // namespace twum::inline v0_1::studies
