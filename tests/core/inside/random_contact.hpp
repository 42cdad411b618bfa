// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/layer_motion.hpp"
#include "contact/zone_curves.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace twum::test {

/// Seeded numbers, the same on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }

 private:
  std::mt19937_64 engine_;
};

/// Partial contact with this half angle, the pressure's amplitude unchanged.
inline void set_half_angle(contact::ContactNumbers<double>& n, double half_angle) {
  n.half_angle = half_angle;
  n.edge = contact::trig(half_angle);
  n.peak = n.edge.versine;
}

/// Pressed `load` times as hard as it takes for full contact, load > 1.
inline void set_full_contact(contact::ContactNumbers<double>& n, double load) {
  n.full = true;
  n.half_angle = std::numbers::pi;
  n.edge = {0, -1, 2};
  n.peak = 1 + load;
}

/// The energy norm of the difference of two states.
inline double apart(const contact::LayerMotion<double>& layer, const contact::LayerState<double>& a,
                    const contact::LayerState<double>& b) {
  return std::sqrt(layer.energy({a.e - b.e, a.rate - b.rate}));
}

/// Contact numbers (E1.1) of layers of every kind: elastic, relaxing, oscillating, near critical damping
/// and overdamped in turn.
inline contact::ContactNumbers<double> random_contact(Dice& dice, int index,
                                                      bool threshold = false) {
  const double M = index % 5 < 2 ? 0 : dice.log_uniform(1e-4, 4);
  const double ratio = index % 5 == 2   ? dice.log_uniform(1e-3, 0.9)
                       : index % 5 == 3 ? dice.uniform(0.98, 1.02)
                                        : dice.uniform(1.6, 40);
  const double C = index % 5 == 0 ? 0
                   : M == 0       ? dice.log_uniform(1e-3, 3)
                                  : 2 * ratio * std::sqrt(M);
  const double half_angle = dice.uniform(0.1, 3.0), mu = dice.uniform(0.05, 0.6);
  contact::ContactNumbers<double> n{M,
                                    C,
                                    dice.log_uniform(0.02, 3),
                                    dice.uniform(-0.3, 1.5),
                                    half_angle,
                                    0,
                                    mu,
                                    mu * (threshold ? dice.uniform(1, 1.6) : 1.0),
                                    {},
                                    false};
  set_half_angle(n, half_angle);
  return n;
}

/// A slip zone from entry with the layer's own motion at random.
struct RandomSlip {
  contact::LayerMotion<double> layer;
  contact::FreeMotion<double> motion;
  double sigma;
  contact::Harmonic<double> slow;
  double start, length;

  RandomSlip(const contact::ContactNumbers<double>& n, Dice& dice)
      : layer(n.inertia, n.damping),
        motion(layer.start(layer.own_part({dice.uniform(-0.3, 0.3), dice.uniform(-1, 1)}))),
        sigma(dice.uniform(-1, 1) < 0 ? -1 : 1),
        slow(contact::relative_rate(n, contact::forced_response(n, layer, sigma))),
        start(-n.half_angle),
        length(2 * n.half_angle) {}

  contact::SlipCurve curve() const {
    return {layer,  motion,
            slow,   sigma,
            start,  contact::trig(start),
            length, contact::trig(start + length)};
  }
};

}  // namespace twum::test
