// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/slip_step.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {

/// e' of all points per traction, from M e'' + C e' + e = t.
inline Collocation::Matrix rate_response(const ContactNumbers<double>& n, double length) {
  const Collocation& c = Collocation::points();
  Collocation::Matrix m;
  if (n.inertia == 0 && n.damping == 0) {
    for (std::size_t i = 0; i < Collocation::N; ++i)
      for (std::size_t j = 0; j < Collocation::N; ++j) m[i][j] = c.rate[i][j] / length;
    return m;
  }
  for (std::size_t i = 0; i < Collocation::N; ++i)
    for (std::size_t j = 0; j < Collocation::N; ++j)
      m[i][j] =
          n.inertia / length * c.rate[i][j] + (i == j ? n.damping : 0) + length * c.integral[i][j];
  return Factors<Collocation::N>(m).inverse();
}

template <>
inline void SlipStep<double>::respond() {
  for (std::size_t i = 0; i < N; ++i) {
    rates_[i] = own_[i];
    for (std::size_t j = 0; j < N; ++j)
      rates_[i] = rates_[i] + (response_[i][j] * bound_[j]) * direction(j);
  }
}

// Derivatives of the sideways slip at each point in the angles.
template <>
inline Collocation::Matrix SlipStep<double>::jacobian() const {
  Collocation::Matrix m;
  for (std::size_t i = 0; i < N; ++i) {
    const Plane<double> across = -inverse_rate_ * normal(i);
    for (std::size_t j = 0; j < N; ++j)
      m[i][j] = response_[i][j] * bound_[j] * dot(across, normal(j));
    m[i][i] -= slip(i);
  }
  return m;
}

template <>
inline void SlipStep<double>::prepare() {
  response_ = rate_response(n_, length_);
  for (std::size_t i = 0; i < N; ++i) {
    own_[i] = {0, 0};
    for (std::size_t j = 0; j < N; ++j)
      own_[i] =
          own_[i] +
          response_[i][j] *
              ((n_.inertia * inverse_length_ * table().rate_of_one[j]) * state_.rate - state_.e);
  }
}

template <>
inline void SlipStep<double>::take(const Stages<double>& known) {
  prepare();
  angles_ = known;
  for (std::size_t i = 0; i < N; ++i) set_angle(i, angles_[i]);
  respond();
}

template <>
inline bool SlipStep<double>::solve(const Stages<double>& guess) {
  constexpr int kMostSteps = 12;
  constexpr double kLastTurn = 1e-5;  // Newton's method squares it
  prepare();
  angles_ = guess;
  for (std::size_t i = 0; i < N; ++i) set_angle(i, angles_[i]);
  double before = HUGE_VAL;
  for (int step = 0; step < kMostSteps; ++step) {
    respond();
    Stages<double> miss;
    for (std::size_t i = 0; i < N; ++i) miss[i] = -dot(slip_velocity(i), normal(i));
    const Stages<double> turn = Factors<N>(jacobian()).solve(miss);
    double largest = 0;
    for (std::size_t i = 0; i < N; ++i) largest = std::fmax(largest, std::fabs(turn[i]));
    if (!(largest < 1.5) || (step > 3 && largest > 0.5 * before)) return false;
    before = largest;
    for (std::size_t i = 0; i < N; ++i) {
      angles_[i] += turn[i];
      if (largest < kLastTurn) {
        const Plane<double> d = direction(i);
        cosine_[i] = d.along - turn[i] * d.across, sine_[i] = d.across + turn[i] * d.along;
      } else {
        set_angle(i, angles_[i]);
      }
    }
    if (largest < kLastTurn) {
      respond();
      return true;
    }
  }
  return false;
}

template <>
inline SlipStep<double>::Stages<double> SlipStep<double>::euler_angles() const {
  Stages<double> angles;
  PlaneState<double> at = state_;
  double last = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double h = (table().place[i] - last) * length_;
    last = table().place[i];
    const double mass = n_.inertia / h, stiff = mass + n_.damping + h;
    const Plane<double> stuck = n_.stick_rate * surface_[i].velocity;
    const Plane<double> trial = at.e + stiff * stuck - mass * at.rate;
    angles[i] = std::atan2(trial.across, trial.along);
    if (i > 0)
      angles[i] +=
          2 * std::numbers::pi * std::round((angles[i - 1] - angles[i]) / (2 * std::numbers::pi));
    const double size = length(trial), most = bound_[i];
    const Plane<double> traction = size > most ? (most / size) * trial : trial;
    at.rate = (1 / stiff) * (traction - at.e + mass * at.rate);
    at.e = at.e + h * at.rate;
  }
  return angles;
}

template <typename S>
void SlipStep<S>::lift(const SlipStep<double>& step) {
  Stages<S> angles;
  for (std::size_t i = 0; i < N; ++i) {
    angles[i] = S(step.angles_[i]);
    sine_[i] = S(step.sine_[i]), cosine_[i] = S(step.cosine_[i]);
    rates_[i] = {S(step.rates_[i].along), S(step.rates_[i].across)};
  }
  const Factors<N> newton(step.jacobian());
  // Without derivatives at first, the rates are those of the step in double: that saves half of the work.
  for (int depth = 0; depth < kDualDepth<S>; ++depth) {
    Stages<Plane<S>> off;
    for (std::size_t i = 0; i < N; ++i)
      off[i] = depth == 0 ? excess(i, step.rates_) : excess(i, rates_);
    Stages<Plane<S>> change;
    Stages<S> miss;
    for (std::size_t i = 0; i < N; ++i) {
      change[i] = S(-1.0) * weighed(step.response_[i], off);
      const Plane<double> across = step.inverse_rate_ * step.normal(i);
      miss[i] = across.along * change[i].along + across.across * change[i].across -
                dot(slip_velocity(i), normal(i));
    }
    const Stages<S> turn = newton.solve(miss);
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        const Plane<double> push = (step.response_[i][j] * step.bound_[j]) * step.normal(j);
        change[i] = change[i] + Plane<S>{push.along * turn[j], push.across * turn[j]};
      }
      rates_[i] = {with_value(S(rates_[i].along + change[i].along), step.rates_[i].along),
                   with_value(S(rates_[i].across + change[i].across), step.rates_[i].across)};
      angles[i] = with_value(S(angles[i] + turn[i]), step.angles_[i]);
      set_angle(i, angles[i]);
    }
  }
}

// (R2.4), (R2.5)
template <typename S>
void SlipStep<S>::add_to(ContactMeans<S>& m) const {
  for (std::size_t i = 0; i < N; ++i) {
    const S weight = table().integral[N - 1][i] * length_, size = weight * bound_[i];
    const Trig<S>& at = surface_[i].at;
    m.traction += size * cosine_[i];
    m.stator_power += size * (cosine_[i] * at.cos + n_.radial * (sine_[i] * at.sin));
    m.reactive_force += size * (cosine_[i] * at.sin - n_.radial * (sine_[i] * at.cos));
    if constexpr (kDualDepth<S> == 0)  // derivatives of the friction power follow from the balance
      m.friction_power += size * slip(i);
    if (value_of(n_.damping) != 0)
      m.layer_loss += weight * (n_.damping * inverse_rate_) * dot(rates_[i], rates_[i]);
  }
}

template <>
inline double SlipStep<double>::last_term() const {
  Plane<double> traction{0, 0}, rate{0, 0};
  for (std::size_t i = 0; i < N; ++i) {
    traction = traction + (table().highest[i] * surface_[i].pressure) * direction(i);
    rate = rate + table().highest[i] * rates_[i];
  }
  return std::fmax(length(traction) / n_.peak,
                   length(rate) / (n_.stick_rate * (1 + std::fabs(n_.speed_ratio))));
}

}  // namespace twum::inline v0_1::contact
