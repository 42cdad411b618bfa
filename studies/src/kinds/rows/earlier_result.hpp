// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor_problem.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Parameters of a design that an earlier study found, SI.
using EarlierDesign = std::vector<ParameterValue>;

/// Designs in the summary.json of a result directory: the best, or those of the front, or the
/// estimates of a calibration. Never empty.
/// @throws InputError if there is no summary, or no design in it
std::vector<EarlierDesign> earlier_designs(const std::string& folder);

/// The design to start from: the best by the first goal among those that meet the limits, else the one with the least
/// violation relative to the limits. Designs without an answer come last.
const EarlierDesign& best_start(const DesignProblem& problem,
                                const std::vector<EarlierDesign>& designs);

}  // namespace twum::inline v0_1::studies
