// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/measured_fit.hpp"

#include <twum/studies/results/calibrate_result.hpp>

#include <vector>

namespace twum::studies {

/// A parameter of a motor by which an answer may have a derivative. Whole numbers have none, and a parameter at 0 is mostly one
/// that the motor does not have. Static friction keeps its ratio to the kinetic one, below which it may not be.
bool may_move(const MotorDesign& motor, const ParameterInfo& row);

/// How the estimates move with each parameter of the motor that the study holds fixed and that what was measured depends on.
std::vector<Move> moves_of(const MeasuredFit& fit, const optim::LeastSquaresResult& best);

}  // namespace twum::studies
