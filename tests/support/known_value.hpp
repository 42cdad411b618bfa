// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

namespace twum::test {

/// A metric of a motor that has to have a value.
inline double known_value(const Motor& motor, const MetricRequest& request) {
  const MetricValue found = evaluate(motor, request);
  CAPTURE(info(request.metric).name, to_string(found.status));
  REQUIRE(found.status == MetricStatus::ok);
  return found.value;
}
inline double known_value(const MotorDesign& design, const MetricRequest& request) {
  return known_value(Motor(design), request);
}

}  // namespace twum::test
