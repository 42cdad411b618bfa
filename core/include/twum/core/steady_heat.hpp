// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/heat.hpp>
#include <twum/core/load.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>

#include <optional>
#include <vector>

namespace twum::inline v0_1 {

/// The network of a design; of one node with the losses at its torque and the reference temperature (H1.10). None where the motor
/// does not carry that torque.
/// @throws InputError for an impossible motor, and without a thermal block
std::optional<HeatNetwork> motor_network(const MotorDesign& design);

/// A motor at its steady temperatures under a load.
struct SteadyHeat {
  /// ok; why the cold motor has no such point; or no_steady_temperature, thermally_unstable, temperature_out_of_range
  MetricStatus status{MetricStatus::ok};
  PartTemperatures temperatures{};  ///< absolute [K]
  HeatLosses losses{};              ///< at these temperatures [W]
  /// Loop gain: the eigenvalue of dPhi / dx that is farthest from zero (H3.3). The state is unstable from 1 on, and the rise
  /// is about 1 / (1 - gain) of that under the losses of the cold motor [1]
  double gain{0};
  double time_constant{
      0};  ///< of the last approach, with the losses following; negative where unstable [s]
  double lost_after{0};  ///< time from cold until the point is lost, with no_steady_temperature [s]
};

/// The steady temperatures that the motor reaches from cold, all of it at ambient, under a load that stays (H3.2). Newton's
/// method with exact derivatives of the losses (H3.3) where the residual is smooth on the way, usually 4 evaluations of the point
/// with derivatives; else the warm-up in time (H4.3) up to a stable state, some 20 to 100.
/// @throws InputError for an impossible motor, and without a thermal block
SteadyHeat steady_heat(const MotorDesign& design, const LoadPoint& load);

/// The steady state, stable or not, that Newton's method finds from one temperature of the whole motor [K]; status
/// thermally_unstable comes with numbers here.
/// @throws InputError as above
SteadyHeat steady_heat_near(const MotorDesign& design, const LoadPoint& load, double temperature);

/// The motor in time.
struct WarmUpPoint {
  MetricStatus status{MetricStatus::ok};  ///< not ok from where the point is lost
  double time{0};                         ///< since it was cold [s]
  PartTemperatures temperatures{};        ///< absolute [K]
  HeatLosses losses{};                    ///< [W]
};

/// The warm-up from cold under a load, at rising times [s], by (H4.3) to 0.001 K a step. Ends with the point that is lost.
/// @throws InputError as above
std::vector<WarmUpPoint> warm_up(const MotorDesign& design, const LoadPoint& load,
                                 const std::vector<double>& times);

/// What a motor loses and gives away where its stator has a temperature, and the other parts have those of a steady state of the
/// same distribution of losses. Where both are equal the motor is in a steady state (H3.4).
struct HeatBalance {
  MetricStatus status{MetricStatus::ok};  ///< ok, or why the motor has no such point
  double temperature{0};                  ///< of the stator [K]
  double losses{0};                       ///< of the motor at these temperatures [W]
  double leaving{0};                      ///< heat that these temperatures send to the ambient [W]
};

/// The balance over the stator's temperature, at each of some temperatures of at least the ambient [K]. A stable state stands
/// where the losses fall below the heat that leaves.
/// @throws InputError as above
std::vector<HeatBalance> heat_balance(const MotorDesign& design, const LoadPoint& load,
                                      const std::vector<double>& stator_temperatures);

/// A moment of a cycle.
struct CyclePoint {
  double time{0};                   ///< since the cycle began [s]
  PartTemperatures temperatures{};  ///< absolute [K]
  HeatLosses losses{};              ///< [W]
};

/// A cycle of loads that is repeated for ever, with losses that follow the temperatures.
struct LoadCycle {
  MetricStatus status{MetricStatus::ok};  ///< ok, or why a phase has no answer
  /// Temperatures at the beginning of each phase, then as the cycle ends, which is as it begins; absolute [K]
  std::vector<PartTemperatures> states{};
  PartTemperatures peak{};           ///< the highest of each part; absolute [K]
  PartTemperatures mean{};           ///< over the cycle (H5.2); absolute [K]
  std::vector<HeatLosses> losses{};  ///< mean of each phase [W]
  std::vector<CyclePoint> course{};  ///< at the times that were asked
};

/// The periodic state of a cycle (H5.1) by Newton's method on the map of a cycle; each phase by (H4.3).
/// @param times  at which its course is wanted, within the cycle [s]
/// @throws InputError as above, without a phase, and for a time that is not more than 0
LoadCycle load_cycle(const MotorDesign& design, const std::vector<LoadPhase>& phases,
                     const std::vector<double>& times = {});

}  // namespace twum::inline v0_1
