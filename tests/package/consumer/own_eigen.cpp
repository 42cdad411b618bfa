// SPDX-License-Identifier: Apache-2.0
// A program that takes Eigen itself, with other options than the library: a fit, and a matrix of its own.
#include <twum/optim.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <cstdio>

int main() {
  Eigen::MatrixXd matrix(20, 20);
  for (Eigen::Index i = 0; i < 20; ++i)
    for (Eigen::Index j = 0; j < 20; ++j) matrix(i, j) = i == j ? 2.0 : 1.0 / double(1 + i + j);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(20);
  const Eigen::VectorXd solved = matrix.colPivHouseholderQr().solve(matrix * ones);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);

  // y = 2 exp(t / 2) at six places
  const auto residuals = [](std::span<const double> b) {
    twum::optim::Residuals at;
    for (int i = 0; i < 6; ++i) {
      const double t = 0.3 * i, curve = std::exp(b[1] * t);
      at.values.push_back(b[0] * curve - 2 * std::exp(0.5 * t));
      at.jacobian.insert(at.jacobian.end(), {curve, b[0] * t * curve});
    }
    return at;
  };
  const auto fit = twum::optim::least_squares({{.name = "a", .lower = 0, .upper = 10, .start = 1},
                                               {.name = "b", .lower = 0, .upper = 10, .start = 1}},
                                              residuals, {});
  std::printf("%.12g %.12g %.12g %.12g\n", fit.estimates[0].value, fit.estimates[1].value,
              solved.sum(), modes.eigenvalues().sum());
}
