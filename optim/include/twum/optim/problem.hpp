// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace twum::optim {

/// No limit.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How a variable is spread over its bounds: solvers see it as a number in [0, 1].
enum class Scale : std::uint8_t { linear, log };

/// One design variable, in the user's units.
struct Variable {
  std::string name;   ///< unique in the problem
  double lower{0.0};  ///< finite; > 0 for a log scale
  double upper{1.0};  ///< finite, >= lower; equal bounds fix the variable
  double start{std::numeric_limits<
      double>::quiet_NaN()};   ///< NaN: the middle of the scale; clamped into the bounds
  Scale scale{Scale::linear};  ///< how solvers see it
  bool integer{false};         ///< then only whole numbers are ever evaluated
  /// Smallest value to which the search for causes of an infeasible problem may extend the lower bound; NaN: no design
  /// below the bound is ever evaluated.
  double lowest{std::numeric_limits<double>::quiet_NaN()};
  /// The same of the upper bound, the largest value.
  double highest{std::numeric_limits<double>::quiet_NaN()};
};

/// What is wanted of an objective.
enum class Sense : std::uint8_t { minimize, maximize };

/// Something that should be small, or large.
struct Objective {
  std::string name;              ///< unique in the problem
  Sense sense{Sense::minimize};  ///< which of the two
};

/// lower <= value <= upper; equal limits make an equality. At least one limit is finite.
struct Constraint {
  std::string name;          ///< unique in the problem
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units, >= lower
};

/// What an evaluator knows about a derivative that is not an ordinary one.
enum class Slope : std::uint8_t {
  smooth,     ///< the two one-sided derivatives agree
  one_sided,  ///< they differ here; `left` and `right` of the KinkedEntry hold them
  undefined   ///< there is none; the Jacobian entry is not to be used
};

/// A Jacobian entry that is not smooth at this point. Optional: an evaluator that cannot tell
/// gives none, and the certificate then looks for kinks with gradients nearby.
struct KinkedEntry {
  std::size_t response{0};        ///< its row
  std::size_t variable{0};        ///< its column
  Slope slope{Slope::undefined};  ///< what it is instead of a derivative
  /// Derivative towards smaller values of the variable; unread on its lower bound.
  double left{0.0};
  double right{0.0};  ///< derivative towards larger values; unread on its upper bound
};

/// What one design evaluates to. A design that cannot be evaluated has a failure and nothing else.
struct Evaluation {
  std::vector<double> values;  ///< objectives, then constraints, user units
  std::vector<double>
      jacobian;  ///< values.size() rows of one entry a variable; empty if not asked for
  std::vector<KinkedEntry> kinks;  ///< entries of the Jacobian that are not smooth
  std::string failure;             ///< short reason such as "no-periodic-state"; empty: it worked

  /// True if there is no failure.
  bool ok() const noexcept { return failure.empty(); }
};

/// Evaluates a design in user units. `gradient` says whether the Jacobian is needed; it may be
/// given anyway. A design without an answer is returned with a failure, or by throwing
/// EvaluationError; any other exception ends the solve and reaches its caller.
/// Must be a pure function of the design, and callable from several threads if a solve is given
/// more than one.
using Evaluator = std::function<Evaluation(std::span<const double> design, bool gradient)>;

/// A design problem: what may vary, what is wanted, what must hold.
struct Problem {
  std::vector<Variable> variables;      ///< what may vary
  std::vector<Objective> objectives;    ///< what is wanted
  std::vector<Constraint> constraints;  ///< what must hold
  Evaluator evaluate;                   ///< what a design comes to

  /// Values that the evaluator gives for a design.
  std::size_t responses() const noexcept { return objectives.size() + constraints.size(); }
};

/// Refuses a problem that cannot be posed.
/// @throws InputError naming the entry: no variable or objective, names missing or twice, bounds
///         that are not finite or cross, a log scale that reaches zero, an integer variable with
///         no whole number in its bounds, a constraint without a limit or with crossed limits.
void validate(const Problem& problem);

/// The design to start from, user units: each start (or middle of the scale) clamped into its bounds,
/// rounded where only whole numbers will do. For a problem that validate() accepts.
std::vector<double> start_design(const Problem& problem);

}  // namespace twum::optim
