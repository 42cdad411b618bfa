// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"

#include <cmath>

namespace twum::inline v0_1::contact {

/// The lowest c_x that a phase allows for a given c_y: the disc of radius mu_0 p about the traction without its mean.
/// `side` is 1, or -1 for the negative of the highest c_x.
template <typename S>
struct LockBound {
  const ContactNumbers<S>& n;
  double side;

  struct Value {
    S at, in_across, in_theta;  // and its derivatives; in_theta only in double
    bool reaches;               // false: c_y lies beside the disc
  };
  Value operator()(double theta, double across) const {
    using std::sqrt;
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const S rest = 1.0 - n.inertia, along = n.stick_rate * (rest * sine + n.damping * cosine);
    const S beside = n.stick_rate * n.radial * (n.damping * sine - rest * cosine) + across;
    const S radius = n.threshold * (n.peak - 1.0 + cosine);
    const S square = radius * radius - beside * beside;
    if (!(value_of(radius) > 0 && value_of(square) > 0)) return {beside, beside, beside, false};
    const S chord = sqrt(square);
    const S along_slope = n.stick_rate * (rest * cosine - n.damping * sine);
    const S beside_slope = n.stick_rate * n.radial * (n.damping * cosine + rest * sine);
    const S square_slope = -2.0 * (n.threshold * sine * radius + beside * beside_slope);
    return {-side * along - chord, beside / chord, -side * along_slope - 0.5 * square_slope / chord,
            true};
  }
};

/// The two phases whose bounds leave the least c_x, whatever c_y is: what highest bound is lowest is convex in c_y.
struct TouchingPhases {
  bool exist;  ///< false: no mean traction keeps the threshold everywhere
  double across;
  double theta[2];
  double first_share;  ///< weight of the first, so that c_y is free; that of the second is the rest
};
TouchingPhases touching_phases(const ContactNumbers<double>& numbers, double side);

/// Mean tractions along the track between which a layer in full contact sticks all round a rotor at rest, where the surface
/// moves radially, too (R4.1): its traction is then
///
///     t = c + s [(1 - M) sin theta + C cos theta, q (C sin theta - (1 - M) cos theta)],   |t| <= mu_0 p.
///
/// c lies in a convex set; a rotor that begins to turn forward draws it to the lowest c_x there, as Coulomb's law gives each
/// contact that slips a little the direction of its traction.
template <typename S>
struct RadialLock {
  explicit RadialLock(const ContactNumbers<S>& n) : low(least(n, 1)), high(-least(n, -1)) {}

  S low, high;  ///< low > high: it does not stick all round

 private:
  static S least(const ContactNumbers<S>& n, double side) {
    const TouchingPhases touch = touching_phases(values_of(n), side);
    const LockBound<S> bound{n, side};
    const auto a = bound(touch.theta[0], touch.across), b = bound(touch.theta[1], touch.across);
    if (!touch.exist || !a.reaches || !b.reaches) return S(HUGE_VAL);
    return touch.first_share * a.at + (1 - touch.first_share) * b.at;
  }
};

}  // namespace twum::inline v0_1::contact
