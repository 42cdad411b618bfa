// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor_problem.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// A question for each combination of the choices, with their sets in its motor and nothing left to choose; the question
/// itself if there is no choice. The set of the first choice changes fastest.
/// @throws InputError if the sets of a combination do not give a valid motor
std::vector<DesignProblem> combinations(const DesignProblem& problem);

/// Index of the combination of a design.
std::size_t combination_of(const DesignProblem& problem, std::span<const double> design);

/// The variables of a question with derived parameters.
/// @throws InputError if they do not go together
VariedParameters varied_parameters(const DesignProblem& problem);

/// motor_of() for one combination and its variables alone.
MotorDesign motor_of_combination(const DesignProblem& problem, const VariedParameters& varied,
                                 std::span<const double> values);

}  // namespace twum::inline v0_1::studies
