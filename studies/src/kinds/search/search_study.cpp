// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/search_study.hpp"

#include "kinds/rows/earlier_result.hpp"
#include "kinds/rows/executor.hpp"

#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/motors/model_notes.hpp>
#include <twum/optim/certify.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

bool finite(const optim::Evaluation& evaluation) {
  return std::all_of(evaluation.values.begin(), evaluation.values.end(),
                     [](double v) { return std::isfinite(v); });
}

// Whether an expression contains the ratio of thickness to contact length.
bool asks_layer_aspect(const MetricExpression& metric) {
  const auto has = [&](const Term& wanted) {
    return std::any_of(metric.terms.begin(), metric.terms.end(), [&](const Term& term) {
      const auto* request = std::get_if<MetricRequest>(&term);
      const auto* asked = std::get_if<MetricRequest>(&wanted);
      if (request != nullptr && asked != nullptr) return request->metric == asked->metric;
      return term == wanted;
    });
  };
  return has(MetricRequest{Metric::layer_aspect}) ||
         (has(Parameter::thickness) && has(MetricRequest{Metric::contact_half_length}));
}

}  // namespace

SearchRun::SearchRun(const StudyFile& file, DesignProblem asked, optim::SolveOptions options,
                     const std::string& start)
    : problem_(std::move(asked)),
      before_(file.motor.design),
      limits_entry_(file.kind() == StudyKind::size ? "limits" : "constraints"),
      options_(std::move(options)) {
  problem_.motor = before_;
  if (!start.empty()) {
    start_from((std::filesystem::path(file.folder) / start).string());
    started_ = before_ = problem_.motor;
  }
  counts_slices_ = leaves_slices();
  first_slices_ = slices();
  if (!counts_slices_) return;
  // reported with each design, although it is not a variable
  extra_parameters_.push_back(Parameter::radial_slices);
  begin_with_slices(Motor(problem_.motor).radial_slices());
}

bool SearchRun::leaves_slices() const {
  const auto varied = parameters_of(problem_.variables);
  return problem_.motor.stator.radial_slices == kAutoSlices &&
         std::find(varied.begin(), varied.end(), Parameter::radial_slices) == varied.end();
}

void SearchRun::begin_with_slices(int slices) {
  first_slices_ = slices;
  use_slices(slices);
}

void SearchRun::use_slices(int slices) {
  problem_.motor.stator.radial_slices = before_.stator.radial_slices = slices;
}

DesignProblem SearchRun::asked_with(int slices) const {
  DesignProblem asked = problem_;
  if (counts_slices_) asked.motor.stator.radial_slices = slices;
  return asked;
}

int SearchRun::slices_of(std::uint64_t stage) const {
  const int nodes = SearchStage::of(stage).nodes;
  return nodes > 0 ? -nodes : first_slices_;
}

int SearchRun::nodes_needed(std::span<const double> design) const {
  MotorDesign motor = motor_of(problem_, design);
  motor.stator.radial_slices = kAutoSlices;
  return -Motor(motor).radial_slices();
}

// Takes the earlier design as the motor; its varied parameters are the start of the search.
void SearchRun::start_from(const std::string& folder) {
  const std::vector<EarlierDesign> designs = earlier_designs(folder);
  const EarlierDesign& design = best_start(problem_, designs);
  const int slices = problem_.motor.stator.radial_slices;
  problem_.motor = with(problem_.motor, design);
  // `auto` is evaluated again for this search
  if (slices == kAutoSlices) problem_.motor.stator.radial_slices = slices;
  for (const auto& [parameter, value] : design) {
    const auto variable =
        std::find_if(problem_.variables.begin(), problem_.variables.end(),
                     [p = parameter](const DesignVariable& v) { return v.parameter == p; });
    const auto derived = parameters_of(problem_.derived);
    if (std::find(derived.begin(), derived.end(), parameter) != derived.end()) continue;
    if (is_chosen(parameter)) continue;
    if (parameter == Parameter::radial_slices && leaves_slices()) continue;
    if (variable == problem_.variables.end())
      extra_parameters_.push_back(parameter);
    else if (std::isnan(variable->start))
      variable->start = value;
  }
}

// Whether a set gives the parameter, so that the value of the earlier design is ignored.
bool SearchRun::is_chosen(Parameter parameter) const {
  for (const DesignChoice& choice : problem_.choices)
    for (const ParameterSet& set : choice.sets)
      if (set.gives(parameter)) return true;
  return false;
}

optim::SolveOptions SearchRun::options(SearchLog& log, const RunContext& context) const {
  optim::SolveOptions options = this->options(context);
  options.observer = log.observer(options.budget.evaluations);
  return options;
}

optim::SolveOptions SearchRun::options(const RunContext& context) const {
  optim::SolveOptions options = options_;
  options.jobs = context.executor.lanes();
  options.stop = context.stop;
  return options;
}

std::optional<Pace> SearchRun::pace() const {
  const optim::Problem problem = motor_problem(problem_);
  double shortest = std::numeric_limits<double>::infinity();
  // the first evaluation includes memory allocation and is not measured
  for (int i = 0; i < 2; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    try {
      problem.evaluate(optim::start_design(problem), true);
    } catch (const EvaluationError&) {  // a failed evaluation takes time as well
    }
    const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - begin;
    shortest = std::min(shortest, lasted.count());
  }
  return Pace{shortest, options_.budget.evaluations};
}

// In a real ring, the plate determines the resonance for each number of wavelengths. If the resonance is given, the
// drive frequency is free.
std::vector<std::string> SearchRun::notes() const {
  const bool known = problem_.motor.stator.resonance_frequency.has_value();
  const Parameter of_ring = known ? Parameter::resonance_frequency : Parameter::frequency;
  std::string varied;
  for (const DesignVariable& v : problem_.variables)
    if (v.parameter == Parameter::wavelengths || v.parameter == of_ring)
      varied += (varied.empty() ? "" : " and ") + std::string(info(v.parameter).name);
  // the geometry determines the resonance
  if (varied.empty() || problem_.motor.stator.geometry) return {};
  return {
      varied +
      " varied: the model accepts any number of waves at any frequency, but a real ring has one "
      "frequency for each number "
      "of waves; check the answer against the modes of the ring, or hold both"};
}

// Without a limit, a search may lead to thick layers, for which the model does not hold.
std::vector<std::string> SearchRun::notes_before() const {
  const auto kept = [](const MotorLimit& limit) { return asks_layer_aspect(limit.metric); };
  if (std::any_of(problem_.limits.begin(), problem_.limits.end(), kept)) return {};
  std::string note = thick_layer_note(problem_.motor);
  if (note.empty()) return {};
  return {note + "; no limit keeps the search from such layers: add 'layer_aspect <= 0.1' to '" +
          limits_entry_ + "'"};
}

// A search that was asked to stop may have a certified design, but not the one with which the whole search would have
// ended.
StudyOutcome SearchRun::outcome(optim::Outcome outcome, const RunContext& context) {
  return context.stop.stop_requested() ? StudyOutcome::interrupted : outcome_of(outcome);
}

const SearchRun::Answers& SearchRun::answers(std::uint64_t stage) const {
  const int nodes = SearchStage::of(stage).nodes;
  const std::lock_guard lock(answers_mutex_);
  const auto found = answers_.find(nodes);
  if (found != answers_.end()) return found->second;
  const DesignProblem asked = asked_with(slices_of(stage));
  return answers_.emplace(nodes, Answers{SearchRows(asked), MotorResponses(asked)}).first->second;
}

std::optional<StoredRow> SearchRun::recompute(const StoredRow& asked) const {
  const auto& [rows, motors] = answers(asked.stage);
  const std::span design(asked.values.data(), variables());
  if (SearchStage::of(asked.stage).phase ==
      SearchStage::Phase::robust) {  // the problem of a round depends on the rows before it
    StoredRow row =
        rows.row(asked.stage, asked.index, design, false, motors.evaluate(design, false));
    row.status = asked.status;
    return row;
  }
  const bool gradient = rows.asked_gradient(asked);
  optim::Evaluation evaluation = motors.evaluate(design, gradient);
  if (evaluation.ok() && !finite(evaluation)) evaluation.failure = "not-finite";
  return rows.row(asked.stage, asked.index, design, gradient, evaluation);
}

std::optional<optim::Certificate> SearchRun::certify(std::span<const double> variables,
                                                     std::span<const ParameterValue> design) const {
  for (const auto& [parameter, value] : design)
    if (parameter == Parameter::radial_slices)
      return certificate(asked_with(static_cast<int>(value)), variables);
  return certificate(problem_, variables);
}

optim::Certificate SearchRun::certificate(const DesignProblem& asked,
                                          std::span<const double> design) const {
  optim::Problem held = motor_problem(asked);
  for (std::size_t j = 0; j < design.size(); ++j) {
    optim::Variable& variable = held.variables[j];
    // Integer variables have no derivative, so the others are certified with the integers fixed.
    if (variable.integer) variable.lower = variable.upper = design[j];
  }
  return optim::certify(held, design, options_);
}

}  // namespace twum::inline v0_1::studies
