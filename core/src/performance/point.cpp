// SPDX-License-Identifier: Apache-2.0
#include "performance/point.hpp"

#include "contact/zone_curves.hpp"
#include "performance/scalars.hpp"

#include <cmath>

namespace twum::performance {
namespace {

using contact::LayerMotion;
using contact::PeriodicStatus;

PointStatus point_status(PeriodicStatus status) {
  switch (status) {
    case PeriodicStatus::ok: return PointStatus::ok;
    case PeriodicStatus::no_periodic_state: return PointStatus::no_periodic_state;
    case PeriodicStatus::not_converged: return PointStatus::not_converged;
    case PeriodicStatus::resonance: return PointStatus::resonance;
    case PeriodicStatus::unresolved: return PointStatus::unresolved;
  }
  return PointStatus::unresolved;
}

// Of the scale of powers (T7.11). A million random motors balance to 3e-11; in nearly rigid layers, far from any motor, the
// powers are small differences and balance to 1e-7, while the torque is still that of the rigid limit.
constexpr double kBalance = 1e-6, kBeyond = 1e-9;

// The laws that rounding may break: balance of powers (T7.10), signs of losses, bound of the torque (C8.1). A number
// that is not finite breaks them too.
bool keeps_laws(const DrivenMotor<double>& m, const PointNumbers<double>& n, double speed) {
  const double holding = holding_torque(m);
  const double scale = holding * std::fmax(m.crest_velocity / m.r, std::fabs(speed));
  const double share = n.stick_fraction;
  return std::isfinite(n.reactive_force) && std::fabs(excess(n, speed)) <= kBalance * scale &&
         n.friction_power >= -kBeyond * scale && n.layer_loss >= -kBeyond * scale &&
         std::fabs(n.torque) <= holding * (1 + kBeyond) && share >= 0 && share <= 1 + kBeyond;
}

// Without a wave the rotor drags the layer over a flat stator. Released at mu_0 p it slips steadily,
// unless its own vibration brings it back to rest on the stator: then it sticks and slips in a rhythm
// that has nothing to do with the turns of the wave.
bool drags_steadily(const DrivenMotor<double>& m, double speed) {
  if (!(m.static_ > m.kinetic) || m.inertia == 0 || speed == 0) return true;
  const double W = m.omega + m.kappa * m.r * speed;
  const double pressure = m.contact.max_pressure;
  const LayerMotion<double> layer(m.inertia * W * W / m.shear, m.viscosity * W / m.shear);
  const double sigma = speed > 0 ? 1 : -1;
  const double drift = m.shear * m.r * speed / (m.thickness * W * pressure);
  const contact::FreeMotion<double> motion =
      layer.start({-sigma * (m.static_ - m.kinetic), -drift});
  const contact::SlipCurve curve(layer, motion, {drift, 0, 0, 0}, sigma, 0, {0, 1, 0}, 1e300,
                                 {0, 1, 0});
  long samples = 0;
  return contact::first_zero(curve, 1e300, contact::StartOrder::zero, samples, 1'000'000) ==
         contact::kNoZero;
}

// Mean traction of a locked layer as the rotor just begins to drag it forward: the constant part falls
// until the traction touches -mu_0 p somewhere. Units of P, at rest W = omega.
template <typename S>
struct Lock {
  S low, high, damping_work;
  S reactive_force;  // <t sin theta> (C20.3)

  explicit Lock(const DrivenMotor<S>& m) {
    using std::sqrt;
    const contact::ContactNumbers<S> n = contact_numbers(m, S(0.0));
    const S mean = n.static_ * (n.peak - 1.0), swing = (1.0 - n.inertia) * n.stick_rate;
    const S forward = n.static_ + n.damping * n.stick_rate,
            back = n.static_ - n.damping * n.stick_rate;
    low = sqrt(forward * forward + swing * swing) - mean;
    high = mean - sqrt(back * back + swing * swing);
    damping_work = 0.5 * n.damping * n.stick_rate;
    reactive_force = 0.5 * swing;
  }
};

}  // namespace

template <typename S>
bool locks_at_rest(const DrivenMotor<S>& m) {
  if (value_of(m.static_) == 0 || value_of(m.preload) == 0) return false;
  if (value_of(m.amplitude) == 0) return true;
  if (!m.contact.full) return false;
  const Lock<S> lock(m);
  return value_of(lock.low) <= value_of(lock.high);
}

template <typename S, typename R>
PointNumbers<R> special_point(const DrivenMotor<S>& m, const R& speed) {
  const R zero(0.0);
  const R force = m.pressure_force + zero;
  if (value_of(m.static_) == 0 || value_of(m.preload) == 0)
    return {zero, zero, zero, zero, zero, force};
  if (value_of(m.amplitude) == 0) {
    // At rest the limit of forward speeds, as everywhere.
    const R drag = (value_of(speed) < 0 ? 1.0 : -1.0) * slipping_torque(m) + zero;
    return {drag, zero, -(drag * speed), zero, zero, force};
  }
  const Lock<S> lock(m);
  const R power = power_scale(m) * lock.damping_work + zero;
  return {torque_scale(m) * lock.low + zero,
          power,
          zero,
          power,
          R(1.0),
          force + wave_force_scale(m) * lock.reactive_force};
}

SolvedPoint::SolvedPoint(const contact::ContactNumbers<double>& n, const WarmStart* guess,
                         double accuracy)
    : state_(contact::find_periodic_state(n, LayerMotion<double>(n.inertia, n.damping),
                                          guess ? &guess->entry : nullptr, accuracy)) {
  status = point_status(state_.status);
}

SolvedPoint SolvedPoint::of_special(const DrivenMotor<double>& m, double speed) {
  SolvedPoint point;
  point.special = true;
  point.numbers = special_point(m, speed);
  const bool steady =
      is_trivial(m) ? (m.amplitude != 0 || drags_steadily(m, speed)) : m.static_ == m.kinetic;
  if (!steady) point.status = PointStatus::no_periodic_state;
  return point;
}

SolvedPoint SolvedPoint::of_rubbing(const DrivenMotor<double>& m, double speed,
                                    const WarmStart* guess, double accuracy) {
  SolvedPoint point(contact_numbers(m, speed), guess, accuracy);
  point.numbers = point.dimensional(m, point.state_.lap.means);
  return point;
}

SolvedPoint solve_point(const DrivenMotor<double>& m, double speed, const WarmStart* guess,
                        double accuracy) {
  const bool special = is_trivial(m) || (speed == 0 && m.contact.full && locks_at_rest(m));
  SolvedPoint point = special ? SolvedPoint::of_special(m, speed)
                              : SolvedPoint::of_rubbing(m, speed, guess, accuracy);
  const bool lawful = accuracy > 0
                          ? std::isfinite(point.numbers.torque + point.numbers.stator_power)
                          : keeps_laws(m, point.numbers, speed);
  if (point.status == PointStatus::ok && !lawful) point.status = PointStatus::inaccurate;
  return point;
}

#define TWUM_INSTANTIATE(S, R)                        \
  template bool locks_at_rest(const DrivenMotor<S>&); \
  template PointNumbers<R> special_point(const DrivenMotor<S>&, const R&);
TWUM_FOR_EACH_MODEL_SCALAR(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE
template PointNumbers<contact::SpeedDual> special_point(const DrivenMotor<double>&,
                                                        const contact::SpeedDual&);

}  // namespace twum::performance
