// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/wear_rates.hpp"

#include <twum/core/life.hpp>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::core {

/// The way of a motor from new to the end of its life, under a load or in its operation (V2.3).
class WearCourse {
 public:
  /// As WearRates; copies the design.
  WearCourse(const MotorDesign& design, const std::optional<LoadPoint>& load);

  const std::optional<LoadPoint>& load() const { return load_; }
  WearRates& rates() { return rates_; }
  /// Found once.
  const Life& life();
  /// The rate with its slopes at a depth, found once: time and revolutions have the same.
  const WearRate& rate_with_slopes(double depth, bool fixed_static_friction);
  /// The rate of its wear has no kink that counts.
  bool is_smooth() {
    life();
    return smooth_;
  }
  /// The motor at the end of its life.
  const Motor& worn_motor() { return rates_.motors().at(life().depth); }
  std::vector<WearPoint> points(const std::vector<double>& depths);

 private:
  double margin(std::size_t limit, double depth);
  double root_of(std::size_t limit, double good, double bad);
  std::optional<Life> first_limit(double depth);
  Life end();
  double last_carried(double depth);
  void spend(Life& life);
  Life found();
  WearPoint point_at(double depth, const std::function<std::vector<double>()>& spent);

  MotorDesign design_;  // `auto` slices are those of the new motor
  std::optional<LoadPoint> load_;
  WearRates rates_;
  std::optional<Life> life_;
  bool smooth_{false};
  std::map<std::pair<double, bool>, WearRate> slopes_;
};

}  // namespace twum::inline v0_1::core
