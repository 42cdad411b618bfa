// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/driven_motors.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>

namespace twum::bench {

/// The driven motor with the kind of layer that the first argument of a benchmark names, 0 to 2, which becomes its label.
inline MotorDesign driven_layer(benchmark::State& state) {
  constexpr std::array kLabels{"elastic layer", "inertia and viscosity", "the same, mu_0 = 1.3 mu"};
  const auto kind = static_cast<std::size_t>(state.range(0));
  state.SetLabel(kLabels[kind]);
  MotorDesign design = kind == 0 ? test::driven_motor() : test::driven_motor_with_layer();
  if (kind == 2) design.friction.threshold = 1.3 * design.friction.kinetic;
  return design;
}

}  // namespace twum::bench
