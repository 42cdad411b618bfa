// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <twum/optim/correlation.hpp>
#include <twum/optim/random_input.hpp>

namespace twum::inline v0_1::optim {

/// Rows of values that were measured together, each with a weight. A product takes one whole row, so that the distributions and
/// correlations of its values are those of the measurement.
class MeasuredRows {
 public:
  /// None.
  MeasuredRows() = default;
  /// @param columns  values of a row, at least 1
  explicit MeasuredRows(std::size_t columns) : columns_(columns) {}

  /// @param row     columns() finite values
  /// @param weight  0 or more: how often the row is drawn compared with the others
  /// @throws InputError if one of them is not
  void add(std::span<const double> row, double weight = 1.0);

  /// Values of a row.
  std::size_t columns() const noexcept { return columns_; }
  /// How many rows there are.
  std::size_t size() const noexcept { return sums_.size(); }
  /// True without rows.
  bool empty() const noexcept { return sums_.empty(); }
  /// Of all rows.
  double sum_of_weights() const noexcept { return sums_.empty() ? 0.0 : sums_.back(); }

  /// The row of a number from 0 to 1, which rows of the same weight share evenly. There must be a weight.
  std::span<const double> draw(double u) const;

  /// Mean over the rows as they are drawn.
  double mean(std::size_t column) const;
  /// Standard deviation over the rows as they are drawn (divided by the sum of the weights).
  double sd(std::size_t column) const;
  /// Coefficient of correlation; 0 if a column does not vary.
  double correlation(std::size_t a, std::size_t b) const;

 private:
  double weight(std::size_t row) const { return row == 0 ? sums_[0] : sums_[row] - sums_[row - 1]; }
  double value(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }
  double covariance(std::size_t a, std::size_t b) const;

  std::size_t columns_{0};
  std::vector<double> values_;  // row by row
  std::vector<double> sums_;    // of the weights up to each row
};

/// The column as an input of a search: normal, with mean and standard deviation of the rows, U1.11.
/// @param value  what the design has
RandomInput measured_input(const MeasuredRows& rows, std::size_t column, std::string name,
                           double value);
/// The correlations of the columns as inputs of a search, U1.11.
/// @param first  position of the first column among the inputs
std::vector<CorrelatedPair> measured_pairs(const MeasuredRows& rows, std::size_t first);

}  // namespace twum::inline v0_1::optim
