// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/motor_design.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace twum::inline v0_1 {

/// What ends the life of a motor.
enum class EndOfLife : unsigned char {
  none,          ///< it does not wear
  depth_limit,   ///< the depth that is allowed
  limit,         ///< one of Wear::until
  preload_gone,  ///< the spring has relaxed
  worn_through,  ///< there is no lining any more
  load_lost      ///< the worn motor does not carry a load of its life
};

/// A short word such as "depth-limit"; static lifetime.
const char* to_string(EndOfLife end) noexcept;

/// The life of a motor whose track wears evenly (V2.3).
struct Life {
  MetricStatus status{
      MetricStatus::ok};           ///< ok; does_not_wear; or why the new motor has no such point
  EndOfLife end{EndOfLife::none};  ///< what ends it
  std::size_t limit{0};            ///< which of Wear::until, if one ended it
  double depth{0};                 ///< worn off both bodies together [m]
  double seconds{0};               ///< infinite where nothing wears
  double revolutions{0};           ///< likewise [1]
};

/// Life under a load that stays. At most 25 evaluations of the point where no zone changes on the way, and 17 of each limit of
/// Wear::until; each a steady state where the motor has temperatures. Of a motor under a voltage the running wave is searched when
/// the motor is new and at the end of its life; between, the point is followed from depth to depth, which costs a tenth of a search.
/// @throws InputError for an impossible motor, and without a wear block
Life life(const MotorDesign& design, const LoadPoint& load);

/// Life with the operation of the design.
/// @throws InputError as above, and without an operation
Life life(const MotorDesign& design);

/// A motor on its way.
struct WearPoint {
  MetricStatus status{MetricStatus::ok};  ///< not ok from where it has lost its load
  double depth{0};                        ///< worn off [m]
  double seconds{0};                      ///< since it was new
  double revolutions{0};                  ///< likewise [1]
  double rate{0};                         ///< of the depth, over the mission [m/s]
  double thickness{0};                    ///< of the layer as the contact sees it [m]
  double preload{0};                      ///< [N]
  double contact_temperature{0};          ///< hottest of the loads; NaN without temperatures [K]
};

/// How far a value keeps a limit that ends a life, in its unit: negative where it does not; infinite for a time without an end, NaN
/// without a value.
double margin_of(const WearLimit& limit, const MetricValue& found);

/// The way to some rising depths, at the design's operation without a load. Times by the rule of life() where no zone
/// changes on the way and there are eight depths or more, else between the depths by Gauss' rule with three points.
/// @throws InputError as above
std::vector<WearPoint> wear_course(const MotorDesign& design, const std::optional<LoadPoint>& load,
                                   const std::vector<double>& depths);

/// The motor whose track has worn to a depth (V2.2). @throws InputError beyond the lining or the preload
MotorDesign worn_motor(const MotorDesign& design, double depth);

}  // namespace twum::inline v0_1
