// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"
#include "integrator.hpp"

#include <optional>

namespace twum::inline v0_1::motion {

/// Where a function of time that falls through zero between two times does so: bisection, to 1e-12 of their distance.
template <typename Function>
double falls_through_zero(double from, double to, Function function) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (from + to);
    (function(middle) > 0 ? from : to) = middle;
  }
  return to;
}

/// When the rotor stopped to gain speed within the last step, forward or backward; nothing if it did not.
inline std::optional<double> time_of_peak(const Integrator& integrator, double begin) {
  const double side = integrator.y()[kSpeed] < 0 ? -1 : 1;
  const auto gain = [&](double time) { return side * integrator.at(time, 1)[kSpeed]; };
  if (!(gain(begin) > 0 && gain(integrator.time()) <= 0)) return {};
  return falls_through_zero(begin, integrator.time(), gain);
}

}  // namespace twum::inline v0_1::motion
