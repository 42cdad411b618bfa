// SPDX-License-Identifier: Apache-2.0
#include "robust/robust_search.hpp"

#include "problem/session.hpp"
#include "robust/statistic_verdict.hpp"
#include "robust/verification.hpp"
#include "search/range_place.hpp"

#include <twum/optim/certify.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <twum/base/ordered.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kDesignStill = 1e-3;                  // of the unit box
constexpr std::uint64_t kFreshScrambles = 10'000;      // apart from those that correct
constexpr std::uint64_t kSoughtScrambles = 1'000'000;  // apart from both
constexpr std::uint64_t kCoarse = 4096, kFine = 16384;

double of_unit(const Variable& v, double u) {
  const double x = value_in_range(v, u);
  return v.integer ? std::round(x) : x;
}

bool found(const Result& result) {
  return result.outcome == Outcome::optimal || result.outcome == Outcome::feasible;
}

// Leaves the indices of a largest yield free up to 6.
constexpr double kGoalRisk = 1e-6;

bool is_goal(const RobustProblem& problem, std::size_t target) {
  return std::any_of(problem.goals.begin(), problem.goals.end(), [&](const RobustObjective& goal) {
    return goal.kind == RobustGoal::yield && goal.index == target;
  });
}

}  // namespace

std::vector<double> wanted_risks(const RobustProblem& problem) {
  std::vector<double> risks;
  for (std::size_t s = 0; s < problem.yields.size(); ++s)
    risks.push_back(is_goal(problem, s) ? kGoalRisk : 1.0 - problem.yields[s].at_least);
  return risks;
}

std::vector<double> aimed_risks(const RobustProblem& problem) {
  std::vector<double> risks = wanted_risks(problem);
  for (std::size_t s = 0; s < risks.size(); ++s)
    if (!is_goal(problem, s))
      risks[s] = risks[s] < kRareRisk ? risk_to_aim_at_weighted(risks[s])
                                      : risk_to_aim_at(risks[s], products_for(risks[s]));
  return risks;
}

std::vector<double> backed_off(const RobustProblem& problem, std::vector<double> risks,
                               const Verification& seen) {
  const std::vector<double> wanted = wanted_risks(problem);
  for (std::size_t s = 0; s < risks.size(); ++s) {
    const double most = 1.0 - seen.yields[s].low;
    if (!is_goal(problem, s) && most > wanted[s]) risks[s] *= wanted[s] / most;
  }
  return risks;
}

YieldVerdict worst_verdict(const RobustProblem& problem, const Verification& seen) {
  YieldVerdict worst = YieldVerdict::holds;
  for (std::size_t s = 0; s < seen.yields.size(); ++s)
    if (!is_goal(problem, s))
      worst = std::max(worst, verdict_on(seen.yields[s], problem.yields[s].at_least));
  for (std::size_t s = 0; s < seen.statistics.size(); ++s)
    worst = std::max(worst, verdict_on(problem.statistics[s], seen.statistics[s]));
  return worst;
}

// U5.3a
bool all_far_above_wanted(const RobustProblem& problem, const std::vector<YieldEstimate>& yields) {
  for (std::size_t s = 0; s < yields.size(); ++s)
    if (is_goal(problem, s) || 1.0 - yields[s].low >= 0.5 * (1.0 - problem.yields[s].at_least))
      return false;
  return true;
}

std::uint64_t products_for_rarest(const std::vector<double>& risks) {
  constexpr double kWithoutYield = 0.01;
  const double rarest =
      risks.empty() ? kWithoutYield : *std::min_element(risks.begin(), risks.end());
  return products_for(rarest < kRareRisk ? kWithoutYield : rarest);
}

RobustSearch::RobustSearch(const RobustProblem& problem, const RobustOptions& options)
    : problem_(problem),
      options_(options),
      terms_(problem),
      next_stage_(options.solve.first_stage) {}

SamplePlan RobustSearch::plan(std::uint64_t products, std::uint64_t replicate) const {
  return {products,
          options_.solve.seed,
          replicate,
          static_cast<unsigned>(options_.solve.jobs),
          [this] { return !stopped(); },
          options_.sampled};
}

std::vector<std::vector<double>> RobustSearch::starts() const {
  std::vector<std::vector<double>> list = options_.starts;
  const auto& variables = problem_.design.variables;
  if (list.empty()) list.push_back(start_design(problem_.design));
  for (const auto& u : sobol_points(variables.size(), options_.draws, options_.solve.seed)) {
    list.emplace_back();
    for (std::size_t k = 0; k < u.size(); ++k) list.back().push_back(of_unit(variables[k], u[k]));
  }
  return list;
}

// The problem of a round, answered from the caller's stored evaluations where possible.
Problem RobustSearch::remembered(Problem problem, std::uint64_t number) const {
  if (options_.recall) {
    problem.evaluate = [this, number, evaluate = problem.evaluate](std::span<const double> at,
                                                                   bool gradient) {
      return options_.recall(number, at, gradient, evaluate);
    };
  }
  return problem;
}

SolveOptions RobustSearch::options_for(std::uint64_t number, std::uint64_t stage) {
  SolveOptions o = options_.solve;
  o.solver = "auto";
  o.starts = 1;
  o.jobs = 1;
  o.global.clear();
  o.solver_options.clear();
  o.analyse_infeasible = false;
  o.first_stage = stage;
  o.observer = [this, number](const Observation& observation) {
    if (!options_.observer) return;
    const std::lock_guard lock(observing_);
    options_.observer(number, observation);
  };
  return o;
}

Result RobustSearch::search(const Problem& problem, std::uint64_t number, std::span<const double> y,
                            const std::string& solver, std::uint64_t stage) {
  Problem p = remembered(problem, number);
  for (std::size_t k = 0; k < y.size(); ++k) p.variables[k].start = y[k];
  SolveOptions o = options_for(number, stage);
  o.solver = solver;
  return optim::solve(p, o);
}

Result RobustSearch::search(const Problem& problem, std::span<const double> y) {
  Result result = search(problem, next_round_++, y, "auto", next_stage_);
  next_stage_ += kStagesOfASolve;
  book(result);
  return result;
}

Front RobustSearch::front(const RobustRound& round, std::size_t points, std::span<const double> x) {
  const std::uint64_t number = next_round_++;
  Problem p = remembered(round.problem(), number);
  const std::vector<double> y = round.start(x);
  for (std::size_t k = 0; k < y.size(); ++k) p.variables[k].start = y[k];
  ParetoOptions o;
  o.solve = options_for(number, next_stage_);
  o.points = points;
  Front found = pareto_front(p, o);
  next_stage_ += found.stages_used + 1;
  counters_.add(found.counters);
  return found;
}

void RobustSearch::book(const Result& result) { counters_.add(result.counters); }

bool RobustSearch::better(const Result& a, const Result& b) const {
  if (found(a) != found(b)) return found(a);
  if (a.evaluation.values.empty() || b.evaluation.values.empty())
    return !a.evaluation.values.empty();
  if (!found(a)) return a.certificate.infeasibility < b.certificate.infeasibility;
  const double value = a.evaluation.values.front(), other = b.evaluation.values.front();
  return value < other - 1e-9 * std::abs(other);
}

SolvedRound RobustSearch::first_round(const std::vector<RobustObjective>& goals,
                                      const std::vector<double>& risks) {
  const auto round = std::make_shared<const RobustRound>(
      problem_, goals, risks, first_correction(goals, risks), options_.solve.seed);
  const std::uint64_t number = next_round_++;
  const auto list = starts();
  const std::uint64_t first = next_stage_;
  next_stage_ += kStagesOfASolve * list.size();
  std::vector<Result> results;
  run_indexed(
      {0, list.size(), static_cast<unsigned>(options_.solve.jobs), {}},
      [&](std::uint64_t i) {
        return search(round->problem(), number, round->start(list[i]), "nlopt:slsqp",
                      first + kStagesOfASolve * i);
      },
      [&](std::uint64_t, std::vector<Result>& some) {
        for (Result& one : some) results.push_back(std::move(one));
      });
  const bool largest = round->problem().objectives.front().sense == Sense::maximize;
  const auto improves = [&](const Result& a, const Result& b) {
    return largest && found(a) && found(b)
               ? a.evaluation.values.front() >
                     b.evaluation.values.front() + 1e-9 * std::abs(b.evaluation.values.front())
               : better(a, b);
  };
  std::size_t best = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    book(results[i]);
    if (improves(results[i], results[best])) best = i;
  }
  SolvedRound solved{round, std::move(results[best])};
  if (solved.result.certificate.passed || solved.result.design.empty() || stopped()) return solved;
  Result finished = search(round->problem(), number, solved.result.design, "auto", next_stage_);
  next_stage_ += kStagesOfASolve;
  book(finished);
  if (!improves(solved.result, finished)) solved.result = std::move(finished);
  return solved;
}

SolvedRound RobustSearch::solve(std::shared_ptr<const RobustRound> round,
                                std::span<const double> y) {
  Result result = search(round->problem(), y);
  return {std::move(round), std::move(result)};
}

SolvedRound RobustSearch::solve_again(const SolvedRound& from,
                                      const std::vector<RobustObjective>& goals,
                                      const std::vector<double>& risks) {
  return solve_again(from, goals, risks, from.round->correction().shifts);
}

SolvedRound RobustSearch::solve_again(const SolvedRound& from,
                                      const std::vector<RobustObjective>& goals,
                                      const std::vector<double>& risks,
                                      std::vector<double> shifts) {
  Correction correction = from.round->correction();
  correction.shifts = std::move(shifts);
  return solve(std::make_shared<const RobustRound>(problem_, goals, risks, std::move(correction),
                                                   options_.solve.seed),
               from.result.design);
}

// U5.8; a statistic whose limit holds keeps what it has.
std::vector<double> RobustSearch::shifts_after(const SolvedRound& solved,
                                               const Verification& seen) const {
  const RobustRound& round = *solved.round;
  std::vector<double> shifts = round.correction().shifts;
  if (seen.statistics.empty()) return shifts;
  const auto worst = round.points(solved.result.design);
  for (std::size_t s = 0; s < shifts.size(); ++s) {
    const StatisticTarget& target = problem_.statistics[s];
    if (verdict_on(target, seen.statistics[s]) == YieldVerdict::holds) continue;
    const Moment searched = round.statistic(solved.result.design, s, worst);
    if (searched.failure.empty())
      shifts[s] = statistic_shift(target, seen.statistics[s], searched.value);
  }
  return shifts;
}

// The law of measured rows is corrected at the design itself; how the correction changes with the design is not known (U4.4a).
Certificate RobustSearch::certified(const SolvedRound& solved) const {
  SolveOptions quiet = options_.solve;
  quiet.observer = {};
  Certificate found = certify(solved.round->problem(), solved.result.design, quiet);
  if (found.passed && !problem_.measured.empty() && risks_bind(*solved.round, found)) {
    found.passed = found.second_order = false;
    found.reason =
        "with measured parts the share that fails changes in steps; the search used a smooth "
        "law in their place, so another design may be slightly better";
  }
  return found;
}

// Centres at the worst products of a round, whose distance from the design is that of U3.2.
Centres RobustSearch::centres(const SolvedRound& solved) const {
  const auto& y = solved.result.design;
  const std::vector<double> beta = solved.round->betas(y);
  const auto x = design(solved);
  return {problem_,
          terms_,
          x,
          solved.round->points(y),
          take_part(terms_, beta),
          [this, x, beta](std::size_t term, std::span<const double> direction) {
            return inverse_form(problem_, terms_.terms[term].margin, x, beta[term], direction);
          }};
}

Verification RobustSearch::verified(const SolvedRound& solved, std::uint64_t products,
                                    std::uint64_t run) const {
  Verification seen = verify_products(problem_, terms_, design(solved), plan(products, 0), run,
                                      [this](const std::vector<YieldEstimate>& yields) {
                                        return all_far_above_wanted(problem_, yields);
                                      });
  if (!wants_rare(problem_) || stopped()) return seen;
  // The ways to fail that any of several samples shows are centres of all that then decide (U5.5).
  Centres centres = this->centres(solved);
  for (std::uint64_t scramble = 0; scramble < kScrambles && !stopped(); ++scramble)
    centres.sample(plan(kCoarse, kSoughtScrambles + kScrambles * run + scramble));
  return weighted(std::move(seen), terms_, [&](std::uint64_t scramble) {
    return centres.sample_unchanged(plan(kCoarse, kFreshScrambles + kScrambles * run + scramble));
  });
}

double RobustSearch::goal_at(const SolvedRound& solved) const {
  const RobustRound& old = *solved.round;
  const RobustRound round(problem_, problem_.goals, risks_of(old), old.correction(),
                          options_.solve.seed);
  const Evaluation answer = round.problem().evaluate(solved.result.design, false);
  return answer.ok() ? round.goal_value(answer.values.front())
                     : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> RobustSearch::risks_of(const RobustRound& round) const {
  std::vector<double> risks;
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s) risks.push_back(round.risk(s));
  return risks;
}

double RobustSearch::moved(const SolvedRound& from, const SolvedRound& to) const {
  double most = 0.0;
  for (std::size_t k = 0; k < problem_.design.variables.size(); ++k) {
    const Variable& v = problem_.design.variables[k];
    most = std::max(most, std::abs(place_in_range(v, from.result.design[k]) -
                                   place_in_range(v, to.result.design[k])));
  }
  return most;
}

// Where the multipliers are not known, they may be more than 0. A correction changes goals other than nominal ones.
bool RobustSearch::risks_bind(const SolvedRound& solved) const {
  return risks_bind(*solved.round, solved.result.certificate);
}

bool RobustSearch::risks_bind(const RobustRound& round, const Certificate& certificate) const {
  const auto& goals = round.goals();
  const bool nominal = std::all_of(goals.begin(), goals.end(), [](const RobustObjective& goal) {
    return goal.kind == RobustGoal::nominal;
  });
  if (!certificate.passed || !nominal) return true;
  const auto& own = problem_.design.constraints;
  return std::any_of(
      certificate.limits.begin(), certificate.limits.end(), [&](const Activity& limit) {
        const bool of_design =
            limit.is_bound || std::any_of(own.begin(), own.end(), [&](const Constraint& c) {
              return c.name == limit.name;
            });
        return !of_design && limit.active && limit.multiplier != 0.0;
      });
}

// U4.4a: a measured row is a share of the products. At a margin of exactly 0 rounding would decide whether all of them fail.
double RobustSearch::clearance(const ImportanceSample& sample, std::size_t term) const {
  constexpr double kClear = 1e-6;
  return problem_.measured.empty() ? 0.0 : kClear * weighted_spread(sample, term);
}

// U4.4a: the index at which the normal law has this margin is known from the design to others; what Newton's method leaves is
// added to the margin.
void RobustSearch::correct_law(const SolvedRound& solved, std::size_t term, double margin,
                               InversePoint at, Correction& next) const {
  constexpr int kSteps = 6;
  constexpr double kFarthest = 8.0;  // where the normal law ends
  const double beta = solved.round->betas(solved.result.design)[term];
  double index = beta + solved.round->correction().offsets[term];
  for (int i = 0; i < kSteps && at.by_beta != 0.0; ++i) {
    const double asked =
        std::clamp(index + (margin - at.at.value) / at.by_beta, -kFarthest, kFarthest);
    InversePoint found =
        inverse_form(problem_, terms_.terms[term].margin, design(solved), asked, at.direction);
    if (!found.at.failure.empty()) break;
    index = asked;
    at = std::move(found);
  }
  next.offsets[term] = index - beta;
  next.delta[term] = margin - at.at.value;
}

// The normal law of measured rows may be far from them, so the first round has a correction from the first start.
Correction RobustSearch::first_correction(const std::vector<RobustObjective>& goals,
                                          const std::vector<double>& risks) {
  const auto plain = std::make_shared<const RobustRound>(
      problem_, goals, risks, Correction::none(terms_), options_.solve.seed);
  if (problem_.measured.empty()) return plain->correction();
  SolvedRound begin{plain, {}};
  begin.result.design = plain->start(starts().front());
  for (const InversePoint& point : plain->points(begin.result.design))
    if (!point.at.failure.empty()) return plain->correction();
  return correction(begin, plan(kCoarse, 0));
}

// U4.4
Correction RobustSearch::correction(const SolvedRound& solved, const SamplePlan& plan) {
  const RobustRound& round = *solved.round;
  const auto beta = round.betas(solved.result.design);
  Centres centres = this->centres(solved);
  const ImportanceSample sample = centres.sample(plan);
  Correction next = Correction::none(terms_);
  next.shifts = round.correction().shifts;
  for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
    if (!centres.holds(j)) continue;
    next.directions[j] = centres.points()[j].direction;
    const double quantile = weighted_quantile(sample, j, beta[j]);
    if (!std::isfinite(quantile)) continue;
    if (problem_.measured.empty())
      next.delta[j] = quantile - centres.points()[j].at.value;
    else
      correct_law(solved, j, quantile - clearance(sample, j), centres.points()[j], next);
  }
  for (std::size_t s = 0; s < terms_.of_target.size(); ++s) {
    const auto& members = terms_.of_target[s];
    std::vector<double> own;
    std::vector<std::vector<double>> directions;
    for (const std::size_t j : members) {
      own.push_back(beta[j]);
      directions.push_back(centres.holds(j) ? centres.points()[j].direction
                                            : std::vector<double>{});
    }
    next.overlaps[s] = overlaps_of(own, directions);
    const SampledRisk risk = sampled_risk(sample, members);
    std::vector<double> sampled;
    for (const double p : risk.of_term) sampled.push_back(-normal_quantile(p));
    if (risk.any > 0.0) next.kappa[s] = joint_risk(sampled, next.overlaps[s]).risk / risk.any - 1.0;
    if (s == 0) last_risk_ = risk;
  }
  return next;
}

SolvedRound RobustSearch::correct_once(const SolvedRound& solved, std::uint64_t products,
                                       std::uint64_t replicate) {
  const RobustRound& old = *solved.round;
  const auto next = std::make_shared<const RobustRound>(
      problem_, old.goals(), risks_of(old), correction(solved, plan(products, replicate)),
      options_.solve.seed);
  if (stopped()) return solved;
  SolvedRound after = solve(next, solved.result.design);
  RobustRoundReport report{products, last_risk_.any, last_risk_.error, 0.0, 0.0};
  if (!next->correction().kappa.empty()) report.kappa = next->correction().kappa.front();
  if (!after.result.evaluation.values.empty())
    report.objective = next->goal_value(after.result.evaluation.values.front());
  reports_.push_back(report);
  return after;
}

SolvedRound RobustSearch::corrected(SolvedRound solved) {
  struct Level {
    std::uint64_t products;
    int rounds;
  };
  std::uint64_t replicate = 0;
  for (const Level level : {Level{kCoarse, 3}, Level{kFine, 2}}) {
    for (int round = 0; round < level.rounds; ++round) {
      SolvedRound next = correct_once(solved, level.products, replicate);
      if (stopped() || !next.feasible()) return next;
      const double still = moved(solved, next);
      const bool right = solved.round->seeks_yield() || terms_.of_target.empty() ||
                         std::abs(last_risk_.any - next.round->risk(0)) < 2.0 * last_risk_.error;
      solved = std::move(next);
      if (right && still < kDesignStill) break;
    }
    ++replicate;
  }
  return solved;
}

}  // namespace twum::inline v0_1::optim
