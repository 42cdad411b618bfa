// SPDX-License-Identifier: Apache-2.0
#include "problem/metric_values.hpp"

#include <utility>

namespace twum::studies {
namespace {

bool same(const MetricRequest& a, const MetricRequest& b) {
  return a.metric == b.metric && a.argument == b.argument && a.at == b.at;
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
        answers_[i] = at_reachable_load(requests_[i].metric);
    }
  }

  const MetricDerivative& operator[](std::size_t place) const { return answers_[place]; }

 private:
  MetricDerivative at_reachable_load(Metric metric) const {
    if (gradient_) return differentiate_at_share(motor_, metric, kReachable, fixed_);
    return {evaluate_at_share(motor_, metric, kReachable), {}, Smoothness::smooth};
  }

  const Motor& motor_;
  bool gradient_;
  bool fixed_;
  std::vector<MetricRequest> requests_;
  std::vector<MetricDerivative> answers_;
};

}  // namespace

MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction) {
  return {{get(design, parameter), MetricStatus::ok},
          parameter_jacobian(design, fixed_static_friction)[index_of(parameter)],
          Smoothness::smooth};
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
