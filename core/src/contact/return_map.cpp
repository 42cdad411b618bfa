// SPDX-License-Identifier: Apache-2.0
#include "contact/return_map.hpp"

#include "contact/scalars.hpp"

#include <cmath>
#include <limits>

namespace twum::contact {

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
          n.kinetic,     n.static_,    {n.edge.sin, n.edge.cos, n.edge.versine},
          n.full};
}

Matrix2 return_jacobian(const ContactNumbers<double>& numbers, const LapEntry<double>& at,
                        const Script* script) {
  const ContactNumbers<StateDual> n = constant(numbers);
  LapEntry<StateDual> entry = constant_entry<StateDual>(at);
  entry.layer.e.d[0] = 1;
  entry.layer.rate.d[1] = 1;
  const LayerState<StateDual> next = run_lap(n, {n.inertia, n.damping}, entry, script).next.layer;
  return {next.e.d[0], next.e.d[1], next.rate.d[0], next.rate.d[1]};
}

}  // namespace twum::contact
