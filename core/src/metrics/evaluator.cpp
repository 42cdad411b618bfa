// SPDX-License-Identifier: Apache-2.0
#include "metrics/evaluator.hpp"
#include "metrics/found_value.hpp"
#include "metrics/motor_parts.hpp"

#include "metrics/motor_curve.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

std::unique_ptr<const Curve> curve_of(const Motor& motor) {
  if (!MotorParts::drive(motor))
    return std::make_unique<PrescribedCurve>(MotorParts::model(motor), MotorParts::modes(motor));
  return std::make_unique<DrivenCurve>(*MotorParts::drive(motor), MotorParts::model(motor));
}

}  // namespace

Evaluator::Evaluator(const Motor& motor)
    : motor_(motor), curve_(curve_of(motor)), m_(curve_->motor()), search_(*curve_) {}

Evaluator::Evaluator(const Motor& motor, std::unique_ptr<const FollowedCurve> known)
    : motor_(motor), curve_(std::move(known)), m_(curve_->motor()), search_(*curve_) {
  const MotorPoint& point = static_cast<const FollowedCurve&>(*curve_).found();
  places_.emplace(curve_->begin(), points_.size());
  points_.push_back({&point.motor, point.solved});
}

Evaluator::Evaluator(const Motor& motor, std::unique_ptr<const RestCurve> at_rest)
    : motor_(motor), curve_(std::move(at_rest)), m_(curve_->motor()), search_(*curve_) {}

const StatorModes<double>& Evaluator::modes() const {
  if (!MotorParts::modes(motor_)) throw SearchFailure{MetricStatus::undefined};
  return *MotorParts::modes(motor_);
}

Thresholds& Evaluator::thresholds() {
  modes();
  if (thresholds_) return *thresholds_;
  const WavesAtRest* rest = MotorParts::at_rest(motor_);
  thresholds_.emplace(motor_.design(), m_.track,
                      rest ? std::optional(rest->extrema()) : std::nullopt,
                      rest ? rest->largest() : nullptr);
  return *thresholds_;
}

const CurveNode& Evaluator::pull_out() const {
  if (!MotorParts::drive(motor_)) throw SearchFailure{MetricStatus::undefined};
  const RunningBranch& branch = MotorParts::drive(motor_)->branch();
  if (!branch.exists()) throw SearchFailure{MetricStatus::no_running_branch};
  const CurveNode* end = branch.pull_out();
  if (!end) throw SearchFailure{MetricStatus::does_not_pull_out};
  return *end;
}

double Evaluator::at_pull_out(Metric metric) {
  const MotorPoint at = pull_out_point();
  return point_metric(metric, at.solved.numbers, pull_out().parameter, at.motor);
}

MotorPoint Evaluator::pull_out_point() const {
  const CurveNode& end = pull_out();
  MotorPoint at{MotorParts::drive(motor_)->waves().motor(end.amplitude), {}};
  at.solved = solve_point(at.motor, end.parameter, &end.start);
  if (at.solved.status != PointStatus::ok) throw SearchFailure{metric_status(at.solved.status)};
  return at;
}

double Evaluator::of_plate(PlateNumber number) const {
  if (!motor_.design().stator.geometry) throw SearchFailure{MetricStatus::undefined};
  const MotorDesign& design = motor_.design();
  return number == PlateNumber::mode_separation ? mode_separation(design)
                                                : plate_numbers(design)[index_of(number)];
}

// To find that out by a throw takes as long as several points.
bool Evaluator::has_meaning(Metric metric) const {
  const MetricInfo& row = info(metric);
  if ((row.needs_modes && !MotorParts::modes(motor_)) ||
      (row.needs_geometry && !motor_.design().stator.geometry))
    return false;
  const bool of_stator =
      metric == Metric::max_efficiency || metric == Metric::speed_at_max_efficiency;
  return !of_stator || curve_->has_input();
}

template <typename Find>
MetricValue Evaluator::found(Metric metric, Find find) {
  if (!has_meaning(metric)) return {kNoValue, MetricStatus::undefined};
  return found_value(find);
}

MetricValue Evaluator::evaluate(const MetricRequest& request) {
  return found(request.metric, [&] { return metric_row(*this, request); });
}

MetricValue Evaluator::evaluate_at(Metric metric, double speed) {
  return found(metric, [&] { return at(metric, speed); });
}

MetricValue Evaluator::evaluate_at_share(Metric metric, double share) {
  const MetricValue largest = evaluate({Metric::max_torque});
  if (largest.status != MetricStatus::ok || !(largest.value > 0))
    return {kNoValue, MetricStatus::unreachable};
  return evaluate({metric, Argument::torque, share * largest.value});
}

double Evaluator::at(Metric metric, double speed) {
  if (!wave_meets_rotor(m_, speed)) throw SearchFailure{MetricStatus::out_of_range};
  require_input(metric, speed);
  const PointNumbers<double>& n = point(speed).numbers;
  const DrivenMotor<double>& m = motor_at(speed);
  if (!is_wave_metric(metric)) return point_metric(metric, n, speed, m);
  if (needs_sensor(metric) && !modes().sensor) throw SearchFailure{MetricStatus::undefined};
  WavePoint<double> p{m.mean.amplitude, m.omega, n.reactive_force, n.stator_power,
                      n.torque * speed};
  if (needs_backward_wave(metric, modes()))
    p = with_backward_wave(metric, p, modes(), disturbed_contact_at(speed));
  return wave_metric(metric, modes(), p);
}

DisturbedContact<double> Evaluator::disturbed_contact_at(double speed) {
  auto contact = disturbed_contact(motor_at(speed), speed);
  if (!contact) throw SearchFailure{MetricStatus::backward_wave_unknown};
  return *contact;
}

double Evaluator::at_peak(Metric metric, const Peak& peak) {
  require_input(metric, peak.speed);
  return peak.value;
}

double Evaluator::speed_of_peak(Metric metric, const Peak& peak) {
  require_input(metric, peak.speed);
  return peak.speed;
}

const Evaluator::Known& Evaluator::known(double speed) {
  if (const auto kept = places_.find(speed); kept != places_.end()) return points_[kept->second];
  const DrivenMotor<double>* motor = &m_;
  SolvedPoint solved;
  if (has_drive()) {
    MotorPoint at = MotorParts::drive(motor_)->at(speed);
    motor = &motors_.emplace_back(at.motor);
    solved = at.solved;
  } else {
    solved = solve_point(m_, speed);
  }
  if (solved.status != PointStatus::ok) throw SearchFailure{metric_status(solved.status)};
  places_.emplace(speed, points_.size());
  return points_.emplace_back(Known{motor, std::move(solved)});
}

// An efficiency needs an input power that is more than rounding.
void Evaluator::require_input(Metric metric, double speed) {
  const bool contact_alone = metric == Metric::contact_efficiency_at,
             overall = metric == Metric::overall_efficiency_at;
  if (!contact_alone && !overall && metric != Metric::efficiency_at) return;
  const PointNumbers<double>& n = point(speed).numbers;
  const double input = overall
                           ? at(Metric::electrical_power_at, speed)
                           : n.stator_power + (contact_alone ? 0 : stator_loss(motor_at(speed)));
  if (!(input > 0)) throw SearchFailure{MetricStatus::undefined};
  if (!is_known(input, excess(n, speed))) throw SearchFailure{MetricStatus::inaccurate};
}

}  // namespace twum::inline v0_1::core
