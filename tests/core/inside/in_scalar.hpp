// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/scalars.hpp"

#include <type_traits>

namespace twum::test {

/// The numbers of partial contact in S, number k an independent variable where S has a direction for it.
template <typename S>
contact::ContactNumbers<S> in_scalar(const contact::ContactNumbers<double>& n) {
  contact::ContactNumbers<S> k{S(n.inertia),
                               S(n.damping),
                               S(n.stick_rate),
                               S(n.speed_ratio),
                               S(n.half_angle),
                               S(0.0),
                               S(n.kinetic),
                               S(n.threshold),
                               {},
                               n.full};
  if constexpr (std::is_same_v<S, contact::NumbersDual> ||
                std::is_same_v<S, contact::NumbersDual2>) {
    S* const list[] = {&k.inertia,    &k.damping, &k.stick_rate, &k.speed_ratio,
                       &k.half_angle, &k.kinetic, &k.threshold};
    for (int i = 0; i < 7; ++i) list[i]->d[i] = 1.0;
  }
  k.edge = contact::trig(k.half_angle);
  k.peak = k.edge.versine;
  return k;
}

}  // namespace twum::test
