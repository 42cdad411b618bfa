// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metrics.hpp>
#include <twum/motion/free_life.hpp>

#include <list>
#include <optional>
#include <utility>

namespace twum::inline v0_1::motion {

/// Metrics of lives with a free profile of one design, each life found once.
class FreeLives {
 public:
  /// @param design  outlives this
  explicit FreeLives(const MotorDesign& design) : design_(design) {}

  /// @throws WithoutValue where there is no life
  double number(const MetricRequest& request);

 private:
  const FreeLife& under(const std::optional<LoadPoint>& load);

  const MotorDesign& design_;
  std::list<std::pair<std::optional<LoadPoint>, FreeLife>> lives_;  // references stay valid
};

}  // namespace twum::inline v0_1::motion
