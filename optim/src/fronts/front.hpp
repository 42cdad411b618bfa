// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/certify.hpp"

#include <twum/optim/pareto.hpp>

namespace twum::inline v0_1::optim {

/// Objective values of an evaluation, with a sign such that all are minimized.
std::vector<double> minimized(const Problem& problem, const Evaluation& evaluation);

/// Computes reference and hypervolume of a front from its points; an empty reference is replaced by a default.
void measure(Front& front, const Problem& problem, const std::vector<double>& reference);

/// @throws InputError unless the problem is valid and has two or three objectives
void validate_front(const Problem& problem, const std::vector<double>& reference);

}  // namespace twum::inline v0_1::optim
