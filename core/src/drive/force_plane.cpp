// SPDX-License-Identifier: Apache-2.0
#include "drive/force_plane.hpp"

#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {

double ForcePlane::parameter(double y) const {
  switch (continued_) {
    case Continued::speed: return unit_ * y;
    case Continued::frequency: return waves_.resonance() + std::exp(y);
    case Continued::voltage: return std::exp(y);
  }
  return 0;
}

double ForcePlane::coordinate(double parameter) const {
  switch (continued_) {
    case Continued::speed: return parameter / unit_;
    case Continued::frequency: return std::log(parameter - waves_.resonance());
    case Continued::voltage: return std::log(parameter);
  }
  return 0;
}

double ForcePlane::rate(double y) const {
  return continued_ == Continued::speed ? unit_ : std::exp(y);
}

ForcePlane::Value ForcePlane::at(PlanePoint p, const WarmStart* guess, double accuracy,
                                 const SolvedPoint* near) const {
  const double amplitude = std::exp(p.x);
  const bool in_frequency = continued_ == Continued::frequency;
  Value v{in_frequency ? waves_.at_frequency(parameter(p.y))
                             .slopes(amplitude, speed(p.y), guess, accuracy, near, continued_)
                       : waves_.slopes(amplitude, speed(p.y), guess, accuracy, near),
          0, 0, 0};
  const SlopedWave& w = v.wave.in_amplitude;
  if (!v.ok()) return v;
  const double force = w.wave.force();
  v.in_x = amplitude * w.force_slope() / force;
  const bool explicit_force = continued_ == Continued::voltage;
  v.in_y = explicit_force ? -1 : rate(p.y) * v.wave.force_per_speed / force;
  v.excess = std::log(force) - (explicit_force ? p.y : std::log(waves_.drive()));
  return v;
}

CurveNode ForcePlane::node(Value v, PlanePoint p, PlanePoint step) const {
  const SlopedWave& w = v.wave.in_amplitude;
  const PlanePoint at{p.x + step.x, p.y + step.y};
  const double length = std::hypot(v.in_x, v.in_y), amplitude = std::exp(at.x);
  const PlanePoint along =
      length > 0 ? PlanePoint{-v.in_y / length, v.in_x / length} : PlanePoint{0, 1};
  const bool in_plane = continued_ != Continued::voltage;
  const double turn = in_plane ? rate(at.y) * step.y : 0, grown = amplitude - w.wave.amplitude;
  WarmStart start = moved(w.wave.start, v.wave.states, grown, turn);
  v.wave.solved.numbers = moved(v.wave.numbers, grown, turn);
  return {.at = at,
          .along = along,
          .amplitude = amplitude,
          .parameter = parameter(at.y),
          .amplitude_rate = amplitude * along.x,
          .parameter_rate = rate(at.y) * along.y,
          .rise = v.in_x,
          .force_slope = w.force_slope(),
          .behind = w.wave.balance.real <= 0,
          .grows = !(waves_.stability(w).trace < 0),
          .solved = std::move(v.wave.solved),
          .start = std::move(start),
          .states = std::move(v.wave.states)};
}

}  // namespace twum::inline v0_1::core
