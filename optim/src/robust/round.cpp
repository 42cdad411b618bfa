// SPDX-License-Identifier: Apache-2.0
#include "robust/round.hpp"

#include "robust/moments.hpp"
#include "robust/normal.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

constexpr double kLeastBeta = -3.0;  // some limits cannot be held more often than not
constexpr double kMostBeta = 6.0;    // a risk of 1e-9
// A limit that matters little has an index that depends on the start and costs steps: this share of the risk is small
// enough to be left with it.
constexpr double kSmallShare = 1e-3;

void append_line(Evaluation& answer, const LineOf& line) {
  answer.values.push_back(line.value);
  answer.jacobian.insert(answer.jacobian.end(), line.slope.begin(), line.slope.end());
}

std::string side_name(const RobustProblem& problem, const Margin& margin) {
  const RandomLimit& limit = problem.limits[margin.response];
  const bool both = limit.lower > -kInfinity && limit.upper < kInfinity;
  if (!both) return limit.name;
  return limit.name + (margin.sign > 0.0 ? " (lower end)" : " (upper end)");
}

}  // namespace

RobustTerms::RobustTerms(const RobustProblem& problem) {
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
    terms.push_back(
        {target.name, {target.response, 1.0, 0.0}, {}, s, -normal_quantile(target.probability)});
  }
}

double RobustTerms::beta(std::span<const double> y, std::size_t variables, std::size_t term) const {
  return terms[term].target ? y[variables + term] : terms[term].fixed_beta;
}

Correction Correction::none(const RobustTerms& terms) {
  return {std::vector<double>(terms.terms.size(), 0.0),
          std::vector<double>(terms.of_target.size(), 0.0),
          std::vector<std::vector<Overlap>>(terms.of_target.size()),
          std::vector<std::vector<double>>(terms.terms.size())};
}

RobustRound::RobustRound(const RobustProblem& problem, RobustGoal goal, std::vector<double> risks,
                         Correction correction, std::uint64_t seed)
    : problem_(problem),
      goal_(goal),
      terms_(problem),
      risks_(std::move(risks)),
      correction_(std::move(correction)) {
  if (std::any_of(problem.statistics.begin(), problem.statistics.end(),
                  [](const StatisticTarget& s) { return s.kind != Statistic::quantile; }))
    sample_ = moment_sample(problem, seed);
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
  if (goal_ == RobustGoal::nominal) p.objectives = problem_.design.objectives;
  if (goal_ == RobustGoal::yield)
    p.objectives = {{"log risk of " + problem_.yields.front().name, Sense::minimize}};
  if (goal_ == RobustGoal::statistic)
    p.objectives = {{problem_.statistics.front().name, problem_.sense}};
  p.constraints = problem_.design.constraints;
  for (const RobustTerm& term : terms_.terms)
    if (term.target)
      p.constraints.push_back({term.name + " in " + problem_.yields[*term.target].name, 0.0});
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s)
    if (!is_goal(s)) p.constraints.push_back({risk_line(s), 0.0});
  for (const StatisticTarget& target : problem_.statistics)
    if (target.lower > -kInfinity || target.upper < kInfinity)
      p.constraints.push_back({target.name, target.lower, target.upper});
  p.evaluate = [this](std::span<const double> y, bool gradient) { return evaluate(y, gradient); };
  return p;
}

std::vector<InversePoint> RobustRound::points(std::span<const double> y) const {
  std::vector<InversePoint> list;
  const auto x = y.first(variables());
  for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
    list.push_back(inverse_form(problem_, terms_.terms[j].margin, x, terms_.beta(y, variables(), j),
                                correction_.directions[j]));
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

// U2.1 to U2.3
LineOf RobustRound::statistic_line(std::span<const double> y, std::size_t statistic,
                                   const std::vector<InversePoint>& worst) const {
  LineOf line{std::vector<double>(y.size(), 0.0)};
  const auto put = [&](double value, const std::vector<double>& by_design) {
    line.value = value;
    std::copy(by_design.begin(), by_design.end(), line.slope.begin());
  };
  for (std::size_t j = 0; j < worst.size(); ++j)
    if (terms_.terms[j].statistic == statistic)
      put(worst[j].at.value + correction_.delta[j], worst[j].at.by_design);
  const StatisticTarget& target = problem_.statistics[statistic];
  if (target.kind == Statistic::quantile) return line;
  const Moment found = moment(problem_, target, y.first(variables()), sample_);
  if (found.failure.empty()) put(found.value, found.by_design);
  line.failure = found.failure;
  return line;
}

// Objective, constraints of the design, margins, risk lines, statistics.
Evaluation RobustRound::evaluate(std::span<const double> y, bool gradient) const {
  const std::size_t n = variables(), all = y.size();
  const auto x = y.first(n);
  Evaluation design;
  if (problem_.design.responses() > 0) design = problem_.design.evaluate(x, gradient);
  if (!design.ok()) return design;
  const std::vector<InversePoint> worst = points(y);
  Evaluation answer;
  if (!worst.empty()) answer.failure = worst.back().at.failure;
  if (!answer.ok()) return answer;

  const auto design_line = [&](std::size_t i) {
    LineOf line{std::vector<double>(all, 0.0), design.values[i]};
    if (gradient)
      std::copy_n(design.jacobian.begin() + static_cast<std::ptrdiff_t>(i * n), n,
                  line.slope.begin());
    return line;
  };
  const auto risk_of = [&](std::size_t s, double sign, double end) {
    std::vector<double> beta;
    for (const std::size_t j : terms_.of_target[s]) beta.push_back(y[n + j]);
    const JointRisk joint = joint_risk(beta, correction_.overlaps[s]);
    LineOf line{std::vector<double>(all, 0.0), end + sign * std::log(joint.risk)};
    for (std::size_t i = 0; i < beta.size(); ++i)
      line.slope[n + terms_.of_target[s][i]] = sign * joint.by_beta[i] / joint.risk;
    return line;
  };
  const auto margin_line = [&](std::size_t j) {
    LineOf line{std::vector<double>(all, 0.0), worst[j].at.value + correction_.delta[j]};
    std::copy(worst[j].at.by_design.begin(), worst[j].at.by_design.end(), line.slope.begin());
    if (terms_.terms[j].target) line.slope[n + j] = worst[j].by_beta;
    return line;
  };

  const std::size_t objectives = problem_.design.objectives.size();
  if (goal_ == RobustGoal::nominal) append_line(answer, design_line(0));
  if (goal_ == RobustGoal::yield) append_line(answer, risk_of(0, 1.0, 0.0));
  if (goal_ == RobustGoal::statistic) {
    const LineOf line = statistic_line(y, 0, worst);
    if (!line.failure.empty()) return {{}, {}, {}, line.failure};
    append_line(answer, line);
  }
  for (std::size_t i = objectives; i < design.values.size(); ++i)
    append_line(answer, design_line(i));
  for (std::size_t j = 0; j < worst.size(); ++j)
    if (terms_.terms[j].target) append_line(answer, margin_line(j));
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s)
    if (!is_goal(s))
      append_line(answer, risk_of(s, -1.0, std::log(risks_[s] * (1.0 + correction_.kappa[s]))));
  for (std::size_t s = 0; s < problem_.statistics.size(); ++s) {
    const StatisticTarget& target = problem_.statistics[s];
    if (!(target.lower > -kInfinity || target.upper < kInfinity)) continue;
    const LineOf line = statistic_line(y, s, worst);
    if (!line.failure.empty()) return {{}, {}, {}, line.failure};
    append_line(answer, line);
  }
  if (!gradient) answer.jacobian.clear();
  return answer;
}

}  // namespace twum::optim
