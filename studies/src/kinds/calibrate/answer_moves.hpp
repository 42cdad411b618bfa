// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/calibrate/measured_fit.hpp"

#include <twum/studies/calibrate_result.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// Whether derivatives of an answer with respect to a parameter make sense. Integer parameters have none, and a
/// parameter that is 0 usually belongs to a feature that the motor does not have. Static friction keeps its ratio to
/// kinetic friction, below which it may not fall.
bool may_move(const MotorDesign& motor, const ParameterInfo& row);

/// Derivatives of the estimates with respect to each parameter of the motor that the study holds fixed and on which
/// the measured quantities depend.
std::vector<Move> moves_of(const MeasuredFit& fit, const optim::LeastSquaresResult& best);

}  // namespace twum::inline v0_1::studies
