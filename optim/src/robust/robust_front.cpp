// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/robust_front.hpp>

#include "fronts/front.hpp"
#include "robust/ray.hpp"
#include "robust/robust_search.hpp"
#include "robust/validate.hpp"
#include "robust/verification.hpp"

#include <twum/optim/hypervolume.hpp>

#include <algorithm>
#include <cmath>
#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::uint64_t kProductsOfARayRound[] = {4096, 16384};
constexpr int kMostStepsBack = 3;

// A point of the front in design and indices, with its round.
struct RefinedPoint {
  SolvedRound solved;
  Verification seen;
};

class RobustFrontSearch {
 public:
  RobustFrontSearch(const RobustProblem& problem, const RobustOptions& options)
      : problem_(problem),
        options_(options),
        search_(problem, options),
        aimed_(options.back_off ? aimed_risks(problem) : wanted_risks(problem)) {}

  RobustFront run(std::size_t points) {
    const auto round = std::make_shared<const RobustRound>(
        problem_, problem_.goals, aimed_, Correction::none(search_.terms()), options_.solve.seed);
    const std::vector<double> start =
        options_.starts.empty() ? start_design(problem_.design) : options_.starts.front();
    const Front form = search_.front(*round, points, start);
    find_spans(*round, form);
    std::vector<RefinedPoint> refined;
    for (const FrontPoint& point : form.points) {
      if (search_.stopped()) break;
      refined.push_back(refine(round, point));
    }
    RobustFront front = collected(refined);
    if (form.points.empty()) front.outcome = form.outcome;
    if (form.outcome == Outcome::infeasible) front.largest = largest_yield();
    if (search_.stopped()) front.outcome = Outcome::budget;
    front.counters.add(search_.counters());
    return front;
  }

 private:
  // The span of FORM's front in each goal, which is the direction of the rays.
  void find_spans(const RobustRound& round, const Front& form) {
    for (std::size_t k = 0; k < round.goals().size(); ++k) {
      const auto less = [k](const FrontPoint& a, const FrontPoint& b) {
        return a.evaluation.values[k] < b.evaluation.values[k];
      };
      if (form.points.empty()) return;
      const auto [least, most] = std::minmax_element(form.points.begin(), form.points.end(), less);
      const double low = least->evaluation.values[k], high = most->evaluation.values[k];
      spans_.push_back(high > low ? high - low : 1.0 + std::abs(high));
    }
  }

  // Corrects and verifies a point, and moves it back until an independent sample confirms its yield.
  RefinedPoint refine(const std::shared_ptr<const RobustRound>& round, const FrontPoint& point) {
    RefinedPoint at{{round, {}}, {}};
    at.solved.result.design = point.design;
    at.solved.result.evaluation = point.evaluation;
    at.solved.result.certificate = point.certificate;
    const std::vector<double> f(
        point.evaluation.values.begin(),
        point.evaluation.values.begin() + static_cast<std::ptrdiff_t>(spans_.size()));
    std::vector<double> risks = aimed_;
    std::uint64_t replicate = 0;
    for (const std::uint64_t products : kProductsOfARayRound)
      at.solved = along_ray(at.solved, f, risks, search_.plan(products, replicate++));
    for (int run = 0;; ++run) {
      at.seen = search_.verified(at.solved, products_for_rarest(limited_risks()), next_stream_++);
      const bool holds = worst_verdict(problem_, at.seen) == YieldVerdict::holds;
      if (holds || search_.stopped() || !options_.back_off || run == kMostStepsBack) break;
      risks = backed_off(problem_, std::move(risks), at.seen);
      at.solved = along_ray(at.solved, f, risks, search_.plan(kProductsOfARayRound[1], 1),
                            search_.shifts_after(at.solved, at.seen));
    }
    drop_values(at.seen);
    if (!search_.stopped()) at.solved.result.certificate = search_.certified(at.solved);
    return at;
  }

  // The next round of a point: corrected by a sample about it, and solved along the ray through f. If that finds no
  // design, the point is unchanged.
  SolvedRound along_ray(const SolvedRound& at, const std::vector<double>& f,
                        const std::vector<double>& risks, const SamplePlan& plan,
                        std::vector<double> shifts = {}) {
    Correction correction = search_.correction(at, plan);
    if (!shifts.empty()) correction.shifts = std::move(shifts);
    const auto next = std::make_shared<const RobustRound>(
        problem_, problem_.goals, risks, std::move(correction), options_.solve.seed);
    if (search_.stopped()) return at;
    std::vector<double> start = at.result.design;
    start.push_back(0.0);
    const Result found = search_.search(ray_problem(next->problem(), f, spans_), start);
    SolvedRound solved{next, found};
    if (!solved.feasible()) return at;
    solved.result.design.pop_back();
    solved.result.evaluation = next->problem().evaluate(solved.result.design, true);
    return solved.result.evaluation.ok() ? solved : at;
  }

  // Wanted risks; a yield that is a goal has none.
  std::vector<double> limited_risks() const {
    std::vector<double> risks;
    for (const YieldTarget& target : problem_.yields)
      if (target.at_least > 0.0 && target.at_least < 1.0) risks.push_back(1.0 - target.at_least);
    return risks;
  }

  // Drops the responses that no statistic needs, because they are many numbers.
  void drop_values(Verification& seen) const {
    for (std::size_t r = 0; r < seen.values.size(); ++r)
      if (std::none_of(problem_.statistics.begin(), problem_.statistics.end(),
                       [r](const StatisticTarget& s) { return s.response == r; }))
        seen.values[r] = {};
  }

  // Goals in their own units, of which none dominates another, in order of the first.
  RobustFront collected(const std::vector<RefinedPoint>& refined) const {
    Problem goals;
    for (const RobustObjective& goal : problem_.goals)
      goals.objectives.push_back({"goal " + std::to_string(goals.objectives.size()), sense(goal)});
    Front measured;
    RobustFront front;
    front.outcome = Outcome::optimal;
    std::vector<std::vector<double>> turned;
    for (const RefinedPoint& point : refined) {
      RobustFrontPoint told;
      const auto x = search_.design(point.solved);
      told.design.assign(x.begin(), x.end());
      for (std::size_t k = 0; k < spans_.size(); ++k)
        told.goals.push_back(
            point.solved.round->goal_value(point.solved.result.evaluation.values[k], k));
      told.certificate = point.solved.result.certificate;
      told.verification = point.seen;
      told.verdict = worst_verdict(problem_, point.seen);
      measured.points.push_back({told.design, {told.goals, {}, {}, {}}, {}});
      turned.push_back(minimized(goals, measured.points.back().evaluation));
      front.points.push_back(std::move(told));
    }
    keep(front.points, measured.points, turned);
    measure(measured, goals, {});
    front.hypervolume = measured.hypervolume;
    front.reference = measured.reference;
    for (const RobustFrontPoint& point : front.points)
      if (!point.certificate.passed || point.verdict != YieldVerdict::holds)
        front.outcome = Outcome::feasible;
    return front;
  }

  Sense sense(const RobustObjective& goal) const {
    if (goal.kind == RobustGoal::nominal) return problem_.design.objectives[goal.index].sense;
    return goal.kind == RobustGoal::yield ? Sense::maximize : goal.sense;
  }

  static void keep(std::vector<RobustFrontPoint>& points, std::vector<FrontPoint>& measured,
                   const std::vector<std::vector<double>>& turned) {
    std::vector<std::size_t> order = nondominated(turned);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return points[a].goals[0] < points[b].goals[0];
    });
    std::vector<RobustFrontPoint> left;
    std::vector<FrontPoint> left_measured;
    for (const std::size_t i : order) {
      left.push_back(std::move(points[i]));
      left_measured.push_back(std::move(measured[i]));
    }
    points = std::move(left);
    measured = std::move(left_measured);
  }

  // Products of the design of largest yield; its rounds and stages follow those of the front.
  Verification largest_yield() const {
    if (problem_.yields.empty()) return {};
    RobustProblem one = problem_;
    one.goals = {{RobustGoal::yield, 0}};
    RobustOptions options = options_;
    options.solve.first_stage = search_.next_stage();
    const std::uint64_t first = search_.next_round();
    if (options_.recall)
      options.recall = [this, first](std::uint64_t round, std::span<const double> y, bool gradient,
                                     const Evaluator& evaluate) {
        return options_.recall(first + round, y, gradient, evaluate);
      };
    if (options_.observer)
      options.observer = [this, first](std::uint64_t round, const Observation& observation) {
        options_.observer(first + round, observation);
      };
    return solve_robust(one, options).verification;
  }

  const RobustProblem& problem_;
  const RobustOptions& options_;
  RobustSearch search_;
  std::vector<double> aimed_;
  std::vector<double> spans_;
  std::uint64_t next_stream_{0};
};

}  // namespace

RobustFront solve_robust_front(const RobustProblem& problem, std::size_t points,
                               const RobustOptions& options) {
  validate_robust(problem);
  if (problem.goals.size() < 2) throw InputError("a front has two or three goals");
  return RobustFrontSearch(problem, options).run(points);
}

}  // namespace twum::inline v0_1::optim
