// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"

#include <cmath>

namespace twum::inline v0_1::contact {

/// A linear map of states of the layer, (e, e') -> (a e + b e', c e + d e').
struct Matrix2 {
  double a, b, c, d;
};

template <typename S>
LayerState<S> operator*(const Matrix2& m, const LayerState<S>& x) {
  return {m.a * x.e + m.b * x.rate, m.c * x.e + m.d * x.rate};
}

/// An entry that does not move.
template <typename S>
LapEntry<S> constant_entry(const LapEntry<double>& entry) {
  return {{S(entry.layer.e), S(entry.layer.rate)}, entry.carried, entry.zone};
}

/// States at an entry and at the next.
struct Turn {
  LayerState<double> in, out;
};

inline LayerState<double> difference(const LayerState<double>& a, const LayerState<double>& b) {
  return {a.e - b.e, a.rate - b.rate};
}
/// In the norm of the layer's energy.
inline double distance(const LayerMotion<double>& layer, const LayerState<double>& a,
                       const LayerState<double>& b) {
  return std::sqrt(layer.energy(difference(a, b)));
}
/// The next entry, with what two turns tell of the slope of the return map along their difference (E6.4).
LayerState<double> secant(const Turn& before, const Turn& now, const LayerMotion<double>& layer);

/// Derivative of the state at the next entry in the state at this one (E6.2).
Matrix2 return_jacobian(const ContactNumbers<double>& numbers, const LapEntry<double>& at,
                        const ZoneSequence* sequence);

/// (I - J)^-1; NaN where the return map has no isolated fixed point.
Matrix2 resolvent(const Matrix2& j);

/// Whether laps from nearby come to the fixed point, if only by the least damping (E6.6).
bool attracts(const Matrix2& j);

}  // namespace twum::inline v0_1::contact
