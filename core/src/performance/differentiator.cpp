// SPDX-License-Identifier: Apache-2.0
#include "performance/differentiator.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace twum::performance {
namespace {

using M = Metric;

constexpr double kVanishing = 1e-8;  // length of a zone that counts as about to vanish [rad]
constexpr double kBeside = 1e-9;  // of the crest speed: a zone about to appear is there so far away
constexpr double kNoDerivative = std::numeric_limits<double>::quiet_NaN();

// Zones come or go a hair away from the speed.
bool zones_change_beside(const DrivenMotor<double>& m, const SolvedPoint& p, double speed) {
  const double hair = kBeside * m.crest_velocity / m.r;
  const WarmStart start = p.start();
  for (const double beside : {speed - hair, speed + hair}) {
    if (!wave_meets_rotor(m, beside)) continue;
    const SolvedPoint near = solve_point(m, beside, &start);
    if (near.status == PointStatus::ok && near.signature() != p.signature()) return true;
  }
  return false;
}

Derived with_speed(const Derived& moving, double speed) {
  return {with_value(moving.dual, speed), moving.smoothness};
}

}  // namespace

// One-sided where a zone is about to vanish or to appear, unless the torque is C1 there (theory section 8):
// elastic layers with mu_0 = mu. Special points are limits (locked at rest) or stand where nothing rubs.
Smoothness smoothness_of(const DrivenMotor<double>& m, const SolvedPoint& p, double speed) {
  if (is_trivial(m)) return Smoothness::undefined;
  if (p.special || p.locks_in_part()) return Smoothness::one_sided;
  const bool may_kink = m.static_ > m.kinetic || m.inertia > 0;
  const bool kinks =
      may_kink && (p.shortest_zone() < kVanishing || zones_change_beside(m, p, speed));
  return kinks ? Smoothness::one_sided : Smoothness::smooth;
}

Differentiator::Differentiator(const Motor& motor, bool fixed_static_friction)
    : design_(motor.design()),
      values_(motor.model()),
      m_(motor.model()),
      model_(differentiated_motor<ModelDual>(design_, m_.track)) {
  const ParameterJacobian jacobian = parameter_jacobian(design_, fixed_static_friction);
  for (std::size_t i = 0; i < kModelParameters.size(); ++i) {
    const auto& row = jacobian[index_of(kModelParameters[i])];
    for (std::size_t j = 0; j < kParameterCount; ++j)
      if (row[j] != 0) slopes_.push_back({i, j, row[j]});
  }
}

std::array<double, kParameterCount> Differentiator::in_parameters(const ModelDual& dual) const {
  std::array<double, kParameterCount> gradient{};
  for (const Slope& slope : slopes_) gradient[slope.parameter] += dual.d[slope.model] * slope.value;
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

MetricDerivative Differentiator::differentiate_at_share(Metric metric, double share) {
  return answered(values_.evaluate_at_share(metric, share), [&] {
    const Derived largest = metric_row(*this, {M::max_torque});
    const Derived load{share * largest.dual, largest.smoothness};
    return at(metric, crossing(search().speed_at(value_of(load.dual)), load));
  });
}

// Where partial turns into full contact the contact angle at the mean radius has no derivative.
Smoothness Differentiator::of_contact_angle() const {
  const double gap =
      m_.contact.full ? m_.contact.edge_cosine + 1 : m_.contact.half_angle - std::numbers::pi;
  return std::fabs(gap) < 1e-7 ? Smoothness::one_sided : Smoothness::smooth;
}

// An annulus takes the contact angle's square root into an integral, which is smooth there (W4.1).
Smoothness Differentiator::of_normal_contact() const {
  return m_.annulus.empty() ? of_contact_angle() : Smoothness::smooth;
}

// By (T3.2) theta_L grows with the cube root of the first preload, and pressure with the square of that. In full contact
// theta_L is pi.
Derived Differentiator::sized(const ModelDual& dual) const {
  if (m_.annulus.empty() && m_.contact.half_angle == 0) return {dual, Smoothness::undefined};
  const bool constant = std::all_of(dual.d, dual.d + kDirections, [](double d) { return d == 0; });
  return {dual, constant ? Smoothness::flat : of_contact_angle()};
}

Smoothness Differentiator::of_point(double speed) {
  for (const auto& [at, kept] : smoothness_) {
    if (at == speed) return kept;
  }
  const Smoothness found =
      worse(smoothness_of(m_, values_.point(speed), speed), of_normal_contact());
  return smoothness_.emplace_back(speed, found).second;
}

const PointNumbers<ModelDual>& Differentiator::numbers(double speed) {
  for (const auto& [at, kept] : duals_) {
    if (at == speed) return kept;
  }
  const ModelDual moving = speed_variable<ModelDual>(speed);
  return duals_.emplace_back(speed, values_.point(speed).differentiated(model_, moving)).second;
}

Derived Differentiator::at(Metric metric, const Derived& speed) {
  const double omega = value_of(speed.dual);
  if (metric == M::speed_at) return speed;
  ModelDual f = point_metric(metric, numbers(omega), speed_variable<ModelDual>(omega), model_);
  for (int j = 0; j < kSpeedDirection; ++j) f.d[j] += f.d[kSpeedDirection] * speed.dual.d[j];
  Smoothness smoothness = worse(speed.smoothness, of_point(omega));
  const SolvedPoint& p = values_.point(omega);
  const bool plateau = metric == M::torque_at && p.slips_one_way();
  const bool no_stick = metric == M::stick_fraction_at && p.numbers.stick_fraction == 0;
  if (smoothness == Smoothness::smooth && (plateau || no_stick)) smoothness = Smoothness::flat;
  return {f, smoothness};
}

Derived Differentiator::at_peak(Metric metric, const Peak& peak) {
  switch (peak.kind) {
    case PeakKind::smooth:
    case PeakKind::rest: return at(metric, fixed(peak.speed));
    case PeakKind::plateau_end: return at_plateau_end(metric, peak.speed);
    case PeakKind::beyond_plateau: return beyond_plateau(metric);
    case PeakKind::kink: break;
  }
  return {ModelDual(peak.value), Smoothness::undefined};
}

Derived Differentiator::along_peak(Metric metric, const Peak& peak) {
  if (peak.kind == PeakKind::beyond_plateau) return beyond_plateau(metric);
  return at(metric, speed_of_peak(M::output_power_at, peak));
}

// On the plateau T = mu F_N r.
Derived Differentiator::at_plateau_end(Metric metric, double speed) {
  const ModelDual torque = slipping_torque(model_);
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
    return {ModelDual(values_.at(metric, near)), Smoothness::undefined};
  const Derived f = at(metric, {end.dual * (1 + kDistance), end.smoothness}),
                g = at(metric, {end.dual * (1 + 4 * kDistance), end.smoothness});
  return Derived{2.0 * f.dual - g.dual, worse(f.smoothness, g.smoothness)}.at_kink();
}

Derived Differentiator::plateau() {
  const double end = search().plateau_end();
  if (!(end > 0)) return {ModelDual(end), Smoothness::flat};
  // With mu_0 > mu the laps may leave the plateau for another state before they must.
  const Margin margin = plateau_margin(m_, end);
  if (std::fabs(margin.value / margin.slope) > 1e-9 * m_.crest_velocity / m_.r)
    return {ModelDual(end), Smoothness::undefined};
  return {plateau_end_derivative(model_, end), of_normal_contact()};
}

Derived Differentiator::plateau_of_track() {
  const Derived slices = plateau();
  const double of_slices = value_of(slices.dual), end = track_plateau_end(m_, of_slices);
  if (end == of_slices) return slices;
  if (end == 0) return {ModelDual(0.0), Smoothness::flat};
  return {track_plateau_end_derivative(model_, end), Smoothness::smooth};
}

// dOmega = -d(T - load) / T_Omega.
Derived Differentiator::crossing(const Crossing& crossing, const Derived& load) {
  const double torque = value_of(load.dual), end = search().plateau_end();
  const bool on_plateau =
      end > 0 && crossing.speed == end && torque <= search().stall_torque() * (1 + 1e-12);
  if (on_plateau) return plateau().at_kink();
  const ModelDual speed(crossing.speed);
  if (crossing.slopeless) return {speed, Smoothness::undefined};
  const bool at_rest = crossing.speed == 0;
  if (at_rest && torque == 0) return {speed, Smoothness::one_sided};
  const ModelDual t = numbers(crossing.speed).torque - load.dual;
  if (at_rest && !(t.d[kSpeedDirection] < 0)) return {speed, Smoothness::undefined};
  ModelDual moving = speed;
  for (int j = 0; j < kSpeedDirection; ++j) moving.d[j] = -t.d[j] / t.d[kSpeedDirection];
  const Derived found{moving, worse(load.smoothness, of_point(crossing.speed))};
  return at_rest ? found.at_kink() : found;  // a load beyond the largest torque is not carried
}

// Where the slope f_Omega is zero: dOmega = -df_Omega / f_OmegaOmega.
Derived Differentiator::speed_of_peak(Metric metric, const Peak& peak) {
  if (peak.kind == PeakKind::rest) return {ModelDual(0.0), Smoothness::flat};
  if (peak.kind == PeakKind::kink) return {ModelDual(peak.speed), Smoothness::undefined};
  if (peak.kind == PeakKind::plateau_end || peak.kind == PeakKind::beyond_plateau)
    return with_speed(plateau(), peak.speed).at_kink();
  for (const auto& [kept, speed] : peak_speeds_) {
    if (kept == metric) return speed;
  }
  if (!model2_) model2_ = differentiated_motor<ModelDual2>(design_, m_.track);
  const ModelDual2 moving = speed_variable<ModelDual2>(peak.speed);
  const PointNumbers<ModelDual2> n = values_.point(peak.speed).differentiated(*model2_, moving);
  const ModelDual2 f = point_metric(metric, n, moving, *model2_);
  ModelDual speed(peak.speed);
  for (int j = 0; j < kSpeedDirection; ++j) speed.d[j] = -f.d[j].d[0] / f.d[kSpeedDirection].d[0];
  return peak_speeds_.emplace_back(metric, Derived{speed, of_point(peak.speed)}).second;
}

}  // namespace twum::performance
