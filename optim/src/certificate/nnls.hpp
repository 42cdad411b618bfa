// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace twum::inline v0_1::optim {

/// Minimizes |A x - b| with x_i >= 0 for every i whose `free` flag is false (Lawson and Hanson's active set method; a
/// free unknown is never bounded). A may have dependent columns; columns should have about unit length.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                          const std::vector<bool>& free);

}  // namespace twum::inline v0_1::optim
