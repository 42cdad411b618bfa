// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust_problem.hpp>

namespace twum::inline v0_1::optim {

/// One end of a limit as g(x, z) = sign (X - end) >= 0, U1.8.
struct Margin {
  std::size_t response{0};
  double sign{1.0};
  double end{0.0};
  bool limited{true};  ///< false for a quantile, which has no limit
};

/// The ends of a limit: one or two.
std::vector<Margin> margins_of(const RobustProblem& problem, std::size_t response);

/// A margin with its derivatives at a built product.
struct MarginPoint {
  std::vector<double> z;
  double value{0.0};
  std::vector<double> by_design;  ///< dg/dx
  std::vector<double> by_normal;  ///< d = dg/dz
  std::vector<double> by_spread;  ///< s dg/ds for each input
  std::vector<double> by_input;   ///< dg/dP for each input
  std::string failure;            ///< if not empty, the other members are not valid
};

/// How many normal numbers make a product that is drawn: one for each input, and one that selects the measured row.
std::size_t drawn_numbers(const RobustProblem& problem);
/// The normal numbers of the inputs.
std::span<const double> input_numbers(const RobustProblem& problem, std::span<const double> z);

/// The built product of a design x and normal numbers z: x followed by the inputs that are not variables, scattered. With
/// drawn_numbers() of them, the measured inputs have the values of a row, else those of their law.
std::vector<double> build(const RobustProblem& problem, std::span<const double> x,
                          std::span<const double> z);

/// The value that input k has in the design.
double design_value(const RobustProblem& problem, std::span<const double> x, std::size_t k);

MarginPoint margin_at(const RobustProblem& problem, const Margin& margin, std::span<const double> x,
                      std::vector<double> z);

double norm(std::span<const double> v);
double dot(std::span<const double> a, std::span<const double> b);

}  // namespace twum::inline v0_1::optim
