// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/first_zero.hpp"
#include "contact/layer_motion.hpp"

#include <cmath>

namespace twum::contact {

/// k0 + kb theta + kc cos theta + ks sin theta: all that is not the layer's own motion.
template <typename S>
struct Harmonic {
  S k0, kb, kc, ks;

  S at(const S& theta, const SinCos<S>& a) const { return k0 + kb * theta + kc * a.cos + ks * a.sin; }
  S slope(const SinCos<S>& a) const { return kb + ks * a.cos - kc * a.sin; }
  S curvature(const SinCos<S>& a) const { return -(kc * a.cos + ks * a.sin); }
  Harmonic<double> values() const { return {value_of(k0), value_of(kb), value_of(kc), value_of(ks)}; }
};

/// Distance to the end of sticking on one side, f = mu_0 p - iota t, along a stick zone.
class StickCurve {
 public:
  StickCurve(const Harmonic<double>& f, double theta)
      : f_(f), theta_(theta), bound_(std::sqrt(f.kc * f.kc + f.ks * f.ks)) {}

  CurveSample sample(double x) const {
    const SinCos<double> a = twum::sincos(theta_ + x);
    return {f_.at(theta_ + x, a), f_.slope(a), f_.curvature(a), bound_, bound_, 0};
  }

 private:
  Harmonic<double> f_;
  double theta_, bound_;
};

/// sigma v_rel along a slip zone, f = sigma (h' + harmonic): positive as long as the zone lasts.
///
/// The bounds come from the layer's own motion, which can only lose: an oscillating layer's energy
/// M h''^2 + h'^2 falls, and so do both modes of an overdamped one.
class SlipCurve {
 public:
  SlipCurve(const LayerMotion<double>& layer, const FreeMotion<double>& motion,
            const Harmonic<double>& slow, double sigma, double theta)
      : layer_(layer), motion_(motion), slow_{sigma * slow.k0, 0, sigma * slow.kc, sigma * slow.ks},
        sigma_(sigma), theta_(theta), swing_(std::sqrt(slow.kc * slow.kc + slow.ks * slow.ks)) {}

  CurveSample sample(double x) const {
    const SinCos<double> a = twum::sincos(theta_ + x);
    const double slow = slow_.at(theta_ + x, a), slope = slow_.slope(a);
    const Own own = own_motion(x);
    return {slow + sigma_ * own.rate,
            slope + sigma_ * own.rate1,
            slow_.curvature(a) + sigma_ * own.rate2,
            swing_ + own.bound2,
            swing_ + own.bound3,
            slow > own.bound0 ? skip(slow, slope, own.bound0) : 0};
  }

  /// True if a glance shows that the zone lasts: the harmonic part stays above what the layer's own
  /// motion can reach.
  bool lasts(double length, const SinCos<double>& a, const SinCos<double>& b) const {
    const double bound = own_motion_bound();
    const bool may_turn = length > 3 || (slow_.slope(a) < 0 && slow_.slope(b) > 0);
    const double low = may_turn ? slow_.k0 - swing_
                                : std::fmin(slow_.at(theta_, a), slow_.at(theta_, b));
    return low > bound;
  }

 private:
  // h', h'', h''' and bounds of |h'|, |h'''|, |h''''| from x on.
  struct Own {
    double rate, rate1, rate2, bound0, bound2, bound3;
  };

  Own own_motion(double x) const {
    switch (layer_.kind()) {
      case LayerKind::oscillating: return oscillation(x);
      case LayerKind::elastic: return {0, 0, 0, 0, 0, 0};
      default: return modes(x);
    }
  }

  Own oscillation(double x) const {
    const double M = layer_.M, C = layer_.C;
    const LayerState<double> h = layer_.at(motion_, x);
    const double h2 = -(C * h.rate + h.e) / M, h3 = -(C * h2 + h.rate) / M;
    const double reach = std::sqrt(h.rate * h.rate + M * h2 * h2), reach1 = reach / std::sqrt(M);
    const double bound2 = (C * reach1 + reach) / M;
    return {h.rate, h2, h3, reach, bound2, (C * bound2 + reach1) / M};
  }

  Own modes(double x) const {
    const double l1 = layer_.fast(), l2 = layer_.slow();
    const double fast = motion_.u == 0 ? 0 : motion_.u * std::exp(l1 * x) * l1;
    const double slow = motion_.w * std::exp(l2 * x) * l2;
    return {fast + slow, fast * l1 + slow * l2, fast * l1 * l1 + slow * l2 * l2,
            std::fabs(fast) + std::fabs(slow), std::fabs(fast * l1 * l1) + std::fabs(slow * l2 * l2),
            std::fabs(fast * l1 * l1 * l1) + std::fabs(slow * l2 * l2 * l2)};
  }

  double own_motion_bound() const {
    if (layer_.kind() == LayerKind::elastic) return 0;
    if (layer_.kind() != LayerKind::oscillating) {
      return std::fabs(motion_.u * layer_.fast()) + std::fabs(motion_.w * layer_.slow());
    }
    const double h2 = -(layer_.C * motion_.w + motion_.u) / layer_.M;
    return std::sqrt(motion_.w * motion_.w + layer_.M * h2 * h2);
  }

  // How far the harmonic part k0 + rho cos(u) stays above `bound`, from where it is `slow` and falls or
  // rises with `slope` = -rho sin(u).
  double skip(double slow, double slope, double bound) const {
    const double level = (bound - slow_.k0) / swing_;
    if (level <= -1) return kNoZero;
    return std::acos(level) - std::atan2(-slope, slow - slow_.k0);
  }

  const LayerMotion<double>& layer_;
  FreeMotion<double> motion_;
  Harmonic<double> slow_;
  double sigma_, theta_, swing_;
};

}  // namespace twum::contact
