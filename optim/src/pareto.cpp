// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>

#include "causes.hpp"
#include "front_search.hpp"
#include "infeasibility.hpp"
#include "integer_front.hpp"
#include "polish.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::optim {
namespace {

std::vector<std::vector<double>> usual_starts(Campaign& campaign, std::size_t count) {
  std::vector<std::vector<double>> starts{campaign.unit_start()};
  const std::size_t n = campaign.scaling().size();
  if (n == 0 || count < 2) return starts;
  for (auto& u : sobol_points(n, count - 1, campaign.options().seed))
    starts.push_back(std::move(u));
  return starts;
}

// A population's front: some of it as starts for the ends, all of it as a pool for the rest.
void ask_population(const Problem& problem, const ParetoOptions& options, FrontSearch& search,
                    std::vector<std::vector<double>>& starts) {
  if (options.population_evaluations == 0) return;
  Campaign& campaign = search.campaign();
  Nsga2Options population;
  population.solve = campaign.options();
  population.solve.first_stage = campaign.next_stage();
  population.solve.budget.evaluations = campaign.left();
  population.solve.budget.seconds -= campaign.deadline().elapsed();
  const std::size_t in_all = options.population_evaluations / population.population;
  population.generations =
      std::max<std::size_t>(in_all, 1) - 1;  // the first population costs as much
  const Front front = nsga2(problem, population);
  Result used;
  used.counters = front.counters;
  used.stages_used = front.stages_used;
  used.stop = front.stop;
  campaign.book(used);
  const std::size_t step = std::max<std::size_t>(1, front.points.size() / 8);
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const auto unit = campaign.scaling().to_unit(front.points[i].design);
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

// A point that misses its certificate by a little is finished by Newton steps on the sum of the
// objectives with its own weights: that moves it along the front, if at all, by as little.
FrontPoint finished(Session& session, const Scaling& scaling, FrontPoint point) {
  const Certificate& c = point.certificate;
  if (c.passed || c.weights.empty() || c.stationarity > 1e-2 || session.left() == 0) return point;
  const auto better = polish(session, scaling, point.design, c.weights);
  if (!better || !near(scaling.to_unit(point.design), scaling.to_unit(*better))) return point;
  FrontPoint second = certified(session, scaling, *better, point.evaluation);
  return second.certificate.passed ? second : point;
}

void certify_points(FrontSearch& search, const std::vector<Solved>& solved, Front& front) {
  Campaign& campaign = search.campaign();
  Attempt stage;
  stage.session =
      std::make_unique<Session>(campaign.problem(), campaign.options(), campaign.deadline(),
                                campaign.take_stage(), campaign.left());
  for (const Solved& s : solved) {
    stage.session->remember(s.design, s.evaluation);
    FrontPoint point{s.design, s.evaluation, {}};
    try {
      point = certified(*stage.session, campaign.scaling(), s.design, s.evaluation);
      point = finished(*stage.session, campaign.scaling(), point);
    } catch (const Stop& stop) {
      stage.report.stop = stop.reason;
    }
    front.points.push_back(std::move(point));
  }
  campaign.book(stage);
}

// Finishing moves points a little: none may end up behind another.
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

// The ends of the front, if need be from the design that breaks the limits least, `least`.
bool find_ends(FrontSearch& search, const std::vector<std::vector<double>>& starts,
               std::optional<Candidate>& least) {
  if (search.find_ends(starts)) return true;
  Campaign& campaign = search.campaign();
  least = elastic_search(campaign, usual_starts(campaign, campaign.options().starts));
  const double tolerance = campaign.options().feasibility_tolerance;
  if (!least || least->f > tolerance || least->violation > tolerance) return false;
  return search.find_ends({least->z});
}

void explain(Campaign& campaign, const std::optional<Candidate>& least, Front& front) {
  front.outcome = Outcome::infeasible;
  if (least && campaign.options().analyse_infeasible)
    front.infeasibility = explain_infeasible(campaign, least->z);
  if (campaign.counters().all_failed() ||
      (campaign.exhausted() && front.infeasibility.relaxations.empty()))
    front.outcome = campaign.without_design();
  if (front.infeasibility.relaxations.empty()) return;
  SolveOptions rest = campaign.options();
  rest.first_stage = campaign.next_stage();
  Causes causes =
      find_causes(campaign.problem(), rest, campaign.deadline(),
                  cost_of_causes(campaign.counters(), rest.budget), std::move(front.infeasibility));
  front.infeasibility = std::move(causes.infeasibility);
  front.counters.add(causes.counters);
  front.stages_used = causes.stages_used;
}

void conclude(Campaign& campaign, Front& front) {
  const bool all = std::all_of(front.points.begin(), front.points.end(),
                               [](const FrontPoint& p) { return p.certificate.passed; });
  if (!front.points.empty()) {
    front.outcome = all ? Outcome::optimal : Outcome::feasible;
    if (campaign.exhausted()) front.outcome = Outcome::budget;
  }
  if (front.outcome == Outcome::budget)
    front.stop = campaign.stop_reason() == StopReason::finished ? StopReason::evaluations
                                                                : campaign.stop_reason();
  front.counters.add(campaign.counters());
  front.stages_used += campaign.next_stage() - campaign.options().first_stage;
  front.seconds = campaign.deadline().elapsed();
}

}  // namespace

Front pareto_front(const Problem& problem, const ParetoOptions& options) {
  validate_front(problem, options.reference);
  if (options.points == 0) throw InputError("a front of no points: `points` is at least 1");
  if (has_free_integers(problem)) return integer_front(problem, options);
  SolveOptions solve = options.solve;
  const Deadline deadline(solve.budget.seconds);
  FrontSearch search(problem, solve, options, deadline);
  Campaign& campaign = search.campaign();
  Front front;
  if (!campaign.scale()) {
    front.outcome = campaign.without_design();
    conclude(campaign, front);
    return front;
  }
  auto starts = usual_starts(campaign, solve.starts);
  ask_population(problem, options, search, starts);
  std::optional<Candidate> least;
  if (find_ends(search, starts, least)) {
    auto solved = problem.objectives.size() == 2 ? two_objective_front(search, options)
                                                 : three_objective_front(search, options);
    certify_points(search, best_spread(problem, options, std::move(solved)), front);
    drop_dominated(problem, front);
    measure(front, problem, options.reference);
  } else {
    explain(campaign, least, front);
  }
  conclude(campaign, front);
  return front;
}

}  // namespace twum::optim
