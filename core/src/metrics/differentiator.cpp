// SPDX-License-Identifier: Apache-2.0
#include "metrics/differentiator.hpp"

#include "metrics/motor_curve.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;

constexpr double kVanishing = 1e-8;  // length of a zone that counts as about to vanish [rad]
constexpr double kBeside = 1e-9;  // of the crest speed: a zone about to appear is there so far away
constexpr double kNoDerivative = std::numeric_limits<double>::quiet_NaN();

// Whether zones begin or end close to the speed.
bool zones_change_beside(const DrivenMotor<double>& m, const SolvedPoint& p, double speed) {
  const double offset = kBeside * m.mean.crest_velocity / m.r;
  for (const double beside : {speed - offset, speed + offset})
    if (wave_meets_rotor(m, beside) && p.changes_zones_at(m, beside)) return true;
  return false;
}

Derived with_speed(const Derived& moving, double speed) {
  return {with_value(moving.dual, speed), moving.smoothness};
}

// f with the speed, too, moving as it does.
DesignDual moved(DesignDual f, const DesignDual& speed) {
  const double slope = f.d[kSpeedDirection];
  f.d[kSpeedDirection] = 0;
  for (int j = 0; j < kDesignDirections; ++j)
    if (j != kSpeedDirection) f.d[j] += slope * speed.d[j];
  return f;
}

// Where f stays zero: dOmega = -df / f_Omega.
DesignDual zero_of(const DesignDual& f, double speed) {
  DesignDual moving(speed);
  for (int j = 0; j < kDesignDirections; ++j)
    if (j != kSpeedDirection) moving.d[j] = -f.d[j] / f.d[kSpeedDirection];
  return moving;
}

DrivenMotor<ModelDual> moving_motor(const Evaluator& values) {
  const MotorDesign& design = values.motor().design();
  const DrivenMotor<double>& m = values.first_motor();
  return values.has_drive() ? differentiated_motor(design, m.mean.amplitude, m.track)
                            : differentiated_motor<ModelDual>(design, m.track);
}

}  // namespace

// One-sided where a zone is about to vanish or to appear, unless the torque is C1 there (theory section 8):
// elastic layers with mu_0 = mu. Special points are limits (locked at rest) or stand where nothing rubs.
Smoothness smoothness_of(const DrivenMotor<double>& m, const SolvedPoint& p, double speed) {
  if (is_trivial(m)) return Smoothness::undefined;
  if (p.special || p.locks_in_part()) return Smoothness::one_sided;
  const bool may_kink = m.threshold > m.kinetic || m.inertia > 0;
  const bool kinks =
      may_kink && (p.shortest_zone() < kVanishing || zones_change_beside(m, p, speed));
  return kinks ? Smoothness::one_sided : Smoothness::smooth;
}

Differentiator::Differentiator(const Motor& motor, bool fixed_static_friction)
    : design_(motor.design()),
      values_(motor),
      m_(values_.first_motor()),
      model_(moving_motor(values_)),
      slopes_(direction_slopes(design_, fixed_static_friction)) {}

Differentiator::Differentiator(const Motor& motor, std::unique_ptr<const FollowedCurve> known,
                               bool fixed_static_friction)
    : design_(motor.design()),
      values_(motor, std::move(known)),
      m_(values_.first_motor()),
      model_(moving_motor(values_)),
      slopes_(direction_slopes(design_, fixed_static_friction)) {}

Differentiator::Differentiator(const Motor& motor, std::unique_ptr<const RestCurve> at_rest,
                               bool fixed_static_friction)
    : design_(motor.design()),
      values_(motor, std::move(at_rest)),
      m_(values_.first_motor()),
      model_(moving_motor(values_)),
      slopes_(direction_slopes(design_, fixed_static_friction)) {}

std::array<double, kParameterCount> Differentiator::in_parameters(const DesignDual& dual) const {
  std::array<double, kParameterCount> gradient = core::in_parameters(dual, slopes_);
  // Modes of other numbers of waves are computed only where they are asked for.
  const double share = dual.d[plate_direction(PlateNumber::mode_separation)];
  if (design_.stator.geometry && share != 0) {
    const auto slopes = mode_separation_slopes(design_);
    for (std::size_t j = 0; j < kParameterCount; ++j) gradient[j] += share * slopes[j];
  }
  return gradient;
}

// A limit may need points nearby that have no answer.
template <typename Ask>
MetricDerivative Differentiator::answered(const MetricValue& value, Ask ask) {
  MetricDerivative result{value, {}, Smoothness::undefined};
  result.gradient.fill(kNoDerivative);
  if (value.status != MetricStatus::ok) return result;
  try {
    const Derived derived = ask();
    const auto gradient = in_parameters(derived.dual);
    const bool finite =
        std::all_of(gradient.begin(), gradient.end(), [](double d) { return std::isfinite(d); });
    if (!finite || derived.smoothness == Smoothness::undefined) return result;
    return {value, gradient, derived.smoothness};
  } catch (const SearchFailure&) {
    return result;
  }
}

MetricDerivative Differentiator::differentiate(const MetricRequest& request) {
  return answered(values_.evaluate(request), [&] { return metric_row(*this, request); });
}

MetricDerivative Differentiator::differentiate_at(Metric metric, double speed,
                                                  std::optional<double> torque) {
  return answered(values_.evaluate_at(metric, speed), [&] {
    return at(metric, torque ? falling_through(speed, fixed(*torque)) : fixed(speed));
  });
}

MetricDerivative Differentiator::differentiate_at_share(Metric metric, double share) {
  return answered(values_.evaluate_at_share(metric, share), [&] {
    const Derived largest = metric_row(*this, {M::max_torque});
    const Derived load{share * largest.dual, largest.smoothness};
    return at(metric, crossing(search().speed_at(value_of(load.dual)), load));
  });
}

MetricDerivative Differentiator::torque_of_full_slip() {
  return answered({core::slipping_torque(m_), MetricStatus::ok},
                  [&] { return of_motor([](const auto& m) { return core::slipping_torque(m); }); });
}

// Where partial turns into full contact the contact angle at the mean radius has no derivative.
Smoothness Differentiator::of_contact_angle(const DrivenMotor<double>& m) const {
  const double gap = m.mean.contact.full ? m.mean.contact.edge_cosine + 1
                                         : m.mean.contact.half_angle - std::numbers::pi;
  return std::fabs(gap) < 1e-7 ? Smoothness::one_sided : Smoothness::smooth;
}

// An annulus takes the contact angle's square root into an integral, which is smooth there (W4.1).
Smoothness Differentiator::of_normal_contact(const DrivenMotor<double>& m) const {
  return m.annulus.empty() ? of_contact_angle(m) : Smoothness::smooth;
}

// By (T3.2) theta_L grows with the cube root of the first preload, and pressure with the square of that. In full contact
// theta_L is pi.
Derived Differentiator::sized(const ModelDual& dual) {
  const double begin = values_.begin();
  const bool vanishing = m_.annulus.empty() && m_.mean.contact.half_angle == 0;
  if (vanishing || begin > 0) return {DesignDual(dual.v), Smoothness::undefined};
  const bool constant = std::all_of(dual.d, dual.d + kDirections, [](double d) { return d == 0; });
  return {held(dual, begin), constant ? Smoothness::flat : of_contact_angle(m_)};
}

Smoothness Differentiator::of_point(double speed) {
  if (const auto kept = smoothness_places_.find(speed); kept != smoothness_places_.end())
    return smoothness_[kept->second];
  const Smoothness found =
      worse(smoothness_of(values_.motor_at(speed), values_.point(speed), speed),
            of_normal_contact(values_.motor_at(speed)));
  smoothness_places_.emplace(speed, smoothness_.size());
  return smoothness_.emplace_back(found);
}

template <typename T>
WaveMotion<T> Differentiator::wave_motion(const DrivenMotor<Dual<T, kDirections>>& motor,
                                          const WavePoint<DesignDualOf<T>>& point) {
  const auto modes = moving_modes(values_.modes(), motor.stator_damping);
  return WaveMotion<T>(drive_balance(modes, point).force() -
                       moving_drive(modes, *design_.stator.voltage));
}

const Differentiator::Moving& Differentiator::moving(double speed) {
  if (const auto place = dual_places_.find(speed); place != dual_places_.end())
    return duals_[place->second];
  const SolvedPoint& point = values_.point(speed);
  const ModelDual omega = speed_variable<ModelDual>(speed);
  const auto kept = [&](Moving moving) -> const Moving& {
    dual_places_.emplace(speed, duals_.size());
    return duals_.emplace_back(std::move(moving));
  };
  if (!values_.has_drive()) return kept({&model_, point.differentiated(model_, omega), {}});
  const DrivenMotor<ModelDual>& motor = motors_.emplace_back(
      differentiated_motor(design_, values_.motor_at(speed).mean.amplitude, m_.track));
  const PointNumbers<ModelDual> n = point.differentiated(motor, omega);
  return kept({&motor, n, wave_motion<double>(motor, wave_point(motor, n, omega))});
}

DesignDual Differentiator::held(const ModelDual& dual, double speed) {
  if (!values_.has_drive()) return widened(dual);
  return moving(speed).wave->of(widened(dual));
}

DesignDual Differentiator::wave_metric_at(Metric metric, double speed) {
  const Moving& p = moving(speed);
  const ModelDual variable = speed_variable<ModelDual>(speed);
  const auto modes = moving_modes(values_.modes(), p.motor->stator_damping);
  WavePoint<DesignDual> point = wave_point(*p.motor, p.numbers, variable);
  if (needs_backward_wave(metric, modes)) {
    const auto contact = values_.disturbed_contact_at(speed);
    point = with_backward_wave(metric, point, modes,
                               widened(moved_contact(*p.motor, variable, contact)));
  }
  return wave_metric(metric, modes, point);
}

Derived Differentiator::at(Metric metric, const Derived& speed) {
  if (metric == M::speed_at) return speed;
  const double omega = value_of(speed.dual);
  const SolvedPoint& point = values_.point(omega);
  const bool plateau = metric == M::torque_at && point.slips_one_way();
  const bool no_stick = metric == M::stick_fraction_at && point.numbers.stick_fraction == 0;
  Smoothness smoothness = worse(speed.smoothness, of_point(omega));
  if (smoothness == Smoothness::smooth && (plateau || no_stick)) smoothness = Smoothness::flat;
  // T = mu F_N r in closed form; an annulus that is split there has other slices than the model.
  const bool closed = plateau && point.drives() && !m_.track.splits;
  const DesignDual f = closed ? held(slipping_torque(model_), omega) : moving_metric(metric, omega);
  return {moved(f, speed.dual), smoothness};
}

// A point metric in all directions, the speed free.
DesignDual Differentiator::moving_metric(Metric metric, double speed) {
  const Moving& p = moving(speed);
  const ModelDual variable = speed_variable<ModelDual>(speed);
  const DesignDual f = is_wave_metric(metric)
                           ? wave_metric_at(metric, speed)
                           : widened(point_metric(metric, p.numbers, variable, *p.motor));
  return p.wave ? p.wave->of(f) : f;
}

Derived Differentiator::at_peak(Metric metric, const Peak& peak) {
  switch (peak.kind) {
    case PeakKind::smooth:
    case PeakKind::rest: return at(metric, fixed(peak.speed));
    case PeakKind::plateau_end: return at_plateau_end(metric, peak.speed);
    case PeakKind::beyond_plateau: return beyond_plateau(metric);
    case PeakKind::kink: break;
  }
  return {DesignDual(peak.value), Smoothness::undefined};
}

Derived Differentiator::along_peak(Metric metric, const Peak& peak) {
  if (peak.kind == PeakKind::beyond_plateau) return beyond_plateau(metric);
  return at(metric, speed_of_peak(M::output_power_at, peak));
}

// On the plateau T = mu F_N r. Over an annulus r moves with the wave.
Derived Differentiator::at_plateau_end(Metric metric, double speed) {
  const DesignDual torque = held(slipping_torque(model_), speed);
  if (metric == M::torque_at) return {torque, Smoothness::flat};
  const Derived end = plateau();
  if (metric == M::output_power_at) return Derived{torque * end.dual, end.smoothness}.at_kink();
  return at(metric, with_speed(end, speed)).at_kink();
}

// The limit where the torque has jumped off its plateau. There slip ends where v_rel just touches zero, at a
// place that moves like the square root of the distance to the jump: two distances tell the limit.
Derived Differentiator::beyond_plateau(Metric metric) {
  constexpr double kDistance = 1e-10;  // its root is far from rounding, itself from what counts
  const Derived end = plateau();
  const double near = value_of(end.dual) * (1 + kDistance),
               far = value_of(end.dual) * (1 + 4 * kDistance);
  const SolvedPoint &a = values_.point(near), &b = values_.point(far);
  if (a.slips_one_way() || a.signature() != b.signature())
    return {DesignDual(values_.at(metric, near)), Smoothness::undefined};
  const Derived f = at(metric, {end.dual * (1 + kDistance), end.smoothness}),
                g = at(metric, {end.dual * (1 + 4 * kDistance), end.smoothness});
  return Derived{2.0 * f.dual - g.dual, worse(f.smoothness, g.smoothness)}.at_kink();
}

Derived Differentiator::plateau() {
  const double end = search().plateau_end();
  if (!(end > 0)) return {DesignDual(end), Smoothness::flat};
  // With mu_0 > mu the laps may leave the plateau for another state before they must.
  const Margin margin = plateau_margin(m_, end);
  if (std::fabs(margin.value / margin.slope) > 1e-9 * m_.mean.crest_velocity / m_.r)
    return {DesignDual(end), Smoothness::undefined};
  return {zero_of(held(plateau_margin_derivative(model_, end), end), end), of_normal_contact(m_)};
}

Derived Differentiator::plateau_of_track() {
  const Derived slices = plateau();
  const double end = values_.plateau_of_track();
  if (end == value_of(slices.dual)) return slices;
  if (end == 0) return {DesignDual(0.0), Smoothness::flat};
  // With mu_0 > mu an edge may leave the plateau for another state before its margin is used up.
  const ModelDual margin = edge_margin_derivative(model_, end);
  if (std::fabs(margin.v / margin.d[kSpeedDirection]) > 1e-9 * m_.mean.crest_velocity / m_.r)
    return {DesignDual(end), Smoothness::undefined};
  return {zero_of(held(edge_margin_derivative(model_, end), end), end), Smoothness::smooth};
}

// dOmega = -d(T - load) / T_Omega.
Derived Differentiator::crossing(const Crossing& crossing, const Derived& load) {
  const double torque = value_of(load.dual), end = search().plateau_end();
  const bool on_plateau =
      end > 0 && crossing.speed == end && torque <= search().stall_torque() * (1 + 1e-12);
  if (on_plateau) return plateau().at_kink();
  if (crossing.slopeless) return {DesignDual(crossing.speed), Smoothness::undefined};
  return falling_through(crossing.speed, load);
}

Derived Differentiator::falling_through(double speed, const Derived& load) {
  const bool at_rest = speed == 0;
  if (at_rest && value_of(load.dual) == 0) return {DesignDual(speed), Smoothness::one_sided};
  const DesignDual t = held(moving(speed).numbers.torque, speed) - load.dual;
  if (at_rest && !(t.d[kSpeedDirection] < 0)) return {DesignDual(speed), Smoothness::undefined};
  const Derived found{zero_of(t, speed), worse(load.smoothness, of_point(speed))};
  return at_rest ? found.at_kink() : found;  // a load beyond the largest torque is not carried
}

// Where the slope f_Omega is zero: dOmega = -df_Omega / f_OmegaOmega.
Derived Differentiator::speed_of_peak(Metric metric, const Peak& peak) {
  if (peak.kind == PeakKind::rest) return {DesignDual(0.0), Smoothness::flat};
  if (peak.kind == PeakKind::kink) return {DesignDual(peak.speed), Smoothness::undefined};
  if (peak.kind == PeakKind::plateau_end || peak.kind == PeakKind::beyond_plateau)
    return with_speed(plateau(), peak.speed).at_kink();
  for (const auto& [kept, speed] : peak_speeds_) {
    if (kept == metric) return speed;
  }
  const DesignDual2 f = along_curve(metric, peak.speed);
  DesignDual slope;
  slope.v = f.d[kSpeedDirection].v;
  for (int j = 0; j < kDesignDirections; ++j) slope.d[j] = f.d[j].d[0];
  return peak_speeds_
      .emplace_back(metric, Derived{zero_of(slope, peak.speed), of_point(peak.speed)})
      .second;
}

// A metric with its derivatives and theirs along the curve.
DesignDual2 Differentiator::along_curve(Metric metric, double speed) {
  const bool driven = values_.has_drive();
  if (driven) {
    contact::SpeedDual amplitude(values_.motor_at(speed).mean.amplitude);
    amplitude.d[0] = moving(speed).wave->in_speed();
    model2_ = differentiated_motor(design_, amplitude, m_.track);
  } else if (!model2_) {
    model2_ = constant_in_speed(model_);
  }
  const ModelDual2 variable = speed_variable<ModelDual2>(speed);
  const PointNumbers<ModelDual2> n = values_.point(speed).differentiated(*model2_, variable);
  const auto p = wave_point(*model2_, n, variable);
  const DesignDual2 f =
      is_wave_metric(metric)
          ? wave_metric(metric, moving_modes(values_.modes(), model2_->stator_damping), p)
          : widened(point_metric(metric, n, variable, *model2_));
  return driven ? wave_motion<contact::SpeedDual>(*model2_, p).of(f) : f;
}

}  // namespace twum::inline v0_1::core
