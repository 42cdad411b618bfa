// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/optimum_moves.hpp>

#include "certificate/curvature.hpp"

#include <twum/base/error.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Why there are no derivatives.
struct NoMoves {
  std::string reason;
};

// The optimum moves if such a limit is tightened, but not if it is loosened: there are two derivatives.
std::string without_force(const std::string& met) {
  return met + " but does not restrict the optimum (multiplier 0)";
}

// Step of the differences, relative to a range or a held value. Truncation (the square of the step) and rounding over
// the step are both about 1e-8.
constexpr double kDifference = 1e-4;
constexpr double kLeastStep = 1e-7;
// A multiplier below this share of the objective's slope or curvature over the box may be 0.
constexpr double kStrict = 1e-5;
// Curvatures below this share of the largest count as 0.
constexpr double kNoCurvature = 1e-6;

// First derivatives with respect to coordinates scaled by their range or held value.
struct Slopes {
  Eigen::VectorXd objective;  // gradient of the minimized objective
  Eigen::MatrixXd active;     // a row for each active limit
};

class Sensitivity {
 public:
  Sensitivity(const Problem& problem, std::span<const double> at, std::size_t held,
              const Certificate& certificate)
      : problem_(problem),
        at_(at.begin(), at.end()),
        variables_(static_cast<Index>(at.size() - held)),
        count_(static_cast<Index>(at.size())),
        sign_(problem.objectives.front().sense == Sense::maximize ? -1.0 : 1.0) {
    if (!certificate.passed) throw NoMoves{"the design is not a certified optimum"};
    refuse(certificate.findings);
    choose(certificate.limits);
    size_.resize(count_);
    for (Index k = 0; k < count_; ++k) size_[k] = size_of(k);
  }

  OptimumMoves find() {
    here_ = slopes(at_);
    find_multipliers();
    const Eigen::MatrixXd second = second_derivatives();
    const Index n = static_cast<Index>(free_.size());
    const Eigen::MatrixXd hessian = 0.5 * (second(free_, free_) + second(free_, free_).transpose());
    require_multipliers(second.cwiseAbs().maxCoeff());
    require_minimum(hessian);

    const Index m = here_.active.rows();
    const Index held = count_ - variables_;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::MatrixXd right(n + m, held);
    if (n + m == 0) return in_user_units(right);  // bounds hold all
    const Eigen::MatrixXd a = here_.active(Eigen::all, free_);
    system.topLeftCorner(n, n) = hessian;
    system.topRightCorner(n, m) = -a.transpose();
    system.bottomLeftCorner(m, n) = a;
    right.topRows(n) = -second(free_, Eigen::seqN(variables_, held));
    right.bottomRows(m) = -here_.active.rightCols(held);
    const Eigen::MatrixXd moves = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(system).solve(right);
    return in_user_units(moves.topRows(n));
  }

 private:
  static std::size_t index(Index k) { return static_cast<std::size_t>(k); }
  const std::string& name(Index k) const { return problem_.variables[index(k)].name; }

  static void refuse(const std::vector<Finding>& findings) {
    for (const Finding& one : findings) {
      std::string names;
      for (const std::string& each : one.names) names += (names.empty() ? "" : ", ") + each;
      if (one.kind != Degeneracy::flat_objective)
        throw NoMoves{one.text + (names.empty() ? "" : " (" + names + ")")};
    }
  }

  // Selects the active limits, and the variables that are free.
  void choose(const std::vector<Activity>& limits) {
    std::vector<bool> held(index(variables_), false);
    for (Index k = 0; k < variables_; ++k) {
      const Variable& v = problem_.variables[index(k)];
      held[index(k)] = v.integer || v.lower == v.upper;
      if (!held[index(k)]) moving_.push_back(k);
    }
    for (const Activity& one : limits) {
      if (!one.active) continue;
      if (one.is_bound)
        for (const Index k : moving_) held[index(k)] = held[index(k)] || name(k) == one.name;
      for (std::size_t i = 0; !one.is_bound && i < problem_.constraints.size(); ++i)
        if (problem_.constraints[i].name == one.name) rows_.push_back(i);
    }
    for (const Index k : moving_) (held[index(k)] ? bound_ : free_).push_back(k);
  }

  double size_of(Index k) const {
    const Variable& v = problem_.variables[index(k)];
    const double value = at_[index(k)];
    if (k >= variables_) return std::abs(value);
    if (v.lower == v.upper) return 1.0;
    return v.scale == Scale::log ? value * std::log(v.upper / v.lower) : v.upper - v.lower;
  }

  Slopes slopes(const std::vector<double>& at) const {
    Evaluation found;
    try {
      found = problem_.evaluate(at, true);
    } catch (const EvaluationError& error) {
      found.failure = error.reason();
    }
    if (!found.ok()) throw NoMoves{"a neighbouring design cannot be evaluated: " + found.failure};
    for (const KinkedEntry& kink : found.kinks)
      if (counts(kink.response))
        throw NoMoves{"the objective or an active limit has a kink at the optimum"};
    const auto row = [&](std::size_t response) {
      return Eigen::Map<const Eigen::VectorXd>(found.jacobian.data() + response * at.size(), count_)
          .cwiseProduct(size_)
          .eval();
    };
    Slopes result{sign_ * row(0), Eigen::MatrixXd(static_cast<Index>(rows_.size()), count_)};
    for (std::size_t i = 0; i < rows_.size(); ++i)
      result.active.row(static_cast<Index>(i)) = row(1 + rows_[i]).transpose();
    if (!result.objective.allFinite() || !result.active.allFinite())
      throw NoMoves{"the objective or an active limit has no derivative at the optimum"};
    return result;
  }

  bool counts(std::size_t response) const {
    return response == 0 || std::find(rows_.begin(), rows_.end(), response - 1) != rows_.end();
  }

  // grad f = sum lambda grad c over the free variables.
  void find_multipliers() {
    const Eigen::MatrixXd a = here_.active(Eigen::all, free_).transpose();
    multipliers_ = Eigen::VectorXd::Zero(a.cols());
    if (a.cols() == 0) return;
    Eigen::VectorXd norms = a.colwise().norm();
    for (double& norm : norms) norm = norm > 0.0 ? norm : 1.0;
    const Eigen::VectorXd inverse = norms.cwiseInverse();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a * inverse.asDiagonal());
    qr.setThreshold(1e-8);
    if (qr.rank() < a.cols())
      throw NoMoves{"the gradients of the active limits are linearly dependent"};
    multipliers_ = qr.solve(here_.objective(free_).matrix()).cwiseProduct(inverse);
  }

  Eigen::VectorXd lagrangian(const Slopes& slopes) const {
    return slopes.objective - slopes.active.transpose() * multipliers_;
  }

  // Second derivatives of the Lagrangian with respect to the free coordinates; other columns are 0.
  Eigen::MatrixXd second_derivatives() const {
    Eigen::MatrixXd second = Eigen::MatrixXd::Zero(count_, count_);
    const auto column = [&](Index k) {
      const double h = step(k);
      std::vector<double> low = at_;
      std::vector<double> high = at_;
      low[index(k)] -= h;
      high[index(k)] += h;
      const double parts = (high[index(k)] - low[index(k)]) / size_[k];
      second.col(k) = (lagrangian(slopes(high)) - lagrangian(slopes(low))) / parts;
    };
    for (const Index k : free_) column(k);
    for (Index k = variables_; k < count_; ++k) column(k);
    return second;
  }

  // No variable leaves its range.
  double step(Index k) const {
    const Variable& v = problem_.variables[index(k)];
    const double value = at_[index(k)];
    if (k >= variables_) return kDifference * size_[k];
    const double h = std::min({kDifference * size_[k], value - v.lower, v.upper - value});
    if (h < kLeastStep * size_[k])
      throw NoMoves{without_force(v.name + " is at an end of its range")};
    return h;
  }

  // Every active limit and bound has to have a positive multiplier.
  void require_multipliers(double curvature) const {
    double size = curvature;
    for (const Index k : moving_) size = std::max(size, std::abs(here_.objective[k]));
    const Eigen::VectorXd pull = lagrangian(here_);
    for (const Index k : bound_)
      if (std::abs(pull[k]) <= kStrict * size)
        throw NoMoves{without_force(name(k) + " is at an end of its range")};
    for (Index i = 0; i < multipliers_.size(); ++i) {
      const std::size_t row = rows_[index(i)];
      const double weight = std::abs(multipliers_[i]) * here_.active.row(i)(free_).norm();
      const Constraint& limit = problem_.constraints[row];
      if (limit.lower != limit.upper && weight <= kStrict * size)
        throw NoMoves{without_force("the limit " + limit.name + " is met exactly")};
    }
  }

  // The Lagrangian has to have positive curvature along the active limits.
  void require_minimum(const Eigen::MatrixXd& hessian) const {
    const Eigen::MatrixXd z = null_space(here_.active(Eigen::all, free_).transpose());
    if (z.cols() == 0) return;
    const Eigen::MatrixXd reduced = z.transpose() * hessian * z;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(reduced);
    if (eigen.eigenvalues()[0] <= kNoCurvature * hessian.cwiseAbs().maxCoeff())
      throw NoMoves{"the objective is flat in some direction of the variables, to second order"};
  }

  // Also the derivatives of the optimal objective by the held numbers, which are those of the Lagrangian.
  OptimumMoves in_user_units(const Eigen::MatrixXd& moves) const {
    const Index held = count_ - variables_;
    OptimumMoves result;
    result.design.assign(index(variables_ * held), 0.0);
    const Eigen::VectorXd slope = lagrangian(here_);
    for (Index k = 0; k < held; ++k) {
      const double size = size_[variables_ + k];
      result.objective.push_back(sign_ * slope[variables_ + k] / size);
      for (std::size_t i = 0; i < free_.size(); ++i)
        result.design[index(free_[i] * held + k)] =
            moves(static_cast<Index>(i), k) * size_[free_[i]] / size;
    }
    return result;
  }

  const Problem& problem_;
  std::vector<double> at_;
  Index variables_;
  Index count_;  // variables and held numbers
  double sign_;
  Eigen::VectorXd size_;
  std::vector<std::size_t> rows_;             // active constraints
  std::vector<Index> moving_, free_, bound_;  // variables
  Slopes here_;
  Eigen::VectorXd multipliers_;
};

}  // namespace

OptimumMoves optimum_moves(const Problem& problem, std::span<const double> at, std::size_t held,
                           const Certificate& certificate) {
  try {
    return Sensitivity(problem, at, held, certificate).find();
  } catch (NoMoves& none) {
    return {{}, {}, std::move(none.reason)};
  }
}

}  // namespace twum::inline v0_1::optim
