// SPDX-License-Identifier: Apache-2.0
#include "robust/explained.hpp"

#include <algorithm>
#include <cmath>
#include <twum/base/no_value.hpp>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

const Activity* activity_of(const Certificate& certificate, const std::string& name) {
  const Activity* found = nullptr;  // of a limit with two ends the one that holds the design back
  for (const Activity& limit : certificate.limits)
    if (!limit.is_bound && limit.name == name && (found == nullptr || limit.active)) found = &limit;
  return found;
}

}  // namespace

Explained::Explained(const RobustProblem& problem, const SolvedRound& solved)
    : problem_(problem),
      round_(*solved.round),
      certificate_(solved.result.certificate),
      y_(solved.result.design),
      points_(round_.points(y_)),
      beta_(round_.betas(y_)) {
  for (std::size_t s = 0; s < problem.statistics.size(); ++s) {
    Moment& one = statistics_.emplace_back(round_.statistic(y_, s, points_));
    if (problem.statistics[s].kind == Statistic::quantile && !fail_by_law())
      std::ranges::fill(one.by_spread, kNoValue);
  }
}

// Improvement of the goal per unit that a limit is relaxed.
double Explained::multiplier(const std::string& name) const {
  const Activity* limit = activity_of(certificate_, name);
  return limit == nullptr ? 0.0 : per_objective() * limit->multiplier;
}

double Explained::multiplier(std::size_t term) const {
  const RobustTerm& one = round_.terms().terms[term];
  return one.target ? multiplier(one.name + " in " + problem_.yields[*one.target].name) : 0.0;
}

std::vector<RiskShare> Explained::risks(const Verification& verified) const {
  std::vector<RiskShare> list;
  const auto& terms = round_.terms().terms;
  for (std::size_t j = 0; j < terms.size(); ++j) {
    if (!terms[j].target) continue;
    RiskShare share{problem_.limits[terms[j].margin.response].name,
                    terms[j].margin.sign > 0.0 ? Side::lower : Side::upper, *terms[j].target,
                    beta_[j]};
    if (fail_by_law()) share.importance = problem_.correlation.parts(points_[j].direction);
    share.multiplier = multiplier(j);
    share.converged = points_[j].converged;
    share.delta = round_.correction().delta[j];
    if (!verified.yields.empty()) {
      const YieldEstimate& yield = verified.yields[share.target];
      share.probability = verified.term_shares[j];
      const double any = verified.weighted ? 1.0 - yield.value
                                           : static_cast<double>(yield.products - yield.good) /
                                                 static_cast<double>(yield.products);
      share.share = any > 0.0 ? share.probability / any : 0.0;
    }
    list.push_back(std::move(share));
  }
  return list;
}

double Explained::per_objective() const {
  const RobustObjective& goal = round_.goals().front();
  if (goal.kind == RobustGoal::yield) return std::exp(round_.log_risk(y_, goal.index));
  if (goal.kind == RobustGoal::nominal || problem_.statistics[goal.index].kind != Statistic::sd)
    return 1.0;
  const double spread = statistics_[goal.index].value;
  return spread > 0.0 ? 0.5 / spread : 0.0;
}

// The slope of a margin by the spread of an input.
double Explained::by_spread(std::size_t term, std::size_t input) const {
  return fail_by_law() ? points_[term].at.by_spread[input] : kNoValue;
}

// Improvement of the goal by the margins if the spread of an input is 1 % smaller.
double Explained::gain_of_margins(std::size_t input) const {
  double gain = 0.0;
  for (std::size_t j = 0; j < points_.size(); ++j)
    if (const double worth = multiplier(j); worth != 0.0)
      gain -= 0.01 * worth * by_spread(j, input);
  return gain;
}

// The same by the statistics: the goal itself, and those with a limit.
double Explained::gain_of_statistics(std::size_t input) const {
  double gain = 0.0;
  const RobustObjective& goal = round_.goals().front();
  if (goal.kind == RobustGoal::statistic)
    gain -=
        (goal.sense == Sense::maximize ? 0.01 : -0.01) * statistics_[goal.index].by_spread[input];
  for (std::size_t s = 0; s < statistics_.size(); ++s) {
    const Activity* limit = activity_of(certificate_, problem_.statistics[s].name);
    if (limit == nullptr || !limit->active) continue;
    const double sign = limit->side == Side::lower ? 1.0 : -1.0;
    gain -= 0.01 * multiplier(limit->name) * sign * statistics_[s].by_spread[input];
  }
  return gain;
}

std::vector<TolerancePrice> Explained::prices() const {
  std::vector<TolerancePrice> list;
  for (std::size_t k = 0; k < problem_.inputs.size(); ++k) {
    TolerancePrice price{problem_.inputs[k].name, gain_of_margins(k) + gain_of_statistics(k)};
    for (std::size_t j = 0; j < points_.size(); ++j)
      if (round_.terms().terms[j].target == 0U && points_[j].by_beta != 0.0)
        price.yield_per_percent_tighter +=
            0.01 * normal_density(beta_[j]) * by_spread(j, k) / points_[j].by_beta;
    list.push_back(std::move(price));
  }
  return list;
}

double Explained::price_of_yield() const {
  if (problem_.yields.empty() || round_.is_goal(0)) return 0.0;
  if (!fail_by_law()) return kNoValue;
  return multiplier(round_.risk_line(0)) / round_.risk(0);
}

}  // namespace twum::inline v0_1::optim
