// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::inline v0_1::optim {

/// What a solver does when a design cannot be evaluated.
enum class FailurePolicy : std::uint8_t {
  shorter_step,  ///< the solver itself tries a shorter step
  restart,       ///< the solver is stopped and restarted from the best design in a smaller box
  rank_last      ///< the solver only compares designs, and a failed one ranks behind all others
};

/// "shorter-step", "restart" or "rank-last"; static lifetime.
const char* to_string(FailurePolicy policy);

/// Name and capabilities of a solver.
struct SolverInfo {
  std::string name{};         ///< such as "nlopt:slsqp"
  std::string description{};  ///< one line
  bool gradient{false};       ///< needs the Jacobian
  bool inequality{
      false};  ///< accepts inequality constraints, possibly through an augmented Lagrangian
  bool equality{false};     ///< accepts equality constraints
  bool global{false};       ///< searches the whole box
  bool stochastic{false};   ///< uses random numbers, which depend on the seed
  bool augmented{false};    ///< constraints only through an augmented Lagrangian (nlopt:auglag)
  bool available{true};     ///< false: not in this build; `description` says why
  bool own_process{false};  ///< may compute for ever, so that it needs use_solver_process()
  FailurePolicy on_failure{FailurePolicy::restart};  ///< reaction to a failed evaluation
};

/// All solvers of the library, including those that this build lacks, in a fixed order; static lifetime.
const std::vector<SolverInfo>& solvers();

/// The row of a name such as "nlopt:slsqp"; static lifetime.
/// @throws InputError for a name that does not exist, with the nearest one and the list.
const SolverInfo& find_solver(const std::string& name);

/// One option that a solver takes in SolveOptions::solver_options.
struct SolverOption {
  std::string solver;                ///< "ipopt" or "nlopt"
  std::string name;                  ///< as the solver calls it
  std::string type;                  ///< "number", "integer" or "text"
  std::string text;                  ///< what it does, in one line
  double least{0};                   ///< smallest value of a number or integer
  double most{0};                    ///< largest value of a number or integer
  std::vector<std::string> words{};  ///< admissible values of a text

  /// Its admissible values as a text: "1e-14 to 0.1" or "monotone|adaptive".
  std::string range() const;
};

/// Every option of every solver; static lifetime.
const std::vector<SolverOption>& solver_options();

}  // namespace twum::inline v0_1::optim
