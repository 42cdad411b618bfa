// SPDX-License-Identifier: Apache-2.0
#include "certify.hpp"

#include "first_design.hpp"
#include "limits_report.hpp"

#include <twum/base/error.hpp>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace twum::optim {
namespace {

using Eigen::Index;

// Scaled slack within which a limit counts as active. Multiplier times slack is then checked as complementarity.
constexpr double kActivity = 1e-6;
// relative curvature well above the error of central differences
constexpr double kNegative = 1e-5;

class Certifier {
 public:
  Certifier(Session& session, const Scaling& scaling)
      : session_(session),
        scaling_(scaling),
        objectives_(session.problem().objectives.size()),
        options_(session.options()) {}

  std::optional<Certified> run(std::span<const double> design, bool second_order) {
    auto point = kkt_point(session_, scaling_, design);
    if (!point) return std::nullopt;
    result_.point = std::move(*point);
    if (derivatives_exist()) {
      worst_first_order(candidate_gradients());
      if (stalled() && room()) look_for_kinks();
      name_dependent_limits();
      name_flat_objective();
      // With several objectives no test: on a concave front, the weighted sum has negative curvature along the front.
      second_order = second_order && objectives_ == 1 && scaling_.size() > 0;
      if (second_order && stationary() && room() && !has(Degeneracy::kink)) second_order_test();
    }
    conclude();
    return std::move(result_);
  }

 private:
  Certificate& certificate() { return result_.certificate; }
  bool room() const { return session_.left() >= 2 * scaling_.size(); }
  bool stationary() const { return result_.certificate.stationarity <= options_.tolerance; }
  bool feasible() const { return result_.point.infeasibility <= options_.feasibility_tolerance; }
  bool stalled() const { return !stationary() && feasible() && objectives_ == 1; }
  bool has(Degeneracy kind) const {
    const auto& f = result_.certificate.findings;
    return std::any_of(f.begin(), f.end(), [&](const Finding& x) { return x.kind == kind; });
  }
  const std::string& variable_name(Index k) const {
    return session_.problem().variables[scaling_.variable(static_cast<std::size_t>(k))].name;
  }

  bool limit_matters(std::size_t response) const {
    if (response < objectives_) return true;
    return std::any_of(result_.point.limits.begin(), result_.point.limits.end(),
                       [&](const Limit& l) {
                         return l.constraint + objectives_ == response && l.slack <= kActivity;
                       });
  }

  bool derivatives_exist() {
    if (!undefined_entry()) return true;
    certificate().stationarity = std::numeric_limits<double>::infinity();
    certificate().findings.push_back({Degeneracy::undefined_gradient,
                                      "a derivative that the test needs does not exist here",
                                      {}});
    return false;
  }

  bool undefined_entry() const {
    const auto& kinks = result_.point.evaluation.kinks;
    return std::any_of(kinks.begin(), kinks.end(), [&](const KinkedEntry& k) {
      return k.slope == Slope::undefined && limit_matters(k.response) && varies(k.variable);
    });
  }

  bool varies(std::size_t variable) const {
    for (std::size_t k = 0; k < scaling_.size(); ++k)
      if (scaling_.variable(k) == variable) return true;
    return false;
  }

  // Candidate gradients of the objective at the reported kinks. For each matrix, some convex combination of its
  // columns has to be stationary.
  std::vector<Eigen::MatrixXd> candidate_gradients() {
    const Eigen::MatrixXd g = objective_gradients(result_.point, objectives_);
    std::vector<KinkedEntry> kinks;
    std::set<std::size_t> kinked;
    for (const KinkedEntry& kink : result_.point.evaluation.kinks) {
      const bool counts = kink.slope == Slope::one_sided && kink.response == 0 && objectives_ == 1;
      if (!counts || !varies(kink.variable)) continue;
      kinks.push_back(kink);
      kinked.insert(kink.variable);
    }
    std::vector<Eigen::MatrixXd> all;
    for (const KinkedEntry& kink : kinks) add_candidates(kink, kinked.size() == 1, g, all);
    if (all.empty()) all.push_back(g);
    return all;
  }

  // At a convex kink, any slope between the two sides is a candidate. At a concave kink, both sides have to be
  // stationary. The same holds for kinks in several variables, because the entries do not say which sides belong
  // together. On a bound there is only one side.
  void add_candidates(const KinkedEntry& kink, bool mixes, const Eigen::MatrixXd& g,
                      std::vector<Eigen::MatrixXd>& all) {
    std::size_t at = 0;
    while (scaling_.variable(at) != kink.variable) ++at;
    name_kink(variable_name(static_cast<Index>(at)));
    const bool maximize = session_.problem().objectives[0].sense == Sense::maximize;
    const double scale =
        (maximize ? -1.0 : 1.0) * scaling_.factor(0) * scaling_.slope(at, result_.point.design);
    Eigen::MatrixXd left = g, right = g;
    left(static_cast<Index>(at), 0) = scale * kink.left;
    right(static_cast<Index>(at), 0) = scale * kink.right;
    const double u = result_.point.unit[at];
    if (mixes && kink.left * scale <= kink.right * scale && u > 0.0 && u < 1.0) {
      left.conservativeResize(Eigen::NoChange, 2);
      left.col(1) = right.col(0);
      all.push_back(left);
      return;
    }
    if (u > 0.0) all.push_back(left);
    if (u < 1.0) all.push_back(right);
  }

  // Reports each variable only once.
  void name_kink(const std::string& variable) {
    const auto named = [&](const Finding& x) {
      return x.kind == Degeneracy::kink && x.names.front() == variable;
    };
    auto& findings = certificate().findings;
    if (std::any_of(findings.begin(), findings.end(), named)) return;
    findings.push_back(
        {Degeneracy::kink, "one-sided derivatives of the objective differ", {variable}});
  }

  void worst_first_order(const std::vector<Eigen::MatrixXd>& candidate_gradients) {
    const Eigen::MatrixXd* worst = nullptr;
    double largest = -1.0, complementarity = 0.0;
    for (const Eigen::MatrixXd& each : candidate_gradients) {
      first_order(each);
      complementarity = std::max(complementarity, certificate().complementarity);
      if (certificate().stationarity <= largest) continue;
      largest = certificate().stationarity;
      worst = &each;
    }
    if (candidate_gradients.size() > 1 && worst != nullptr) first_order(*worst);
    certificate().complementarity = complementarity;
  }

  void first_order(const Eigen::MatrixXd& gradients) {
    if (gradients.size() == 0) {  // every variable is fixed: the only design is stationary
      result_.multipliers.weights =
          Eigen::VectorXd::Constant(gradients.cols(), 1.0 / static_cast<double>(gradients.cols()));
      return;
    }
    result_.multipliers = find_multipliers(result_.point, gradients, objectives_, kActivity);
    // Each gradient is weighted, so that a large gradient with weight 0 does not hide an error in the others.
    const double size = gradient_size(gradients * result_.multipliers.weights.asDiagonal());
    certificate().stationarity = result_.multipliers.residual.cwiseAbs().maxCoeff() / size;
    certificate().complementarity = 0.0;
    for (std::size_t i = 0; i < result_.multipliers.limits.size(); ++i)
      certificate().complementarity =
          std::max(certificate().complementarity,
                   std::abs(result_.multipliers.limit_values[i]) / size *
                       result_.point.limits[result_.multipliers.limits[i]].slack);
  }

  // Size of the gradient here, or at the start (1, by the scaling), over the variables that are not held by a bound,
  // because a steep slope into a bound says nothing about the others.
  double gradient_size(const Eigen::MatrixXd& gradients) const {
    const auto& bounds = result_.multipliers.bounds;
    double size = 1.0;
    for (Index k = 0; k < gradients.rows(); ++k)
      if (std::find(bounds.begin(), bounds.end(), k) == bounds.end())
        size = std::max(size, gradients.row(k).cwiseAbs().maxCoeff());
    return size;
  }

  // A point that is not stationary may lie on a kink. Then gradients on its two sides differ at any distance, and
  // some convex combination of them is stationary.
  void look_for_kinks() {
    constexpr double kNear = 1e-7;
    Eigen::MatrixXd mixed = objective_gradients(result_.point, 1);
    std::vector<std::string> names;
    const double here = objective(result_.point);
    for (Index k = 0; k < result_.point.variables(); ++k) {
      const auto right = neighbour(k, kNear);
      const auto left = neighbour(k, -kNear);
      if (!right || !left) return;
      const double noise = 1e-12 * (1.0 + std::abs(here));
      // a neighbour is better, so this is not an optimum
      for (const auto* side : {&*left, &*right})
        if (objective(*side) < here - noise && side->infeasibility <= result_.point.infeasibility)
          return;
      const double jump = (right->jacobian.row(0) - left->jacobian.row(0)).cwiseAbs().maxCoeff();
      if (jump <= 1e-3 * (1.0 + mixed.cwiseAbs().maxCoeff())) continue;
      names.push_back(variable_name(k));
      mixed.conservativeResize(Eigen::NoChange, mixed.cols() + 2);
      mixed.col(mixed.cols() - 2) = left->jacobian.row(0).transpose();
      mixed.col(mixed.cols() - 1) = right->jacobian.row(0).transpose();
    }
    if (names.empty()) return;
    for (const std::string& name : names) name_kink(name);
    first_order(mixed);
  }

  double objective(const KktPoint& p) const {
    const bool maximize = session_.problem().objectives[0].sense == Sense::maximize;
    return (maximize ? -1.0 : 1.0) * scaling_.factor(0) * p.evaluation.values[0];
  }

  std::optional<KktPoint> neighbour(Index k, double step) {
    std::vector<double> unit = result_.point.unit;
    double& u = unit[static_cast<std::size_t>(k)];
    u = std::clamp(u + step, 0.0, 1.0);
    return kkt_point(session_, scaling_, scaling_.to_design(unit));
  }

  void name_dependent_limits() {
    const auto& m = result_.multipliers;
    if (m.active.cols() < 2) return;
    Eigen::MatrixXd unit = m.active;
    for (Index j = 0; j < unit.cols(); ++j) unit.col(j).normalize();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(unit);
    qr.setThreshold(1e-8);
    if (qr.rank() == unit.cols()) return;
    std::vector<std::string> names;
    for (const std::size_t i : m.limits)
      names.push_back(session_.problem().constraints[result_.point.limits[i].constraint].name);
    for (const Index k : m.bounds) names.push_back(variable_name(k));
    certificate().findings.push_back(
        {Degeneracy::dependent_constraints,
         "the gradients of the active limits are dependent: their multipliers are not unique",
         names});
  }

  void name_flat_objective() {
    const Eigen::MatrixXd g = objective_gradients(result_.point, objectives_);
    std::vector<std::string> names;
    for (Index k = 0; k < g.rows(); ++k)
      if (g.row(k).cwiseAbs().maxCoeff() == 0.0) names.push_back(variable_name(k));
    if (static_cast<Index>(names.size()) == g.rows() && g.rows() > 0 && flat_at_start())
      certificate().findings.push_back(
          {Degeneracy::flat_objective, "the gradient of the objective is zero", names});
  }

  bool flat_at_start() const { return objectives_ == 1 && scaling_.flat_at_start(0); }

  void second_order_test() {
    const auto curvature =
        lagrangian_curvature(session_, scaling_, result_.point, result_.multipliers, objectives_);
    if (!curvature) return;
    const ReducedCurvature reduced = reduced_curvature(*curvature, result_.multipliers);
    certificate().curvature = reduced.smallest;
    if (reduced.smallest < -kNegative)
      certificate().findings.push_back({Degeneracy::negative_curvature,
                                        "stationary, but the objective falls to second order",
                                        {}});
    for (Index j = 0; j < reduced.flat.cols(); ++j) name_flat_direction(reduced.flat.col(j));
  }

  void name_flat_direction(const Eigen::VectorXd& direction) {
    Finding finding{Degeneracy::flat_direction,
                    "the objective does not change to second order when these vary together",
                    {}};
    for (Index k = 0; k < direction.size(); ++k)
      if (std::abs(direction[k]) > 0.05) finding.names.push_back(variable_name(k));
    if (!finding.names.empty()) certificate().findings.push_back(std::move(finding));
  }

  void conclude() {
    Certificate& c = certificate();
    c.infeasibility = result_.point.infeasibility;
    if (result_.multipliers.weights.size() == static_cast<Index>(objectives_))
      c.weights.assign(result_.multipliers.weights.begin(), result_.multipliers.weights.end());
    else
      c.weights.assign(objectives_, objectives_ == 1 ? 1.0 : 0.0);
    for (std::size_t k = 0; k < objectives_; ++k)
      c.prices.push_back(c.weights[k] * scaling_.factor(k) / scaling_.factor(0));
    c.limits = report_limits(session_.problem(), scaling_, result_.point, result_.multipliers);
    if (!feasible())
      c.reason = "a constraint is violated";
    else if (has(Degeneracy::undefined_gradient))
      c.reason = "a derivative does not exist";
    else if (!stationary())
      c.reason = "not stationary: the objective can still improve to first order";
    else if (c.complementarity > options_.tolerance)
      c.reason = "a limit with a nonzero multiplier is not active";
    else if (has(Degeneracy::negative_curvature))
      c.reason = "stationary, but not a minimum";
    c.passed = c.reason.empty();
  }

  Session& session_;
  const Scaling& scaling_;
  std::size_t objectives_;
  const SolveOptions& options_;
  Certified result_;
};

}  // namespace

const char* to_string(Degeneracy degeneracy) {
  switch (degeneracy) {
    case Degeneracy::flat_direction: return "flat-direction";
    case Degeneracy::flat_objective: return "flat-objective";
    case Degeneracy::dependent_constraints: return "dependent-constraints";
    case Degeneracy::kink: return "kink";
    case Degeneracy::negative_curvature: return "negative-curvature";
    case Degeneracy::undefined_gradient: return "undefined-gradient";
  }
  return "unknown";
}

std::optional<Certified> certify_in(Session& session, const Scaling& scaling,
                                    std::span<const double> design, bool second_order) {
  return Certifier(session, scaling).run(design, second_order);
}

Certificate certify(const Problem& problem, std::span<const double> design,
                    const SolveOptions& options) {
  validate(problem);
  if (design.size() != problem.variables.size())
    throw InputError("certify: the design has " + std::to_string(design.size()) + " values for " +
                     std::to_string(problem.variables.size()) + " variables");
  const Deadline deadline(options.budget.seconds);
  Session session(problem, options, deadline, options.first_stage, options.budget.evaluations);
  Scaling scaling(problem);
  Certificate failed;
  failed.reason = "the design cannot be evaluated";
  try {
    scale_at_first_design(session, scaling);
    const auto certified = certify_in(session, scaling, design);
    return certified ? certified->certificate : failed;
  } catch (const Stop&) {
    failed.reason = kCutShort;
    return failed;
  }
}

}  // namespace twum::optim
