// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// Why a design is not a regular local optimum.
enum class Degeneracy : std::uint8_t {
  flat_direction,  ///< the objective does not change along a direction: the optimum is a valley
  flat_objective,  ///< the gradient of the objective is zero
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

/// "lower", "upper" or "equal"; static lifetime.
const char* to_string(Side side);

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
  double tolerance{0.0};  ///< violation up to which the limit counts as kept (O2.1); 0 for a bound
  std::string unit{};     ///< of value, limit, violation and tolerance, as the problem says
  /// Of the multiplier: "Pa per N.m", or "Pa" for a limit without unit. Empty unless the problem says both units; with several
  /// objectives that of the first.
  std::string price_unit{};
};

/// Evidence that a design is a constrained local optimum, computed from exact gradients at the design only. Neither the
/// start nor the width of a range wider than the variable's magnitude enters any number.
///
///     r = grad f - sum_i lambda_i grad c_i,   lambda >= 0 over the active limits and bounds
///
/// where lambda follows from non-negative least squares. With several objectives, grad f is sum_k w_k grad f_k with
/// the best weights w >= 0, sum w = 1: Pareto stationarity.
struct Certificate {
  /// Every limit is kept, the design is stationary and complementary and, with one objective, no direction that the
  /// limits allow improves it to second order. Values beside the design agree with the Jacobian (O5.1), unless the budget
  /// does not allow the two evaluations.
  bool passed{false};
  /// The second order is decided too: the curvature is positive on the critical cone, or values rise along the one
  /// direction without. If passed without, the design is optimal to first order only.
  bool second_order{false};
  /// Largest violation of a limit, relative to the larger of the limit and its terms (O2.1). A limit with an own
  /// tolerance counts as if this were 1e-8 of that size. NaN: not measured.
  double infeasibility{std::numeric_limits<double>::quiet_NaN()};
  double stationarity{0.0};  ///< dimensionless residual of the first-order conditions (O3.2)
  /// Largest multiplier times slack or violation, relative to the objective and its gradient (O3.4).
  double complementarity{0.0};
  /// What a step could still gain at most, by the quadratic model (O3.3), user units of the objective; NaN if it was
  /// not computed.
  double gain{std::numeric_limits<double>::quiet_NaN()};
  /// Smallest curvature on the critical cone, relative to the largest entry of the Hessian. NaN if it was not tested: with several
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

}  // namespace twum::inline v0_1::optim
