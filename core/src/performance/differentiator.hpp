// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/evaluator.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace twum::performance {

inline Smoothness worse(Smoothness a, Smoothness b) { return std::max(a, b); }

/// A number with its derivatives in kModelParameters, the speed no longer free.
struct Derived {
  ModelDual dual;
  Smoothness smoothness{Smoothness::smooth};

  Derived at_kink() const { return {dual, worse(smoothness, Smoothness::one_sided)}; }
};

/// What the derivatives of a point in the parameters or the speed are good for.
Smoothness smoothness_of(const DrivenMotor<double>& motor, const SolvedPoint& point, double speed);

/// Metrics with their derivatives. The members between the first and search() are what metric_row() is made of.
class Differentiator {
 public:
  using Number = Derived;

  Differentiator(const Motor& motor, bool fixed_static_friction);

  MetricDerivative differentiate(const MetricRequest& request);
  /// At a load of a share of the largest torque, which moves with the design.
  MetricDerivative differentiate_at_share(Metric metric, double share);

  Derived fixed(double x) const { return {ModelDual(x)}; }
  /// A point metric at a speed that moves with the parameters.
  Derived at(Metric metric, const Derived& speed);
  /// The value of a peak: the speed drops out where the slope is zero.
  Derived at_peak(Metric metric, const Peak& peak);
  /// A point metric where the power has its peak.
  Derived along_peak(Metric metric, const Peak& peak);
  Derived speed_of_peak(Metric metric, const Peak& peak);
  /// A speed where the torque takes a load that moves with the parameters.
  Derived crossing(const Crossing& crossing, const Derived& load);
  Derived plateau_of_track();
  template <typename F>
  Derived of_motor(F f) const {
    return {f(model_)};
  }
  template <typename F>
  Derived of_contact(F f) const {
    return sized(f(model_));
  }
  CurveSearch& search() { return values_.search(); }

 private:
  /// How one of kModelParameters moves with a parameter in use.
  struct Slope {
    std::size_t model, parameter;
    double value;
  };

  template <typename Ask>
  MetricDerivative answered(const MetricValue& value, Ask ask);
  std::array<double, kParameterCount> in_parameters(const ModelDual& dual) const;
  Derived sized(const ModelDual& dual) const;
  Smoothness of_contact_angle() const;
  Smoothness of_normal_contact() const;
  Derived plateau();
  Smoothness of_point(double speed);
  const PointNumbers<ModelDual>& numbers(double speed);
  Derived at_plateau_end(Metric metric, double speed);
  Derived beyond_plateau(Metric metric);

  const MotorDesign& design_;
  Evaluator values_;
  const DrivenMotor<double>& m_;
  DrivenMotor<ModelDual> model_;
  std::vector<Slope> slopes_;  // those that are not zero
  std::optional<DrivenMotor<ModelDual2>> model2_;
  std::vector<std::pair<Metric, Derived>> peak_speeds_;  // of smooth peaks
  std::deque<std::pair<double, PointNumbers<ModelDual>>> duals_;
  std::vector<std::pair<double, Smoothness>> smoothness_;
};

}  // namespace twum::performance
