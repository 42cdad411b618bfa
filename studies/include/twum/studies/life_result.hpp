// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/life.hpp>
#include <twum/core/worn_in.hpp>
#include <twum/io/column.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// The life of one motor, or of a family over one parameter. The rows of the store are its way to the end: stage is the motor, index
/// the depth.
struct LifeResult {
  /// A motor on its way.
  struct Point {
    WearPoint wear{};  ///< depth, time, rate
    std::vector<double>
        metrics{};  ///< of `columns`, of the worn motor at its reference temperature; NaN: none
    std::vector<double> margins{};  ///< of the limits, 0 where the life ends, 1 of the new motor
  };
  /// What may end the life.
  struct Limit {
    std::string text;   ///< as typed, such as "start_voltage <= 120 V"
    bool ended{false};  ///< it is what ended the life
  };
  /// A radius of the track.
  struct AtRadius {
    double radius;  ///< [m]
    double rate;    ///< at which it would wear by itself [m/s]
  };
  /// A node of a track that wears freely, at one time.
  struct AtNode {
    double radius;    ///< [m]
    double depth;     ///< worn off [m]
    double pressure;  ///< largest in a turn of the wave, under the load that is told [Pa]
    double share;     ///< of the preload, under that load
  };
  /// Such a track at one time.
  struct TrackState {
    double seconds{0};            ///< since it was new
    double speed{0};              ///< of the rotor under the load that is told [rad/s]
    double torque{0};             ///< likewise [N m]
    double friction_power{0};     ///< likewise [W]
    std::vector<AtNode> nodes{};  ///< from the inner edge on
  };
  /// What a free profile tells of a life.
  struct FreeTrack {
    TrackState fresh{};  ///< new
    std::optional<TrackState>
        run_in{};             ///< first time from which all nodes wear at one rate, to 1 %
    TrackState last{};        ///< at the end of the life, or where the wear localizes
    double largest_share{1};  ///< load of a node there, in parts of its even share
  };
  /// One motor.
  struct Member {
    double value{0};     ///< of the family's parameter, SI; NaN for the motor alone
    Life life{};         ///< when it ends, and why
    std::string status;  ///< "ok", or why there is no life
    std::vector<Limit>
        limits;  ///< what ends lives: the depth, then those of the file, then spring and lining
    bool one_slice{false};                            ///< the whole contact is at one radius
    std::vector<Point> points;                        ///< from new to the end
    std::vector<AtRadius> profile_new{};              ///< under the load that is told; may be empty
    std::vector<AtRadius> profile_worn{};             ///< likewise at the end of the life
    WearStability stability{WearStability::unknown};  ///< of the new motor under that load
    std::optional<WornIn> worn_in;                    ///< the state after run-in, where it is known
    std::optional<FreeTrack> free;                    ///< with `wear.profile: free`
  };
  std::optional<StoredColumn> family;  ///< nothing for the motor alone
  std::optional<LoadPoint> load;       ///< that was asked for; nothing: the operation
  std::vector<StoredColumn> columns;   ///< of Point::metrics
  std::vector<Member> members;         ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
