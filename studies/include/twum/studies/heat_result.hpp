// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/steady_heat.hpp>
#include <twum/io/column.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Temperatures of one motor, or of a family over one parameter. The rows of the store are the warm-up under the load, or
/// without a load a cycle of the operation: stage is the motor, index the time.
struct HeatResult {
  /// A steady state under the load, stable or not.
  struct State {
    bool stable{true};                ///< the motor stays there
    PartTemperatures temperatures{};  ///< absolute [K]
    double gain{0};                   ///< loop gain [1]
  };
  /// A metric of the motor as it is cold, and at its steady temperatures.
  struct Change {
    std::string metric;  ///< without its load, such as "speed_at"
    std::string unit;    ///< SI
    double cold{0};      ///< NaN where it has no value
    double warm{0};      ///< likewise
  };
  /// What the load does.
  struct Steady {
    std::string status;                  ///< "ok", or why there is no steady state
    PartTemperatures temperatures{};     ///< absolute [K]; of "ok" alone, as what follows
    HeatLosses losses{};                 ///< at these temperatures [W]
    double gain{0};                      ///< loop gain [1]
    double time_constant{0};             ///< of the last approach [s]
    double lost_after{0};                ///< time until the point is lost [s]; 0: it is not
    std::string on_time_status;          ///< "ok", or why no limit is reached
    double on_time{0};                   ///< time from cold until a limit is reached [s]
    std::string duty_limit_status;       ///< "ok", or why there is none
    double duty_limit{0};                ///< largest share of the operation's period [1]
    std::vector<State> states{};         ///< all that a search over the stator's temperature finds
    std::vector<HeatBalance> balance{};  ///< losses and heat that leaves over that temperature
    std::vector<Change> changes{};       ///< what becomes of the motor
  };
  /// What the operation does.
  struct Cycle {
    std::string status;               ///< "ok", or why a phase has no answer
    std::vector<LoadPhase> phases{};  ///< as the motor gives them
    LoadCycle found{};                ///< with its course over one period
  };
  /// One motor.
  struct Member {
    double value{0};        ///< of the family's parameter, SI; NaN for the motor alone
    double ambient{0};      ///< [K]
    HeatNetwork network{};  ///< of its heat
    std::vector<double> time_constants{};           ///< under constant losses, rising [s]
    std::array<std::optional<double>, 4> limits{};  ///< of stator, rotor, housing, contact [K]
    std::optional<Steady> steady{};                 ///< with a load
    std::optional<Cycle> cycle{};                   ///< with an operation
    std::vector<WarmUpPoint> warm_up{};             ///< with a load
  };
  std::optional<StoredColumn> family;  ///< nothing for the motor alone
  std::optional<LoadPoint> load;       ///< that was asked for
  double time{0};                      ///< of the warm-up [s]
  std::vector<Member> members;         ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
