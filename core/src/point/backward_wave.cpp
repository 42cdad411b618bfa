// SPDX-License-Identifier: Apache-2.0
#include "point/backward_wave.hpp"

#include "contact/periodic_state.hpp"
#include "model/scalars.hpp"
#include "point/point.hpp"

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using contact::ContactNumbers;
using contact::LayerMotion;

double slip_sign(ZoneState state) { return static_cast<double>(state); }

// An elastic layer: the change of its traction by a small disturbance has a closed form (D6.3).
bool is_elastic(const DrivenMotor<double>& m) {
  return m.inertia == 0 && m.viscosity == 0 && m.threshold == m.kinetic;
}

// The zones of a slice; none where the theory has no answer.
Vector<DisturbedZone<double>> zones_of(const DrivenMotor<double>& m, const Slice<double>& s,
                                       double speed) {
  if (m.track.radial || s.contact.half_angle == 0 || (speed == 0 && locks_at_rest(m, s))) return {};
  const ContactNumbers<double> n = contact_numbers(m, s, speed);
  const LayerMotion<double> layer(n.inertia, n.damping);
  const contact::PeriodicState state = contact::find_periodic_state(n, layer);
  if (state.status != contact::PeriodicStatus::ok) return {};
  if (state.lap.one_slip)
    return {{state.lap.first, false, slip_sign(state.lap.first), -n.half_angle, n.half_angle}};
  if (!is_elastic(m) || n.full) return {};
  Vector<contact::ZoneTrace> trace;
  contact::run_lap(n, layer, state.entry, &state.lap.sequence, &trace);
  Vector<DisturbedZone<double>> zones;
  double before = 0;
  for (const contact::ZoneTrace& z : trace) {
    const double own = slip_sign(z.zone.state);
    const bool sticks = z.zone.state == ZoneState::stick;
    zones.push_back({z.zone.state, before != 0, sticks ? before : own, z.zone.from, z.zone.to});
    before = own;
  }
  return zones;
}

// Borders of zones with their derivatives. Each border is the root of a closed form, and one Newton step on Duals
// gives its derivatives (implicit function theorem). For elastic layers, or a single zone.
template <typename S>
Vector<DisturbedZone<S>> moved_zones(const ContactNumbers<S>& n,
                                     const Vector<DisturbedZone<double>>& zones) {
  using std::sin, std::cos;
  const S& s = n.stick_rate;
  Vector<DisturbedZone<S>> moved;
  S from = -n.half_angle, strain(0.0);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const DisturbedZone<double>& z = zones[i];
    const bool sticks = z.state == ZoneState::stick;
    S to = n.half_angle;
    if (i + 1 < zones.size()) {
      const double place = z.to, c = std::cos(place), v = std::sin(place);
      const double side = sticks ? slip_sign(zones[i + 1].state) : z.sign;
      S excess, slope;
      if (sticks) {  // the traction reaches its limit
        const S pressure = n.peak - (1 - c);
        excess = strain + s * (v - sin(from)) - s * n.speed_ratio * (place - from) -
                 side * (n.kinetic * pressure);
        slope = s * c - s * n.speed_ratio + side * v * n.kinetic;
      } else {  // the slip velocity vanishes
        excess = n.speed_ratio - c - side * v * (n.kinetic / s);
        slope = v - side * c * (n.kinetic / s);
      }
      to = with_value(S(place - with_value(excess, 0.0) / slope), place);
    }
    moved.push_back({z.state, z.after_slip, z.sign, from, to});
    if (!sticks) strain = z.sign * (n.kinetic * (n.peak - (1.0 - cos(to))));
    from = to;
  }
  return moved;
}

template <typename S>
DisturbedSlice<S> slice_without_zones(const DrivenMotor<S>& m, const Slice<S>& s, const S& speed,
                                      const S& wave_rate) {
  DisturbedSlice<S> d;
  d.stiffness =
      std::numbers::pi * s.radius * s.shape * s.width * m.youngs / thickness_at(m, s.radius);
  d.shape = s.shape;
  d.half_angle = s.contact.half_angle;
  d.tilt = m.tilt * (m.r / s.radius);
  d.kinetic = m.kinetic;
  d.shear = m.shear / m.youngs;
  d.entry_rate = S(0.0);
  if (!s.contact.full)
    d.entry_rate = d.shear * (s.crest_velocity * s.edge.cos - s.radius * speed) /
                   (wave_rate * s.amplitude * s.edge.sin);
  return d;
}

template <typename S>
S wave_rate_of(const DrivenMotor<S>& m, const S& speed) {
  return m.omega + m.kappa * (m.r * speed);
}

}  // namespace

std::optional<DisturbedContact<double>> disturbed_contact(const DrivenMotor<double>& m,
                                                          double speed) {
  if (is_trivial(m)) return {};
  DisturbedContact<double> contact{wave_rate_of(m, speed), m.omega, {}};
  for (const Slice<double>& s : m.slices()) {
    DisturbedSlice<double> slice = slice_without_zones(m, s, speed, contact.wave_rate);
    slice.zones = zones_of(m, s, speed);
    if (slice.zones.empty()) return {};
    contact.slices.push_back(std::move(slice));
  }
  return contact;
}

template <typename S>
DisturbedContact<S> moved_contact(const DrivenMotor<S>& m, const S& speed,
                                  const DisturbedContact<double>& value) {
  DisturbedContact<S> contact{wave_rate_of(m, speed), m.omega, {}};
  const auto slices = m.slices();
  for (std::size_t k = 0; k < slices.size(); ++k) {
    DisturbedSlice<S> slice = slice_without_zones(m, slices[k], speed, contact.wave_rate);
    slice.zones = moved_zones(contact_numbers(m, slices[k], speed), value.slices[k].zones);
    contact.slices.push_back(std::move(slice));
  }
  return contact;
}

template DisturbedContact<ModelDual> moved_contact(const DrivenMotor<ModelDual>&, const ModelDual&,
                                                   const DisturbedContact<double>&);

}  // namespace twum::inline v0_1::core
