// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// No limit.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How a variable is mapped to the number in [0, 1] that solvers see.
enum class Scale : std::uint8_t { linear, log };

/// "linear" or "log"; static lifetime.
const char* to_string(Scale scale);

/// One design variable, in the user's units.
struct Variable {
  std::string name{};  ///< unique in the problem
  double lower{0.0};   ///< finite; > 0 for a log scale
  double upper{1.0};   ///< finite, >= lower; equal bounds fix the variable
  double start{std::numeric_limits<
      double>::quiet_NaN()};   ///< NaN: the middle of the scale; clamped into the bounds
  Scale scale{Scale::linear};  ///< how it is mapped to [0, 1]
  bool integer{false};         ///< true: only whole numbers are evaluated
  /// Smallest value to which the search for causes of an infeasible problem may extend the lower bound; NaN: no design
  /// below the bound is ever evaluated.
  double lowest{std::numeric_limits<double>::quiet_NaN()};
  /// The same for the upper bound: the largest value.
  double highest{std::numeric_limits<double>::quiet_NaN()};
  std::string unit{};  ///< of its values, for reports; empty: not said, "1": none
};

/// Direction of an objective.
enum class Sense : std::uint8_t { minimize, maximize };

/// "minimize" or "maximize"; static lifetime.
const char* to_string(Sense sense);

/// A response to be minimized or maximized.
struct Objective {
  std::string name{};            ///< unique in the problem
  Sense sense{Sense::minimize};  ///< its direction
  std::string unit{};            ///< of its value, as that of a variable
};

/// lower <= value <= upper; equal limits make an equality. At least one limit is finite.
struct Constraint {
  std::string name{};        ///< unique in the problem
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units, >= lower
  /// Amount by which a limit may be broken and still counts as kept, user units, >= 0. NaN: 1e-8 of the larger of the
  /// limit and the magnitude of its terms at the design (O2.1).
  double tolerance{std::numeric_limits<double>::quiet_NaN()};
  std::string unit{};  ///< of its value, as that of a variable
};

/// Kind of a derivative.
enum class Slope : std::uint8_t {
  smooth,     ///< left and right derivatives agree
  one_sided,  ///< left and right derivatives differ; the KinkedEntry holds both
  undefined   ///< there is no derivative; the Jacobian entry is not used
};

/// "smooth", "one-sided" or "undefined"; static lifetime.
const char* to_string(Slope slope);

/// A Jacobian entry that is not smooth at this point. Optional: if an evaluator gives none, the certificate searches
/// for kinks with gradients at nearby designs.
struct KinkedEntry {
  std::size_t response{0};        ///< its row
  std::size_t variable{0};        ///< its column
  Slope slope{Slope::undefined};  ///< one_sided or undefined
  /// Derivative towards smaller values of the variable; ignored on its lower bound.
  double left{0.0};
  double right{0.0};  ///< derivative towards larger values; ignored on its upper bound
};

/// Result of evaluating one design. If the design cannot be evaluated, only `failure` is set.
struct Evaluation {
  std::vector<double> values{};  ///< objectives, then constraints, user units
  /// values.size() rows with one entry for each variable; empty if it was not requested
  std::vector<double> jacobian{};
  std::vector<KinkedEntry> kinks{};  ///< entries of the Jacobian that are not smooth
  std::string failure{};             ///< short reason such as "no-periodic-state"; empty on success

  /// True if there is no failure.
  bool ok() const noexcept { return failure.empty(); }
};

/// Evaluates a design in user units. `gradient` says whether the Jacobian is needed; it may be returned in any case.
/// For a design without an answer, return a failure or throw EvaluationError. Any other exception ends the solve and
/// reaches the caller. Must be a pure function of the design, and thread-safe if a solve uses more than one thread.
using Evaluator = std::function<Evaluation(std::span<const double> design, bool gradient)>;

/// A design problem: variables, objectives and constraints.
struct Problem {
  std::vector<Variable> variables{};      ///< what may vary
  std::vector<Objective> objectives{};    ///< what is wanted
  std::vector<Constraint> constraints{};  ///< what must hold
  Evaluator evaluate{};                   ///< computes objectives and constraints

  /// False: the evaluator gives no Jacobian and is never asked for one. Then solve() needs a named solver without gradients,
  /// and the certificate is not measured.
  bool derivatives{true};

  /// Number of values that the evaluator returns.
  std::size_t responses() const noexcept { return objectives.size() + constraints.size(); }
  /// Name of the objective or constraint that a value belongs to.
  const std::string& response_name(std::size_t response) const {
    return response < objectives.size() ? objectives[response].name
                                        : constraints.at(response - objectives.size()).name;
  }
};

/// Checks that a problem can be solved at all.
/// @throws InputError naming the entry: no variable or objective, names missing or twice, bounds
///         that are not finite or cross, a log scale that reaches zero, an integer variable with
///         no whole number in its bounds, a constraint without a limit or with crossed limits.
void validate(const Problem& problem);

/// The start design in user units: each start (or the middle of the scale) clamped into its bounds, rounded for an
/// integer variable. For a problem that validate() accepts.
std::vector<double> start_design(const Problem& problem);

}  // namespace twum::inline v0_1::optim
