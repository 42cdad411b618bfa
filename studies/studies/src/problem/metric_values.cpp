// SPDX-License-Identifier: Apache-2.0
#include "problem/metric_values.hpp"

#include "problem/load_out_of_reach.hpp"

#include <utility>

namespace twum::studies {
namespace {

using P = Parameter;
using Powers = std::vector<std::pair<P, double>>;

bool same(const MetricRequest& a, const MetricRequest& b) {
  return a.metric == b.metric && a.argument == b.argument && a.at == b.at;
}

// Parameters that follow from others are products of powers (of 1 + nu in the case of nu).
Powers powers(P parameter) {
  switch (parameter) {
    case P::shear_modulus: return {{P::youngs_modulus, 1}, {P::poisson_ratio, -1}};
    case P::shear_viscosity:  // gamma = loss_factor G / omega
      return {{P::loss_factor, 1}, {P::shear_modulus, 1}, {P::frequency, -1}};
    case P::inertia: return {{P::density, 1}, {P::thickness, 2}};
    case P::poisson_ratio: return {{P::youngs_modulus, 1}, {P::shear_modulus, -1}};
    case P::loss_factor:
      return {{P::shear_viscosity, 1}, {P::shear_modulus, -1}, {P::frequency, 1}};
    case P::density: return {{P::inertia, 1}, {P::thickness, -2}};
    default: return {};
  }
}

// What a power in powers() is of: the parameter itself, or 1 + nu.
double base(const MotorDesign& design, P parameter) {
  return get(design, parameter) + (parameter == P::poisson_ratio ? 1 : 0);
}

using Gradient = std::array<double, kParameterCount>;

void add_gradient(const MotorDesign& design, P parameter, bool fixed_static_friction, double factor,
                  Gradient& gradient) {
  if (in_use(design, parameter)) gradient[index_of(parameter)] += factor;
  if (parameter == P::static_friction && !fixed_static_friction) {  // keeps its ratio to mu
    const Friction& friction = design.friction;
    gradient[index_of(P::kinetic_friction)] +=
        factor * (friction.kinetic > 0 ? friction.static_ / friction.kinetic : 1);
  }
  if (in_use(design, parameter)) return;
  const double value = base(design, parameter);
  for (const auto& [other, power] : powers(parameter)) {
    // value = const * prod base^power, so d value / d base = power value / base. With a loss factor or
    // density of zero the power is that of the factor that is zero: the rest is its derivative.
    double slope = 0;
    if (value != 0) {
      slope = power * value / base(design, other);
    } else if (base(design, other) == 0) {
      slope = base(with(design, other, 1), parameter);
    }
    add_gradient(design, other, fixed_static_friction, factor * slope, gradient);
  }
}

class Collected {
 public:
  Collected(const Motor& motor, bool gradient, bool fixed)
      : motor_(motor), gradient_(gradient), fixed_(fixed) {}

  // Where the answer to a request will be.
  std::size_t add(const MetricRequest& request) {
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      if (same(requests_[i], request)) return i;
    }
    requests_.push_back(request);
    return requests_.size() - 1;
  }

  void answer() {
    if (gradient_) {
      answers_ = differentiate(motor_, requests_, fixed_);
    } else {
      for (const MetricValue& value : twum::evaluate(motor_, requests_)) {
        answers_.push_back({value, {}, Smoothness::smooth});
      }
    }
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      if (answers_[i].value.status == MetricStatus::unreachable)
        answers_[i] = out_of_reach(motor_, requests_[i].metric, gradient_, fixed_);
    }
  }

  const MetricDerivative& operator[](std::size_t place) const { return answers_[place]; }

 private:
  const Motor& motor_;
  bool gradient_;
  bool fixed_;
  std::vector<MetricRequest> requests_;
  std::vector<MetricDerivative> answers_;
};

}  // namespace

MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction) {
  MetricDerivative result;
  result.value.value = get(design, parameter);
  add_gradient(design, parameter, fixed_static_friction, 1, result.gradient);
  return result;
}

std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            std::span<const MetricExpression> expressions,
                                            bool gradient, bool fixed_static_friction) {
  Collected collected(motor, gradient, fixed_static_friction);
  std::vector<std::size_t> places;
  for (const MetricExpression& expression : expressions) {
    const auto* request = std::get_if<MetricRequest>(&expression.what);
    places.push_back(request != nullptr ? collected.add(*request) : 0);
  }
  collected.answer();
  std::vector<MetricDerivative> values;
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    const auto* parameter = std::get_if<Parameter>(&expressions[i].what);
    values.push_back(parameter != nullptr
                         ? parameter_value(motor.design(), *parameter, fixed_static_friction)
                         : collected[places[i]]);
  }
  return values;
}

}  // namespace twum::studies
