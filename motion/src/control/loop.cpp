// SPDX-License-Identifier: Apache-2.0
#include "control/loop.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {

AngleSensor::AngleSensor(const std::optional<double>& counts) {
  if (counts) count_ = 2 * std::numbers::pi / *counts;
}

double AngleSensor::read(double angle) const {
  return count_ > 0 ? count_ * std::round(angle / count_) : angle;
}

const char* to_string(Actuator value) noexcept {
  switch (value) {
    case Actuator::frequency: return "frequency";
    case Actuator::voltage: return "voltage";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::motion
