// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nlp.hpp"

#include <twum/optim/solvers.hpp>

namespace twum::optim {

/// What one solver run is told.
struct RunSettings {
  std::uint64_t seed{1};
  std::size_t max_calls{0};  ///< distinct points it may ask for; the session's quota holds as well
  const std::map<std::string, std::string>* options{nullptr};
};

/// What one solver run says. Its word and code are for the report; the archive of the Nlp holds
/// what it found.
struct RunReport {
  std::string word;
  int code{0};
  StopReason stop{StopReason::finished};
  std::vector<double> z;  ///< the solver's own final point; may be empty
};

/// One solver of the registry. `run` throws what the evaluator throws, never Stop.
struct Optimizer {
  SolverInfo info;
  RunReport (*run)(const SolverInfo& info, Nlp& nlp, std::span<const double> start,
                   const RunSettings& settings);
};

/// Each solver library is one pair of files that gives such a list.
std::vector<Optimizer> nlopt_optimizers();
std::vector<Optimizer> ipopt_optimizers();
std::vector<SolverOption> nlopt_options();
std::vector<SolverOption> ipopt_options();

/// @throws InputError as find_solver()
const Optimizer& find_optimizer(const std::string& name);

/// Refuses a solver that this build lacks, saying why.
/// @throws InputError
void require_available(const SolverInfo& solver);

/// The number given for an option, or the default.
/// @throws InputError for text that is no number or lies outside [least, most]
double number_option(const RunSettings& settings, const std::string& name, double standard,
                     double least, double most);

/// The same for an option that counts something.
/// @throws InputError also for a number with a fraction
int whole_option(const RunSettings& settings, const std::string& name, double standard,
                 double least, double most);

/// Refuses option names that a solver does not have, with the nearest one.
/// @throws InputError
void require_known_options(const RunSettings& settings, const std::vector<SolverOption>& known);

/// Of the candidates, the one nearest to `name` in edit distance; empty if none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace twum::optim
