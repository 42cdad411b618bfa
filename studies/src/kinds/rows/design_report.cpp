// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/design_report.hpp"

#include "problem/held_duty.hpp"
#include "problem/implied_limits.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

NamedValue named(const MotorDesign& motor, Parameter parameter) {
  const ParameterInfo& row = info(parameter);
  return {std::string(row.name), std::string(row.unit), get(motor, parameter)};
}

// Infinite is a time that does not end.
double value_of(const MetricValue& answer) {
  if (is_endless(answer.status)) return HUGE_VAL;
  return answer.status == MetricStatus::ok ? answer.value : kNoValue;
}

std::vector<double> values_of(const MotorDesign& design,
                              const std::vector<MetricExpression>& metrics) {
  std::vector<MetricValue> answers(metrics.size());
  ExpressionEvaluator(metrics).evaluate(Motor(design), answers);
  std::vector<double> values;
  for (const MetricValue& answer : answers) values.push_back(value_of(answer));
  return values;
}

// What a designer wants to know of a torque that the drive holds at a speed.
std::vector<Metric> told_of_a_duty(const Stator& stator) {
  using M = Metric;
  if (!stator.voltage) return {M::amplitude_at, M::efficiency_at, M::pull_out_margin_at};
  const bool by_frequency = stator.control == DriveControl::frequency;
  return {by_frequency ? M::drive_frequency_at : M::drive_voltage_at,
          M::phase_current_at,
          M::electrical_power_at,
          M::overall_efficiency_at,
          M::amplitude_at,
          M::squeal_rate_at,
          M::pull_out_margin_at};
}

std::vector<MotorLimit> all_limits(const DesignProblem& problem) {
  std::vector<MotorLimit> limits = problem.limits;
  for (const ImpliedLimit& implied : implied_limits(problem)) limits.push_back(implied.limit);
  return limits;
}

const optim::Activity* activity_of(const optim::Certificate& certificate, const std::string& name,
                                   bool bound) {
  const optim::Activity* found = nullptr;  // of a limit with two ends, the active one
  for (const optim::Activity& a : certificate.limits) {
    if (a.is_bound == bound && a.name == name && (found == nullptr || a.active)) found = &a;
  }
  return found;
}

double end_of(const MotorLimit& limit, bool at_least) {
  return at_least ? limit.lower : limit.upper;
}

// If both sides depend on the motor, the left one is shown as the value and the right one as the limit, to which 1 %
// refers.
void show_sides(LimitState& state, double left, double right, bool maximize) {
  state.value = left;
  state.limit = right;
  if (state.active)
    state.gain_per_percent = (maximize ? 1 : -1) * state.multiplier * 0.01 * std::fabs(right);
}

}  // namespace

DesignReporter::DesignReporter(const DesignProblem& problem,
                               std::vector<Parameter> extra_parameters)
    : problem_(problem),
      extra_parameters_(std::move(extra_parameters)),
      metrics_(plain_metrics(problem.motor)),
      limits_(all_limits(problem)) {
  for (const DesignChoice& choice : problem.choices)
    for (const ParameterSet& set : choice.sets)
      for (const auto& [parameter, ignored] : set.values)
        if (std::find(chosen_.begin(), chosen_.end(), parameter) == chosen_.end())
          chosen_.push_back(parameter);
  const auto add = [this](const MetricExpression& metric) {
    const bool known = std::any_of(metrics_.begin(), metrics_.end(),
                                   [&](const auto& m) { return m.text == metric.text; });
    if (!known) metrics_.push_back(metric);
  };
  for (const DesignObjective& objective : problem.objectives) add(objective.metric);
  for (const MotorLimit& limit : problem.limits) add(limit.metric);
  for (const DutyPoint& point : problem.held)
    for (const Metric metric : told_of_a_duty(problem.motor.stator))
      add(parse_metric(std::string(info(metric).name) + "(" + held_arguments(point) + ")"));
}

std::vector<Goal> DesignReporter::goals() const {
  std::vector<Goal> goals;
  for (const DesignObjective& objective : problem_.objectives)
    goals.push_back(
        {objective.metric.text, std::string(objective.metric.unit()), objective.maximize});
  return goals;
}

std::vector<NamedValue> DesignReporter::design_of(const MotorDesign& motor) const {
  std::vector<NamedValue> values;
  for (const DesignVariable& variable : problem_.variables)
    values.push_back(named(motor, variable.parameter));
  for (const DerivedParameter& rule : problem_.derived)
    values.push_back(named(motor, rule.parameter));
  for (const Parameter parameter : chosen_)
    if (is_given(motor, parameter)) values.push_back(named(motor, parameter));
  for (const Parameter parameter : extra_parameters_) values.push_back(named(motor, parameter));
  return values;
}

std::vector<NamedValue> DesignReporter::metrics_of(const MotorDesign& motor) const {
  const std::vector<double> values = values_of(motor, metrics_);
  std::vector<NamedValue> list;
  for (std::size_t i = 0; i < metrics_.size(); ++i)
    list.push_back({metrics_[i].text, std::string(metrics_[i].unit()), values[i]});
  return list;
}

std::vector<LimitState> DesignReporter::limits(const MotorDesign& motor,
                                               const optim::Certificate& certificate) const {
  std::vector<LimitState> states;
  for (const MotorLimit& limit : limits_) {
    std::vector<MetricExpression> asked{limit.metric};
    asked.insert(asked.end(), limit.sides.begin(), limit.sides.end());
    const std::vector<double> values = values_of(motor, asked);
    LimitState state{limit.text, limit.metric.text, limit.metric.unit()};
    state.implied = states.size() >= problem_.limits.size();
    state.lower = limit.lower;
    state.upper = limit.upper;
    state.value = values[0];
    state.at_least = limit.at_least(state.value);
    if (const optim::Activity* a = activity_of(certificate, limit.text, false)) {
      state.active = a->active;
      state.tolerance = a->tolerance;
      state.multiplier = a->multiplier;
      state.gain_per_percent = a->gain_per_percent;
      if (a->active && a->side != optim::Side::equal)
        state.at_least = a->side == optim::Side::lower;
      if (state.implied && !is_of_the_drive(limit) && std::isfinite(a->value))
        state.value = a->value;  // such as mu_0 - mu
    }
    state.limit = end_of(limit, state.at_least);
    // Without a least voltage that is known no voltage is too low, as for the search.
    const bool unknown = is_of_the_drive(limit) && std::isnan(state.value) &&
                         limit.metric.request()->metric == Metric::voltage_reserve_at;
    state.violation = unknown ? 0 : limit.excess(state.value);
    const bool one_end = std::isinf(limit.lower) || std::isinf(limit.upper);
    if (one_end && !limit.sides.empty())
      show_sides(state, values[1], values[2], problem_.objectives.front().maximize);
    states.push_back(std::move(state));
  }
  return states;
}

std::vector<BoundState> DesignReporter::bounds(const optim::Certificate& certificate) const {
  std::vector<BoundState> states;
  for (const DesignVariable& variable : problem_.variables) {
    const ParameterInfo& row = info(variable.parameter);
    const optim::Activity* a = activity_of(certificate, std::string(row.name), true);
    if (a == nullptr || variable.min == variable.max) continue;
    states.push_back({{std::string(row.name), std::string(row.unit)},
                      a->side == optim::Side::upper,
                      a->limit,
                      a->multiplier,
                      a->gain_per_percent});
  }
  return states;
}

std::vector<BoundState> DesignReporter::whole_ends(std::span<const double> design) const {
  std::vector<BoundState> ends;
  for (std::size_t j = 0; j < problem_.variables.size(); ++j) {
    const DesignVariable& variable = problem_.variables[j];
    const ParameterInfo& row = info(variable.parameter);
    const double low = std::ceil(variable.min);
    const double high = std::floor(variable.max);
    if (!row.integer || !(low < high) || (design[j] > low && design[j] < high)) continue;
    ends.push_back({{std::string(row.name), std::string(row.unit)}, design[j] >= high, design[j]});
  }
  return ends;
}

DesignReport DesignReporter::report(std::span<const double> design,
                                    const optim::Certificate& certificate) const {
  const MotorDesign motor = motor_of(problem_, design);
  return {design_of(motor),    metrics_of(motor), limits(motor, certificate),
          bounds(certificate), certificate,       choice_of(design)};
}

std::vector<ChosenSet> DesignReporter::choice_of(std::span<const double> design) const {
  std::vector<ChosenSet> choice;
  if (design.empty()) return choice;
  const std::vector<const ParameterSet*> sets = chosen_sets(problem_, design);
  for (std::size_t i = 0; i < sets.size(); ++i)
    choice.push_back({problem_.choices[i].name, sets[i]->name});
  return choice;
}

// Nobody can loosen that a drive has to hold its duty.
bool DesignReporter::is_of_the_drive(const MotorLimit& limit) const {
  const bool implied = &limit - limits_.data() >= std::ssize(problem_.limits);
  const MetricRequest* request = limit.metric.request();
  return implied && request != nullptr &&
         (request->argument == Argument::both || request->metric == Metric::voltage_reserve_at);
}

const MotorLimit* DesignReporter::limit_named(const std::string& text) const {
  const auto at = std::find_if(limits_.begin(), limits_.end(),
                               [&](const MotorLimit& limit) { return limit.text == text; });
  return at == limits_.end() ? nullptr : &*at;
}

Explanation DesignReporter::explanation(const optim::Infeasibility& infeasibility) const {
  Explanation told;
  told.conflict = infeasibility.conflict;
  told.choice = choice_of(infeasibility.design);
  for (const optim::Relaxation& r : infeasibility.relaxations) {
    const MotorLimit* limit = limit_named(r.name);
    if (limit != nullptr && !is_of_the_drive(*limit))
      told.limits.push_back({limit->text, limit->metric.text, limit->metric.unit(),
                             r.side == optim::Side::lower, r.limit, r.amount, r.amount_alone,
                             !limit->sides.empty()});
  }
  for (const optim::Impossible& i : infeasibility.impossible) {
    if (const MotorLimit* limit = limit_named(i.name))
      told.impossible.push_back({limit->text, limit->metric.unit(), i.side == optim::Side::lower,
                                 i.limit, i.best, i.certified, i.ends, choice_of(i.design),
                                 !limit->sides.empty()});
  }
  for (const optim::RangeEnd& end : infeasibility.ranges) {
    const auto parameter = find_parameter(end.variable);
    TWUM_ASSERT(parameter.has_value());
    told.ranges.push_back({{end.variable, std::string(info(*parameter).unit)},
                           end.side == optim::Side::upper,
                           end.limit,
                           end.limit_alone});
  }
  return told;
}

std::vector<std::string> DesignReporter::without_influence(const optim::Evaluation& evaluation,
                                                           const DesignReport& report) const {
  const std::size_t n = problem_.variables.size();
  const std::size_t width = n + problem_.choices.size();  // of a row of the Jacobian
  if (evaluation.jacobian.empty()) return {};
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < problem_.objectives.size(); ++k) rows.push_back(k);
  for (std::size_t i = 0; i < report.constraints.size(); ++i) {
    if (report.constraints[i].active || report.constraints[i].violation > 0)
      rows.push_back(problem_.objectives.size() + i);
  }
  // Changes of a response over a variable's range below this share of the largest change are rounding errors.
  constexpr double kNothing = 1e-12;
  std::vector<bool> matters(n, false);
  for (const std::size_t row : rows) {
    std::vector<double> change;
    for (std::size_t j = 0; j < n; ++j)
      change.push_back(std::fabs(evaluation.jacobian[row * width + j]) *
                       (problem_.variables[j].max - problem_.variables[j].min));
    const double largest = *std::max_element(change.begin(), change.end());
    for (std::size_t j = 0; j < n; ++j)
      matters[j] = matters[j] || !(change[j] <= kNothing * largest);
  }
  std::vector<std::string> names;
  for (std::size_t j = 0; j < n; ++j) {
    if (!matters[j]) names.emplace_back(info(problem_.variables[j].parameter).name);
  }
  return names;
}

}  // namespace twum::inline v0_1::studies
