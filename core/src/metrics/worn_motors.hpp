// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/followed_wave.hpp"
#include "wear/worn_design.hpp"

#include <twum/core/metrics.hpp>

#include <list>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::core {

/// A motor at worn depths. The wave that carries a load is searched once and then followed from depth to depth, which costs a few
/// operating points in place of the whole running branch.
class WornMotors {
 public:
  /// @param voltage  of the drive in place of that of the design
  WornMotors(const MotorDesign& design, const std::optional<double>& voltage);

  const std::optional<double>& voltage() const { return voltage_; }
  /// The motor at a depth; the last one is kept.
  const Motor& at(double depth);
  std::vector<MetricValue> evaluate(double depth, std::span<const MetricRequest> requests);
  std::vector<MetricDerivative> differentiate(double depth, std::span<const MetricRequest> requests,
                                              bool fixed_static_friction);
  /// Compares the waves that were followed to a depth with those of a new search there. Without agreement no wave is followed any
  /// more, and what was found before is not to be used.
  bool confirm_or_stop_following(double depth);

 private:
  /// The wave that carries a load, by the depths at which it is known.
  struct Path {
    LoadPoint load;
    std::map<double, LoadWave> waves;

    LoadWave near(double depth) const;
  };

  Path* path_of(const MetricRequest& request);
  std::unique_ptr<const FollowedCurve> followed(Path& path, double depth);
  std::optional<LoadWave> searched(const LoadPoint& load, double depth);
  template <typename Answers, typename Answer, typename Ask, typename Search, typename... More>
  std::vector<Answer> answers(double depth, std::span<const MetricRequest> requests, Ask ask,
                              Search search, More... more);

  MotorDesign design_;
  std::optional<double> voltage_;
  std::list<Path> paths_;  // references stay valid
  std::optional<std::pair<double, Motor>> last_;
  bool follows_{true};
};

}  // namespace twum::inline v0_1::core
