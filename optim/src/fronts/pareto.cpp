// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>

#include "certificate/polish.hpp"
#include "fronts/front_search.hpp"
#include "fronts/integer_front.hpp"
#include "search/causes.hpp"
#include "search/infeasibility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::inline v0_1::optim {
namespace {

std::vector<std::vector<double>> usual_starts(StageRunner& runner, std::size_t count) {
  std::vector<std::vector<double>> starts{runner.unit_start()};
  const std::size_t n = runner.scaling().size();
  if (n == 0 || count < 2) return starts;
  for (auto& u : sobol_points(n, count - 1, runner.options().seed)) starts.push_back(std::move(u));
  return starts;
}

// Runs NSGA-II. Some points of its front start the search for the ends, all serve as starts for the other points.
void ask_population(const Problem& problem, const ParetoOptions& options, FrontSearch& search,
                    std::vector<std::vector<double>>& starts) {
  if (options.population_evaluations == 0) return;
  StageRunner& runner = search.runner();
  Nsga2Options population;
  population.solve = runner.options();
  population.solve.first_stage = runner.next_stage();
  population.solve.budget.evaluations = runner.left();
  population.solve.budget.seconds -= runner.deadline().elapsed();
  const std::size_t in_all = options.population_evaluations / population.population;
  population.generations =
      std::max<std::size_t>(in_all, 1) - 1;  // the first population costs as much
  const Front front = nsga2(problem, population);
  Result used;
  used.counters = front.counters;
  used.stages_used = front.stages_used;
  used.stop = front.stop;
  runner.book(used);
  const std::size_t step = std::max<std::size_t>(1, front.points.size() / 8);
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const auto unit = runner.scaling().to_unit(front.points[i].design);
    search.add_to_pool(unit, front.points[i].evaluation);
    if (i % step == 0 || i + 1 == front.points.size()) starts.push_back(unit);
  }
}

std::vector<Solved> best_spread(const Problem& problem, const ParetoOptions& options,
                                std::vector<Solved> all) {
  if (all.size() <= options.points) return all;
  std::vector<std::vector<double>> values;
  Front whole;
  for (const Solved& s : all) {
    values.push_back(minimized(problem, s.evaluation));
    whole.points.push_back({s.design, s.evaluation, {}});
  }
  measure(whole, problem, options.reference);
  std::vector<double> reference = whole.reference;
  for (std::size_t k = 0; k < reference.size(); ++k)
    if (problem.objectives[k].sense == Sense::maximize) reference[k] = -reference[k];
  std::vector<Solved> kept;
  const bool with_ends = problem.objectives.size() == 2 && options.points > 1;
  const auto chosen = with_ends ? best_subset(values, options.points, reference)
                                : greedy_subset(values, options.points, reference);
  for (const std::size_t i : chosen) kept.push_back(std::move(all[i]));
  return kept;
}

FrontPoint certified(Session& session, const Scaling& scaling, const std::vector<double>& design,
                     const Evaluation& evaluation) {
  FrontPoint point{design, evaluation, {}};
  if (auto c = certify_in(session, scaling, design, false)) {
    point.certificate = std::move(c->certificate);
    point.evaluation = c->point.evaluation;
  }
  return point;
}

bool near(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kLittle = 1e-3;  // of the box
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::abs(a[k] - b[k]) > kLittle) return false;
  return true;
}

// The design with every variable that is within a millionth of its range from a bound on that bound.
std::vector<double> on_its_bounds(const Scaling& ranges, std::span<const double> design) {
  constexpr double kNear = 1e-6;
  std::vector<double> unit = ranges.to_unit(design);
  for (double& u : unit) u = u < kNear ? 0.0 : u > 1.0 - kNear ? 1.0 : u;
  return ranges.to_design(unit);
}

// Improves a point that narrowly misses its certificate, by Newton steps on the weighted sum of objectives or by
// placing it on its bounds. Both hardly move it along the front.
FrontPoint finished(Session& session, const Scaling& scaling, FrontPoint point) {
  const Certificate& c = point.certificate;
  if (c.passed || c.weights.empty() || c.stationarity > 1e-2 || session.left() == 0) return point;
  std::vector<std::vector<double>> others;
  if (auto better = polish(session, scaling, point.design, c.weights))
    others.push_back(std::move(*better));
  others.push_back(on_its_bounds(scaling, point.design));
  for (const auto& design : others) {
    if (design == point.design || session.left() == 0) continue;
    if (!near(scaling.to_unit(point.design), scaling.to_unit(design))) continue;
    FrontPoint second = certified(session, scaling, design, point.evaluation);
    if (second.certificate.passed) return second;
  }
  return point;
}

void certify_points(FrontSearch& search, const std::vector<Solved>& solved, Front& front) {
  StageRunner& runner = search.runner();
  SolverRun stage;
  stage.session = std::make_unique<Session>(runner.problem(), runner.options(), runner.deadline(),
                                            runner.take_stage(), runner.left());
  for (const Solved& s : solved) {
    stage.session->remember(s.design, s.evaluation);
    FrontPoint point{s.design, s.evaluation, {}};
    try {
      point = certified(*stage.session, runner.scaling(), s.design, s.evaluation);
      point = finished(*stage.session, runner.scaling(), point);
    } catch (const Stop& stop) {
      stage.report.stop = stop.reason;
    }
    front.points.push_back(std::move(point));
  }
  runner.book(stage);
}

// Removes points that became dominated by the last Newton steps.
void drop_dominated(const Problem& problem, Front& front) {
  std::vector<std::vector<double>> values;
  for (const auto& p : front.points) values.push_back(minimized(problem, p.evaluation));
  std::vector<FrontPoint> kept;
  for (const std::size_t i : nondominated(values)) kept.push_back(std::move(front.points[i]));
  std::stable_sort(kept.begin(), kept.end(), [&](const auto& a, const auto& b) {
    return minimized(problem, a.evaluation) < minimized(problem, b.evaluation);
  });
  front.points = std::move(kept);
}

// Finds the ends of the front, if necessary from the least infeasible design `least`.
bool find_ends(FrontSearch& search, const std::vector<std::vector<double>>& starts,
               std::optional<Candidate>& least) {
  if (search.find_ends(starts)) return true;
  StageRunner& runner = search.runner();
  least = elastic_search(runner, usual_starts(runner, runner.options().starts));
  const double tolerance = runner.options().feasibility_tolerance;
  if (!least || least->f > tolerance || least->violation > tolerance) return false;
  return search.find_ends({least->z});
}

void explain(StageRunner& runner, const std::optional<Candidate>& least, Front& front) {
  front.outcome = Outcome::infeasible;
  if (least && runner.options().analyse_infeasible)
    front.infeasibility = explain_infeasible(runner, least->z).report;
  if (runner.counters().all_failed() ||
      (runner.exhausted() && front.infeasibility.relaxations.empty()))
    front.outcome = runner.without_design();
  if (front.infeasibility.relaxations.empty()) return;
  SolveOptions rest = runner.options();
  rest.first_stage = runner.next_stage();
  Causes causes =
      find_causes(runner.problem(), rest, runner.deadline(),
                  cost_of_causes(runner.counters(), rest.budget), std::move(front.infeasibility));
  front.infeasibility = std::move(causes.infeasibility);
  front.counters.add(causes.counters);
  front.stages_used = causes.stages_used;
}

void conclude(FrontSearch& search, Front& front) {
  StageRunner& runner = search.runner();
  const bool all = std::all_of(front.points.begin(), front.points.end(),
                               [](const FrontPoint& p) { return p.certificate.passed; });
  if (!front.points.empty()) {
    front.outcome = all ? Outcome::optimal : Outcome::feasible;
    if (search.exhausted()) front.outcome = Outcome::budget;
  }
  if (front.outcome == Outcome::budget)
    front.stop = runner.stop_reason() == StopReason::finished ? StopReason::evaluations
                                                              : runner.stop_reason();
  front.counters.add(runner.counters());
  front.stages_used += runner.next_stage() - runner.options().first_stage;
  front.seconds = runner.deadline().elapsed();
}

}  // namespace

Front pareto_front(const Problem& problem, const ParetoOptions& options) {
  validate_front(problem, options.reference);
  validate(options.solve);
  if (options.points == 0) throw InputError("a front of no points: `points` is at least 1");
  if (has_free_integers(problem)) return integer_front(problem, options);
  SolveOptions solve = options.solve;
  const Deadline deadline(solve.budget.seconds);
  FrontSearch search(problem, solve, options, deadline);
  StageRunner& runner = search.runner();
  Front front;
  if (!runner.scale()) {
    front.outcome = runner.without_design();
    conclude(search, front);
    return front;
  }
  auto starts = usual_starts(runner, solve.starts);
  ask_population(problem, options, search, starts);
  std::optional<Candidate> least;
  if (find_ends(search, starts, least)) {
    auto solved = problem.objectives.size() == 2 ? two_objective_front(search, options)
                                                 : three_objective_front(search, options);
    certify_points(search, best_spread(problem, options, std::move(solved)), front);
    drop_dominated(problem, front);
    measure(front, problem, options.reference);
  } else {
    explain(runner, least, front);
  }
  conclude(search, front);
  return front;
}

}  // namespace twum::inline v0_1::optim
