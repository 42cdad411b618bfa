// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/collocation.hpp"
#include "contact/contact_numbers.hpp"
#include "contact/small_system.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace twum::inline v0_1::contact {

/// A vector in the plane of the surface: along the track and across it.
template <typename S>
struct Plane {
  S along, across;
};
template <typename S>
Plane<S> operator+(const Plane<S>& a, const Plane<S>& b) {
  return {a.along + b.along, a.across + b.across};
}
template <typename S>
Plane<S> operator-(const Plane<S>& a, const Plane<S>& b) {
  return {a.along - b.along, a.across - b.across};
}
template <typename S, typename T>
Plane<S> operator*(const T& x, const Plane<S>& a) {
  return {x * a.along, x * a.across};
}
template <typename S>
S dot(const Plane<S>& a, const Plane<S>& b) {
  return a.along * b.along + a.across * b.across;
}
template <typename S>
S length(const Plane<S>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// State of a layer that moves in the plane: strain e and its derivative in theta. Without inertia only e counts.
template <typename S>
struct PlaneState {
  Plane<S> e, rate;
};

/// True if x has no derivative but zeros.
/// @{
inline bool is_constant(double) { return true; }
template <typename T, int N>
bool is_constant(const Dual<T, N>& x) {
  if (!is_constant(x.v)) return false;
  for (int i = 0; i < N; ++i)
    if (value_of(x.d[i]) != 0 || !is_constant(x.d[i])) return false;
  return true;
}
/// @}

/// What the wave does at a phase: its velocity against the rotor in units of V0 (R1.1), and its pressure in units of P.
template <typename S>
struct SurfaceMotion {
  Plane<S> velocity;
  S pressure;
  Trig<S> at;
};
template <typename S>
SurfaceMotion<S> surface_motion(const ContactNumbers<S>& n, const Trig<S>& at) {
  return {{at.cos - n.speed_ratio, n.radial * at.sin}, n.peak - at.versine, at};
}

/// One step through a slip zone (R2.1, R2.3). The direction of the traction, angle alpha, is unknown at the points of
/// collocation; the layer's rate e' follows from the tractions mu p (cos alpha, sin alpha) linearly, and there the slip
///
///     w = v - e' / s
///
/// is to point along alpha (R3.1). For an elastic layer this is (R2.6) and (R2.7).
template <typename S>
class SlipStep {
 public:
  static constexpr std::size_t N = Collocation::N;
  template <typename T>
  using Stages = std::array<T, N>;

  /// @param from    phase at the start
  /// @param length  of the step
  SlipStep(const ContactNumbers<S>& n, const S& from, const PlaneState<S>& state, const S& length)
      : n_(n),
        state_(state),
        length_(length),
        inverse_length_(1.0 / length),
        inverse_rate_(1.0 / n.stick_rate) {
    for (std::size_t i = 0; i < N; ++i) set_surface(i, trig_at(from, length, table().place[i]));
  }
  /// With what is known exactly of its end.
  void ends_at(const Trig<S>& at) { set_surface(N - 1, at); }

  /// The angles by Newton's method from these; false if that fails. In double.
  bool solve(const Stages<double>& guess);
  /// The angles of a solution that is known; in double.
  void take(const Stages<double>& known);
  /// Angles by implicit Euler steps from point to point, each exactly in the direction of its trial traction: a guess for
  /// solve() where nothing is known.
  Stages<double> euler_angles() const;
  /// The derivatives of the angles and rates of the same step in double.
  void lift(const SlipStep<double>& step);

  const Stages<double>& angles() const { return angles_; }
  const Stages<Plane<S>>& rates() const { return rates_; }
  /// Slip velocities w along the traction [V0]; negative where the zone is over.
  S slip(std::size_t i) const { return dot(slip_velocity(i), direction(i)); }
  PlaneState<S> end() const {
    return {state_.e + length_ * weighed(table().integral[N - 1], rates_), rates_[N - 1]};
  }
  /// Adds the step to the means, times 2 pi.
  void add_to(ContactMeans<S>& means) const;
  /// Size of the last term of the step as a series of polynomials: of the direction of slip, weighed with the pressure, and of
  /// the layer's velocity in units of V0 and the rotor's speed.
  double last_term() const;

 private:
  template <typename>
  friend class SlipStep;

  static const Collocation& table() { return Collocation::points(); }

  // Most steps begin and end at phases that do not move.
  static Trig<S> trig_at(const S& from, const S& length, double place) {
    if constexpr (kDualDepth<S> != 0) {
      if (is_constant(from) && is_constant(length)) {
        const Trig<double> a = trig(value_of(from) + place * value_of(length));
        return {S(a.sin), S(a.cos), S(a.versine)};
      }
    }
    return trig(S(from + place * length));
  }

  void set_surface(std::size_t i, const Trig<S>& at) {
    surface_[i] = surface_motion(n_, at);
    bound_[i] = n_.kinetic * surface_[i].pressure;
    if (value_of(bound_[i]) < 0) bound_[i] = with_value(bound_[i], 0.0);
  }
  Plane<S> direction(std::size_t i) const { return {cosine_[i], sine_[i]}; }
  Plane<S> normal(std::size_t i) const { return {-sine_[i], cosine_[i]}; }
  Plane<S> slip_velocity(std::size_t i) const {
    return surface_[i].velocity - inverse_rate_ * rates_[i];
  }
  void set_angle(std::size_t i, const S& angle) {
    const SinCos<S> a = twum::sincos(angle);
    sine_[i] = a.sin, cosine_[i] = a.cos;
  }

  // The rates without traction, and those that go with tractions; in double.
  void prepare();
  // The rates that go with the angles, and the derivatives of the sideways slip in the angles; in double.
  void respond();
  Collocation::Matrix jacobian() const;

  // What a row of weights makes of the rates.
  template <typename R>
  static Plane<R> weighed(const Collocation::Row& weights, const Stages<Plane<R>>& rates) {
    Plane<R> sum = weights[0] * rates[0];
    for (std::size_t j = 1; j < N; ++j) sum = sum + weights[j] * rates[j];
    return sum;
  }

  // M e'' + C e' + e of the collocated motion with these rates, less the traction, at a point.
  template <typename R>
  Plane<S> excess(std::size_t i, const Stages<Plane<R>>& rates) const {
    const Plane<R> strain = weighed(table().integral[i], rates);
    Plane<S> r = state_.e + Plane<S>{length_ * strain.along, length_ * strain.across} -
                 bound_[i] * direction(i);
    if (value_of(n_.damping) != 0)
      r = r + Plane<S>{n_.damping * rates[i].along, n_.damping * rates[i].across};
    if (value_of(n_.inertia) == 0) return r;
    const Plane<R> bend = weighed(table().rate[i], rates);
    const double of_one = table().rate_of_one[i];
    const S mass = n_.inertia * inverse_length_;
    return r + Plane<S>{mass * (bend.along - of_one * state_.rate.along),
                        mass * (bend.across - of_one * state_.rate.across)};
  }

  const ContactNumbers<S>& n_;
  PlaneState<S> state_;
  S length_, inverse_length_, inverse_rate_;
  Stages<SurfaceMotion<S>> surface_;
  Stages<S> bound_, sine_, cosine_;
  Stages<Plane<S>> rates_;
  // In double: the angles, the rates without traction, and their response to tractions.
  Stages<double> angles_;
  Stages<Plane<double>> own_;
  Collocation::Matrix response_;
};

}  // namespace twum::inline v0_1::contact
