// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cstdint>
#include <vector>

/// Motors and scans of operating points, which metrics are compared with.
namespace twum::test {

inline MetricValue at_speed(const Motor& motor, Metric which, double speed) {
  return evaluate(motor, {which, Argument::speed, speed});
}

struct Scan {
  std::vector<OperatingPoint> points;  ///< from rest to the no-load speed
  double free;
};

inline Scan scan(const Motor& motor, int count) {
  Scan found{{}, ask(motor, Metric::no_load_speed).value};
  for (int i = 1; i < count; ++i)
    found.points.push_back(motor.operating_point(found.free * i / count));
  return found;
}

/// Motors with an ordinary characteristic, every kind of layer.
inline std::vector<Motor> motors(std::uint64_t seed, int count, bool threshold) {
  Uniform random(seed);
  std::vector<Motor> made;
  for (int i = 0; i < count; ++i) {
    MotorDesign design = realistic_design(random);
    if (!threshold) design.friction.threshold = design.friction.kinetic;
    if (i % 3 == 1) design = damped(design);
    if (i % 3 == 2) design = elastic(design);
    made.emplace_back(design);
  }
  return made;
}

}  // namespace twum::test
