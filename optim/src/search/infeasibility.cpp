// SPDX-License-Identifier: Apache-2.0
#include "search/infeasibility.hpp"

#include "certificate/polish.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace twum::inline v0_1::optim {
namespace {

// A formulation in which each finite side of each row with `soft` has a slack.
struct Elastic {
  Formulation formulation;
  std::vector<std::size_t> rows;  // of each slack
};

template <typename Soft>
Elastic elastic_formulation(const StageRunner& runner, Soft soft) {
  Elastic e;
  e.formulation = plain_formulation(runner.problem(), runner.scaling());
  e.formulation.objective.responses.clear();
  std::vector<LinearForm> rows;
  for (std::size_t i = 0; i < e.formulation.rows.size(); ++i) {
    LinearForm row = e.formulation.rows[i];
    if (!soft(i)) {
      rows.push_back(row);
      continue;
    }
    const auto slack = [&](double sign, double lower, double upper) {
      LinearForm side = row;
      side.lower = lower;
      side.upper = upper;
      side.extras = {{e.rows.size(), sign}};
      e.formulation.objective.extras.push_back({e.rows.size(), 1.0});
      e.rows.push_back(i);
      rows.push_back(side);
    };
    if (std::isfinite(row.lower)) slack(1.0, row.lower, kInfinity);
    if (std::isfinite(row.upper)) slack(-1.0, -kInfinity, row.upper);
  }
  e.formulation.rows = std::move(rows);
  return e;
}

// Scaled responses change by about 1 with the variables, so slacks begin at 1; their bound leaves room for starts far
// outside.
std::vector<double> add_slacks(Elastic& e, std::span<const double> unit) {
  std::vector<double> z(unit.begin(), unit.end());
  z.resize(unit.size() + e.rows.size(), 1.0);
  e.formulation.extra_lower.assign(e.rows.size(), 0.0);
  e.formulation.extra_upper.assign(e.rows.size(), 1e12);
  return z;
}

}  // namespace

std::optional<Candidate> elastic_search(StageRunner& runner,
                                        const std::vector<std::vector<double>>& starts) {
  const Optimizer& slsqp = find_optimizer("nlopt:slsqp");
  std::optional<Candidate> best;
  for (const auto& start : starts) {
    if (runner.exhausted()) break;
    Elastic e = elastic_formulation(runner, [](std::size_t) { return true; });
    const std::vector<double> z = add_slacks(e, start);
    const SolverRun run = runner.run(slsqp, e.formulation, z);
    if (!run.best) continue;
    Candidate c = *run.best;
    c.z.resize(runner.scaling().size());
    if (!best || better(c, *best, runner.options().feasibility_tolerance)) best = std::move(c);
  }
  return best;
}

namespace {

// The smallest relaxation of one constraint while all others hold.
struct Alone {
  double amount{std::nan("")};
  std::vector<double> design;  // user units; empty: none was found
};

bool keeps_the_others(const StageRunner& runner, const Candidate& c) {
  return c.violation <= 100.0 * runner.options().feasibility_tolerance;
}

Alone relaxation_alone(StageRunner& runner, std::size_t row, std::span<const double> unit) {
  if (runner.exhausted() || runner.scaling().size() == 0) return {};
  Elastic e = elastic_formulation(runner, [&](std::size_t i) { return i == row; });
  const std::vector<double> z = add_slacks(e, unit);
  const SolverRun run = runner.run(find_optimizer("nlopt:slsqp"), e.formulation, z);
  if (!run.best || !keeps_the_others(runner, *run.best)) return {};
  const std::size_t r = runner.problem().objectives.size() + row;
  return {run.best->f / runner.scaling().factor(r), run.design};
}

// Constraints and range ends that are active at a point with the smallest sum of violations.
struct Fight {
  std::set<std::size_t> constraints;
  std::vector<RangeEnd> ranges;
  bool stationary{false};
};

RangeEnd range_end(const Problem& problem, const Scaling& scaling, const KktPoint& point,
                   std::size_t k) {
  const Variable& v = problem.variables[scaling.variable(k)];
  return point.nearer[k] == Side::lower ? RangeEnd{v.name, Side::lower, v.lower}
                                        : RangeEnd{v.name, Side::upper, v.upper};
}

// Stationarity of the sum of violations: violated limits have weight one, limits and range ends that are just met
// have multipliers.
Fight fighting(const Problem& problem, const Scaling& scaling, const KktPoint& point) {
  constexpr double kNoForce = 1e-6;
  const std::size_t objectives = problem.objectives.size();
  KktPoint met = point;
  met.limits.clear();
  Fight fight;
  Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(point.variables(), 1);
  for (const Limit& l : point.limits) {
    if (l.excess <= l.tolerance) {
      met.limits.push_back(l);
      continue;
    }
    fight.constraints.insert(l.constraint);
    const std::size_t response = objectives + l.constraint;
    const bool from_above =
        point.evaluation.values[response] > problem.constraints[l.constraint].upper;
    pull -= (from_above ? -1.0 : 1.0) *
            point.jacobian.row(static_cast<Eigen::Index>(response)).transpose();
  }
  const Multipliers m = find_multipliers(met, pull, objectives, 1e-6);
  for (std::size_t i = 0; i < m.limits.size(); ++i)
    if (std::abs(m.limit_values[i]) > kNoForce)
      fight.constraints.insert(met.limits[m.limits[i]].constraint);
  for (std::size_t i = 0; i < m.bounds.size(); ++i)
    if (m.bound_values[i] > kNoForce)
      fight.ranges.push_back(
          range_end(problem, scaling, point, static_cast<std::size_t>(m.bounds[i])));
  const double tiny = 1e-5 * (1.0 + (pull.size() == 0 ? 0.0 : pull.cwiseAbs().maxCoeff()));
  // A violated limit enters the sum with weight one, which bounds its multiplier.
  const bool held = std::all_of(m.limit_values.begin(), m.limit_values.end(),
                                [&](double force) { return std::abs(force) <= 1.0 + tiny; });
  fight.stationary = held && (m.residual.size() == 0 || m.residual.cwiseAbs().maxCoeff() <= tiny);
  return fight;
}

}  // namespace

Explanation explain_infeasible(StageRunner& runner, std::span<const double> unit) {
  Explanation told;
  Infeasibility& report = told.report;
  const Problem& problem = runner.problem();
  report.design = runner.scaling().to_design(unit);
  SolverRun look;
  look.session = std::make_unique<Session>(problem, runner.options(), runner.deadline(),
                                           runner.take_stage(), runner.left());
  const auto point_at = [&](const std::vector<double>& design) -> std::optional<KktPoint> {
    std::optional<KktPoint> point;
    try {
      runner.allow(look, 1);
      point = kkt_point(*look.session, runner.scaling(), design);
    } catch (const Stop&) {
    }
    runner.book(look);
    return point;
  };
  const double tolerance = runner.options().feasibility_tolerance;
  const auto point = point_at(report.design);
  if (!point || point->violation <= tolerance) return told;
  Fight fight = fighting(problem, runner.scaling(), *point);
  const auto& names = fight.constraints;
  report.certified = fight.stationary;
  report.ranges = std::move(fight.ranges);
  for (const std::size_t i : names) report.conflict.push_back(problem.constraints[i].name);
  for (const Limit& l : point->limits) {
    if (!names.contains(l.constraint) || (l.excess <= l.tolerance && l.slack > 1e-6)) continue;
    const Constraint& c = problem.constraints[l.constraint];
    const std::size_t r = problem.objectives.size() + l.constraint;
    const double amount = l.excess <= l.tolerance ? 0.0 : l.excess / runner.scaling().factor(r);
    Alone alone = relaxation_alone(runner, l.constraint, unit);
    if (runner.scaling().size() == 0 && names.size() == 1) alone.amount = amount;
    report.relaxations.push_back(
        {c.name, l.side, l.side == Side::upper ? c.upper : c.lower, amount, alone.amount});
    if (alone.design.empty() || !told.feasible.empty()) continue;
    const auto there = point_at(alone.design);
    if (there && there->violation <= tolerance) told.feasible = std::move(alone.design);
  }
  return told;
}

}  // namespace twum::inline v0_1::optim
