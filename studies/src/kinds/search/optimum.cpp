// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/optimum.hpp"

#include "kinds/robust/robust_optimum.hpp"
#include "kinds/search/optimum_moves.hpp"
#include "problem/multi_start.hpp"

#include <twum/optim/solve.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// Slices of a track that is not split. Their error is 1e-3 of the torque, which is enough for a first search.
constexpr int kFewSlices = 8;

DesignProblem nominal(DesignProblem asked) {
  asked.objectives.front() = nominal_goal(asked.objectives.front(), asked.limits);
  return asked;
}

}  // namespace

OptimumRun::OptimumRun(const StudyFile& file, DesignProblem asked, BuiltMotorsAsked built,
                       optim::SolveOptions options, const std::string& start)
    : SearchRun(file, nominal(asked), std::move(options), start),
      goal_(asked.objectives.front()),
      built_(std::move(built)),
      motors_([this](const BuiltQuestion& of) { return robust_question(of); }) {
  // Not under tolerances: a robust search has many rounds that each start from the last one.
  if (counts_slices() && !built_.scatter()) begin_with_slices(kFewSlices);
}

std::vector<std::string> OptimumRun::notes() const {
  return built_.table.notes_after(SearchRun::notes());
}

std::optional<StoredRow> OptimumRun::recompute(const StoredRow& asked) const {
  return is_of_built_motor(asked) ? motors_.answer(asked) : SearchRun::recompute(asked);
}

std::optional<optim::Certificate> OptimumRun::certify(
    std::span<const double> variables, std::span<const ParameterValue> design) const {
  return !built_.scatter() ? SearchRun::certify(variables, design) : std::nullopt;
}

OptimizeResult OptimumRun::answer(const optim::Result& found) const {
  const DesignReporter reports = reporter();
  OptimizeResult result;
  result.goal = {goal_.text(), goal_.unit(), goal_.maximize};
  result.before_design = reports.design_of(before());
  result.before_metrics = reports.metrics_of(before());
  result.scan = found.scan;
  result.solver = found.solver;
  result.stages = found.stages;
  if (counts_slices())
    for (const optim::StageReport& stage : found.stages)
      result.slices_of_stages.push_back(slices_of(stage.stage));
  result.found = !found.design.empty();
  if (result.found) {
    result.best = reports.report(found.design, found.certificate);
    result.whole_ends = reports.whole_ends(found.design);
    result.without_influence = reports.without_influence(found.evaluation, result.best);
  }
  if (found.outcome == optim::Outcome::infeasible)
    result.explanation = reports.explanation(found.infeasibility);
  return result;
}

// The question with whole numbers and sets as a design has them.
DesignProblem OptimumRun::held(std::span<const double> design) const {
  DesignProblem question = problem();
  question.objectives = {goal_};
  question.motor = motor_of(question, design);
  question.choices.clear();
  for (std::size_t j = 0; j < question.variables.size(); ++j) {
    DesignVariable& variable = question.variables[j];
    if (info(variable.parameter).integer) variable.min = variable.max = design[j];
  }
  return question;
}

RobustQuestion OptimumRun::question_of(std::span<const double> design) const {
  return built_.question(held(design));
}

RobustQuestion OptimumRun::robust_question(const BuiltQuestion& of) const {
  RobustQuestion question = question_of(of.design);
  return of.motor_before ? question_before(std::move(question), before()) : question;
}

// A design with every combination of integers and sets, its own first. Only its own if there are more than
// kMostCombinations.
std::vector<std::vector<double>> OptimumRun::combinations_at(
    const std::vector<double>& design) const {
  std::vector<std::vector<double>> list{design};
  const auto with_values = [&](std::size_t place, long low, long high) {
    const std::size_t before = list.size();
    for (long value = low; value <= high && list.size() <= kMostCombinations; ++value)
      for (std::size_t i = 0; i < before; ++i) {
        if (static_cast<double>(value) == design[place]) continue;
        list.push_back(list[i]);
        list.back()[place] = static_cast<double>(value);
      }
  };
  const std::size_t variables = problem().variables.size();
  for (std::size_t j = 0; j < variables; ++j) {
    const DesignVariable& variable = problem().variables[j];
    if (info(variable.parameter).integer)
      with_values(j, std::lround(std::ceil(variable.min)), std::lround(std::floor(variable.max)));
  }
  for (std::size_t c = 0; c < problem().choices.size(); ++c)
    with_values(variables + c, 1, static_cast<long>(problem().choices[c].sets.size()));
  if (list.size() > kMostCombinations) list.resize(1);
  return list;
}

// Continues a search with few slices from its optimum with the slices that `auto` takes there, until the motor needs no
// more. Integers and sets stay fixed. All searches share one budget.
optim::Result OptimumRun::refined(optim::Result found, RunContext& context) {
  const optim::Budget budget = this->options(context).budget;
  while (counts_slices() && !found.design.empty() && found.stop == optim::StopReason::finished &&
         found.counters.evaluations < budget.evaluations) {
    const int nodes = nodes_needed(found.design);
    if (nodes <= -slices()) break;
    use_slices(-nodes);
    SearchLog log(problem(), context, nodes);
    optim::Problem there = log.problem();
    for (std::size_t j = 0; j < found.design.size(); ++j) {
      optim::Variable& variable = there.variables[j];
      variable.start = found.design[j];
      if (variable.integer) variable.lower = variable.upper = found.design[j];
    }
    optim::SolveOptions options = this->options(log, context);
    options.starts = 1;
    options.first_stage = SearchStage{SearchStage::Phase::with_nodes, nodes}.number();
    options.budget.evaluations -= found.counters.evaluations;
    optim::Result finer = optim::solve(there, options);
    finer.scan = found.scan;
    finer.counters.add(found.counters);
    finer.stages.insert(finer.stages.begin(), found.stages.begin(), found.stages.end());
    found = std::move(finer);
  }
  return found;
}

// Under tolerances, first finds the optimum without them, from which the robust search starts and with which its
// answer is compared. If no motor meets the limits, there is no robust search.
KindAnswer OptimumRun::run(RunContext& context) {
  SearchLog log(problem(), context);
  const optim::Result found =
      refined(solve_from_starts(log.problem(), options(log, context)), context);
  context.store.flush();
  KindAnswer plain{outcome(found.outcome, context), answer(found)};
  const bool feasible =
      found.outcome == optim::Outcome::optimal || found.outcome == optim::Outcome::feasible;
  if (!built_.scatter() && found.outcome == optim::Outcome::optimal)
    add_moves(held(found.design), found, std::get<OptimizeResult>(plain.answer));
  if (!built_.scatter() || !feasible || context.stop.stop_requested()) return plain;
  std::vector<RobustCandidate> candidates;
  for (std::vector<double>& design : combinations_at(found.design))
    candidates.push_back({question_of(design), design});
  std::vector<std::vector<double>> valleys = log.valleys();
  // the first is the optimum without tolerances itself
  if (!valleys.empty()) valleys.erase(valleys.begin());
  KindAnswer robust = robust_optimum({std::move(candidates), problem(), before(), reporter(),
                                      options(context), found, std::move(valleys)},
                                     std::get<OptimizeResult>(std::move(plain.answer)), context);
  if (auto& report = std::get<OptimizeResult>(robust.answer).robust) {
    report->parts = built_.table.name;
    report->part_count = built_.table.parts.rows.size();
  }
  return robust;
}

}  // namespace twum::inline v0_1::studies
