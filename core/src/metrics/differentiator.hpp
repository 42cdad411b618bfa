// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/direction_slopes.hpp"
#include "metrics/evaluator.hpp"
#include "metrics/wave_motion.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::core {

inline Smoothness worse(Smoothness a, Smoothness b) { return std::max(a, b); }

/// A number with its derivatives in kModelParameters and kDriveParameters, the speed no longer free, and the amplitude
/// neither where a voltage holds it.
struct Derived {
  DesignDual dual;
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
  /// Of a motor under a voltage at the one point that is known.
  Differentiator(const Motor& motor, std::unique_ptr<const FollowedCurve> known,
                 bool fixed_static_friction);
  /// Of a motor under a voltage that stands still, for its thresholds.
  Differentiator(const Motor& motor, std::unique_ptr<const RestCurve> at_rest,
                 bool fixed_static_friction);

  MetricDerivative differentiate(const MetricRequest& request);
  /// A point metric at a speed, which stays, or where the curve falls through a torque, which stays.
  MetricDerivative differentiate_at(Metric metric, double speed, std::optional<double> torque);
  /// At a load of a share of the largest torque, which moves with the design.
  MetricDerivative differentiate_at_share(Metric metric, double share);
  /// T_p, the torque of a contact that slips all through (T7.8).
  MetricDerivative torque_of_full_slip();

  Derived fixed(double x) const { return {DesignDual(x)}; }
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
  Derived at_pull_out(Metric metric);
  /// The wave at a fold moves with the design, but that does not count where H is at its extremum.
  Derived threshold(Metric metric);
  struct RestForce {
    DesignDual force;  ///< H [N]
    double slope;      ///< H_A [N/m]
    Smoothness smoothness;
  };
  /// H of a wave at rest at the threshold's frequency (D2.4); derivatives at fixed amplitude.
  RestForce force_at_rest(const Threshold& threshold, double amplitude, const MotorDesign& design);
  template <typename F>
  Derived of_motor(F f) const {
    return {widened(f(model_))};
  }
  template <typename F>
  Derived of_contact(F f) {
    return sized(f(model_));
  }
  template <typename F>
  Derived of_modes(F f) {
    return {f(moving_modes(values_.modes(), model_.stator_damping))};
  }
  Derived of_plate(PlateNumber number) const {
    return {DesignDual::variable(values_.of_plate(number), plate_direction(number))};
  }
  Derived free_wave() {
    const double voltage = values_.voltage();
    const auto modes = moving_modes(values_.modes(), model_.stator_damping);
    return {free_amplitude(modes, widened(model_.omega), moving_drive(modes, voltage))};
  }
  Derived product(const Derived& a, const Derived& b) const {
    return {a.dual * b.dual, worse(a.smoothness, b.smoothness)};
  }
  CurveSearch& search() { return values_.search(); }

 private:
  /// A point with derivatives.
  struct Moving {
    const DrivenMotor<ModelDual>* motor;
    PointNumbers<ModelDual> numbers;
    std::optional<WaveMotion<double>> wave;  ///< under a voltage
  };

  template <typename Ask>
  MetricDerivative answered(const MetricValue& value, Ask ask);
  std::array<double, kParameterCount> in_parameters(const DesignDual& dual) const;
  Derived falling_through(double speed, const Derived& load);
  Derived sized(const ModelDual& dual);
  Smoothness of_contact_angle(const DrivenMotor<double>& motor) const;
  Smoothness of_normal_contact(const DrivenMotor<double>& motor) const;
  Derived plateau();
  Smoothness of_point(double speed);
  const Moving& moving(double speed);
  /// A number at a speed, with the amplitude held by the voltage if there is one.
  DesignDual held(const ModelDual& dual, double speed);
  template <typename T>
  WaveMotion<T> wave_motion(const DrivenMotor<Dual<T, kDirections>>& motor,
                            const WavePoint<DesignDualOf<T>>& point);
  DesignDual wave_metric_at(Metric metric, double speed);
  DesignDual moving_metric(Metric metric, double speed);
  DesignDual2 along_curve(Metric metric, double speed);
  DesignDual frequency_of(DesignDual excess, const MotorDesign& there, double frequency) const;
  Derived at_plateau_end(Metric metric, double speed);
  Derived beyond_plateau(Metric metric);

  const MotorDesign& design_;
  Evaluator values_;
  const DrivenMotor<double>& m_;  // under the wave that the curve begins with
  DrivenMotor<ModelDual> model_;
  std::vector<DirectionSlope> slopes_;
  std::optional<DrivenMotor<ModelDual2>> model2_;
  std::vector<std::pair<Metric, Derived>> peak_speeds_;  // of smooth peaks
  // References stay valid.
  std::deque<Moving> duals_;
  std::map<double, std::size_t> dual_places_;  // of a speed among them
  std::deque<DrivenMotor<ModelDual>> motors_;
  std::vector<Smoothness> smoothness_;
  std::map<double, std::size_t> smoothness_places_;  // likewise
};

}  // namespace twum::inline v0_1::core
