// SPDX-License-Identifier: Apache-2.0
#include "certificate/kkt.hpp"

#include "certificate/nnls.hpp"
#include "problem/tolerance.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Distance within which a bound counts as active, relative to the variable's size. An interior point method stops about 1e-8 short of
// it.
constexpr double kBoundActivity = 1e-6;

void add_limits(KktPoint& point, const Session& session, const Scaling& scaling, std::size_t i) {
  const Problem& problem = session.problem();
  const std::size_t r = problem.objectives.size() + i;
  const Constraint& c = problem.constraints[i];
  const double value = point.evaluation.values[r];
  const double s = scaling.factor(r);
  const double terms = term_magnitude(problem, r, point.evaluation, point.design);
  const auto add = [&](Side side, double bound, double gap) {
    const double tolerance =
        s * limit_tolerance(c, bound, terms, session.options().feasibility_tolerance);
    const double inside = side == Side::equal ? -std::abs(gap) : -gap;
    point.limits.push_back(
        {i, side, std::max(inside, 0.0), std::max(-inside, 0.0), tolerance, gap});
    point.infeasibility = std::max(point.infeasibility, -inside);
  };
  if (c.lower == c.upper) return add(Side::equal, c.lower, s * (c.lower - value));
  if (std::isfinite(c.lower)) add(Side::lower, c.lower, s * (c.lower - value));
  if (std::isfinite(c.upper)) add(Side::upper, c.upper, s * (value - c.upper));
}

// A limit that is not active enters no condition, so that its derivative need not exist.
void flatten_inactive(KktPoint& point, std::size_t objectives) {
  std::vector<bool> inactive(static_cast<std::size_t>(point.jacobian.rows()) - objectives, true);
  for (const Limit& limit : point.limits)
    if (!(limit.slack > kActivity)) inactive[limit.constraint] = false;
  for (std::size_t i = 0; i < inactive.size(); ++i) {
    auto row = point.jacobian.row(static_cast<Index>(objectives + i));
    if (inactive[i] && !row.allFinite()) row.setZero();
  }
}

void place_in_range(KktPoint& point, const Problem& problem, const Scaling& scaling) {
  for (std::size_t k = 0; k < scaling.size(); ++k) {
    const double below = point.unit[k] - scaling.lower()[k];
    const double above = scaling.upper()[k] - point.unit[k];
    point.room.push_back(std::min(below, above));
    point.nearer.push_back(below < above ? Side::lower : Side::upper);
    const std::size_t j = scaling.variable(k);
    const Variable& v = problem.variables[j];
    const double unit = std::max(std::abs(point.design[j]), std::min(1.0, v.upper - v.lower));
    point.reach.push_back(unit / scaling.slope(k, point.design));
  }
}

// Gradient that points into the feasible side; for an equality towards larger values.
Eigen::VectorXd inward(const KktPoint& point, const Limit& limit, std::size_t objectives) {
  const Index row = static_cast<Index>(objectives + limit.constraint);
  const double sign = limit.side == Side::upper ? -1.0 : 1.0;
  return sign * point.jacobian.row(row).transpose();
}

void choose_active(const KktPoint& point, double activity, Multipliers& m) {
  for (std::size_t i = 0; i < point.limits.size(); ++i)
    if (point.limits[i].slack <= std::max(activity, point.limits[i].tolerance))
      m.limits.push_back(i);
  for (Index k = 0; k < point.variables(); ++k)
    if (point.room[static_cast<std::size_t>(k)] <= std::max(1e-3 * activity, kBoundActivity))
      m.bounds.push_back(k);
}

// Of the columns that are not zero; 1 if all are.
double smallest_norm(const Eigen::MatrixXd& columns) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double norm : columns.colwise().norm())
    if (norm > 0.0) smallest = std::min(smallest, norm);
  return std::isfinite(smallest) ? smallest : 1.0;
}

}  // namespace

Scaling scaling_at(const Problem& problem, const Scaling& search, const std::vector<double>& sizes,
                   std::span<const double> design, const Evaluation& evaluation) {
  Scaling here(problem, sizes);
  here.scale_responses(design, evaluation);
  for (std::size_t k = 0; problem.objectives.size() > 1 && k < problem.objectives.size(); ++k)
    here.set_factor(k, search.factor(k));
  return here;
}

std::optional<KktPoint> kkt_point(Session& session, const Scaling& scaling,
                                  std::span<const double> design) {
  KktPoint point;
  point.design.assign(design.begin(), design.end());
  point.unit = scaling.to_unit(design);
  point.evaluation = session.at(design, true);
  if (!point.evaluation.ok()) return std::nullopt;
  const Problem& problem = session.problem();
  const Index n = static_cast<Index>(scaling.size());
  point.jacobian.resize(static_cast<Index>(problem.responses()), n);
  for (Index r = 0; r < point.jacobian.rows(); ++r) {
    const auto response = static_cast<std::size_t>(r);
    const bool flip = response < problem.objectives.size() &&
                      problem.objectives[response].sense == Sense::maximize;
    for (Index k = 0; k < n; ++k) {
      const double d =
          scaling.derivative(point.evaluation, response, static_cast<std::size_t>(k), point.design);
      point.jacobian(r, k) = flip ? -d : d;
    }
  }
  place_in_range(point, problem, scaling);
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
    add_limits(point, session, scaling, i);
  flatten_inactive(point, problem.objectives.size());
  point.violation = relative_violation(problem, point.evaluation, point.design,
                                       session.options().feasibility_tolerance);
  return point;
}

Eigen::MatrixXd objective_gradients(const KktPoint& point, std::size_t objectives) {
  return point.jacobian.topRows(static_cast<Index>(objectives)).transpose();
}

Eigen::MatrixXd active_columns(const KktPoint& point, std::size_t objectives,
                               const Multipliers& m) {
  const Index count = static_cast<Index>(m.limits.size() + m.bounds.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(point.variables(), count);
  Index at = 0;
  for (const std::size_t i : m.limits)
    columns.col(at++) = inward(point, point.limits[i], objectives);
  for (const Index k : m.bounds)
    columns(k, at++) = point.nearer[static_cast<std::size_t>(k)] == Side::lower ? 1.0 : -1.0;
  return columns;
}

Multipliers find_multipliers(const KktPoint& point, const Eigen::MatrixXd& gradients,
                             std::size_t objectives, double activity) {
  Multipliers m;
  choose_active(point, activity, m);
  m.active = active_columns(point, objectives, m);
  const Index mixed = gradients.cols() > 1 ? gradients.cols() : 0;
  const Index n = point.variables();
  const Index rows = n + (mixed > 0 ? 1 : 0);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, mixed + m.active.cols());
  Eigen::VectorXd b = Eigen::VectorXd::Zero(rows);
  a.topRightCorner(n, m.active.cols()) = m.active;
  if (mixed > 0)
    a.topLeftCorner(n, mixed) = -gradients;
  else
    b.head(n) = gradients.col(0);
  if (mixed > 0) {
    // Not all weights zero: their sum is 1, as one more equation. The least |r| / sum does not depend on how much
    // the equation counts. It is at most the smallest gradient, and with that much the sum stays above one half.
    b[n] = smallest_norm(gradients);
    a.row(n).head(mixed).setConstant(b[n]);
  }
  // Scales columns to unit length, because their sizes may differ by many orders of magnitude.
  Eigen::VectorXd size = a.colwise().norm();
  for (Index j = 0; j < a.cols(); ++j) {
    if (!(size[j] > 0.0)) size[j] = 1.0;
    a.col(j) /= size[j];
  }
  std::vector<bool> free(static_cast<std::size_t>(a.cols()), false);
  for (std::size_t i = 0; i < m.limits.size(); ++i)
    free[static_cast<std::size_t>(mixed) + i] = point.limits[m.limits[i]].side == Side::equal;
  Eigen::VectorXd x = nonnegative_least_squares(a, b, free);
  if (x.size() == 0) x = Eigen::VectorXd::Zero(a.cols());
  x = x.cwiseQuotient(size).eval();
  m.weights = Eigen::VectorXd::Ones(1);
  if (mixed > 0) {
    const double sum = x.head(mixed).sum();
    x /= sum > 0.0 ? sum : 1.0;
    m.weights = x.head(mixed);
  }
  const Eigen::VectorXd lambda = x.tail(m.active.cols());
  m.residual = gradients * m.weights - m.active * lambda;
  for (std::size_t i = 0; i < m.limits.size(); ++i)
    m.limit_values.push_back(lambda[static_cast<Index>(i)]);
  for (std::size_t i = 0; i < m.bounds.size(); ++i)
    m.bound_values.push_back(lambda[static_cast<Index>(m.limits.size() + i)]);
  m.worth = lambda;
  return m;
}

std::vector<Index> dependent_columns(const Eigen::MatrixXd& active) {
  if (active.cols() < 2) return {};
  const Eigen::MatrixXd unit = active.colwise().normalized();
  Eigen::FullPivLU<Eigen::MatrixXd> lu(unit);
  lu.setThreshold(1e-8);
  std::vector<Index> dependent;
  if (lu.dimensionOfKernel() == 0) return dependent;
  const Eigen::VectorXd parts = lu.kernel().colwise().normalized().rowwise().norm();
  for (Index j = 0; j < parts.size(); ++j)
    if (parts[j] > 1e-6) dependent.push_back(j);
  return dependent;
}

// Among the multipliers that balance the slope, those with the least one of a limit: what the limit alone holds up (the value
// function falls by the least of them). A small weight on it chooses which of them are not zero; those balance the slope exactly.
void set_least_worth(const KktPoint& point, const std::vector<Index>& dependent, Multipliers& m) {
  constexpr double kWeight = 1e-4, kNothing = 1e-6;
  const Index n = m.active.rows(), count = m.active.cols();
  const Eigen::VectorXd values = m.worth, size = m.active.colwise().norm();
  const auto limits = static_cast<Index>(m.limits.size());
  std::vector<bool> free(static_cast<std::size_t>(count), false);
  for (std::size_t i = 0; i < m.limits.size(); ++i)
    free[i] = point.limits[m.limits[i]].side == Side::equal;
  for (const Index j : dependent) {
    if (j < limits && free[static_cast<std::size_t>(j)]) continue;  // nothing loosens an equality
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, count);
    a.topRows(n) = m.active.colwise().normalized();
    a(n, j) = kWeight;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
    b.head(n) = m.active * values;
    const Eigen::VectorXd x = nonnegative_least_squares(a, b, free);
    if (x.size() == 0) continue;
    std::vector<Index> held;
    for (Index k = 0; k < count; ++k)
      if (std::abs(x[k]) > kNothing * b.norm()) held.push_back(k);
    m.worth[j] = 0.0;
    if (std::find(held.begin(), held.end(), j) == held.end()) continue;
    const Eigen::MatrixXd columns = a.topRows(n)(Eigen::all, held);
    const Eigen::VectorXd exact = columns.colPivHouseholderQr().solve(b.head(n));
    m.worth[j] = exact[std::find(held.begin(), held.end(), j) - held.begin()] / size[j];
  }
}

double slope_beside_bounds(const Eigen::MatrixXd& gradients, const Multipliers& m) {
  Eigen::VectorXd sizes = gradients.cwiseAbs().rowwise().maxCoeff();
  for (std::size_t i = 0; i < m.bounds.size(); ++i)
    if (m.bound_values[i] > 0.0) sizes[m.bounds[i]] = 0.0;
  return sizes.maxCoeff();
}

bool each_slope_is_balanced(const Eigen::MatrixXd& gradients, const Multipliers& m, double part,
                            double rounding) {
  Eigen::VectorXd terms = gradients.cwiseAbs().rowwise().maxCoeff();
  for (std::size_t i = 0; i < m.limits.size(); ++i)
    terms = terms.cwiseMax(std::abs(m.limit_values[i]) *
                           m.active.col(static_cast<Index>(i)).cwiseAbs());
  return (m.residual.cwiseAbs().array() <= part * terms.array() + rounding).all();
}

}  // namespace twum::inline v0_1::optim
