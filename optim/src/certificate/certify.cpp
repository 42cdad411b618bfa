// SPDX-License-Identifier: Apache-2.0
#include "certificate/certify.hpp"

#include "certificate/contradiction.hpp"
#include "certificate/kinks.hpp"
#include "certificate/limits_report.hpp"
#include "certificate/probe.hpp"
#include "problem/first_design.hpp"

#include <twum/base/error.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

constexpr double kShallow = 1e-4;  // of the Hessian: curvature that a step of 1e-2 may outrun
// Relative to the Hessian and to the gradient: curvature above the error of the differences, and clearly so.
constexpr double kZero = 1e-6;
constexpr double kClear = 10.0;
constexpr double kNoise = 1e-8;
constexpr double kRounding = 1e-12;  // of slopes that cancel each other

class Certifier {
 public:
  Certifier(Session& session, const Scaling& search)
      : session_(session),
        search_(search),
        objectives_(session.problem().objectives.size()),
        options_(session.options()) {}

  std::optional<Certified> run(std::span<const double> design, bool second_order) {
    const Evaluation here = session_.at(design, true);
    if (!here.ok()) return std::nullopt;
    const Problem& problem = session_.problem();
    scaling_.emplace(scaling_at(problem, search_, sizes_at(problem, design), design, here));
    auto point = kkt_point(session_, *scaling_, design);
    if (!point) return std::nullopt;
    result_.point = std::move(*point);
    Kinks kinks(session_, *scaling_, result_.point);
    if (derivatives_exist(kinks)) {
      first_order_at(kinks);
      if (kinks.names().empty() && feasible()) measure_with_curvature();
      if (!stationary() && feasible() && objectives_ == 1 && room()) look_for(kinks);
      name_dependent_limits();
      if (kinks.names().empty()) name_flat_objective();
      // With several objectives no test: on a concave front, the weighted sum has negative curvature along the front.
      if (second_order && objectives_ == 1 && stationary() && kinks.names().empty()) decide();
    }
    for (const std::string& variable : kinks.names())
      certificate().findings.push_back(
          {Degeneracy::kink, "one-sided derivatives of the objective differ", {variable}});
    conclude();
    return std::move(result_);
  }

 private:
  Certificate& certificate() { return result_.certificate; }
  bool room() const { return session_.left() >= 2 * scaling_->size(); }
  bool feasible() const { return result_.point.violation <= options_.feasibility_tolerance; }
  bool stationary() const {
    const Certificate& c = result_.certificate;
    const bool all_slopes = objectives_ == 1 || gain_ != kNotMeasured || balanced_;
    return c.stationarity <= options_.tolerance && all_slopes && !(gain_ > allowed_gain());
  }
  bool has(Degeneracy kind) const {
    const auto& f = result_.certificate.findings;
    return std::any_of(f.begin(), f.end(), [&](const Finding& x) { return x.kind == kind; });
  }
  const std::string& variable_name(Index k) const {
    return session_.problem().variables[scaling_->variable(static_cast<std::size_t>(k))].name;
  }
  // The largest, if there are several: at an end of a front the one with a weight may be zero.
  double objective_size() const {
    double size = 0.0;
    for (std::size_t k = 0; k < objectives_; ++k)
      size = std::max(size, std::abs(scaling_->factor(k) * result_.point.evaluation.values[k]));
    return size;
  }
  // (O3.3): a billionth of the objective, or what rounding leaves of slopes and curvatures. The points of a front lie
  // apart by far more.
  double allowed_gain() const {
    const double part = objectives_ == 1 ? 1e-3 : 1e-2;
    return options_.tolerance * (part * objective_size() + kNoise * size_);
  }

  bool limit_matters(std::size_t response) const {
    if (response < objectives_) return true;
    return std::any_of(result_.point.limits.begin(), result_.point.limits.end(),
                       [&](const Limit& l) {
                         return l.constraint + objectives_ == response && l.slack <= kActivity;
                       });
  }

  bool derivatives_exist(const Kinks& kinks) {
    if (!kinks.undefined([&](std::size_t response) { return limit_matters(response); }))
      return true;
    certificate().stationarity = std::numeric_limits<double>::infinity();
    certificate().findings.push_back({Degeneracy::undefined_gradient,
                                      "a derivative that the test needs does not exist here",
                                      {}});
    return false;
  }

  // Each candidate has to be stationary: the worst decides.
  void first_order_at(Kinks& kinks) {
    const auto candidates = kinks.reported();
    std::size_t worst = 0;
    double largest = -1.0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      first_order(candidates[i]);
      if (certificate().stationarity <= largest) continue;
      largest = certificate().stationarity;
      worst = i;
    }
    if (candidates.size() > 1) first_order(candidates[worst]);
  }

  void look_for(Kinks& kinks) {
    const auto mixed = kinks.found_nearby();
    if (!mixed) return;
    gain_ = kNotMeasured;
    certificate().gain = std::numeric_limits<double>::quiet_NaN();
    first_order(*mixed);
  }

  void first_order(const Eigen::MatrixXd& gradients) {
    if (gradients.size() == 0) {  // every variable is fixed: the only design is stationary
      result_.multipliers.weights =
          Eigen::VectorXd::Constant(gradients.cols(), 1.0 / static_cast<double>(gradients.cols()));
      certificate().stationarity = 0.0;
      return;
    }
    result_.multipliers = find_multipliers(result_.point, gradients, objectives_, kActivity);
    // Each gradient is weighted, so that a large gradient with weight 0 does not hide an error in the others.
    const Eigen::MatrixXd weighted = gradients * result_.multipliers.weights.asDiagonal();
    slope_ = slope_beside_bounds(weighted, result_.multipliers);
    steepest_ = weighted.cwiseAbs().maxCoeff();
    set_stationarity(slope_);
    balanced_ = each_slope_is_balanced(weighted, result_.multipliers, options_.tolerance,
                                       kRounding * size_);
  }

  // (O3.2). Forces of limits that cancel each other are no measure, but they leave rounding errors.
  void set_stationarity(double size) {
    const auto& m = result_.multipliers;
    double force = 0.0;
    for (Index j = 0; j < m.active.cols(); ++j) {
      const auto at = static_cast<std::size_t>(j);
      const double value =
          at < m.limits.size() ? m.limit_values[at] : m.bound_values[at - m.limits.size()];
      force = std::max(force, std::abs(value) * m.active.col(j).cwiseAbs().maxCoeff());
    }
    size_ = std::max(size, kNoise * force);
    const double residual = m.residual.size() > 0 ? m.residual.cwiseAbs().maxCoeff() : 0.0;
    certificate().stationarity = residual > 0.0 ? residual / size_ : 0.0;
  }

  // (O3.1, O3.2): where gradient and multipliers vanish, the curvature is the measure.
  void measure_with_curvature() {
    const bool needed = objectives_ == 1 || !stationary();
    if (!needed || scaling_->size() == 0 || !room()) return;
    hessian_ =
        lagrangian_curvature(session_, *scaling_, result_.point, result_.multipliers, objectives_);
    if (!hessian_) return;
    set_stationarity(std::max(slope_, hessian_->cwiseAbs().maxCoeff()));
    limits_ = strength(result_.point, result_.multipliers, size_);
    set_gain();
  }

  // (O3.3): what the quadratic model gains within one magnitude of the variables, along the directions in which the
  // limits with multipliers stay met.
  void set_gain() {
    const Eigen::MatrixXd z = null_space(limits_.strong);
    gain_ = 0.0;
    if (z.cols() > 0) {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(z.transpose() * *hessian_ * z);
      const Eigen::VectorXd slopes =
          eigen.eigenvectors().transpose() * (z.transpose() * result_.multipliers.residual);
      for (Index j = 0; j < slopes.size(); ++j) {
        const double p = std::abs(slopes[j]), curvature = std::max(eigen.eigenvalues()[j], 0.0);
        const double step = p < curvature ? p / curvature : 1.0;
        gain_ += step * (p - 0.5 * curvature * step);
      }
    }
    if (objectives_ == 1) certificate().gain = gain_ / scaling_->factor(0);
  }

  void name_dependent_limits() {
    auto& m = result_.multipliers;
    const std::vector<Index> dependent = dependent_columns(m.active);
    if (dependent.empty()) return;
    set_least_worth(result_.point, dependent, m);
    std::vector<std::string> names;
    for (const Index j : dependent) {
      const auto at = static_cast<std::size_t>(j);
      names.push_back(
          at < m.limits.size()
              ? session_.problem().constraints[result_.point.limits[m.limits[at]].constraint].name
              : variable_name(m.bounds[at - m.limits.size()]));
    }
    certificate().findings.push_back(
        {Degeneracy::dependent_constraints,
         "some of these limits follow from the others at this design; to loosen one of them alone "
         "may change nothing",
         names});
  }

  void name_flat_objective() {
    const Eigen::MatrixXd g = objective_gradients(result_.point, objectives_);
    std::vector<std::string> names;
    for (Index k = 0; k < g.rows(); ++k)
      if (g.row(k).cwiseAbs().maxCoeff() == 0.0) names.push_back(variable_name(k));
    const bool curved = hessian_ && hessian_->cwiseAbs().maxCoeff() > 0.0;
    if (static_cast<Index>(names.size()) == g.rows() && g.rows() > 0 && !curved)
      certificate().findings.push_back(
          {Degeneracy::flat_objective, "the gradient of the objective is zero", names});
  }

  // Second order on the critical cone, then probes along the directions that it leaves open.
  void decide() {
    if (scaling_->size() == 0) certificate().second_order = true;
    if (!hessian_) return;
    const double largest = hessian_->cwiseAbs().maxCoeff();
    const double zero = no_curvature(largest);
    const ConeCurvature cone = cone_curvature(*hessian_, limits_, zero);
    certificate().curvature = largest > 0.0 ? cone.smallest / largest : cone.smallest;
    const ProbeBase base{result_.point, result_.multipliers, *hessian_, allowed_gain()};
    const bool falls = cone.direction.size() > 0;
    if (falls) result_.better = probe(session_, *scaling_, base, cone.direction).better;
    const bool clear = cone.smallest < -kClear * zero && !has(Degeneracy::dependent_constraints);
    if (falls && (result_.better || clear))
      certificate().findings.push_back({Degeneracy::negative_curvature,
                                        "stationary, but the objective falls to second order",
                                        {}});
    for (Index j = 0; j < cone.flat.cols(); ++j) name_flat_direction(cone.flat.col(j));
    // Beside an inflection the curvature is small, but not zero: the third order decides.
    const Eigen::MatrixXd shallow =
        cone_curvature(*hessian_, limits_, std::max(zero, kShallow * largest)).flat;
    bool shown = cone.flat.cols() == 0;
    for (Index j = 0; j < shallow.cols(); ++j) {
      const bool rises = rises_both_ways(base, shallow.col(j));
      // Several directions without curvature can be mixed to others, which nobody has tried.
      if (cone.flat.cols() == 1 && same_line(cone.flat.col(0), shallow.col(j))) shown = rises;
    }
    certificate().second_order = cone.decided && shown && !falls && !result_.better;
  }

  // Curvature up to which a direction has none.
  double no_curvature(double largest) {
    const double known = std::max(slope_, objective_size());
    const bool seen =
        known > kShallow * largest || session_.left() < 2 ||
        curvature_is_resolved(session_, *scaling_, result_.point, result_.multipliers, *hessian_);
    const double bound = static_cast<double>(hessian_->rows());  // of eigenvalues by entries
    return std::max(kNoise * known, (seen ? kZero : bound) * largest);
  }

  static bool same_line(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::abs(a.dot(b)) > 0.999 * a.norm() * b.norm();
  }

  // Whether the objective is seen to rise along a direction, both ways as far as the limits allow them.
  bool rises_both_ways(const ProbeBase& base, const Eigen::VectorXd& direction) {
    constexpr std::size_t kSteps = 15;
    bool rises = true;
    for (const double sign : {1.0, -1.0}) {
      if (result_.better || session_.left() < kSteps) return false;
      const Eigen::VectorXd d = sign * direction;
      if (limits_.weak.cols() > 0 && (limits_.weak.transpose() * d).minCoeff() < -1e-9) continue;
      const Probed probed = probe(session_, *scaling_, base, d);
      result_.better = probed.better;
      rises = rises && probed.rises;
    }
    return rises;
  }

  void name_flat_direction(const Eigen::VectorXd& direction) {
    Finding finding{Degeneracy::flat_direction,
                    "the objective does not change to second order when these vary together",
                    {}};
    for (Index k = 0; k < direction.size(); ++k)
      if (std::abs(direction[k]) > 0.05) finding.names.push_back(variable_name(k));
    if (!finding.names.empty()) certificate().findings.push_back(std::move(finding));
  }

  // (O3.4)
  double complementarity() const {
    const auto& m = result_.multipliers;
    const double size = std::max(objective_size(), steepest_);
    double largest = 0.0;
    for (std::size_t i = 0; i < m.limits.size(); ++i) {
      const Limit& l = result_.point.limits[m.limits[i]];
      largest = std::max(largest, std::abs(m.limit_values[i]) * std::max(l.slack, l.excess));
    }
    for (std::size_t i = 0; i < m.bounds.size(); ++i)
      largest = std::max(
          largest, m.bound_values[i] * result_.point.room[static_cast<std::size_t>(m.bounds[i])]);
    return largest > 0.0 ? largest / size : 0.0;
  }

  void conclude() {
    Certificate& c = certificate();
    c.infeasibility = result_.point.violation;
    c.complementarity = complementarity();
    if (result_.multipliers.weights.size() == static_cast<Index>(objectives_))
      c.weights.assign(result_.multipliers.weights.begin(), result_.multipliers.weights.end());
    else
      c.weights.assign(objectives_, objectives_ == 1 ? 1.0 : 0.0);
    for (std::size_t k = 0; k < objectives_; ++k)
      c.prices.push_back(c.weights[k] * scaling_->factor(k) / scaling_->factor(0));
    c.limits = report_limits(session_.problem(), *scaling_, result_.point, result_.multipliers);
    c.reason = reason();
    if (c.reason.empty())  // everything above trusts the Jacobian
      c.reason = contradiction(session_, *scaling_, result_.point,
                               [&](std::size_t response) { return limit_matters(response); });
    c.passed = c.reason.empty();
    c.second_order = c.second_order && c.passed;
  }

  std::string reason() const {
    const Certificate& c = result_.certificate;
    if (!feasible()) return "a constraint is violated";
    if (has(Degeneracy::undefined_gradient)) return "a derivative does not exist";
    if (!(c.stationarity <= options_.tolerance))
      return has(Degeneracy::dependent_constraints)
                 ? "no multipliers balance the slope; where limits are dependent, an optimum may "
                   "have none"
                 : "not stationary: by its derivatives the objective can still improve";
    if (!stationary()) return "not stationary: a step could still improve the objective";
    if (c.complementarity > 1e-2 * options_.tolerance)
      return "a limit with a nonzero multiplier is not active";
    if (has(Degeneracy::negative_curvature)) return "stationary, but not a minimum";
    if (result_.better) return "stationary, but a better design was found nearby";
    return "";
  }

  static constexpr double kNotMeasured = -1.0;

  Session& session_;
  const Scaling& search_;
  std::size_t objectives_;
  const SolveOptions& options_;
  std::optional<Scaling> scaling_;
  Certified result_;
  double slope_{0.0};     // of the objective over the variables that no bound holds
  double steepest_{0.0};  // over all
  double size_{0.0};      // denominator of the stationarity
  double gain_{kNotMeasured};
  bool balanced_{true};
  std::optional<Eigen::MatrixXd> hessian_;
  Strength limits_;
};

}  // namespace

std::optional<Certified> certify_in(Session& session, const Scaling& search,
                                    std::span<const double> design, bool second_order) {
  return Certifier(session, search).run(design, second_order);
}

Certificate certify(const Problem& problem, std::span<const double> design,
                    const SolveOptions& options) {
  validate(problem);
  if (!problem.derivatives)
    throw InputError("certify: it needs derivatives, which this problem does not give");
  if (design.size() != problem.variables.size())
    throw InputError("certify: the design has " + std::to_string(design.size()) + " values for " +
                     std::to_string(problem.variables.size()) + " variables");
  const Deadline deadline(options.budget.seconds);
  Session session(problem, options, deadline, options.first_stage, options.budget.evaluations);
  Scaling scaling(problem);
  Certificate failed;
  failed.reason = "the design cannot be evaluated";
  try {
    // The weights of several objectives refer to the start.
    if (problem.objectives.size() > 1)
      if (const auto first = first_design(session, scaling))
        scaling.scale_responses(first->design, first->evaluation);
    const auto certified = certify_in(session, scaling, design);
    return certified ? certified->certificate : failed;
  } catch (const Stop&) {
    failed.reason = kCutShort;
    return failed;
  }
}

}  // namespace twum::inline v0_1::optim
