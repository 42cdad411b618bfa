// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certify.hpp"

#include <twum/optim/pareto.hpp>

namespace twum::optim {

/// Objective values of an evaluation, turned so that all are minimized.
std::vector<double> minimized(const Problem& problem, const Evaluation& evaluation);

/// Fills reference and hypervolume of a front from its points; an empty reference is chosen.
void measure(Front& front, const Problem& problem, const std::vector<double>& reference);

/// @throws InputError unless the problem can be posed with two or three objectives
void validate_front(const Problem& problem, const std::vector<double>& reference);

}  // namespace twum::optim
