// SPDX-License-Identifier: Apache-2.0
#include "problem/motor_responses.hpp"

#include "problem/combinations.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// Relative step to either side of a kink. It is far above rounding, and its error in the one-sided derivative is of
// the same order.
constexpr double kAside = 1e-7;
// One-sided derivatives that differ by less than this, relative, are taken as one.
constexpr double kSameSlope = 1e-4;

// A goal that a design reaches without end: none can be better, and the search is over.
class EndlessGoal : public InputError {
 public:
  EndlessGoal(const std::string& goal, MetricStatus status)
      : InputError("study.maximize: " + goal + " has no end for a design within the ranges (" +
                   to_string(status) + "), so that there is no largest; give it as a limit") {}
};

std::string reason(const MetricExpression& metric, MetricStatus status) {
  return metric.text + ": " + to_string(status);
}

}  // namespace

CombinationResponses::CombinationResponses(DesignProblem problem, std::vector<ImpliedLimit> implied,
                                           RunningReserves running)
    : problem_(std::move(problem)),
      varied_(varied_parameters(problem_)),
      implied_(std::move(implied)),
      running_(running),
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

// The reserve at a torque costs 6 times as much as a metric; of an evaluation with 8 slices it would be the larger part, with `auto`
// 14 times as much, and with mu_0 > mu 100 times.
bool has_dear_reserve(const MotorDesign& motor) {
  return motor.friction.threshold > motor.friction.kinetic || motor.stator.radial_slices != 1;
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
  const bool wanted =
      lacks ? gradient : running_ == RunningReserves::computed && !has_dear_reserve(motor);
  Numbers reserves(responses_.size() - metrics_);
  for (MetricDerivative& one : reserves) one.value.value = kSomeReserve;
  if (!reserves.empty() && wanted) {
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

MotorResponses::MotorResponses(DesignProblem problem, RunningReserves running)
    : problem_(std::move(problem)), implied_(implied_limits(problem_)) {
  for (DesignProblem& one : combinations(problem_))
    combinations_.emplace_back(std::move(one), implied_, running);
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

}  // namespace twum::inline v0_1::studies
