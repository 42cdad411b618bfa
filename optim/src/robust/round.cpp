// SPDX-License-Identifier: Apache-2.0
#include "robust/round.hpp"

#include <algorithm>
#include <cmath>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kLeastBeta = -3.0;  // negative, because some limits fail for most products
constexpr double kMostBeta = 6.0;    // a risk of 1e-9
// Smallest share of the risk for each limit. The index of an unimportant limit is badly determined and costs steps,
// so it keeps this small share.
constexpr double kSmallShare = 1e-3;

std::string side_name(const RobustProblem& problem, const Margin& margin) {
  const RandomLimit& limit = problem.limits[margin.response];
  const bool both = limit.lower > -kInfinity && limit.upper < kInfinity;
  if (!both) return limit.name;
  return limit.name + (margin.sign > 0.0 ? " (lower end)" : " (upper end)");
}

bool is_limited(const StatisticTarget& target) {
  return target.lower > -kInfinity || target.upper < kInfinity;
}

// The square of a row: a standard deviation of zero has no derivative, its square has one.
LineOf squared(LineOf row) {
  for (double& slope : row.slope) slope *= 2.0 * row.value;
  row.value *= row.value;
  return row;
}

LineOf subtracted(double end, LineOf row) {
  for (double& slope : row.slope) slope = -slope;
  row.value = end - row.value;
  return row;
}

// The rows of a round.
class RoundRows {
 public:
  explicit RoundRows(bool gradient) : gradient_(gradient) {}

  void add(const LineOf& line) {
    if (answer_.ok()) answer_.failure = line.failure;
    answer_.values.push_back(line.value);
    if (gradient_)
      answer_.jacobian.insert(answer_.jacobian.end(), line.slope.begin(), line.slope.end());
  }

  Evaluation answer() && {
    if (answer_.ok()) return std::move(answer_);
    return {{}, {}, {}, std::move(answer_.failure)};
  }

 private:
  bool gradient_;
  Evaluation answer_;
};

Objective objective_of(const RobustProblem& problem, const RobustObjective& goal) {
  switch (goal.kind) {
    case RobustGoal::nominal: return problem.design.objectives[goal.index];
    case RobustGoal::yield:
      return {"log risk of " + problem.yields[goal.index].name, Sense::minimize};
    case RobustGoal::statistic: break;
  }
  const StatisticTarget& target = problem.statistics[goal.index];
  return {(target.kind == Statistic::sd ? "square of " : "") + target.name, goal.sense};
}

}  // namespace

RobustTerms::RobustTerms(const RobustProblem& problem) : statistics(problem.statistics.size()) {
  for (std::size_t s = 0; s < problem.yields.size(); ++s) {
    of_target.emplace_back();
    for (const std::size_t response : problem.yields[s].limits) {
      for (const Margin& margin : margins_of(problem, response)) {
        of_target.back().push_back(terms.size());
        terms.push_back({side_name(problem, margin), margin, s, {}, 0.0});
      }
    }
  }
  for (std::size_t s = 0; s < problem.statistics.size(); ++s) {
    const StatisticTarget& target = problem.statistics[s];
    if (target.kind != Statistic::quantile) continue;
    terms.push_back({target.name,
                     {target.response, 1.0, 0.0, false},
                     {},
                     s,
                     -normal_quantile(target.probability)});
  }
}

double RobustTerms::beta(std::span<const double> y, std::size_t variables, std::size_t term) const {
  return terms[term].target ? y[variables + term] : terms[term].fixed_beta;
}

Correction Correction::none(const RobustTerms& terms) {
  return {std::vector<double>(terms.terms.size(), 0.0),
          std::vector<double>(terms.of_target.size(), 0.0),
          std::vector<std::vector<Overlap>>(terms.of_target.size()),
          std::vector<std::vector<double>>(terms.terms.size()),
          std::vector<double>(terms.statistics, 0.0),
          std::vector<double>(terms.terms.size(), 0.0)};
}

RobustRound::RobustRound(const RobustProblem& problem, std::vector<RobustObjective> goals,
                         std::vector<double> risks, Correction correction, std::uint64_t seed)
    : problem_(problem),
      goals_(std::move(goals)),
      terms_(problem),
      risks_(std::move(risks)),
      correction_(std::move(correction)) {
  if (std::any_of(problem.statistics.begin(), problem.statistics.end(),
                  [](const StatisticTarget& s) { return s.kind != Statistic::quantile; }))
    sample_ = moment_sample(problem, seed);
}

bool RobustRound::is_goal(std::size_t target) const {
  return std::any_of(goals_.begin(), goals_.end(), [&](const RobustObjective& goal) {
    return goal.kind == RobustGoal::yield && goal.index == target;
  });
}

std::string RobustRound::risk_line(std::size_t target) const {
  return "risk of " + problem_.yields[target].name;
}

std::vector<double> RobustRound::start(std::span<const double> x) const {
  std::vector<double> y(x.begin(), x.end());
  for (const RobustTerm& term : terms_.terms) {
    if (!term.target) continue;
    const auto count = static_cast<double>(terms_.of_target[*term.target].size());
    y.push_back(std::clamp(-normal_quantile(risks_[*term.target] / count), kLeastBeta, kMostBeta));
  }
  return y;
}

std::vector<double> RobustRound::betas(std::span<const double> y) const {
  std::vector<double> list;
  for (std::size_t j = 0; j < terms_.terms.size(); ++j)
    list.push_back(terms_.beta(y, variables(), j));
  return list;
}

Problem RobustRound::problem() const {
  Problem p;
  p.variables = problem_.design.variables;
  const std::vector<double> first = start(std::vector<double>(variables(), 0.0));
  for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
    const RobustTerm& term = terms_.terms[j];
    if (!term.target) continue;
    const double most = -normal_quantile(kSmallShare * risks_[*term.target]);
    p.variables.push_back({"beta of " + term.name + " in " + problem_.yields[*term.target].name,
                           kLeastBeta, std::clamp(most, 0.0, kMostBeta), first[variables() + j]});
  }
  for (const RobustObjective& goal : goals_) p.objectives.push_back(objective_of(problem_, goal));
  p.constraints = problem_.design.constraints;
  for (const RobustTerm& term : terms_.terms)
    if (term.target)
      p.constraints.push_back({term.name + " in " + problem_.yields[*term.target].name, 0.0});
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s)
    if (!is_goal(s)) p.constraints.push_back({risk_line(s), 0.0});
  for (const StatisticTarget& target : problem_.statistics)
    if (is_limited(target)) p.constraints.push_back({target.name, target.lower, target.upper});
  p.evaluate = [this](std::span<const double> y, bool gradient) { return evaluate(y, gradient); };
  return p;
}

std::vector<InversePoint> RobustRound::points(std::span<const double> y) const {
  std::vector<InversePoint> list;
  const auto x = y.first(variables());
  for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
    const double beta = terms_.beta(y, variables(), j) + correction_.offsets[j];
    list.push_back(
        inverse_form(problem_, terms_.terms[j].margin, x, beta, correction_.directions[j]));
    if (!list.back().at.failure.empty()) break;
  }
  return list;
}

double RobustRound::log_risk(std::span<const double> y, std::size_t target) const {
  std::vector<double> beta;
  for (const std::size_t j : terms_.of_target[target])
    beta.push_back(terms_.beta(y, variables(), j));
  return std::log(joint_risk(beta, correction_.overlaps[target]).risk);
}

double RobustRound::goal_value(double objective, std::size_t position) const {
  const RobustObjective& goal = goals_[position];
  if (goal.kind == RobustGoal::yield) return 1.0 - std::exp(objective);
  const bool squared =
      goal.kind == RobustGoal::statistic && problem_.statistics[goal.index].kind == Statistic::sd;
  return squared ? std::sqrt(objective) : objective;
}

// U2.1 to U2.3
Moment RobustRound::statistic(std::span<const double> y, std::size_t statistic,
                              const std::vector<InversePoint>& worst) const {
  for (std::size_t j = 0; j < worst.size(); ++j)
    if (terms_.terms[j].statistic == statistic)
      return {worst[j].at.value + correction_.delta[j], worst[j].at.by_design,
              worst[j].at.by_spread};
  return moment(problem_, problem_.statistics[statistic], y.first(variables()), sample_);
}

LineOf RobustRound::design_row(std::span<const double> y, const Evaluation& design,
                               std::size_t response) const {
  const std::size_t n = variables();
  LineOf row{std::vector<double>(y.size(), 0.0), design.values[response]};
  if (!design.jacobian.empty())
    std::copy_n(design.jacobian.begin() + static_cast<std::ptrdiff_t>(response * n), n,
                row.slope.begin());
  return row;
}

// G_j + delta_j of U3.1
LineOf RobustRound::margin_row(std::span<const double> y, const InversePoint& worst,
                               std::size_t term) const {
  LineOf row{std::vector<double>(y.size(), 0.0), worst.at.value + correction_.delta[term]};
  std::copy(worst.at.by_design.begin(), worst.at.by_design.end(), row.slope.begin());
  row.slope[variables() + term] = worst.by_beta;
  return row;
}

// ln R of U3.1
LineOf RobustRound::log_risk_row(std::span<const double> y, std::size_t target) const {
  const std::vector<std::size_t>& terms = terms_.of_target[target];
  std::vector<double> beta;
  for (const std::size_t j : terms) beta.push_back(y[variables() + j]);
  const JointRisk joint = joint_risk(beta, correction_.overlaps[target]);
  LineOf row{std::vector<double>(y.size(), 0.0), std::log(joint.risk)};
  for (std::size_t i = 0; i < beta.size(); ++i)
    row.slope[variables() + terms[i]] = joint.by_beta[i] / joint.risk;
  return row;
}

LineOf RobustRound::statistic_row(std::span<const double> y, std::size_t index,
                                  const std::vector<InversePoint>& worst) const {
  Moment found = statistic(y, index, worst);
  LineOf row{std::vector<double>(y.size(), 0.0), found.value, std::move(found.failure)};
  std::copy(found.by_design.begin(), found.by_design.end(), row.slope.begin());
  return row;
}

LineOf RobustRound::limited_statistic_row(std::span<const double> y, std::size_t index,
                                          const std::vector<InversePoint>& worst) const {
  LineOf row = statistic_row(y, index, worst);
  row.value += correction_.shifts[index];
  return row;
}

LineOf RobustRound::goal_row(std::span<const double> y, const RobustObjective& goal,
                             const Evaluation& design,
                             const std::vector<InversePoint>& worst) const {
  if (goal.kind == RobustGoal::nominal) return design_row(y, design, goal.index);
  if (goal.kind == RobustGoal::yield) return log_risk_row(y, goal.index);
  const LineOf row = statistic_row(y, goal.index, worst);
  return problem_.statistics[goal.index].kind == Statistic::sd ? squared(row) : row;
}

// Objectives, constraints of the design, margins, risk lines, statistics.
Evaluation RobustRound::evaluate(std::span<const double> y, bool gradient) const {
  Evaluation design;
  if (problem_.design.responses() > 0)
    design = problem_.design.evaluate(y.first(variables()), gradient);
  if (!design.ok()) return design;
  const std::vector<InversePoint> worst = points(y);
  if (!worst.empty() && !worst.back().at.failure.empty())
    return {{}, {}, {}, worst.back().at.failure};
  RoundRows rows(gradient);
  for (const RobustObjective& goal : goals_) rows.add(goal_row(y, goal, design, worst));
  for (std::size_t i = problem_.design.objectives.size(); i < design.values.size(); ++i)
    rows.add(design_row(y, design, i));
  for (std::size_t j = 0; j < worst.size(); ++j)
    if (terms_.terms[j].target) rows.add(margin_row(y, worst[j], j));
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s)
    if (!is_goal(s))
      rows.add(subtracted(std::log(risks_[s] * (1.0 + correction_.kappa[s])), log_risk_row(y, s)));
  for (std::size_t s = 0; s < problem_.statistics.size(); ++s)
    if (is_limited(problem_.statistics[s])) rows.add(limited_statistic_row(y, s, worst));
  return std::move(rows).answer();
}

}  // namespace twum::inline v0_1::optim
