// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "heat/heat_state.hpp"
#include "metrics/warm_motors.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/metrics.hpp>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::core {

/// Derivatives of a number in every parameter.
using Gradient = std::array<double, kParameterCount>;

/// A metric as it is at a load.
inline MetricRequest at_load(Metric metric, const LoadPoint& load) {
  return {metric, load.argument, load.at, load.torque, {}};
}

/// A value that has no derivatives.
inline MetricDerivative no_derivative(const MetricValue& value) {
  MetricDerivative result{value, {}, Smoothness::undefined};
  result.gradient.fill(kNoValue);
  return result;
}

/// How what is found of a motor at temperatures moves with the parameters of the design and with the temperatures (H3.1).
class DriftRule {
 public:
  DriftRule(const MotorDesign& design, bool fixed_static_friction);

  /// Derivatives by the design's parameters at temperatures that stay, from those by the warm motor's.
  Gradient at_fixed_temperatures(const Gradient& of_warm, const NodeTemperatures& x) const;
  /// Derivatives by the temperatures of the nodes.
  Vector3 by_temperatures(const Gradient& of_warm) const;

 private:
  std::vector<Drifting> drifting_;
  double reference_;
  bool fixed_, follows_ambient_;
};

/// The losses of a motor under a load that stays while its temperatures move.
class LoadLosses {
 public:
  /// @param motors  of the design, shared with others; null: its own
  LoadLosses(const MotorDesign& design, const LoadPoint& load,
             std::shared_ptr<WarmMotors> motors = nullptr);

  /// Losses and their derivatives by the temperatures; a point costs one motor with gradients, without any drift one without.
  WarmLosses at(const NodeTemperatures& x) const;
  /// The same by following the wave from other temperatures, which costs a few points. Nothing where that is not possible.
  std::optional<WarmLosses> near(const NodeTemperatures& x, const LoadWave& known) const;
  /// Derivatives of the losses in all parameters of the warm motor. Empty where there are none.
  /// @param known  a wave from which that at x is followed; without it the wave is searched
  std::optional<std::array<Gradient, kSources>> gradients(
      const NodeTemperatures& x, bool fixed_static_friction,
      const std::optional<LoadWave>& known = {}) const;

 private:
  std::vector<MetricRequest> requests() const;
  WarmLosses values(const Motor& warm) const;
  /// Those at a wave that is followed, and the wave.
  struct Followed {
    std::vector<MetricDerivative> losses;
    LoadWave wave;
  };
  std::optional<Followed> followed(const NodeTemperatures& x, const LoadWave& known,
                                   bool fixed_static_friction) const;
  WarmLosses with_slopes(std::span<const MetricDerivative> found) const;
  std::array<Vector3, kSources> differences(const NodeTemperatures& x) const;

  MotorDesign design_;
  LoadPoint load_;
  std::shared_ptr<WarmMotors> motors_;
  DriftRule rule_;
  bool drifts_, follows_;
};

/// The problem of a design under a load.
HeatProblem heat_problem(const MotorDesign& design, const HeatNetwork& network,
                         const LoadPoint& load, std::shared_ptr<WarmMotors> motors = nullptr);

/// The network of the design; of one node with the losses at its torque and the reference temperature (H1.10).
/// @throws SearchFailure where these losses have no value
HeatNetwork network_of(const MotorDesign& design);

}  // namespace twum::inline v0_1::core
