// SPDX-License-Identifier: Apache-2.0
#include "problem/motor_responses.hpp"

#include "problem/combinations.hpp"
#include "problem/held_duty.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/io/number.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::studies {
namespace {

// Relative step to either side of a kink. It is far above rounding, and its error in the one-sided derivative is of
// the same order.
constexpr double kAside = 1e-7;
// One-sided derivatives that differ by less than this, relative, are taken as one.
constexpr double kSameSlope = 1e-4;

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

std::vector<MetricExpression> asked(const DesignProblem& problem) {
  std::vector<MetricExpression> list;
  for (const DesignObjective& objective : problem.objectives) list.push_back(objective.metric);
  for (const MotorLimit& limit : problem.limits) list.push_back(limit.metric);
  return list;
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

// Next to the voltage at which the running wave ends, metrics change with the square root of what is left.
constexpr double kLeastVoltageReserve = 2e-3;

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
                       parse_metric("max_torque"), request.at},
                      request});
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

std::string reason(const MetricExpression& metric, MetricStatus status) {
  return metric.text + ": " + to_string(status);
}

}  // namespace

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

namespace {

// A goal that a design reaches without end: none can be better, and the search is over.
class EndlessGoal : public InputError {
 public:
  EndlessGoal(const std::string& goal, MetricStatus status)
      : InputError("study.maximize: " + goal + " has no end for a design within the ranges (" +
                   to_string(status) + "), so that there is no largest; give it as a limit") {}
};

}  // namespace

CombinationResponses::CombinationResponses(DesignProblem problem, std::vector<ImpliedLimit> implied)
    : problem_(std::move(problem)),
      varied_(varied_parameters(problem_)),
      implied_(std::move(implied)),
      responses_(asked(problem_)) {
  for (const ImpliedLimit& limit : implied_)
    if (!limit.orders_friction()) responses_.push_back(limit.limit.metric);
  const auto reserves = static_cast<std::size_t>(
      std::count_if(implied_.begin(), implied_.end(),
                    [](const ImpliedLimit& one) { return one.is_of_fixed_drive(); }));
  metrics_ = responses_.size() - reserves;
  evaluator_ = ExpressionEvaluator(std::span(responses_).first(metrics_));
  reserves_ = ExpressionEvaluator(std::span(responses_).subspan(metrics_));
}

optim::Evaluation CombinationResponses::evaluate(std::span<const double> design,
                                                 bool gradient) const {
  try {
    return evaluate_motor(design, gradient);
  } catch (const EvaluationError& error) {
    optim::Evaluation failed;
    failed.failure = error.reason();
    return failed;
  } catch (const EndlessGoal&) {
    throw;
  } catch (const InputError& error) {  // a combination of values that is no motor
    optim::Evaluation failed;
    failed.failure = std::string("not a motor: ") + error.what();
    return failed;
  }
}

CombinationResponses::Numbers CombinationResponses::values_of(
    const MotorDesign& motor, const ExpressionEvaluator& expressions, bool gradient) const {
  return metric_values(Motor(motor), expressions, gradient, varied_.fixed_static_friction());
}

namespace {

// Stands for a reserve that is not asked for, for larger ones, which bind nothing, and where there is no least voltage.
constexpr double kSomeReserve = 1;

// With mu_0 > mu the reserve of a motor that runs costs a hundred times as much as its metrics, else as much or a few times.
bool has_static_excess(const MotorDesign& motor) {
  return motor.friction.threshold > motor.friction.kinetic;
}

// A response at the voltage that is missing, which follows the design.
void follow_voltage(MetricDerivative& response, const MetricDerivative& voltage) {
  const double per_volt = std::exchange(response.gradient[index_of(Parameter::voltage)], 0.0);
  for (std::size_t p = 0; p < kParameterCount; ++p)
    response.gradient[p] += per_volt * voltage.gradient[p];
}

}  // namespace

// The least voltage that leaves every reserve (1 + r) u_0 / (1 + reserve), if the motor has less.
std::optional<MetricDerivative> CombinationResponses::missing_voltage(
    const MotorDesign& motor, const Numbers& reserves) const {
  const auto least =
      std::min_element(reserves.begin(), reserves.end(),
                       [](const auto& a, const auto& b) { return a.value.value < b.value.value; });
  if (!motor.stator.voltage || least == reserves.end() ||
      least->value.value >= kLeastVoltageReserve)
    return {};
  const double share = 1 + least->value.value;
  MetricDerivative voltage;
  voltage.value.value = (1 + kLeastVoltageReserve) * *motor.stator.voltage / share;
  for (std::size_t p = 0; p < kParameterCount; ++p)
    voltage.gradient[p] = -voltage.value.value / share * least->gradient[p];
  voltage.gradient[index_of(Parameter::voltage)] = 0;  // what is missing does not depend on it
  return voltage;
}

namespace {

bool lacks_values(const std::vector<MetricDerivative>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const auto& one) { return one.value.status != MetricStatus::ok; });
}

}  // namespace

// A time that does not end keeps each lower limit and breaks each upper one: what stands for it lies beyond both, and is flat. As a
// goal it ends the search.
void CombinationResponses::end_endless(Numbers& numbers) const {
  constexpr double kBeyond = 10;
  const std::size_t goals = problem_.objectives.size();
  for (std::size_t i = 0; i < goals; ++i)
    if (problem_.objectives[i].maximize && is_endless(numbers[i].value.status))
      throw EndlessGoal(responses_[i].text, numbers[i].value.status);
  for (std::size_t i = 0; i < problem_.limits.size(); ++i) {
    MetricDerivative& number = numbers[goals + i];
    const MotorLimit& limit = problem_.limits[i];
    if (!is_endless(number.value.status) || limit.metric.request() == nullptr) continue;
    const double end = std::isfinite(limit.upper) ? limit.upper : limit.lower;
    number = {{kBeyond * std::max(std::fabs(end), 1.0), MetricStatus::ok}, {}, Smoothness::flat};
  }
}

// Where the voltage does not run the motor, its metrics are those at the least voltage that does (Y5.4): continuous where it just
// runs, so that a search outside gets numbers; the reserves tell how far it has to go, and inside how near the end is. Without
// derivatives, as for the samples of a whole range, a motor that does not run has no answer.
CombinationResponses::Numbers CombinationResponses::numbers(const MotorDesign& motor,
                                                            bool gradient) const {
  Numbers numbers = values_of(motor, evaluator_, gradient);
  const bool lacks = lacks_values(numbers);
  Numbers reserves(responses_.size() - metrics_);
  for (MetricDerivative& one : reserves) one.value.value = kSomeReserve;
  if (!reserves.empty() && (lacks ? gradient : !has_static_excess(motor))) {
    Numbers found = values_of(motor, reserves_, gradient);
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k].value.status == MetricStatus::ok && found[k].value.value < kSomeReserve)
        reserves[k] = found[k];
    const auto missing = lacks ? missing_voltage(motor, reserves) : std::nullopt;
    if (missing) {
      numbers =
          values_of(with(motor, Parameter::voltage, missing->value.value), evaluator_, gradient);
      for (MetricDerivative& one : numbers) follow_voltage(one, *missing);
    }
  }
  end_endless(numbers);
  numbers.insert(numbers.end(), reserves.begin(), reserves.end());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const MetricStatus status = numbers[i].value.status;
    if (status != MetricStatus::ok)
      throw EvaluationError(reason(responses_[i], status), "no answer for this motor");
  }
  return numbers;
}

optim::Evaluation CombinationResponses::evaluate_motor(std::span<const double> design,
                                                       bool gradient) const {
  const MotorDesign motor = motor_of_combination(problem_, varied_, design);
  Numbers responses = numbers(motor, gradient);
  add_friction_order(design, responses);
  const auto slopes = gradient ? varied_.slopes(motor) : VariedParameters::Slopes{};
  optim::Evaluation evaluation;
  for (const MetricDerivative& response : responses) {
    evaluation.values.push_back(response.value.value);
    if (!gradient) continue;
    const std::vector<double> row = varied_.derivatives(response.gradient, slopes);
    evaluation.jacobian.insert(evaluation.jacobian.end(), row.begin(), row.end());
  }
  if (gradient) add_kinks(design, responses, evaluation);
  return evaluation;
}

// mu_0 - mu of the requested values. If it is negative, the motor has mu_0 = mu.
void CombinationResponses::add_friction_order(std::span<const double> design,
                                              Numbers& numbers) const {
  if (implied_.empty() || !implied_.back().orders_friction()) return;
  double kinetic = problem_.motor.friction.kinetic;
  double threshold = 0;
  for (std::size_t j = 0; j < problem_.variables.size(); ++j) {
    if (problem_.variables[j].parameter == Parameter::kinetic_friction) kinetic = design[j];
    if (problem_.variables[j].parameter == Parameter::static_friction) threshold = design[j];
  }
  constexpr std::size_t kStatic = index_of(Parameter::static_friction);
  constexpr std::size_t kKinetic = index_of(Parameter::kinetic_friction);
  if (threshold < kinetic) {
    for (MetricDerivative& response : numbers) {
      response.gradient[kKinetic] += response.gradient[kStatic];
      response.gradient[kStatic] = 0;
    }
  }
  MetricDerivative order;
  order.value.value = threshold - kinetic;
  order.gradient[kStatic] = 1;
  order.gradient[kKinetic] = -1;
  numbers.push_back(order);
}

void CombinationResponses::add_kinks(std::span<const double> design, const Numbers& numbers,
                                     optim::Evaluation& evaluation) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].smoothness != Smoothness::one_sided) continue;
    for (std::size_t j = 0; j < design.size(); ++j) add_kink(i, j, design, evaluation);
  }
}

// Metrics return the derivative of their branch. The derivative of the other branch is computed at a design next to
// this one.
void CombinationResponses::add_kink(std::size_t response, std::size_t variable,
                                    std::span<const double> design,
                                    optim::Evaluation& evaluation) const {
  const auto slope_aside = [&](double step) {
    std::vector<double> next(design.begin(), design.end());
    next[variable] *= 1 + step;
    try {
      const MotorDesign motor = motor_of_combination(problem_, varied_, next);
      const Numbers aside = metric_values(Motor(motor), std::span(&responses_[response], 1), true,
                                          varied_.fixed_static_friction());
      return varied_.derivatives(aside[0].gradient, varied_.slopes(motor))[variable];
    } catch (const InputError&) {  // the step leaves the admissible range
      return kNoValue;
    } catch (const EvaluationError&) {  // likewise for a derived parameter
      return kNoValue;
    }
  };
  if (info(problem_.variables[variable].parameter).integer) return;
  const double left = slope_aside(-kAside);
  const double right = slope_aside(kAside);
  const double size = std::max(std::fabs(left), std::fabs(right));
  if (!(std::fabs(left - right) > kSameSlope * size)) return;
  evaluation.kinks.push_back({response, variable, optim::Slope::one_sided, left, right});
}

MotorResponses::MotorResponses(DesignProblem problem)
    : problem_(std::move(problem)), implied_(implied_limits(problem_)) {
  for (DesignProblem& one : combinations(problem_))
    combinations_.emplace_back(std::move(one), implied_);
}

optim::Evaluation MotorResponses::evaluate(std::span<const double> design, bool gradient) const {
  const CombinationResponses& one = combinations_[combination_of(problem_, design)];
  const std::size_t variables = problem_.variables.size();
  optim::Evaluation evaluation = one.evaluate(design.first(variables), gradient);
  if (problem_.choices.empty() || evaluation.jacobian.empty()) return evaluation;
  std::vector<double> wide;  // with a column of zeros for each choice
  for (std::size_t i = 0; i < evaluation.values.size(); ++i) {
    const auto row = evaluation.jacobian.begin() + static_cast<std::ptrdiff_t>(i * variables);
    wide.insert(wide.end(), row, row + static_cast<std::ptrdiff_t>(variables));
    wide.resize(wide.size() + problem_.choices.size(), 0);
  }
  evaluation.jacobian = std::move(wide);
  return evaluation;
}

}  // namespace twum::studies
