// SPDX-License-Identifier: Apache-2.0
#include "point/fields.hpp"

#include "contact/radial_lap.hpp"
#include "model/track.hpp"
#include "point/point.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace twum::inline v0_1::core {
namespace {

using contact::ContactNumbers;
using contact::LayerMotion;
using contact::LayerState;
using contact::ZoneTrace;

constexpr double kPi = std::numbers::pi;

struct Trace {
  Vector<ZoneTrace> zones;
  Vector<contact::RadialPiece>
      pieces;                     // in place of the zones where the surface moves radially, too
  LayerState<double> exit{0, 0};  // layer at the end of the contact
};

// The layer between two events, in units of P: strain e, its rate, traction t, and the traction across the track.
struct LayerAt {
  double e, rate, traction, across{0};
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

LayerAt radial_at(const ContactNumbers<double>& n, const contact::RadialPiece& piece,
                  double theta) {
  if constexpr (contact::kHasRadialMotion) {
    const contact::RadialSample at = contact::sample_of(piece, n, theta);
    return {at.strain.along, at.rate.along, at.traction.along, at.traction.across};
  } else {
    return {};
  }
}

LayerAt layer_at(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                 const Trace& trace, double theta) {
  for (const contact::RadialPiece& piece : trace.pieces)
    if (theta >= piece.from && theta <= piece.to) return radial_at(n, piece, theta);
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
  if constexpr (contact::kHasRadialMotion) {
    if (n.radial != 0) {
      trace.exit = contact::run_radial_lap(n, state.entry, {{}, nullptr, &trace.pieces}).exit;
      return trace;
    }
  }
  trace.exit = contact::run_lap(n, layer, state.entry, &state.lap.sequence, &trace.zones).exit;
  return trace;
}

double phase_of(int i, int samples) { return -kPi + 2 * kPi * i / (samples - 1); }

// Area of the slice [m^2].
double area_of(const Slice<double>& s) { return 2 * kPi * s.radius * s.width; }

// (T3.1), (T3.3) [Pa]
double pressure_at(const Slice<double>& s, double theta) {
  const double P = s.contact.pressure_amplitude;
  if (s.contact.full) return P * std::cos(theta) + s.load / area_of(s);
  const double edge = s.contact.half_angle;
  if (!(std::fabs(theta) <= edge)) return 0;
  return P * (contact::trig(edge).versine - contact::trig(theta).versine);
}

// What does not depend on the tangential contact.
FieldSample untouched_sample(const Slice<double>& s, double speed, double theta) {
  return {theta,
          pressure_at(s, theta),
          0,
          0,
          s.crest_velocity * std::cos(theta),
          s.radius * speed,
          contact::kHasRadialMotion && s.radial != 0 ? s.radial * s.crest_velocity * std::sin(theta)
                                                     : 0,
          0};
}

// A layer that is dragged over a flat stator.
FieldSample dragged_sample(const DrivenMotor<double>& m, const Slice<double>& s, double speed,
                           double theta) {
  FieldSample sample = untouched_sample(s, speed, theta);
  const double torque = (speed < 0 ? 1.0 : -1.0) * (m.kinetic * s.load * s.radius);
  sample.traction = torque / (area_of(s) * s.radius);
  sample.displacement = thickness_at(m, s.radius) * sample.traction / m.shear;
  return sample;
}

// A layer that is locked at rest.
FieldSample locked_sample(const DrivenMotor<double>& m, const Slice<double>& s, double theta) {
  FieldSample sample = untouched_sample(s, 0, theta);
  const ContactNumbers<double> n = contact_numbers(m, s, 0.0);
  const double P = s.contact.pressure_amplitude, swing = n.stick_rate;
  const double mean = locked_slice(m, s, 0.0).torque / (area_of(s) * s.radius);
  sample.traction =
      mean + P * swing * (n.damping * std::cos(theta) + (1 - n.inertia) * std::sin(theta));
  sample.displacement = thickness_at(m, s.radius) * (mean + P * swing * std::sin(theta)) / m.shear;
  sample.layer_velocity = sample.stator_velocity;
  if constexpr (contact::kHasRadialMotion)
    sample.radial_traction =
        P * swing * s.radial * (n.damping * std::sin(theta) - (1 - n.inertia) * std::cos(theta));
  return sample;
}

FieldSample rubbing_sample(const DrivenMotor<double>& m, const Slice<double>& s,
                           const ContactNumbers<double>& n, const LayerAt& at, double theta) {
  const double P = s.contact.pressure_amplitude;
  FieldSample sample = untouched_sample(s, 0, theta);
  sample.traction = P * at.traction;
  sample.radial_traction = P * at.across;
  sample.displacement = thickness_at(m, s.radius) * P * at.e / m.shear;
  sample.layer_velocity = s.crest_velocity * (n.speed_ratio + at.rate / n.stick_rate);
  return sample;
}

// What rubs at a radius.
enum class Rubbing : unsigned char { nothing, flat_stator, locked_layer, wave };

Rubbing rubbing_of(const DrivenMotor<double>& m, const Slice<double>& s, double speed) {
  if (m.threshold == 0 || m.preload == 0 || s.load == 0) return Rubbing::nothing;
  if (m.mean.amplitude == 0) return Rubbing::flat_stator;
  if (s.contact.half_angle == 0) return Rubbing::nothing;
  return speed == 0 && locks_at_rest(m, s) ? Rubbing::locked_layer : Rubbing::wave;
}

// Steps of one slip zone belong together as long as they slip to the same side.
std::vector<Zone> zones_of(const Trace& trace) {
  std::vector<Zone> zones;
  for (const ZoneTrace& z : trace.zones) zones.push_back(z.zone);
  for (const contact::RadialPiece& piece : trace.pieces) {
    if (zones.empty() || zones.back().state != piece.zone)
      zones.push_back({piece.zone, piece.from, piece.to});
    zones.back().to = piece.to;
  }
  return zones;
}

// The contact in its periodic state.
struct Rubbed {
  ContactNumbers<double> numbers;
  LayerMotion<double> layer;
  Trace trace;

  Rubbed(const DrivenMotor<double>& m, const Slice<double>& s, double speed)
      : numbers(contact_numbers(m, s, speed)),
        layer(numbers.inertia, numbers.damping),
        trace(trace_of(numbers, layer, contact::find_periodic_state(numbers, layer))) {}
};

}  // namespace

std::vector<Zone> zones_at(const DrivenMotor<double>& m, double speed, double radius) {
  const Slice<double> s = slice_at(m, radius, m.b);
  const double edge = s.contact.half_angle;
  if (edge == 0) return {};
  switch (rubbing_of(m, s, speed)) {
    case Rubbing::nothing: return {{ZoneState::slip_plus, -edge, edge}};
    case Rubbing::flat_stator:
      return {{speed < 0 ? ZoneState::slip_plus : ZoneState::slip_minus, -edge, edge}};
    case Rubbing::locked_layer: return {{ZoneState::stick, -edge, edge}};
    case Rubbing::wave: break;
  }
  return zones_of(Rubbed(m, s, speed).trace);
}

std::vector<FieldSample> fields_at(const DrivenMotor<double>& m, double speed, double radius,
                                   int samples) {
  const Slice<double> s = slice_at(m, radius, m.b);
  const Rubbing rubbing = rubbing_of(m, s, speed);
  std::optional<Rubbed> rubbed;
  if (rubbing == Rubbing::wave) rubbed.emplace(m, s, speed);
  const auto sample_at = [&](double theta) {
    switch (rubbing) {
      case Rubbing::nothing: return untouched_sample(s, speed, theta);
      case Rubbing::flat_stator: return dragged_sample(m, s, speed, theta);
      case Rubbing::locked_layer: return locked_sample(m, s, theta);
      case Rubbing::wave: break;
    }
    const auto& [numbers, layer, trace] = *rubbed;
    return rubbing_sample(m, s, numbers, layer_at(numbers, layer, trace, theta), theta);
  };
  std::vector<FieldSample> result;
  result.reserve(static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i) result.push_back(sample_at(phase_of(i, samples)));
  return result;
}

}  // namespace twum::inline v0_1::core
