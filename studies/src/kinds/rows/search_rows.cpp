// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/search_rows.hpp"

#include "kinds/rows/executor.hpp"
#include "kinds/rows/row_bytes.hpp"

#include <twum/io/engineering.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

// Undefined derivatives are NaN in the Jacobian, so their kinks need not be stored.
bool told_by_jacobian(const optim::Evaluation& evaluation, std::size_t variables,
                      const optim::KinkedEntry& kink) {
  return kink.slope == optim::Slope::undefined &&
         !std::isfinite(evaluation.jacobian[kink.response * variables + kink.variable]);
}

}  // namespace

std::string evaluation_bytes(const optim::Evaluation& evaluation, std::size_t variables,
                             bool gradient) {
  std::string bytes;
  append_bytes(bytes, static_cast<std::uint8_t>(gradient));
  append_numbers(bytes, evaluation.values);
  append_numbers(bytes, evaluation.jacobian);
  for (const optim::KinkedEntry& kink : evaluation.kinks) {
    if (told_by_jacobian(evaluation, variables, kink)) continue;
    append_bytes(bytes, static_cast<std::uint8_t>(1));
    append_bytes(bytes, static_cast<std::uint32_t>(kink.response));
    append_bytes(bytes, static_cast<std::uint32_t>(kink.variable));
    append_bytes(bytes, static_cast<std::uint8_t>(kink.slope));
    append_bytes(bytes, kink.left);
    append_bytes(bytes, kink.right);
  }
  append_bytes(bytes, static_cast<std::uint8_t>(0));
  return bytes;
}

optim::Evaluation evaluation_of(const StoredRow& row) {
  optim::Evaluation evaluation;
  if (row.status != "ok") {
    evaluation.failure = row.status;
    return evaluation;
  }
  RowBytes bytes(row.detail);
  bytes.take<std::uint8_t>();
  evaluation.values = bytes.numbers();
  evaluation.jacobian = bytes.numbers();
  while (bytes.take<std::uint8_t>() != 0) {
    optim::KinkedEntry kink;
    kink.response = bytes.take<std::uint32_t>();
    kink.variable = bytes.take<std::uint32_t>();
    kink.slope = static_cast<optim::Slope>(bytes.take<std::uint8_t>());
    kink.left = bytes.take<double>();
    kink.right = bytes.take<double>();
    evaluation.kinks.push_back(kink);
  }
  return evaluation;
}

SearchRows::SearchRows(const DesignProblem& problem)
    : variables_(problem.variables.size() + problem.choices.size()), problem_(problem) {
  if (!problem.derived.empty())
    for (DesignProblem& one : combinations(problem)) {
      VariedParameters varied = varied_parameters(one);
      combinations_.push_back({std::move(one), std::move(varied)});
    }
  for (const DesignVariable& variable : problem.variables) {
    const ParameterInfo& row = info(variable.parameter);
    columns_.push_back({std::string(row.name), std::string(row.unit)});
  }
  for (const DesignChoice& choice : problem.choices) {
    columns_.push_back({choice.name, "1"});
    for (const ParameterSet& set : choice.sets) columns_.back().words.push_back(set.name);
  }
  for (const DerivedParameter& rule : problem.derived) {
    const ParameterInfo& row = info(rule.parameter);
    columns_.push_back({std::string(row.name), std::string(row.unit)});
  }
  const std::vector<ImpliedLimit> implied = implied_limits(problem);
  std::vector<MetricExpression> asked;
  for (const DesignObjective& objective : problem.objectives) asked.push_back(objective.metric);
  for (const MotorLimit& limit : problem.limits) asked.push_back(limit.metric);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const MetricExpression& metric = asked[i];
    const bool known = std::any_of(columns_.begin(), columns_.end(),
                                   [&](const StoredColumn& c) { return c.name == metric.text; });
    if (known) continue;
    columns_.push_back({metric.text, std::string(metric.unit())});
    metrics_.push_back({i, {}});
    for (std::size_t k = 0; k < implied.size(); ++k)
      if (implied[k].is_about(metric))
        metrics_.back().ends.push_back({asked.size() + k, implied[k].end()});
  }
}

StoredRow SearchRows::row(std::uint64_t stage, std::uint64_t index, std::span<const double> design,
                          bool gradient, const optim::Evaluation& evaluation) const {
  StoredRow row;
  row.stage = stage;
  row.index = index;
  row.values.assign(design.begin(), design.end());
  append_derived(design, row);
  for (const MetricColumn& metric : metrics_) {
    const bool none =
        !evaluation.ok() ||
        std::any_of(metric.ends.begin(), metric.ends.end(), [&](const MetricColumn::End& end) {
          return evaluation.values[end.response] < end.least;
        });
    row.values.push_back(none ? kNoValue : evaluation.values[metric.response]);
  }
  if (!evaluation.ok()) row.status = evaluation.failure;
  row.detail = evaluation_bytes(evaluation, variables_, gradient);
  return row;
}

StoredRow SearchRows::question(std::span<const double> design, bool gradient, int nodes) {
  StoredRow row;
  if (nodes > 0) row.stage = SearchStage{SearchStage::Phase::with_nodes, nodes}.number();
  row.values.assign(design.begin(), design.end());
  append_bytes(row.detail, static_cast<std::uint8_t>(gradient));
  return row;
}

void SearchRows::append_derived(std::span<const double> design, StoredRow& row) const {
  if (problem_.derived.empty()) return;
  std::optional<MotorDesign> motor;
  try {
    const Combination& one = combinations_[combination_of(problem_, design)];
    motor = motor_of_combination(one.problem, one.varied, design.first(problem_.variables.size()));
  } catch (const Error&) {  // the evaluation holds the reason
  }
  for (const DerivedParameter& rule : problem_.derived)
    row.values.push_back(motor ? get(*motor, rule.parameter) : kNoValue);
}

bool SearchRows::asked_gradient(const StoredRow& row) const {
  return RowBytes(row.detail).take<std::uint8_t>() != 0;
}

std::string SearchRows::key(std::span<const double> design, bool gradient) {
  std::string bytes;
  for (const double value : design) append_bytes(bytes, value);
  bytes.push_back(gradient ? '1' : '0');
  return bytes;
}

SearchLog::SearchLog(const DesignProblem& problem, RunContext& context, int nodes)
    : question_(problem),
      context_(context),
      rows_(problem),
      answering_(motor_problem(problem)),
      best_(kNoValue) {
  const std::size_t variables = answering_.variables.size();
  context.store.read([&](const StoredRow& row) {
    const SearchStage stage = SearchStage::of(row.stage);
    if (stage.phase == SearchStage::Phase::robust || stage.nodes != nodes) return;
    const std::span design(row.values.data(), variables);
    stored_.emplace(SearchRows::key(design, rows_.asked_gradient(row)), evaluation_of(row));
  });
  answering_.evaluate = [this, nodes](std::span<const double> design, bool gradient) {
    if (!stored_.empty()) {
      const auto found = stored_.find(SearchRows::key(design, gradient));
      if (found != stored_.end()) return found->second;
    }
    return evaluation_of(context_.executor.row(SearchRows::question(design, gradient, nodes)));
  };
}

optim::Observer SearchLog::observer(std::uint64_t budget) {
  budget_ = budget;
  return [this](const optim::Observation& observation) { observe(observation); };
}

void SearchLog::observe(const optim::Observation& observation) {
  context_.store.add(rows_.row(observation.stage, observation.index, observation.design,
                               observation.gradient, observation.evaluation));
  ++done_;
  note_run(observation);
  if (!context_.progress) return;
  note_best(observation);
  seen_.insert(observation.stage);
  context_.progress({.done = done_,
                     .total = budget_,
                     .budget = true,
                     .best = best_text_,
                     .stage = "run " + std::to_string(seen_.size())});
}

void SearchLog::note_run(const optim::Observation& observation) {
  if (question_.objectives.size() != 1 || !feasible(observation.evaluation)) return;
  const double sign = question_.objectives.front().maximize ? -1 : 1;
  const double value = sign * observation.evaluation.values.front();
  const auto found = runs_.find(observation.stage);
  if (found != runs_.end() && !(value < found->second.value)) return;
  runs_[observation.stage] = {value, {observation.design.begin(), observation.design.end()}};
}

// Whether two designs are within a tenth of every range, on the scale of the search.
bool SearchLog::near(std::span<const double> a, std::span<const double> b) const {
  constexpr double kNear = 0.1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const optim::Variable& v = answering_.variables[k];
    const bool log = v.scale == optim::Scale::log;
    const double range = log ? std::log(v.upper / v.lower) : v.upper - v.lower;
    if (std::fabs(log ? std::log(a[k] / b[k]) : a[k] - b[k]) > kNear * range) return false;
  }
  return true;
}

std::vector<std::vector<double>> SearchLog::valleys() const {
  std::vector<RunsBest> runs;
  for (const auto& [stage, best] : runs_) runs.push_back(best);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RunsBest& a, const RunsBest& b) { return a.value < b.value; });
  std::vector<std::vector<double>> list;
  for (RunsBest& run : runs)
    if (std::none_of(list.begin(), list.end(),
                     [&](const std::vector<double>& other) { return near(other, run.design); }))
      list.push_back(std::move(run.design));
  return list;
}

// For the progress line only; the certificate decides which design is feasible.
void SearchLog::note_best(const optim::Observation& observation) {
  if (question_.objectives.size() != 1 || !feasible(observation.evaluation)) return;
  const DesignObjective& objective = question_.objectives.front();
  const double value = observation.evaluation.values.front();
  const bool better = objective.maximize ? value > best_ : value < best_;
  if (!better && !std::isnan(best_)) return;
  best_ = value;
  best_text_ = objective.metric.text + " " + engineering(value, objective.metric.unit());
}

namespace {

double room(const optim::Constraint& limit, double end) {
  if (!std::isnan(limit.tolerance)) return limit.tolerance;
  return optim::SolveOptions().feasibility_tolerance * std::fabs(end);
}

}  // namespace

bool SearchLog::feasible(const optim::Evaluation& evaluation) const {
  if (!evaluation.ok()) return false;
  const std::size_t objectives = question_.objectives.size();
  for (std::size_t i = 0; i < answering_.constraints.size(); ++i) {
    const optim::Constraint& c = answering_.constraints[i];
    const double value = evaluation.values[objectives + i];
    if (value < c.lower - room(c, c.lower) || value > c.upper + room(c, c.upper)) return false;
  }
  return true;
}

}  // namespace twum::inline v0_1::studies
