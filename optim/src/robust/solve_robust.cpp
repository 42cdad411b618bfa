// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/robust.hpp>

#include "robust/explained.hpp"
#include "robust/robust_search.hpp"
#include "robust/validate.hpp"
#include "robust/verification.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr int kMostBackOffs = 3;
constexpr std::uint64_t kProductsOfALastRound = 16384;
// upper limit; the sample decides nothing
constexpr std::uint64_t kMostProductsOfALargest = 100'000;
constexpr std::uint64_t kProductsOfAPrice = 4096;
const YieldPrice kNoPrice{1.0, std::numeric_limits<double>::quiet_NaN()};
constexpr double kPricedYields[] = {0.9, 0.95, 0.98, 0.99, 0.995, 0.999};

class RobustSolve {
 public:
  RobustSolve(const RobustProblem& problem, const RobustOptions& options)
      : problem_(problem),
        options_(options),
        search_(problem, options),
        wanted_(wanted_risks(problem)) {
    result_.largest_yield = std::numeric_limits<double>::quiet_NaN();
  }

  RobustResult form() {
    SolvedRound solved = search_.first_round(problem_.goals, wanted_);
    result_.outcome = solved.result.outcome;
    conclude(std::move(solved));
    return std::move(result_);
  }

  RobustResult run() {
    std::vector<double> risks = options_.back_off ? aimed_risks(problem_) : wanted_;
    SolvedRound solved = search_.first_round(problem_.goals, risks);
    if (!stopped(solved) && solved.feasible() && search_.risks_bind(solved))
      solved = search_.corrected(std::move(solved));
    if (!stopped(solved) && !solved.feasible()) solved = largest_yield(risks);
    if (stopped(solved) || solved.result.design.empty()) {
      result_.outcome = search_.stopped() ? Outcome::budget : solved.result.outcome;
      conclude(std::move(solved));
      return std::move(result_);
    }
    verify(solved, risks);
    result_.rounds = search_.reports();
    result_.prices_of_yields = prices_of_yields(solved);
    conclude(std::move(solved));
    return std::move(result_);
  }

 private:
  static constexpr std::uint64_t kReplicateOfAPrice = 2;  // apart from those that correct
  bool stopped(const SolvedRound& solved) const {
    return search_.stopped() || solved.result.outcome == Outcome::budget ||
           solved.result.outcome == Outcome::failed;
  }

  // If no design was found, searches the largest yield, U3.6. If it reaches the wanted one, the search continues from
  // that design; otherwise the largest yield is the answer.
  SolvedRound largest_yield(std::vector<double>& risks) {
    if (problem_.yields.empty() || is_goal(0)) return search_.first_round(problem_.goals, risks);
    SolvedRound largest = search_.first_round({{RobustGoal::yield, 0}}, risks);
    if (!largest.feasible()) return largest;
    largest = search_.corrected(std::move(largest));
    if (stopped(largest) || !largest.feasible()) return largest;
    const double risk = search_.last_risk().any;
    if (risk <= wanted_.front()) {
      risks.front() = std::min(wanted_.front(), std::max(risks.front(), kRoom * risk));
      SolvedRound again = search_.solve_again(largest, problem_.goals, risks);
      if (again.feasible()) again = search_.corrected(std::move(again));
      if (again.feasible()) return again;
    }
    result_.largest_yield = 1.0 - risk;
    return largest;
  }

  // The goal at other yields, each searched from its neighbour and corrected by one sample. The largest yield is
  // found first, because a search for a yield that cannot be reached costs more than all others together.
  std::vector<YieldPrice> prices_of_yields(const SolvedRound& solved) {
    std::vector<YieldPrice> list;
    // Shares of measured rows move in steps, which have no prices between them.
    if (problem_.yields.empty() || is_goal(0) || !options_.price_yields ||
        !problem_.measured.empty())
      return list;
    std::vector<double> risks = wanted_;
    const YieldPrice largest =
        all_are_free(solved, risks) ? kNoPrice : largest_price(solved, risks);
    SolvedRound last = solved;
    for (const double yield : kPricedYields) {
      risks.front() = 1.0 - yield;
      if (risks.front() < kRoom * (1.0 - largest.yield)) break;
      SolvedRound next = priced(last, problem_.goals, risks);
      if (search_.stopped()) return {};
      if (!next.feasible()) continue;
      list.push_back({yield, search_.goal_at(next)});
      last = std::move(next);
    }
    if (list.size() < std::size(kPricedYields) && std::isfinite(largest.objective))
      list.push_back(largest);
    return list;
  }

  // No product fails, and no risk holds the goal back at the largest of the yields.
  bool all_are_free(const SolvedRound& solved, std::vector<double> risks) {
    const YieldEstimate& seen = result_.verification.yields.front();
    if (seen.good < seen.products || search_.risks_bind(solved)) return false;
    risks.front() = 1.0 - *std::rbegin(kPricedYields);
    const SolvedRound strictest = search_.solve_again(solved, problem_.goals, risks);
    return strictest.feasible() && !search_.risks_bind(strictest);
  }

  YieldPrice largest_price(const SolvedRound& solved, const std::vector<double>& risks) {
    const SolvedRound largest =
        solved.round->seeks_yield() ? solved : priced(solved, {{RobustGoal::yield, 0}}, risks);
    if (search_.stopped() || !largest.feasible()) return kNoPrice;
    return {1.0 - search_.last_risk().any, search_.goal_at(largest)};
  }

  SolvedRound priced(const SolvedRound& from, const std::vector<RobustObjective>& goals,
                     const std::vector<double>& risks) {
    SolvedRound next = search_.solve_again(from, goals, risks);
    return next.feasible() && !search_.stopped() && search_.risks_bind(next)
               ? search_.correct_once(next, kProductsOfAPrice, kReplicateOfAPrice)
               : next;
  }

  // U5.3, U5.4: an independent sample decides. If it does not confirm the yield, the search aims at a smaller risk.
  void verify(SolvedRound& solved, std::vector<double> risks) {
    for (int run = 0;; ++run) {
      if (!risks.empty()) result_.aimed.push_back(1.0 - risks.front());
      // A largest yield is not compared with the wanted one.
      const bool largest = solved.round->seeks_yield();
      const std::uint64_t products =
          largest
              ? std::min(kMostProductsOfALargest, products_for_rarest({search_.last_risk().any}))
              : products_for_rarest(wanted_);
      result_.verification = search_.verified(solved, products, static_cast<std::uint64_t>(run));
      result_.outcome = solved.result.outcome;
      if (search_.stopped()) result_.outcome = Outcome::budget;
      if (search_.stopped() || judge() || run == kMostBackOffs || !options_.back_off) return;
      if (solved.round->seeks_yield() && !is_goal(0)) return;
      risks = backed_off(problem_, std::move(risks), result_.verification);
      SolvedRound next = search_.solve_again(solved, problem_.goals, risks,
                                             search_.shifts_after(solved, result_.verification));
      if (next.feasible()) next = search_.correct_once(next, kProductsOfALastRound, 1);
      if (!next.feasible()) return;
      solved = std::move(next);
    }
  }

  // True if the verdict on every target is that it holds.
  bool judge() {
    result_.verdict = worst_verdict(problem_, result_.verification);
    if (result_.verdict == YieldVerdict::holds) {
      if (goal_is_biased() && result_.outcome == Outcome::optimal)
        result_.outcome = Outcome::feasible;
      return true;
    }
    result_.outcome =
        result_.verdict == YieldVerdict::broken ? Outcome::infeasible : Outcome::feasible;
    return false;
  }

  // Whether the goal is a mean or a standard deviation and too many products have no answer, so that its derivative
  // is wrong.
  bool goal_is_biased() const {
    const RobustObjective& goal = problem_.goals.front();
    if (goal.kind != RobustGoal::statistic ||
        problem_.statistics[goal.index].kind == Statistic::quantile)
      return false;
    double lost = 0.0;
    for (const auto& [reason, count] : result_.verification.lost)
      lost += static_cast<double>(count);
    const std::size_t made = result_.verification.values.front().size();
    return lost > kMostLostOfAMean * static_cast<double>(made);
  }

  bool is_goal(std::size_t target) const {
    const RobustObjective& goal = problem_.goals.front();
    return goal.kind == RobustGoal::yield && goal.index == target;
  }

  void conclude(SolvedRound solved) {
    result_.counters = search_.counters();
    if (result_.rounds.empty()) result_.rounds = search_.reports();
    if (!solved.result.design.empty()) {
      const auto x = search_.design(solved);
      result_.design.assign(x.begin(), x.end());
      if (!search_.stopped()) solved.result.certificate = search_.certified(solved);
      if (result_.outcome == Outcome::optimal && !solved.result.certificate.passed)
        result_.outcome = Outcome::feasible;
      const Explained explained(problem_, solved);
      result_.risks = explained.risks(result_.verification);
      result_.prices = explained.prices();
      result_.price_of_yield = explained.price_of_yield();
      result_.goal_per_objective = explained.per_objective();
    }
    result_.last = std::move(solved.result);
    for (StageReport& stage : result_.last.stages)
      stage.objective = solved.round->goal_value(stage.objective);
  }

  static constexpr double kRoom =
      1.05;  // risk beyond the smallest one that leaves the goal some room

  const RobustProblem& problem_;
  const RobustOptions& options_;
  RobustSearch search_;
  std::vector<double> wanted_;  // risks
  RobustResult result_;
};

}  // namespace

RobustResult solve_robust(const RobustProblem& problem, const RobustOptions& options) {
  validate_robust(problem);
  if (problem.goals.size() != 1) throw InputError("a robust optimum has one goal");
  return RobustSolve(problem, options).run();
}

Verification verify_design(const RobustProblem& problem, std::span<const double> design,
                           std::uint64_t products, const RobustOptions& options,
                           std::uint64_t stream, double width) {
  validate_robust(problem);
  const RobustSearch search(problem, options);
  const auto known = [width](const std::vector<YieldEstimate>& yields) {
    return std::all_of(yields.begin(), yields.end(),
                       [width](const YieldEstimate& y) { return y.high - y.low < width; });
  };
  return verify_products(problem, search.terms(), design, search.plan(products, 0), stream, known);
}

RobustResult solve_form(const RobustProblem& problem, const RobustOptions& options) {
  validate_robust(problem);
  return RobustSolve(problem, options).form();
}

}  // namespace twum::inline v0_1::optim
