// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/nlp.hpp"

#include <twum/optim/own_solver.hpp>
#include <twum/optim/solvers.hpp>

namespace twum::inline v0_1::optim {

/// Settings of one solver run.
struct RunSettings {
  std::uint64_t seed{1};
  /// largest number of distinct points; the session's quota applies as well
  std::size_t max_calls{0};
  const std::map<std::string, std::string>* options{nullptr};
};

/// Return values of one solver run, for the report. The best point is in the archive of the Nlp.
struct RunReport {
  std::string word;
  int code{0};
  StopReason stop{StopReason::finished};
  std::vector<double> z;  ///< the solver's final point; may be empty
};

/// One solver of the registry. `run` throws what the evaluator throws, never Stop.
struct Optimizer {
  SolverInfo info;
  std::function<RunReport(const SolverInfo& info, Nlp& nlp, std::span<const double> start,
                          const RunSettings& settings)>
      run;
};

/// A solver of the program.
Optimizer own_optimizer(SolverInfo info, OwnSolver solver);

/// Each solver library has one pair of files that returns such a list.
std::vector<Optimizer> nlopt_optimizers();
std::vector<Optimizer> ipopt_optimizers();
std::vector<SolverOption> nlopt_options();
std::vector<SolverOption> ipopt_options();

/// @throws InputError as find_solver()
const Optimizer& find_optimizer(const std::string& name);

/// Throws if this build lacks the solver, or if it needs a process and this program names none; says why.
/// @throws InputError
void require_available(const SolverInfo& solver);

/// The number given for an option, or the default.
/// @throws InputError for a text that is not a number or lies outside [least, most]
double number_option(const RunSettings& settings, const std::string& name, double standard,
                     double least, double most);

/// The same for an integer option.
/// @throws InputError also for a number with a fraction
int whole_option(const RunSettings& settings, const std::string& name, double standard,
                 double least, double most);

/// Throws for an option name that a solver does not have, and suggests the nearest one.
/// @throws InputError
void require_known_options(const RunSettings& settings, const std::vector<SolverOption>& known);

/// Of the candidates, the one nearest to `name` in edit distance; empty if none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace twum::inline v0_1::optim
