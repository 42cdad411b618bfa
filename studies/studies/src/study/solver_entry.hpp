// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/options.hpp>
#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/schema/schema.hpp>
#include <twum/studies/yaml/node.hpp>

#include <string>

/// The entry `solver:` of a study: its shape, what can be wrong with it, its meaning; internal.
namespace twum::studies {

/// Name under which `solver:` of a front asks for the evolutionary search.
inline constexpr const char* kNsga2 = "nsga2";

Schema solver_schema(const char* evaluations);

/// Adds what the table of solvers knows: names that do not exist, solvers that do not fit the study,
/// options of another solver.
void check_solver(const YamlNode& study, Diagnostics& diagnostics);

/// The entry with its defaults; observer, threads and stop are not set.
optim::SolveOptions solver_options_of(const YamlNode& study);

}  // namespace twum::studies
