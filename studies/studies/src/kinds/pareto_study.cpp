// SPDX-License-Identifier: Apache-2.0
#include "kinds/search_study.hpp"
#include "study/solver_entry.hpp"

#include <twum/optim/certificate.hpp>
#include <twum/optim/pareto.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

// The best point of each goal.
std::vector<std::size_t> ends_of(const ParetoResult& result) {
  std::vector<std::size_t> ends;
  for (std::size_t k = 0; k < result.goals.size(); ++k) {
    const auto worse = [&](const auto& a, const auto& b) {
      return result.goals[k].maximize ? a.goals[k] > b.goals[k] : a.goals[k] < b.goals[k];
    };
    const auto best = std::min_element(result.front.begin(), result.front.end(), worse);
    ends.push_back(static_cast<std::size_t>(best - result.front.begin()));
  }
  return ends;
}

// Goals as losses between 0 at the best and 1 at the worst of the front. On the line (plane) through
// the ends they add up to 1; the knee is where they add up to the least.
std::size_t knee_of(const ParetoResult& result) {
  std::size_t knee = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < result.goals.size(); ++k) {
      const auto [low, high] = std::minmax_element(
          result.front.begin(), result.front.end(),
          [k](const auto& a, const auto& b) { return a.goals[k] < b.goals[k]; });
      const double span = high->goals[k] - low->goals[k];
      const double best = (result.goals[k].maximize ? high : low)->goals[k];
      if (span > 0) sum += std::fabs(result.front[i].goals[k] - best) / span;
    }
    if (sum < least) {
      least = sum;
      knee = i;
    }
  }
  return knee;
}

// A trade-off front: by gradients, or by an evolutionary search if the file says so.
class ParetoRun : public SearchRun {
 public:
  ParetoRun(const ParetoStudy& asked, const StudyFile& file)
      : SearchRun(
            file,
            {{}, asked.variables, asked.objectives, asked.constraints, asked.derived, asked.choose},
            asked.solver, asked.start),
        points_(asked.points) {}

  KindAnswer run(RunContext& context) override {
    SearchLog log(problem(), context);
    optim::SolveOptions solve = options(log, context);
    const optim::Front front = solve.solver == kNsga2 ? by_population(log.problem(), solve)
                                                      : by_gradients(log.problem(), solve);
    context.store.flush();
    return {outcome(front.outcome, context), answer(front)};
  }

 private:
  optim::Front by_gradients(const optim::Problem& problem, const optim::SolveOptions& solve) const {
    optim::ParetoOptions options;
    options.solve = solve;
    options.points = points_;
    return optim::pareto_front(problem, options);
  }

  optim::Front by_population(const optim::Problem& problem,
                             const optim::SolveOptions& solve) const {
    optim::Nsga2Options options;
    options.solve = solve;
    options.population = std::max<std::size_t>(4, points_ + points_ % 2);
    return optim::nsga2(problem, options);
  }

  ParetoResult answer(const optim::Front& front) const {
    const DesignReporter reports = reporter();
    ParetoResult result;
    result.goals = reports.goals();
    for (const optim::FrontPoint& point : front.points) {
      DesignReport report = reports.report(point.design, point.certificate);
      const auto& values = point.evaluation.values;
      result.front.push_back(
          {{values.begin(), values.begin() + static_cast<std::ptrdiff_t>(result.goals.size())},
           std::move(report),
           {}});
    }
    if (!result.front.empty()) {
      result.ends = ends_of(result);
      result.knee = knee_of(result);
      for (std::size_t k = 0; k < result.ends.size() && certified(front); ++k)
        result.alone.push_back(alone(k, front.points[result.ends[k]].design));
    }
    result.hypervolume = front.hypervolume;
    result.reference_point = front.reference;
    result.before_design = reports.design_of(before());
    result.before_metrics = reports.metrics_of(before());
    result.explanation = reports.explanation(front.infeasibility);
    return result;
  }

  // nsga2() certifies nothing.
  static bool certified(const optim::Front& front) {
    return std::any_of(front.points.begin(), front.points.end(),
                       [](const auto& p) { return !p.certificate.weights.empty(); });
  }

  // An end of the front is the optimum of one goal, and there the weights of the goals are not unique:
  // as many limits may meet as there are variables. So it is certified for that goal alone.
  DesignReport alone(std::size_t goal, const std::vector<double>& design) const {
    DesignProblem one = problem();
    one.objectives = {problem().objectives[goal]};
    return DesignReporter(one, {}).report(design, certificate(one, design));
  }

  std::size_t points_;
};

}  // namespace

std::unique_ptr<StudyKindRun> ParetoStudy::run(const StudyFile& file) const {
  return std::make_unique<ParetoRun>(*this, file);
}

}  // namespace twum::studies
