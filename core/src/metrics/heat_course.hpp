// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/heat_numbers.hpp"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::core {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Error of a step in time [K].
inline constexpr double kCourseError = 1e-5;

/// Highest temperatures that the parts may have [K]; infinite without a limit.
PartValues<double> temperature_limits(const MotorDesign& design);

/// A phase of a course of loads, of a design with the voltage of the phase.
struct CoursePhase {
  std::optional<LoadLosses> losses;  ///< without them the motor is off
  HeatSolver solver;
  double time;       ///< how long [s]
  bool own_voltage;  ///< that of the design does not count
};

/// The temperatures of a motor through phases of loads, with losses that follow the temperatures.
class HeatCourse {
 public:
  /// @throws SearchFailure where the network of a data sheet has no losses
  HeatCourse(const MotorDesign& design, std::span<const LoadPhase> phases);

  /// States of each phase, from its beginning to its end.
  using Lap = std::vector<std::vector<HeatState>>;
  /// From a state of the masses above ambient on. @throws SearchFailure where a phase loses its point
  Lap run(const Vector3& theta) const;
  /// The one that returns: Newton's method on the map of a cycle, from the periodic state under the losses of the cold motor
  /// (H5.1). @throws SearchFailure, thermally_unstable where it does not settle
  Lap periodic() const;

  /// A state within a phase.
  struct Moment {
    std::size_t phase;
    double time;  ///< since the phase began [s]
    HeatState state;
  };
  /// When a part is hottest.
  Moment peak(const Lap& lap, std::size_t part) const;
  /// When the first part reaches its limit, and which; none if none does.
  std::optional<std::pair<Moment, std::size_t>> first_limit(const Lap& lap,
                                                            const PartValues<double>& limits) const;
  double temperature(const Moment& moment, std::size_t part) const;
  /// The state at a time since the lap began.
  Moment at(const Lap& lap, double time) const;
  /// Mean temperatures over a lap that returns (H5.2) [K].
  PartValues<double> mean(const Lap& lap) const;

  const std::vector<CoursePhase>& phases() const { return phases_; }
  /// The same course, in which no wave is followed.
  HeatCourse searching() const;

 private:
  Vector3 first_guess() const;
  Moment top_between(std::size_t phase, const HeatState& a, const HeatState& b,
                     std::size_t part) const;
  Moment moment_at(std::size_t phase, const HeatState& from, double after) const;

  std::vector<CoursePhase> phases_;
  double ambient_;
};

}  // namespace twum::inline v0_1::core
