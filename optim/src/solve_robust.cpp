// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/robust.hpp>

#include "robust/normal.hpp"
#include "robust/robust_search.hpp"
#include "robust/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <twum/base/error.hpp>

namespace twum::optim {
namespace {

constexpr int kMostBackOffs = 3;
constexpr std::uint64_t kProductsOfALastRound = 16384;

double multiplier_of(const Certificate& certificate, const std::string& name) {
  for (const Activity& limit : certificate.limits)
    if (!limit.is_bound && limit.name == name) return limit.multiplier;
  return 0.0;
}

// U6.1 to U6.5 of a solved round.
class Explained {
 public:
  Explained(const RobustProblem& problem, const SolvedRound& solved)
      : problem_(problem),
        round_(*solved.round),
        certificate_(solved.result.certificate),
        y_(solved.result.design),
        points_(round_.points(y_)),
        beta_(round_.betas(y_)) {}

  std::vector<RiskShare> risks(const Verification& verified) const {
    std::vector<RiskShare> list;
    const auto& terms = round_.terms().terms;
    for (std::size_t j = 0; j < terms.size(); ++j) {
      if (!terms[j].target) continue;
      RiskShare share{problem_.limits[terms[j].margin.response].name,
                      terms[j].margin.sign > 0.0 ? Side::lower : Side::upper, *terms[j].target,
                      beta_[j]};
      for (const double a : points_[j].direction) share.importance.push_back(a * a);
      share.multiplier = multiplier(j);
      share.converged = points_[j].converged;
      share.delta = round_.correction().delta[j];
      if (!verified.yields.empty()) {
        const YieldEstimate& yield = verified.yields[share.target];
        const auto failed = static_cast<double>(verified.term_failures[j]);
        share.probability = failed / static_cast<double>(yield.products);
        const auto bad = static_cast<double>(yield.products - yield.good);
        share.share = bad > 0.0 ? failed / bad : 0.0;
      }
      list.push_back(std::move(share));
    }
    return list;
  }

  // U6.2, U6.3 and U6.5. Where the goal is the yield, ln R is what the multipliers speak of.
  std::vector<TolerancePrice> prices() const {
    const double scale =
        round_.goal() == RobustGoal::yield ? std::exp(round_.log_risk(y_, 0)) : 1.0;
    std::vector<TolerancePrice> list;
    for (std::size_t k = 0; k < problem_.inputs.size(); ++k) {
      TolerancePrice price{problem_.inputs[k].name};
      for (std::size_t j = 0; j < points_.size(); ++j) {
        const double slope = points_[j].at.by_spread[k];
        if (!round_.terms().terms[j].target) continue;
        price.gain_per_percent_tighter -= 0.01 * scale * multiplier(j) * slope;
        if (*round_.terms().terms[j].target == 0 && points_[j].by_beta != 0.0)
          price.yield_per_percent_tighter +=
              0.01 * normal_density(beta_[j]) * slope / points_[j].by_beta;
      }
      list.push_back(std::move(price));
    }
    return list;
  }

  // U6.4
  double price_of_yield() const {
    if (round_.goal() == RobustGoal::yield || problem_.yields.empty()) return 0.0;
    return multiplier_of(certificate_, round_.risk_line(0)) / round_.risk(0);
  }

 private:
  double multiplier(std::size_t j) const {
    const RobustTerm& term = round_.terms().terms[j];
    return term.target ? multiplier_of(certificate_,
                                       term.name + " in " + problem_.yields[*term.target].name)
                       : 0.0;
  }

  const RobustProblem& problem_;
  const RobustRound& round_;
  const Certificate& certificate_;
  const std::vector<double>& y_;
  std::vector<InversePoint> points_;
  std::vector<double> beta_;
};

class RobustSolve {
 public:
  RobustSolve(const RobustProblem& problem, const RobustOptions& options)
      : problem_(problem), options_(options), search_(problem, options) {
    result_.largest_yield = std::numeric_limits<double>::quiet_NaN();
    for (const YieldTarget& target : problem.yields) wanted_.push_back(1.0 - target.at_least);
    if (problem.goal == RobustGoal::yield) wanted_.front() = kGoalRisk;
  }

  RobustResult form() {
    SolvedRound solved = search_.first_round(problem_.goal, wanted_);
    result_.outcome = solved.result.outcome;
    conclude(std::move(solved));
    return std::move(result_);
  }

  RobustResult run() {
    std::vector<double> risks = wanted_;
    if (options_.back_off && problem_.goal != RobustGoal::yield)
      for (double& p : risks) p = risk_to_aim_at(p, products_for(p));
    SolvedRound solved = search_.first_round(problem_.goal, risks);
    if (!stopped(solved) && solved.feasible()) solved = search_.corrected(std::move(solved));
    if (!stopped(solved) && !solved.feasible()) solved = largest_yield(risks);
    if (stopped(solved) || solved.result.design.empty()) {
      result_.outcome = stopped(solved) ? Outcome::budget : solved.result.outcome;
      conclude(std::move(solved));
      return std::move(result_);
    }
    verify(solved, risks);
    conclude(std::move(solved));
    return std::move(result_);
  }

 private:
  static constexpr double kGoalRisk = 1e-6;  // leaves the indices of a largest yield free up to 6

  bool stopped(const SolvedRound& solved) const {
    return search_.stopped() || solved.result.outcome == Outcome::budget ||
           solved.result.outcome == Outcome::failed;
  }

  // No design was found: the largest yield says whether there is one, U3.6. If there is, the search goes on from
  // it, otherwise it is the answer.
  SolvedRound largest_yield(std::vector<double>& risks) {
    if (problem_.yields.empty() || problem_.goal == RobustGoal::yield)
      return search_.first_round(problem_.goal, risks);
    SolvedRound largest = search_.first_round(RobustGoal::yield, risks);
    if (!largest.feasible()) return largest;
    largest = search_.corrected(std::move(largest));
    if (stopped(largest) || !largest.feasible()) return largest;
    const double risk = search_.last_risk().any;
    if (risk <= wanted_.front()) {
      risks.front() = std::min(wanted_.front(), std::max(risks.front(), kRoom * risk));
      SolvedRound again = search_.solve_again(largest, problem_.goal, risks);
      if (again.feasible()) again = search_.corrected(std::move(again));
      if (again.feasible()) return again;
    }
    result_.largest_yield = 1.0 - risk;
    return largest;
  }

  // U5.3, U5.4: fresh products decide; where they do not show that the yield holds, a smaller risk is aimed at.
  void verify(SolvedRound& solved, std::vector<double> risks) {
    for (int attempt = 0;; ++attempt) {
      if (!risks.empty()) result_.aimed.push_back(1.0 - risks.front());
      const double rarest =
          wanted_.empty() ? 0.01 : *std::min_element(wanted_.begin(), wanted_.end());
      // A largest yield is verified as what it is, not as what was wanted.
      const bool largest = solved.round->goal() == RobustGoal::yield;
      const double risk = largest ? search_.last_risk().any : rarest;
      result_.verification = verify_products(problem_, search_.terms(), search_.design(solved),
                                             search_.plan(products_for(std::max(risk, 1e-6)), 0),
                                             static_cast<std::uint64_t>(attempt));
      result_.outcome = solved.result.outcome;
      if (search_.stopped()) result_.outcome = Outcome::budget;
      if (search_.stopped() || judge() || attempt == kMostBackOffs || !options_.back_off) return;
      if (solved.round->goal() != problem_.goal) return;
      for (std::size_t s = 0; s < risks.size(); ++s) {
        const double seen = 1.0 - result_.verification.yields[s].low;
        if (seen > wanted_[s]) risks[s] *= wanted_[s] / seen;
      }
      SolvedRound next = search_.solve_again(solved, problem_.goal, risks);
      if (next.feasible()) next = search_.correct_once(next, kProductsOfALastRound, 1);
      if (!next.feasible()) return;
      solved = std::move(next);
    }
  }

  // True if the verdict on every target is that it holds.
  bool judge() {
    result_.verdict = YieldVerdict::holds;
    for (std::size_t s = 0; s < problem_.yields.size(); ++s) {
      if (s == 0 && problem_.goal == RobustGoal::yield) continue;
      result_.verdict = std::max(
          result_.verdict, verdict_on(result_.verification.yields[s], problem_.yields[s].at_least));
    }
    if (result_.verdict == YieldVerdict::holds) return true;
    result_.outcome =
        result_.verdict == YieldVerdict::broken ? Outcome::infeasible : Outcome::feasible;
    return false;
  }

  void conclude(SolvedRound solved) {
    result_.counters = search_.counters();
    result_.rounds = search_.reports();
    if (!solved.result.design.empty()) {
      const auto x = search_.design(solved);
      result_.design.assign(x.begin(), x.end());
      const Explained explained(problem_, solved);
      result_.risks = explained.risks(result_.verification);
      result_.prices = explained.prices();
      result_.price_of_yield = explained.price_of_yield();
    }
    result_.last = std::move(solved.result);
  }

  static constexpr double kRoom =
      1.05;  // risk beyond the smallest one that leaves the goal some room

  const RobustProblem& problem_;
  const RobustOptions& options_;
  RobustSearch search_;
  std::vector<double> wanted_;  // risks
  RobustResult result_;
};

void validate_robust(const RobustProblem& problem) {
  if (problem.inputs.empty())
    throw InputError("a robust problem has at least one input that scatters");
  for (const RandomInput& input : problem.inputs) {
    if (!(input.spread > 0.0) && !(input.law == Law::triangular && input.above > 0.0))
      throw InputError(input.name + ": its spread must be more than 0");
  }
  if (problem.goal == RobustGoal::yield && problem.yields.empty())
    throw InputError("a robust problem whose goal is the yield has a yield target");
  if (problem.goal == RobustGoal::statistic && problem.statistics.empty())
    throw InputError("a robust problem whose goal is a statistic has one");
  for (const YieldTarget& target : problem.yields) {
    if (target.limits.empty()) throw InputError(target.name + ": no limit counts in it");
    if (!(target.at_least > 0.0 && target.at_least < 1.0) && problem.goal != RobustGoal::yield)
      throw InputError(target.name + ": must be between 0 and 100 %");
  }
}

}  // namespace

RobustResult solve_robust(const RobustProblem& problem, const RobustOptions& options) {
  validate_robust(problem);
  return RobustSolve(problem, options).run();
}

Verification verify_design(const RobustProblem& problem, std::span<const double> design,
                           std::uint64_t products, const RobustOptions& options,
                           std::uint64_t stream) {
  validate_robust(problem);
  const RobustSearch search(problem, options);
  return verify_products(problem, search.terms(), design, search.plan(products, 0), stream);
}

RobustResult solve_form(const RobustProblem& problem, const RobustOptions& options) {
  validate_robust(problem);
  return RobustSolve(problem, options).form();
}

}  // namespace twum::optim
