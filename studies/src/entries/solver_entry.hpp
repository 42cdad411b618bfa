// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/shape.hpp>
#include <twum/optim/options.hpp>

#include <string>

/// The entry `solver:` of a study: its shape and its checks; internal.
namespace twum::inline v0_1::studies {

/// Name under which `solver:` of a front asks for the evolutionary search.
inline constexpr const char* kNsga2 = "nsga2";

/// A name, or a mapping of options.
/// @param fresh  what is left out
Shape<optim::SolveOptions> solver_shape(const optim::SolveOptions& fresh);

/// Adds errors from the table of solvers: unknown names, solvers that do not fit the study, options of another
/// solver.
void check_solver(const Given& study, Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::studies
