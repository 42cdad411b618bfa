// SPDX-License-Identifier: Apache-2.0
#include "contact/return_map.hpp"

#include "contact/scalars.hpp"

#include <cmath>
#include <limits>

namespace twum::inline v0_1::contact {

static double product(const LayerMotion<double>& layer, const LayerState<double>& a,
                      const LayerState<double>& b) {
  return layer.M * a.rate * b.rate + a.e * b.e;
}

LayerState<double> secant(const Turn& before, const Turn& now, const LayerMotion<double>& layer) {
  const LayerState<double> in = difference(now.in, before.in),
                           out = difference(now.out, before.out), gap = difference(now.out, now.in);
  const double along = product(layer, in, gap) / (product(layer, in, in) - product(layer, in, out));
  if (!std::isfinite(along)) return now.out;
  return {now.out.e + along * out.e, now.out.rate + along * out.rate};
}

Matrix2 resolvent(const Matrix2& j) {
  const double a = 1 - j.a, d = 1 - j.d, det = a * d - j.b * j.c;
  const double inverse =
      std::fabs(det) > 1e-14 ? 1 / det : std::numeric_limits<double>::quiet_NaN();
  return {inverse * d, inverse * j.b, inverse * j.c, inverse * a};
}

// Only a real eigenvalue can lead laps away from the state; the least damping brings them back from a circle
// round it. Above one the determinant is rounding.
bool attracts(const Matrix2& j) {
  const double trace = j.a + j.d, det = j.a * j.d - j.b * j.c;
  return std::fabs(trace) < 1 + std::fmin(det, 1.0) + 1e-12;
}

static ContactNumbers<StateDual> constant(const ContactNumbers<double>& n) {
  return {n.inertia,     n.damping,    n.stick_rate,
          n.speed_ratio, n.half_angle, n.peak,
          n.kinetic,     n.threshold,  {n.edge.sin, n.edge.cos, n.edge.versine},
          n.full};
}

Matrix2 return_jacobian(const ContactNumbers<double>& numbers, const LapEntry<double>& at,
                        const ZoneSequence* sequence) {
  const ContactNumbers<StateDual> n = constant(numbers);
  LapEntry<StateDual> entry = constant_entry<StateDual>(at);
  entry.layer.e.d[0] = 1;
  entry.layer.rate.d[1] = 1;
  const LayerState<StateDual> next = next_entry(n, {n.inertia, n.damping}, entry, sequence);
  return {next.e.d[0], next.e.d[1], next.rate.d[0], next.rate.d[1]};
}

}  // namespace twum::inline v0_1::contact
