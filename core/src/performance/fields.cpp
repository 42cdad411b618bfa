// SPDX-License-Identifier: Apache-2.0
#include "performance/point.hpp"

#include <cmath>
#include <numbers>

namespace twum::performance {
namespace {

using contact::ContactNumbers;
using contact::LayerMotion;
using contact::LayerState;
using contact::ZoneTrace;

constexpr double kPi = std::numbers::pi;

struct Trace {
  std::vector<ZoneTrace> zones;
  LayerState<double> exit{0, 0};  // layer at the end of the contact
};

// The layer between two events, in units of P: strain e, its rate, traction t.
struct LayerAt {
  double e, rate, traction;
};

LayerAt stick_at(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                 const ZoneTrace& z, double theta) {
  const double s = n.stick_rate, e = z.start.e + s * (std::sin(theta) - std::sin(z.zone.from)) -
                                     s * n.speed_ratio * (theta - z.zone.from);
  const double rate = s * (std::cos(theta) - n.speed_ratio);
  return {e, rate, e + layer.C * rate - layer.M * s * std::sin(theta)};
}

LayerAt slip_at(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                const ZoneTrace& z, double theta) {
  const double traction = static_cast<double>(z.zone.state) * n.kinetic;
  const double q = traction * layer.response, c = std::cos(theta), s = std::sin(theta);
  const auto forced = [&](double cosine, double sine) {
    return LayerState<double>{q * (layer.D * cosine + layer.C * sine) - traction * (1 - n.peak),
                              q * (layer.C * cosine - layer.D * sine)};
  };
  const LayerState<double> f0 = forced(std::cos(z.zone.from), std::sin(z.zone.from)),
                           f = forced(c, s);
  const LayerState<double> h0 = layer.own_part({z.start.e - f0.e, z.start.rate - f0.rate});
  const LayerState<double> h = layer.at(layer.start(h0), theta - z.zone.from);
  return {h.e + f.e, h.rate + f.rate, traction * (c - 1 + n.peak)};
}

LayerAt free_at(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                const Trace& trace, double theta) {
  const double flight = theta > 0 ? theta - n.half_angle : theta + 2 * kPi - n.half_angle;
  const LayerState<double> h = layer.at(layer.start(layer.own_part(trace.exit)), flight);
  return {h.e, h.rate, 0};
}

LayerAt layer_at(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                 const Trace& trace, double theta) {
  for (const ZoneTrace& z : trace.zones) {
    if (theta >= z.zone.from && theta <= z.zone.to) {
      return z.zone.state == ZoneState::stick ? stick_at(n, layer, z, theta)
                                              : slip_at(n, layer, z, theta);
    }
  }
  return free_at(n, layer, trace, theta);
}

// A lap's `next` state in partial contact is that of the next entry; flying back from entry to exit would amplify
// rounding, so the exit's own state is kept.
Trace trace_of(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
               const contact::PeriodicState& state) {
  Trace trace;
  trace.exit = contact::run_lap(n, layer, state.entry, &state.lap.script, &trace.zones).exit;
  return trace;
}

double phase_of(int i, int samples) { return -kPi + 2 * kPi * i / (samples - 1); }

// (T3.1), (T3.3) [Pa]
double pressure_at(const DrivenMotor<double>& m, double theta) {
  const double P = m.contact.pressure_amplitude;
  if (m.contact.full) return P * std::cos(theta) + m.preload / track_area(m);
  const double edge = m.contact.half_angle;
  if (!(std::fabs(theta) <= edge)) return 0;
  return P * (contact::trig(edge).versine - contact::trig(theta).versine);
}

// Points in closed form: without friction there is no traction; at rest the locked layer sticks all round; a flat
// stator is dragged over.
FieldSample special_sample(const DrivenMotor<double>& m, double torque, double speed,
                           double theta) {
  const double area = track_area(m);
  FieldSample s{theta,      pressure_at(m, theta), 0, 0, m.crest_velocity * std::cos(theta),
                m.r * speed};
  if (m.amplitude == 0) {
    s.traction = torque / (area * m.r);
    s.displacement = m.thickness * s.traction / m.shear;
  } else if (m.contact.full && locks_at_rest(m)) {
    const ContactNumbers<double> n = contact_numbers(m, 0.0);
    const double P = m.contact.pressure_amplitude, swing = n.stick_rate;
    const double mean = torque / (area * m.r);
    s.traction =
        mean + P * swing * (n.damping * std::cos(theta) + (1 - n.inertia) * std::sin(theta));
    s.displacement = m.thickness * (mean + P * swing * std::sin(theta)) / m.shear;
    s.layer_velocity = s.stator_velocity;
  }
  return s;
}

FieldSample dimensional_sample(const DrivenMotor<double>& m, const ContactNumbers<double>& n,
                               const LayerAt& at, double theta) {
  const double P = m.contact.pressure_amplitude, c = std::cos(theta);
  const double layer_ratio = n.speed_ratio + at.rate / n.stick_rate;
  return {theta,
          pressure_at(m, theta),
          P * at.traction,
          m.thickness * P * at.e / m.shear,
          m.crest_velocity * c,
          m.crest_velocity * layer_ratio};
}

}  // namespace

std::vector<Zone> SolvedPoint::zones(const DrivenMotor<double>& m, double speed) const {
  if (status != PointStatus::ok) return {};
  const double edge = m.contact.half_angle;
  if (special) {
    if (edge == 0) return {};
    if (m.amplitude != 0 && m.contact.full && m.static_ > 0)
      return {{ZoneState::stick, -edge, edge}};
    const bool drags = m.amplitude == 0 && speed < 0;
    return {
        {drags || m.amplitude != 0 ? ZoneState::slip_plus : ZoneState::slip_minus, -edge, edge}};
  }
  const ContactNumbers<double> n = contact_numbers(m, speed);
  std::vector<Zone> result;
  for (const ZoneTrace& z : trace_of(n, LayerMotion<double>(n.inertia, n.damping), state_).zones) {
    result.push_back(z.zone);
  }
  return result;
}

std::vector<FieldSample> SolvedPoint::fields(const DrivenMotor<double>& m, double speed,
                                             int samples) const {
  std::vector<FieldSample> result;
  if (status != PointStatus::ok) return result;
  result.reserve(static_cast<std::size_t>(samples));
  if (special) {
    for (int i = 0; i < samples; ++i)
      result.push_back(special_sample(m, numbers.torque, speed, phase_of(i, samples)));
    return result;
  }
  const ContactNumbers<double> n = contact_numbers(m, speed);
  const LayerMotion<double> layer(n.inertia, n.damping);
  const Trace trace = trace_of(n, layer, state_);
  for (int i = 0; i < samples; ++i) {
    const double theta = phase_of(i, samples);
    result.push_back(dimensional_sample(m, n, layer_at(n, layer, trace, theta), theta));
  }
  return result;
}

}  // namespace twum::performance
