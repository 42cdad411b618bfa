// SPDX-License-Identifier: Apache-2.0
#include "problem/multi_start.hpp"

#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/scan.hpp>
#include <twum/optim/solvers.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

using optim::Outcome;

int rank(const optim::Result& result) {
  if (result.design.empty() || result.evaluation.values.empty()) return 0;
  return result.certificate.infeasibility > 1e-8 ? 1 : 2;
}

bool better(const optim::Result& a, const optim::Result& b, const optim::Problem& problem) {
  if (rank(a) != rank(b)) return rank(a) > rank(b);
  if (rank(a) == 0) return false;
  if (rank(a) == 1) return a.certificate.infeasibility < b.certificate.infeasibility;
  const double sign = problem.objectives.front().sense == optim::Sense::maximize ? -1.0 : 1.0;
  const double best = sign * b.evaluation.values.front();
  return sign * a.evaluation.values.front() < best - 1e-9 * std::fabs(best);
}

class MultiStart {
 public:
  MultiStart(const optim::Problem& problem, const optim::SolveOptions& options)
      : problem_(problem), options_(options) {}

  optim::Result run() {
    options_.analyse_infeasible = false;
    bool going = solve(optim::start_design(problem_));
    for (const auto& unit :
         optim::sobol_points(problem_.variables.size(), options_.starts - 1, options_.seed)) {
      if (!going) break;
      going = solve(optim::design_at(problem_, unit));
    }
    if (going && rank(best_) == 1) explain();
    best_.counters = total_.counters;
    best_.stages = total_.stages;
    best_.stages_used = total_.stages_used;
    best_.seconds = total_.seconds;
    return std::move(best_);
  }

 private:
  // False once the budget is used up.
  bool solve(const std::vector<double>& start) {
    const bool first = total_.stages_used == 0;
    optim::Result result = search(start);
    const bool stopped = result.stop != optim::StopReason::finished;
    if (first || better(result, best_, problem_)) best_ = std::move(result);
    if (stopped) end_here();
    return !stopped && total_.counters.evaluations < options_.budget.evaluations &&
           !options_.stop.stop_requested();
  }

  // One local search; what it cost is added to the total.
  optim::Result search(const std::vector<double>& start) {
    optim::Problem problem = problem_;
    for (std::size_t j = 0; j < start.size(); ++j) problem.variables[j].start = start[j];
    optim::SolveOptions options = options_;
    options.first_stage += total_.stages_used;
    options.budget.evaluations -= total_.counters.evaluations;
    optim::Result result = optim::solve(problem, options);
    total_.counters.add(result.counters);
    total_.stages.insert(total_.stages.end(), result.stages.begin(), result.stages.end());
    total_.stages_used += result.stages_used;
    total_.seconds += result.seconds;
    return result;
  }

  // Ends the search early; the answer so far stays.
  void end_here() {
    if (rank(best_) != 2) best_.outcome = Outcome::budget;
    best_.stop = options_.stop.stop_requested() ? optim::StopReason::requested
                                                : optim::StopReason::evaluations;
  }

  // If no start led to a feasible design, searches the reason from the least infeasible one. The explanation is kept
  // even if the design did not improve.
  void explain() {
    options_.analyse_infeasible = true;
    optim::Result result = search(best_.design);
    const bool stopped = result.stop != optim::StopReason::finished;
    if (!better(best_, result, problem_)) best_ = std::move(result);
    if (stopped) end_here();
  }

  const optim::Problem& problem_;
  optim::SolveOptions options_;
  optim::Result best_;
  optim::Result total_;
};

optim::Result local_searches(const optim::Problem& problem, const optim::SolveOptions& options) {
  const bool local = options.solver != "auto" && !optim::find_solver(options.solver).global;
  if (!local || options.starts < 2) return optim::solve(problem, options);
  return MultiStart(problem, options).run();
}

}  // namespace

optim::Result solve_from_starts(const optim::Problem& problem, const optim::SolveOptions& options) {
  return optim::look_further(problem, options, local_searches(problem, options));
}

}  // namespace twum::inline v0_1::studies
