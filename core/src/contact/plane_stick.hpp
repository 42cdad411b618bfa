// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/first_zero.hpp"
#include "contact/slip_step.hpp"

namespace twum::inline v0_1::contact {

/// A sum of waves c + b theta + k cos theta + s sin theta in the plane: what sticks moves so.
template <typename S>
struct PlaneWave {
  Plane<S> constant, drift, cosine, sine;

  Plane<S> at(const S& theta, const Trig<S>& a) const {
    return constant + theta * drift + a.cos * cosine + a.sin * sine;
  }
  Plane<S> slope(const Trig<S>& a) const { return drift + a.cos * sine - a.sin * cosine; }
  Plane<S> bend(const Trig<S>& a) const { return S(-1.0) * (a.cos * cosine + a.sin * sine); }
};

/// Strain of a layer that sticks from here on: e' = s (cos theta - V, q sin theta) (R2.2).
template <typename S>
PlaneWave<S> carried_strain(const ContactNumbers<S>& n, const S& theta, const Trig<S>& at,
                            const Plane<S>& e) {
  const S& s = n.stick_rate;
  const S zero(0.0), drift = -(s * n.speed_ratio);
  PlaneWave<S> wave{{zero, zero}, {drift, zero}, {zero, -(s * n.radial)}, {s, zero}};
  wave.constant = e - wave.at(theta, at);
  return wave;
}

/// Its traction, M e'' + C e' + e.
template <typename S>
PlaneWave<S> carried_traction(const ContactNumbers<S>& n, const PlaneWave<S>& e) {
  const S rest = 1.0 - n.inertia;
  return {e.constant + n.damping * e.drift, e.drift, rest * e.cosine + n.damping * e.sine,
          rest * e.sine - n.damping * e.cosine};
}

/// What is left to the threshold, f = mu_0^2 p^2 - |t|^2 (R3.2), along a stick zone, with bounds of its derivatives as long as it is
/// positive: there |t| <= mu_0 p.
class PlaneReserve {
 public:
  PlaneReserve(const ContactNumbers<double>& n, const PlaneWave<double>& t, double theta,
               const Trig<double>& at)
      : n_(n), t_(t), theta_(theta), at_(at) {
    const double swing = length(t.cosine) + length(t.sine), rate = length(t.drift) + swing;
    const double square = n.threshold * n.threshold, size = n.threshold * n.peak;
    second_ = 2 * square * (1 + n.peak) + 2 * (rate * rate + size * swing);
    third_ = 2 * square * (3 + n.peak) + 2 * (3 * rate * swing + size * swing);
  }

  CurveSample first() const { return sample_at(theta_, at_); }
  CurveSample sample(double x) const { return sample_at(theta_ + x, trig(theta_ + x)); }
  CurveSample terms(double x) const { return sample(x); }

 private:
  CurveSample sample_at(double theta, const Trig<double>& a) const {
    const double k = n_.threshold * n_.threshold, p = n_.peak - a.versine;
    const Plane<double> t = t_.at(theta, a), t1 = t_.slope(a), t2 = t_.bend(a), t3 = t_.drift - t1;
    return {k * p * p - dot(t, t),
            2 * (-k * p * a.sin - dot(t, t1)),
            2 * (k * (a.sin * a.sin - p * a.cos) - dot(t1, t1) - dot(t, t2)),
            second_,
            third_,
            0,
            2 * (k * a.sin * (3 * a.cos + p) - 3 * dot(t1, t2) - dot(t, t3))};
  }

  const ContactNumbers<double>& n_;
  PlaneWave<double> t_;
  double theta_;
  Trig<double> at_;
  double second_, third_;
};

/// Length of the zone to where the traction t reaches its threshold, in S.
/// @param x  the same in double
template <typename S>
S released(const ContactNumbers<S>& n, const PlaneWave<S>& t, const S& from, double x) {
  S length(x);
  for (int i = 0; i < kDualDepth<S>; ++i) {
    const S theta = from + length;
    const Trig<S> a = trig(theta);
    const S p = n.peak - a.versine, k = n.threshold * n.threshold;
    const Plane<S> traction = t.at(theta, a);
    const S f = k * p * p - dot(traction, traction);
    const S slope = -2.0 * (k * p * a.sin + dot(traction, t.slope(a)));
    length = with_value(S(length - with_value(f, 0.0) / value_of(slope)), x);
  }
  return length;
}

/// Adds a stick zone to the means (R2.4, R2.5), times 2 pi: integrals of 1, theta, cos theta and sin theta times 1, cos and sin.
template <typename S>
void add_stick(const ContactNumbers<S>& n, const PlaneWave<S>& t, const PlaneWave<S>& e,
               const Phase<S>& from, const Phase<S>& to, ContactMeans<S>& m) {
  const S span = to.theta - from.theta;
  m.stick_length += span;
  const S d_sin = to.at.sin - from.at.sin, d_cos = to.at.cos - from.at.cos;
  const S cos_cos = 0.5 * (span + to.at.sin * to.at.cos - from.at.sin * from.at.cos);
  const S sin_sin = span - cos_cos,
          sin_cos = 0.5 * (to.at.sin * to.at.sin - from.at.sin * from.at.sin);
  const S theta_1 = 0.5 * (to.theta * to.theta - from.theta * from.theta);
  const S theta_cos = to.theta * to.at.sin - from.theta * from.at.sin + d_cos;
  const S theta_sin = d_sin - (to.theta * to.at.cos - from.theta * from.at.cos);
  const auto with_one = [&](const S& c, const S& b, const S& k, const S& s) {
    return c * span + b * theta_1 + k * d_sin - s * d_cos;
  };
  const auto with_cos = [&](const S& c, const S& b, const S& k, const S& s) {
    return c * d_sin + b * theta_cos + k * cos_cos + s * sin_cos;
  };
  const auto with_sin = [&](const S& c, const S& b, const S& k, const S& s) {
    return b * theta_sin - c * d_cos + k * sin_cos + s * sin_sin;
  };
  const auto along = [&t](const auto& integral) {
    return integral(t.constant.along, t.drift.along, t.cosine.along, t.sine.along);
  };
  const auto across = [&t](const auto& integral) {
    return integral(t.constant.across, t.drift.across, t.cosine.across, t.sine.across);
  };
  m.traction += along(with_one);
  m.stator_power += along(with_cos) + n.radial * across(with_sin);
  m.reactive_force += along(with_sin) - n.radial * across(with_cos);
  if (value_of(n.damping) == 0) return;
  // e' of e, squared.
  const S b = e.drift.along, k = e.sine.along, q = e.cosine.across;
  m.layer_loss += (n.damping / n.stick_rate) *
                  (b * b * span + 2.0 * b * k * d_sin + k * k * cos_cos + q * q * sin_sin);
}

}  // namespace twum::inline v0_1::contact
