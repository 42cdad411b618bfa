// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "heat/warm_design.hpp"

#include <twum/core/motor.hpp>

#include <deque>
#include <optional>
#include <utility>

namespace twum::inline v0_1::core {

/// A motor at temperatures of its nodes. The last ones are kept: what costs most, to follow the running wave over speed, is done
/// once for a steady state and for all that is asked of it. Not for several threads.
class WarmMotors {
 public:
  explicit WarmMotors(const Motor& motor) : reference_(motor) {}

  /// Nothing as at_temperatures(). Copies of a Motor share what was computed.
  std::optional<Motor> at(const NodeTemperatures& x);

 private:
  Motor reference_;
  std::deque<std::pair<NodeTemperatures, Motor>> known_;
};

}  // namespace twum::inline v0_1::core
