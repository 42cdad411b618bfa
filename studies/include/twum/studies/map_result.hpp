// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/held_point.hpp>
#include <twum/io/column.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Maps over speed and torque of one motor, or of a family over one parameter. The points are the rows of the store: stage is
/// the motor, index is speed times the number of torques plus torque.
struct MapResult {
  /// A torque at a speed, held by a drive that follows (Y2.1 to Y2.3).
  struct Point {
    double speed{0};     ///< of the rotor [rad/s]
    double torque{0};    ///< of the load [N m]
    std::string status;  ///< "ok", or why the drive does not hold it, such as "voltage-too-low"
    std::vector<double> values;  ///< of `columns`, SI; NaN where it is not held
  };
  /// The end of the drive at a speed (Y2.5).
  struct Corner {
    double speed{0};             ///< [rad/s]
    double torque{0};            ///< the largest that is held [N m]; NaN: none is
    std::vector<double> values;  ///< of `columns`, at 1 - 1e-5 times the torque
  };
  /// A point that was asked for.
  struct Duty {
    Point at;               ///< what it needs and gives
    double needed{0};       ///< what would do, as HeldPoint::needed; NaN if it is held
    std::string unit;       ///< SI unit of `needed`
    double torque_left{0};  ///< largest torque that is held at its speed, minus its own [N m]
  };
  /// One motor.
  struct Member {
    double value{0};               ///< of the family's parameter, SI; NaN for the motor alone
    double largest_speed{0};       ///< that is held without load [rad/s]; NaN: none is
    std::vector<Point> points;     ///< speed by speed
    std::vector<Corner> envelope;  ///< of each speed
    std::vector<Duty> duty;        ///< in the order asked
  };
  std::optional<StoredColumn> family;  ///< the parameter; nothing for the motor alone
  std::vector<StoredColumn> columns;   ///< what is known of each point
  std::size_t shown{0};                ///< column that pictures show
  std::size_t efficiency{0};           ///< column of the efficiency of the whole motor
  double speed{0};                     ///< largest of the map [rad/s]
  double torque{0};                    ///< largest of the map [N m]
  std::uint64_t speeds{0};   ///< evenly spaced up to the largest, the first one a step above rest
  std::uint64_t torques{0};  ///< evenly spaced from 0 to the largest
  std::vector<Member> members;  ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
