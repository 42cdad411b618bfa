// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

namespace twum::test {

/// Largest deviation that a test saw, and of how many comparisons.
///
/// Written as a line "name,largest,allowed,count" to the file named by the environment variable
/// TWUM_DEVIATIONS, if there is one, when the object goes: that is how the validation page and a reader of
/// the log learn how far inside its tolerance a test passes.
class Deviation {
 public:
  /// @param allowed  the test's tolerance, in the unit of the deviations
  Deviation(std::string name, double allowed) : name_(std::move(name)), allowed_(allowed) {}
  ~Deviation();
  Deviation(const Deviation&) = delete;
  Deviation& operator=(const Deviation&) = delete;

  /// Notes |found - expected| / scale and returns it; NaN if either is NaN. An exact match counts 0
  /// whatever the scale.
  double add(double found, double expected, double scale);

  /// The largest so far; NaN sticks.
  double largest() const { return largest_; }
  bool holds() const { return count_ > 0 && largest_ <= allowed_; }

 private:
  std::string name_;
  double allowed_;
  double largest_{0};
  long count_{0};
};

}  // namespace twum::test
