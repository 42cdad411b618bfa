// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/options.hpp>

#include <limits>

namespace twum::optim {

/// What keeps an optimum from being a plain one.
enum class Degeneracy : std::uint8_t {
  flat_direction,         ///< the objective does not change along it: the optimum is a valley
  flat_objective,         ///< the objective has no slope in any variable, here nor at the start
  dependent_constraints,  ///< active limits with dependent gradients: multipliers are not unique
  kink,                   ///< one-sided derivatives differ
  negative_curvature,     ///< stationary, but not a minimum
  undefined_gradient      ///< a derivative that the test needs does not exist
};

/// The word for it in reports, such as "flat-direction".
const char* to_string(Degeneracy degeneracy);

/// Something unusual about an optimum.
struct Finding {
  Degeneracy kind{};               ///< what it is
  std::string text;                ///< a sentence for a report
  std::vector<std::string> names;  ///< variables or constraints concerned
};

/// Which side of a constraint or variable a limit is on.
enum class Side : std::uint8_t { lower, upper, equal };

/// One limit of a constraint or one bound of a variable, at the design certified. User units.
struct Activity {
  std::string name;        ///< of the constraint or variable
  bool is_bound{false};    ///< of a variable
  Side side{Side::upper};  ///< which of its limits
  double value{0.0};       ///< of the constraint or variable
  double limit{0.0};       ///< what it is held to
  double violation{0.0};   ///< by how much the limit is broken, >= 0
  bool active{false};      ///< the design is at it; it holds it back where it has a multiplier
  double multiplier{0.0};  ///< improvement of the objective per unit of relaxation, >= 0; for an
      ///< equality the improvement per unit that its target is raised, any sign. With several
      ///< objectives that of their weighted sum, see Certificate::prices
  double gain_per_percent{0.0};  ///< first-order change of the objective's value when the limit is
                                 ///< relaxed (an equality: raised) by 1 % of itself; by 1 % of the
                                 ///< response's span over the box where it is zero. With several
                                 ///< objectives that of their weighted sum, as the multiplier
};

/// Evidence that a design is a constrained local optimum, from exact gradients alone.
///
/// With gradients taken in the unit box and scaled as the solver saw them,
///
///     r = grad f - sum_i lambda_i grad c_i,   lambda >= 0 over the active limits and bounds
///
/// by non-negative least squares. With several objectives, grad f is sum_k w_k grad f_k with the
/// best weights w >= 0, sum w = 1: Pareto stationarity.
struct Certificate {
  /// Feasible, stationary, complementary and, with one objective, not curved downwards.
  bool passed{false};
  double infeasibility{
      std::numeric_limits<double>::quiet_NaN()};  ///< largest scaled violation; NaN: not measured
  /// Largest |r|, relative to the objective's gradient here or at the start; of several objectives to the
  /// largest w_k grad f_k.
  double stationarity{0.0};
  double complementarity{0.0};  ///< largest lambda times scaled slack
  /// Smallest eigenvalue of the reduced Hessian, relative to the largest; NaN: not tested, as with several
  /// objectives, at kinks, away from stationary points or without the calls that it takes.
  double curvature{std::numeric_limits<double>::quiet_NaN()};
  std::vector<double> weights;  ///< of the objectives; {1} with one
  /// The same in user units: improving objective k by one unit counts prices[k] units of the first
  /// objective's scale, in which multipliers are. So a limit that gives way by one unit improves
  /// objective k by multiplier / prices[k] while the others stay, and one unit of objective k is
  /// traded for prices[k] / prices[l] units of objective l. 0: no trade to first order.
  std::vector<double> prices;
  std::vector<Activity> limits;   ///< every constraint limit, then the active bounds
  std::vector<Finding> findings;  ///< what is unusual
  std::string reason;             ///< why it did not pass, in words
};

/// Certifies any design, whoever found it. About one evaluation with gradient, and two for each variable
/// where kinks or curvature have to be looked for. The test is as sharp as the gradients: of functions
/// that are not smooth it says `kink`.
/// @param design  user units, one value for each variable
/// @param options  of these the tolerances, budget, stop and observer
/// @throws InputError for a problem that cannot be posed or a design of the wrong size.
Certificate certify(const Problem& problem, std::span<const double> design,
                    const SolveOptions& options = {});

}  // namespace twum::optim
