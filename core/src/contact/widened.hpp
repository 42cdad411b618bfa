// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"

#include <twum/base/dual.hpp>

namespace twum::inline v0_1::contact {

/// x with directions more, in which it does not move: those of the layer's state at entry.
template <int kMore, int N>
Dual<double, N + kMore> widened(const Dual<double, N>& x) {
  Dual<double, N + kMore> wide(x.v);
  for (int i = 0; i < N; ++i) wide.d[i] = x.d[i];
  return wide;
}

template <int kMore, int N>
ContactNumbers<Dual<double, N + kMore>> widened(const ContactNumbers<Dual<double, N>>& n) {
  const auto more = [](const Dual<double, N>& x) { return widened<kMore>(x); };
  return {more(n.inertia),
          more(n.damping),
          more(n.stick_rate),
          more(n.speed_ratio),
          more(n.half_angle),
          more(n.peak),
          more(n.kinetic),
          more(n.threshold),
          {more(n.edge.sin), more(n.edge.cos), more(n.edge.versine)},
          n.full,
          more(n.radial)};
}

}  // namespace twum::inline v0_1::contact
