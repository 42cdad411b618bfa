// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/options.hpp>

#include <limits>

namespace twum::optim {

/// Why a design is not a regular local optimum.
enum class Degeneracy : std::uint8_t {
  flat_direction,  ///< the objective does not change along a direction: the optimum is a valley
  flat_objective,  ///< the gradient of the objective is zero, here and at the start
  dependent_constraints,  ///< active limits with dependent gradients: multipliers are not unique
  kink,                   ///< left and right derivatives differ
  negative_curvature,     ///< stationary, but not a minimum
  undefined_gradient      ///< a derivative needed by the test does not exist
};

/// Its name in reports, such as "flat-direction"; static lifetime.
const char* to_string(Degeneracy degeneracy);

/// A degeneracy that was found at a design.
struct Finding {
  Degeneracy kind{};               ///< kind of degeneracy
  std::string text;                ///< a sentence for a report
  std::vector<std::string> names;  ///< variables or constraints concerned
};

/// Which side of a constraint or variable a limit is on.
enum class Side : std::uint8_t { lower, upper, equal };

/// One limit of a constraint or one bound of a variable, at the design certified. User units.
struct Activity {
  std::string name;        ///< of the constraint or variable
  bool is_bound{false};    ///< whether it is a bound of a variable
  Side side{Side::upper};  ///< which of its limits
  double value{0.0};       ///< of the constraint or variable
  double limit{0.0};       ///< the limit itself
  double violation{0.0};   ///< amount by which the limit is violated, >= 0
  /// the design lies on the limit; the limit restrains it if the multiplier is not zero
  bool active{false};
  /// Improvement of the objective per unit of relaxation, >= 0. For an equality, the improvement per unit by which
  /// the target is raised, of any sign. With several objectives, that of their weighted sum; see Certificate::prices.
  double multiplier{0.0};
  /// First-order change of the objective's value if the limit is relaxed (an equality: raised) by 1 % of its value.
  /// If the limit is zero, by 1 % of the response's span over the box. With several objectives, the change of their
  /// weighted sum, as for the multiplier.
  double gain_per_percent{0.0};
};

/// Evidence that a design is a constrained local optimum, computed from exact gradients only.
///
/// With gradients in the unit box and the scaling of the solver,
///
///     r = grad f - sum_i lambda_i grad c_i,   lambda >= 0 over the active limits and bounds
///
/// where lambda follows from non-negative least squares. With several objectives, grad f is sum_k w_k grad f_k with
/// the best weights w >= 0, sum w = 1: Pareto stationarity.
struct Certificate {
  /// Feasible, stationary, complementary and, with one objective, without negative curvature.
  bool passed{false};
  double infeasibility{
      std::numeric_limits<double>::quiet_NaN()};  ///< largest scaled violation; NaN: not measured
  /// Largest |r|, relative to the objective's gradient here or at the start, whichever is larger. With several
  /// objectives, relative to the largest w_k grad f_k.
  double stationarity{0.0};
  double complementarity{0.0};  ///< largest lambda times scaled slack
  /// Smallest eigenvalue of the reduced Hessian, relative to the largest. NaN if it was not tested: with several
  /// objectives, at kinks, at points that are not stationary, and if the budget does not allow the evaluations.
  double curvature{std::numeric_limits<double>::quiet_NaN()};
  std::vector<double> weights;  ///< of the objectives; {1} with one
  /// The same in user units. Improving objective k by one unit counts as much as prices[k] units of the scale of the
  /// multipliers, which is that of the first objective. So relaxing a limit by one unit improves objective k by
  /// multiplier / prices[k] while the others stay, and one unit of objective k trades for prices[k] / prices[l] units
  /// of objective l. 0: the objective cannot be traded, to first order.
  std::vector<double> prices;
  std::vector<Activity> limits;   ///< every constraint limit, then the active bounds
  std::vector<Finding> findings;  ///< degeneracies of the design
  std::string reason;             ///< a sentence that says why it did not pass
};

/// Certifies any design, however it was found. Cost: about one evaluation with gradient, and two for each variable if
/// kinks or curvature have to be tested. The gradients must be exact; functions that are not smooth give the finding
/// `kink`.
/// @param design  user units, one value for each variable
/// @param options  used are the tolerances, budget, stop and observer
/// @throws InputError for a problem that cannot be posed or a design of the wrong size.
Certificate certify(const Problem& problem, std::span<const double> design,
                    const SolveOptions& options = {});

}  // namespace twum::optim
