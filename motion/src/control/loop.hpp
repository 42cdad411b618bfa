// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stretches.hpp"

#include <optional>
#include <vector>

namespace twum::inline v0_1::motion {

/// A controller that measures an angle once in a sample, and changes the drive.
class Loop {
 public:
  Loop() = default;
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  virtual ~Loop() = default;

  /// Angle and speed of the rotor at the beginning.
  virtual void begin(double angle, double speed) = 0;
  /// A measurement of the angle; sets what the drive does until the next.
  virtual void sample(double time, double angle) = 0;
  /// A stretch within the present sample with what the drive does in it.
  virtual std::vector<Stretch> applied(const Stretch& stretch) const = 0;
};

/// An encoder, or an exact angle.
class AngleSensor {
 public:
  explicit AngleSensor(const std::optional<double>& counts);
  /// The angle to the nearest count [rad].
  double read(double angle) const;
  /// Angle of a count [rad]; 0 if the angle is exact.
  double count() const { return count_; }

 private:
  double count_{0};
};

}  // namespace twum::inline v0_1::motion
