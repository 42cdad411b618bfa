// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"
#include "model/scalars.hpp"

#include <array>
#include <cstddef>
#include <iterator>

namespace twum::inline v0_1::core {

/// The contact's scalar that goes with a model scalar.
template <typename S>
struct ContactScalar;
template <>
struct ContactScalar<ModelDual> {
  using Outer = contact::NumbersDual;
};
template <>
struct ContactScalar<ModelDual2> {
  using Outer = contact::NumbersDual2;
};

/// The eight numbers as a list; in partial contact theta_L stands for the edge, in full contact its pressure.
template <typename S>
std::array<S, 8> listed(const contact::ContactNumbers<S>& n) {
  return {n.inertia, n.damping,   n.stick_rate, n.speed_ratio, n.full ? n.peak : n.half_angle,
          n.kinetic, n.threshold, n.radial};
}

/// Seeds the eight numbers as independent variables.
template <typename K, typename S>
contact::ContactNumbers<K> seeded(const contact::ContactNumbers<S>& n) {
  const std::array<S, 8> x = listed(n);
  const auto variable = [&x](int i) { return K::variable(x[static_cast<std::size_t>(i)].v, i); };
  contact::ContactNumbers<K> k{
      variable(0),
      variable(1),
      variable(2),
      variable(3),
      K(0.0),
      K(0.0),
      variable(5),
      variable(6),
      {K(0.0), K(0.0), K(0.0)},
      n.full,
      contact::kHasRadialMotion ? variable(contact::kContactNumbers - 1) : K(0.0)};
  if (n.full) {
    k.half_angle = K(value_of(n.half_angle));
    k.peak = variable(4);
    k.edge = {K(0.0), K(-1.0), K(2.0)};
  } else {
    k.half_angle = variable(4);
    k.edge = contact::trig(k.half_angle);
    k.peak = k.edge.versine;
  }
  return k;
}

/// Derivatives in the eight numbers times those of the numbers.
template <typename S, typename K>
S chained(const K& f, const std::array<S, 8>& x) {
  S r;
  r.v = f.v;
  for (std::size_t j = 0; j < std::size(r.d); ++j) {
    r.d[j] = f.d[0] * x[0].d[j];
    for (int i = 1; i < contact::kContactNumbers; ++i)
      r.d[j] = r.d[j] + f.d[i] * x[static_cast<std::size_t>(i)].d[j];
  }
  return r;
}

}  // namespace twum::inline v0_1::core
