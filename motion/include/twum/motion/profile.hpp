// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace twum::inline v0_1::motion {

/// A number over time: linear between rows, constant before the first and behind the last. Two rows of one time are a step.
class Profile {
 public:
  using Row = std::pair<double, double>;  ///< time [s], value

  /// The same value at all times. @throws InputError unless it is finite
  Profile(double constant = 0);
  /// @throws InputError unless there is a row, all numbers are finite, times rise, and no time stands in more than two rows.
  explicit Profile(std::vector<Row> rows);

  /// Time and value of each row, in rising order of time.
  const std::vector<Row>& rows() const { return rows_; }
  /// Limit from earlier times; at a step its first value.
  double before(double time) const;
  /// Limit from later times; at a step its last value.
  double after(double time) const;
  /// Largest value at any time.
  double largest() const;

 private:
  std::vector<Row> rows_;
};

}  // namespace twum::inline v0_1::motion
