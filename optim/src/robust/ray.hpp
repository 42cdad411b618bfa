// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::inline v0_1::optim {

/// The problem min t with F_k - n_k t <= f_k for each objective k (turned where it is maximized), of Pascoletti and Serafini, U7.1:
/// its solution lies on the front, on the ray through f. Its last variable is t; it keeps a copy of the problem.
Problem ray_problem(const Problem& problem, const std::vector<double>& f,
                    const std::vector<double>& n);

}  // namespace twum::inline v0_1::optim
