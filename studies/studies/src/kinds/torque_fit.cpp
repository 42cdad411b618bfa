// SPDX-License-Identifier: Apache-2.0
#include "kinds/torque_fit.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::studies {
TorqueFit::TorqueFit(const MotorDesign& motor, std::vector<DesignVariable> parameters,
                     std::vector<MeasuredPoint> points, std::vector<DerivedParameter> derived)
    : motor_(motor),
      parameters_(std::move(parameters)),
      points_(std::move(points)),
      varied_(motor_, parameters_of(parameters_), std::move(derived)) {
  for (const MeasuredPoint& point : points_)
    requests_.push_back({Metric::torque_at, Argument::speed, point.speed});
}

optim::Residuals TorqueFit::residuals(std::span<const double> values) const {
  optim::Residuals failed;
  try {
    return torque_residuals(values);
  } catch (const EvaluationError& error) {
    failed.failure = error.reason();
  } catch (const InputError& error) {  // a combination of values that is no motor
    failed.failure = std::string("not a motor: ") + error.what();
  }
  return failed;
}

optim::Residuals TorqueFit::torque_residuals(std::span<const double> values) const {
  const MotorDesign motor = varied_.motor(values);
  const auto slopes = varied_.slopes(motor);
  const auto torques = differentiate(Motor(motor), requests_, varied_.fixed_static_friction());
  optim::Residuals result;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const MetricDerivative& torque = torques[i];
    if (torque.value.status != MetricStatus::ok)
      throw EvaluationError(std::string("torque: ") + to_string(torque.value.status), "no torque");
    if (torque.smoothness == Smoothness::undefined)
      throw EvaluationError("torque: no derivative", "no derivative");
    const double root = std::sqrt(points_[i].weight);
    result.values.push_back(root * (torque.value.value - points_[i].torque));
    for (const double slope : varied_.derivatives(torque.gradient, slopes))
      result.jacobian.push_back(root * slope);
  }
  return result;
}

double TorqueFit::rms(std::span<const double> residuals) const {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

double TorqueFit::torque_size() const {
  double sum = 0;
  for (const MeasuredPoint& point : points_) sum += point.torque * point.torque;
  return std::sqrt(sum / static_cast<double>(points_.size()));
}

std::vector<NamedValue> TorqueFit::derived(std::span<const double> values) const {
  if (varied_.derived().empty()) return {};
  const MotorDesign motor = varied_.motor(values);
  std::vector<NamedValue> list;
  for (const DerivedParameter& rule : varied_.derived()) {
    const ParameterInfo& row = info(rule.parameter);
    list.push_back({std::string(row.name), std::string(row.unit), get(motor, rule.parameter)});
  }
  return list;
}

double TorqueFit::static_ratio() const {
  const bool estimated = std::any_of(
      parameters_.begin(), parameters_.end(),
      [](const DesignVariable& range) { return range.parameter == Parameter::kinetic_friction; });
  const double kinetic = get(motor_, Parameter::kinetic_friction);
  if (!estimated || varied_.fixed_static_friction() || !(kinetic > 0)) return 1;
  return get(motor_, Parameter::static_friction) / kinetic;
}

std::vector<optim::Variable> TorqueFit::variables(std::span<const double> start) const {
  std::vector<optim::Variable> result;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const DesignVariable& range = parameters_[j];
    const double own = get(motor_, range.parameter);
    optim::Variable variable{std::string(info(range.parameter).name), range.min, range.max,
                             range.start, range.log ? optim::Scale::log : optim::Scale::linear};
    if (!start.empty())
      variable.start = start[j];
    else if (std::isnan(range.start) && own >= range.min && own <= range.max)
      variable.start = own;
    result.push_back(std::move(variable));
  }
  return result;
}

}  // namespace twum::studies
