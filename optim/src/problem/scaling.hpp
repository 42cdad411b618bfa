// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::inline v0_1::optim {

/// Conversion between the user's units and scaled ones, for variables and responses.
///
/// A linear variable is u = (x - origin) / size, one on a log scale u = log(x / origin) / size. Fixed variables (with
/// equal bounds, or integers held by a search) are left out. Where the factors were computed, a response times its
/// factor has a gradient of size 1 in u.
class Scaling {
 public:
  /// The whole range of a variable is [0, 1].
  explicit Scaling(const Problem& problem);

  /// Variables have these sizes (one for each variable of the problem, for log scales in the logarithm). All factors
  /// are 1.
  Scaling(const Problem& problem, const std::vector<double>& sizes);

  /// Computes the factors from an evaluation with a Jacobian.
  void scale_responses(std::span<const double> design, const Evaluation& evaluation);

  std::size_t size() const { return free_.size(); }
  std::size_t variable(std::size_t k) const { return free_[k]; }
  double factor(std::size_t response) const { return factors_[response]; }
  void set_factor(std::size_t response, double factor) { factors_[response] = factor; }
  /// Bounds of the scaled variables.
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }

  std::vector<double> to_unit(std::span<const double> design) const;
  std::vector<double> to_design(std::span<const double> unit) const;

  /// A point of the range given by numbers in [0, 1], scaled.
  std::vector<double> from_range(std::span<const double> part) const;

  /// dx/du of the k-th free variable at a design.
  double slope(std::size_t k, std::span<const double> design) const;

  /// Derivative of a scaled response by the k-th free scaled variable. An infinite slope of an objective into the bound
  /// that the variable is on, such as that of a root, holds the variable there whatever the others are: kSteep stands for it.
  double derivative(const Evaluation& e, std::size_t response, std::size_t k,
                    std::span<const double> design) const;

 private:
  static constexpr double kSteep =
      1e3;  // far above 1, and the other slopes keep their digits beside it

  void set_bounds();
  bool holds(double slope, std::size_t response, std::size_t k,
             std::span<const double> design) const;
  double scaled(std::size_t k, double x) const;

  std::vector<Variable> variables_;
  std::vector<double> senses_;  // of the objectives: 1, or -1 if maximized
  std::vector<std::size_t> free_;
  std::vector<double> fixed_;  // a design that holds the values of the fixed variables
  std::vector<double> origin_;
  std::vector<double> size_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> factors_;
};

/// Sizes for a search that begins at a design: the magnitude of a variable there or one of the user's unit, whichever is
/// more, but no more than its range. So the width of a range that is wider than that has no effect. Powers of two, so
/// that scaling does not round.
std::vector<double> search_sizes(const Problem& problem, std::span<const double> design);

/// Sizes for statements about a design (O3.1): the magnitude of a variable there, but no more than its range. A variable
/// below a thousandth of its unit has no magnitude: its size is one unit, or its range if that is less.
std::vector<double> sizes_at(const Problem& problem, std::span<const double> design);

}  // namespace twum::inline v0_1::optim
