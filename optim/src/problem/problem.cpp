// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/options.hpp>
#include <twum/optim/problem.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace twum::inline v0_1::optim {
namespace {

void require(bool condition, const std::string& text) {
  if (!condition) throw InputError(text);
}

void validate_variable(const Variable& v) {
  const std::string who = "variable '" + v.name + "': ";
  require(std::isfinite(v.lower) && std::isfinite(v.upper), who + "the bounds must be finite");
  require(v.lower <= v.upper, who + "the lower bound lies above the upper one");
  require(v.scale == Scale::linear || v.lower > 0.0, who + "a log scale needs a lower bound > 0");
  require(!std::isinf(v.start), who + "the start must be finite");
  require(!v.integer || std::ceil(v.lower) <= std::floor(v.upper),
          who + "there is no whole number between the bounds");
}

void validate_constraint(const Constraint& c) {
  const std::string who = "constraint '" + c.name + "': ";
  require(!std::isnan(c.lower) && !std::isnan(c.upper), who + "a limit is not a number");
  require(std::isfinite(c.lower) || std::isfinite(c.upper), who + "it has no limit");
  require(c.lower <= c.upper && c.lower < kInfinity && c.upper > -kInfinity,
          who + "the limits cross");
  require(std::isnan(c.tolerance) || (c.tolerance >= 0.0 && std::isfinite(c.tolerance)),
          who + "its tolerance must be a finite number, at least 0");
}

template <typename Named>
void require_names(const std::vector<Named>& entries, const std::string& what) {
  std::set<std::string> seen;
  for (const auto& entry : entries) {
    require(!entry.name.empty(), "a " + what + " has no name");
    require(seen.insert(entry.name).second, what + " '" + entry.name + "' is given twice");
  }
}

double middle(const Variable& v) {
  return v.scale == Scale::log ? std::sqrt(v.lower) * std::sqrt(v.upper)
                               : 0.5 * v.lower + 0.5 * v.upper;
}

}  // namespace

void validate(const Problem& problem) {
  require(!problem.variables.empty(), "the problem has no variable");
  require(!problem.objectives.empty(), "the problem has no objective");
  require(static_cast<bool>(problem.evaluate), "the problem has no evaluator");
  require_names(problem.variables, "variable");
  require_names(problem.objectives, "objective");
  require_names(problem.constraints, "constraint");
  for (const auto& v : problem.variables) validate_variable(v);
  for (const auto& c : problem.constraints) validate_constraint(c);
}

void validate(const SolveOptions& options) {
  const bool automatic = options.solver == "auto";
  require(options.tolerance > 0.0 && options.tolerance < 1.0,
          "tolerance: " + std::to_string(options.tolerance) + "; it must lie between 0 and 1");
  require(options.feasibility_tolerance >= 0.0 && std::isfinite(options.feasibility_tolerance),
          "feasibility_tolerance: " + std::to_string(options.feasibility_tolerance) +
              "; it must be a finite number, at least 0");
  require(options.budget.seconds >= 0.0,
          "budget.seconds: " + std::to_string(options.budget.seconds) + "; it must be at least 0");
  require(!automatic || options.solver_options.empty(),
          "solver_options: solver 'auto' takes none; name the solver that they are for");
  require(automatic || options.global.empty(),
          "global: only solver 'auto' runs a global algorithm first");
}

std::vector<double> start_design(const Problem& problem) {
  std::vector<double> design;
  design.reserve(problem.variables.size());
  for (const auto& v : problem.variables) {
    const double wanted = std::isnan(v.start) ? middle(v) : v.start;
    double x = std::clamp(wanted, v.lower, v.upper);
    if (v.integer) x = std::clamp(std::round(x), std::ceil(v.lower), std::floor(v.upper));
    design.push_back(x);
  }
  return design;
}

const char* to_string(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

const char* to_string(Sense sense) { return sense == Sense::maximize ? "maximize" : "minimize"; }

const char* to_string(Slope slope) {
  switch (slope) {
    case Slope::smooth: return "smooth";
    case Slope::one_sided: return "one-sided";
    case Slope::undefined: return "undefined";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
