// SPDX-License-Identifier: Apache-2.0
#include "metrics/warm_motors.hpp"

namespace twum::inline v0_1::core {
namespace {

constexpr std::size_t kMostMotors = 4;  // cold, steady, and two on the way

}  // namespace

std::optional<Motor> WarmMotors::at(const NodeTemperatures& x) {
  for (const auto& [nodes, motor] : known_)
    if (nodes == x) return motor;
  const auto warm = at_temperatures(reference_.design(), x);
  if (!warm) return {};
  if (known_.size() == kMostMotors) known_.pop_front();
  const bool same = *warm == reference_.design();  // at the reference temperature
  return known_.emplace_back(x, same ? reference_ : Motor(*warm)).second;
}

}  // namespace twum::inline v0_1::core
