// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::optim {

/// Conversion between the user's units and the unit box, for variables and responses.
///
/// Fixed variables (with equal bounds, or integers held by a search) are left out of the box. At the start, a
/// response times its factor has a gradient of size 1 in the box.
class Scaling {
 public:
  explicit Scaling(const Problem& problem);

  /// Computes the factors from an evaluation with a Jacobian.
  void scale_responses(std::span<const double> design, const Evaluation& evaluation);

  std::size_t size() const { return free_.size(); }
  std::size_t variable(std::size_t k) const { return free_[k]; }
  double factor(std::size_t response) const { return factors_[response]; }
  /// Whether the gradient of the response was zero where the factors were computed.
  bool flat_at_start(std::size_t response) const { return flat_[response]; }

  std::vector<double> to_unit(std::span<const double> design) const;
  std::vector<double> to_design(std::span<const double> unit) const;

  /// dx/du of the k-th free variable at a design.
  double slope(std::size_t k, std::span<const double> design) const;

  /// Derivative of a scaled response by the k-th free variable of the unit box.
  double derivative(const Evaluation& e, std::size_t response, std::size_t k,
                    std::span<const double> design) const;

 private:
  std::vector<Variable> variables_;
  std::vector<std::size_t> free_;
  std::vector<double> fixed_;  // a design that holds the values of the fixed variables
  std::vector<double> factors_;
  std::vector<bool> flat_;
};

}  // namespace twum::optim
