// SPDX-License-Identifier: Apache-2.0
#include "problem/implied_limits.hpp"

#include "problem/combinations.hpp"
#include "problem/held_duty.hpp"

#include <twum/io/number.hpp>

#include <algorithm>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

const DesignVariable* variable_of(const DesignProblem& problem, Parameter parameter) {
  for (const DesignVariable& v : problem.variables) {
    if (v.parameter == parameter) return &v;
  }
  return nullptr;
}

bool orders_friction(const DesignProblem& problem) {
  const DesignVariable* threshold = variable_of(problem, Parameter::static_friction);
  if (threshold == nullptr) return false;
  if (const DesignVariable* kinetic = variable_of(problem, Parameter::kinetic_friction))
    return threshold->min < kinetic->max;
  const std::vector<DesignProblem> all = combinations(problem);
  return std::any_of(all.begin(), all.end(), [&](const DesignProblem& one) {
    return threshold->min < one.motor.friction.kinetic;
  });
}

bool same_argument(const MetricRequest& a, const MetricRequest& b) {
  return a.argument == b.argument && a.at == b.at && a.torque == b.torque;
}

// Reserves and margins have values beyond the limit.
bool has_values_everywhere(Metric metric) {
  switch (metric) {
    case Metric::held_speed_limit_at:
    case Metric::held_torque_limit_at:
    case Metric::torque_reserve_at:
    case Metric::drive_reserve_at:
    case Metric::voltage_reserve_at:
    case Metric::thermal_time_constant:
    case Metric::continuous_torque_at:
    case Metric::start_temperature:
    case Metric::burst_angle:
    case Metric::dynamic_start_voltage:
    case Metric::holding_torque:
    case Metric::start_voltage:
    case Metric::hold_voltage:
    case Metric::start_frequency:
    case Metric::pull_out_frequency:
    case Metric::coupling_factor:
    case Metric::capacitance_ratio:
    case Metric::stator_mass:
    case Metric::free_amplitude:
    case Metric::mode_separation: return true;
    default: return false;
  }
}

bool ends_at_a_limit(const MetricRequest& request) {
  const bool held = request.argument == Argument::torque || request.argument == Argument::both;
  return held && !has_values_everywhere(request.metric);
}

// What has no value where the voltage does not run the motor; the worn motor is another one.
bool needs_running_wave(const MetricRequest& request) {
  return !request.worn_at && request.argument != Argument::both &&
         !has_values_everywhere(request.metric);
}

bool varies(const DesignProblem& problem, Parameter parameter) {
  return variable_of(problem, parameter) != nullptr;
}

bool may_have_voltage(const DesignProblem& problem) {
  return problem.motor.stator.voltage || varies(problem, Parameter::voltage);
}

// Next to the end of a drive that follows by frequency its metrics change with the square root of what is left (Y5.3).
constexpr double kLeastReserve = 1e-4;

// A limit is kept to 1e-8; without this reserve the answer of a search might not carry the torque that its metrics are asked at.
constexpr double kLeastTorqueReserve = 1e-7;

// A motor runs at rest for its stall torque, and without load for the other metrics without argument.
MetricRequest reserve_request(const MetricRequest& request) {
  if (request.argument == Argument::speed || request.argument == Argument::torque)
    return {Metric::voltage_reserve_at, request.argument, request.at};
  const bool at_rest = request.metric == Metric::stall_torque;
  return {Metric::voltage_reserve_at, at_rest ? Argument::speed : Argument::torque, 0};
}

// As the user typed it, where the expression is one metric.
std::string argument_text(const MetricRequest& reserve, const MetricExpression& metric) {
  const std::size_t open = metric.text.find('('), close = metric.text.rfind(')');
  const MetricRequest* request = metric.request();
  const bool typed = request && !request->warm_at && !request->worn_at && !request->after;
  if (typed && open != std::string::npos) return metric.text.substr(open + 1, close - open - 1);
  return number_text(reserve.at) + (reserve.argument == Argument::torque ? " N.m" : " rad/s");
}

ImpliedLimit voltage_limit(const MetricRequest& request, const MetricExpression& metric) {
  const MetricRequest reserve = reserve_request(request);
  const std::string argument = argument_text(reserve, metric);
  const std::string text =
      std::string(info(Metric::voltage_reserve_at).name) + "(" + argument + ")";
  return {
      {text + " >= " + number_text(kLeastVoltageReserve), parse_metric(text), kLeastVoltageReserve},
      request};
}

ImpliedLimit reserve_limit(Metric metric, const MetricRequest& held, double least) {
  const MetricRequest reserve{metric, Argument::both, held.at, held.torque};
  const std::string text =
      std::string(info(metric).name) + "(" + held_arguments({held.torque, held.at}) + ")";
  const MetricExpression expression = parse_metric(text);
  return {{text + " >= " + number_text(least), expression, least}, reserve};
}

void add_limits_of(const MetricRequest& request, const MetricExpression& metric,
                   const Stator& stator, std::vector<ImpliedLimit>& limits) {
  if (request.argument == Argument::torque) {
    limits.push_back({{"max_torque >= " + number_text(request.at) + " N.m for " + metric.text,
                       parse_metric("max_torque"), (1 + kLeastTorqueReserve) * request.at},
                      request,
                      request.at});
    return;
  }
  const bool by_frequency = stator.voltage && stator.control == DriveControl::frequency;
  limits.push_back(reserve_limit(Metric::torque_reserve_at, request, kLeastReserve));
  limits.push_back(
      reserve_limit(Metric::drive_reserve_at, request, by_frequency ? kLeastReserve : 0));
}

bool asks_for_life(const Term& term) {
  const auto* request = std::get_if<MetricRequest>(&term);
  return request != nullptr && is_of_life(*request);
}

// A life falls to nothing where the new motor violates what ends it. No slope of the life tells the way back; those limits do.
std::vector<ImpliedLimit> limits_of_new_motor(const DesignProblem& problem) {
  std::vector<ImpliedLimit> limits;
  const bool lives = std::ranges::any_of(asked(problem), [](const MetricExpression& metric) {
    return std::ranges::any_of(metric.terms, asks_for_life);
  });
  if (!lives || !problem.motor.wear) return limits;
  for (const WearLimit& until : problem.motor.wear->until) {
    const bool asked_for = std::ranges::any_of(
        problem.limits, [&](const MotorLimit& limit) { return limit.text == until.text; });
    if (!until.text.empty() && !asked_for)
      limits.push_back({parse_limit(until.text), until.request});
  }
  return limits;
}

// The point at whose temperatures a metric of the warm motor is taken.
std::optional<MetricRequest> load_of_warm(const Term& term) {
  const auto* request = std::get_if<MetricRequest>(&term);
  if (request == nullptr || !request->warm_at) return {};
  const LoadPoint& load = *request->warm_at;
  return MetricRequest{Metric::amplitude_at, load.argument, load.at, load.torque, {}};
}

}  // namespace

std::vector<MetricExpression> asked(const DesignProblem& problem) {
  std::vector<MetricExpression> list;
  for (const DesignObjective& objective : problem.objectives) list.push_back(objective.metric);
  for (const MotorLimit& limit : problem.limits) list.push_back(limit.metric);
  return list;
}

bool ImpliedLimit::is_about(const MetricExpression& metric) const {
  const bool by_voltage = is_of_fixed_drive();
  return argument && std::any_of(metric.terms.begin(), metric.terms.end(), [&](const Term& term) {
           const auto* request = std::get_if<MetricRequest>(&term);
           if (request == nullptr) return false;
           return by_voltage
                      ? needs_running_wave(*request) &&
                            same_argument(reserve_request(*request), reserve_request(*argument))
                      : same_argument(*request, *argument);
         });
}

bool ImpliedLimit::is_of_fixed_drive() const {
  const MetricRequest* request = limit.metric.request();
  return request != nullptr && request->metric == Metric::voltage_reserve_at;
}

namespace {

// A load needs more voltage than none, so that no limit stands for a motor without load beside it.
std::vector<ImpliedLimit> fixed_drive_limits(const DesignProblem& problem) {
  std::vector<ImpliedLimit> limits;
  if (!may_have_voltage(problem)) return limits;
  for (const MetricExpression& metric : asked(problem))
    for (const Term& term : metric.terms) {
      const auto* request = std::get_if<MetricRequest>(&term);
      if (request == nullptr || !needs_running_wave(*request)) continue;
      ImpliedLimit one = voltage_limit(*request, metric);
      if (std::none_of(limits.begin(), limits.end(), [&](const ImpliedLimit& l) {
            return same_argument(*l.limit.metric.request(), *one.limit.metric.request());
          }))
        limits.push_back(std::move(one));
    }
  const auto load = [](const ImpliedLimit& one) {
    const MetricRequest& request = *one.limit.metric.request();
    return request.argument == Argument::torque ? request.at : -1;
  };
  const bool loaded = std::any_of(limits.begin(), limits.end(),
                                  [&](const ImpliedLimit& one) { return load(one) > 0; });
  if (loaded) std::erase_if(limits, [&](const ImpliedLimit& one) { return load(one) == 0; });
  return limits;
}

}  // namespace

std::vector<ImpliedLimit> implied_limits(const DesignProblem& problem) {
  std::vector<ImpliedLimit> limits;
  const auto add = [&](const MetricRequest& request, const MetricExpression& metric) {
    const bool known = std::any_of(limits.begin(), limits.end(), [&](const ImpliedLimit& l) {
      return same_argument(request, *l.argument);
    });
    if (!known) add_limits_of(request, metric, problem.motor.stator, limits);
  };
  for (const DutyPoint& point : problem.held)
    add({Metric::amplitude_at, Argument::both, point.speed, point.torque}, {});
  for (const MetricExpression& metric : asked(problem))
    for (const Term& term : metric.terms)
      if (const auto* request = std::get_if<MetricRequest>(&term);
          request != nullptr && ends_at_a_limit(*request))
        add(*request, metric);
  for (const MetricExpression& metric : asked(problem))
    for (const Term& term : metric.terms)
      if (const auto load = load_of_warm(term); load && ends_at_a_limit(*load)) add(*load, metric);
  for (ImpliedLimit& one : limits_of_new_motor(problem)) limits.push_back(std::move(one));
  for (ImpliedLimit& one : fixed_drive_limits(problem)) limits.push_back(std::move(one));
  if (orders_friction(problem))
    limits.push_back({{"static_friction >= kinetic_friction", parse_metric("static_friction"), 0}});
  return limits;
}

}  // namespace twum::inline v0_1::studies
