// SPDX-License-Identifier: Apache-2.0
#include "performance/curve/prescribed_curve.hpp"

namespace twum::performance {

MetricStatus metric_status(PointStatus status) {
  switch (status) {
    case PointStatus::ok: return MetricStatus::ok;
    case PointStatus::no_periodic_state: return MetricStatus::no_periodic_state;
    case PointStatus::not_converged: return MetricStatus::not_converged;
    case PointStatus::resonance: return MetricStatus::resonance;
    case PointStatus::unresolved: return MetricStatus::unresolved;
    case PointStatus::inaccurate: return MetricStatus::inaccurate;
    case PointStatus::pulled_out: return MetricStatus::pulled_out;
    case PointStatus::no_running_branch: return MetricStatus::no_running_branch;
    case PointStatus::no_dead_branch: return MetricStatus::no_dead_branch;
    case PointStatus::unstable_amplitude: return MetricStatus::unstable_amplitude;
  }
  return MetricStatus::unresolved;
}

CurvePoint PrescribedCurve::point(double speed, const WarmStart* guess, double accuracy) const {
  const SolvedPoint p = solve_point(motor(), speed, guess, accuracy);
  if (p.status != PointStatus::ok)
    return {.speed = speed, .status = metric_status(p.status), .lost = p.zones_followed()};
  return {.speed = speed,
          .torque = p.numbers.torque,
          .input = p.numbers.stator_power + stator_loss(motor()),
          .plateau = p.drives(),
          .special = p.special,
          .signature = p.signature(),
          .start = p.start()};
}

CurveSlope PrescribedCurve::slope(double speed, const WarmStart* guess) const {
  const TorqueSlope t = torque_slope(motor(), speed, guess);
  if (t.status != PointStatus::ok) throw SearchFailure{metric_status(t.status)};
  return {
      speed, {t.torque, t.slope}, {t.stator_power + stator_loss(motor()), t.power_slope}, t.start};
}

}  // namespace twum::performance
