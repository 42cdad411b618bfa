// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/solve.hpp>

#include <twum/optim/low_discrepancy.hpp>

#include "causes.hpp"
#include "infeasibility.hpp"
#include "integer_search.hpp"
#include "solve_continuous.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <twum/base/error.hpp>

namespace twum::optim {
namespace {

// One solve on continuous variables (integer ones are fixed by their bounds).
class ContinuousSolve {
 public:
  ContinuousSolve(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                  const Ladder& ladder)
      : runner_(problem, options, deadline), options_(options), ladder_(ladder) {}

  Result run() {
    if (runner_.scale()) {
      if (options_.solver == "auto")
        automatic();
      else
        named(find_optimizer(options_.solver));
    }
    return conclude();
  }

 private:
  static constexpr int kAgain = 5;

  bool feasible(const SolverRun& a) const {
    return a.best && a.best->violation <= options_.feasibility_tolerance;
  }
  bool passed() const { return best_.certified && best_.certified->certificate.passed; }

  void named(const Optimizer& optimizer) {
    best_ = runner_.run(optimizer, runner_.unit_start(), true);
    runner_.finish(best_);
    // A local solver that stopped short is restarted where it stopped, because its history (asymptotes, Hessian)
    // often causes that.
    for (int again = 0; again < kAgain && !optimizer.info.global; ++again) {
      if (passed() || cut_short() || !best_.best) return;
      SolverRun run = runner_.run(optimizer, runner_.scaling().to_unit(best_.design), true);
      runner_.finish(run);
      const bool better = run.best && clearly_better(*run.best, *best_.best);
      offer(std::move(run));
      if (!better) return;
    }
  }

  void automatic() {
    if (!options_.global.empty()) globally();
    SolverRun first = best_of(runner_.run_all(find_optimizer("nlopt:slsqp"), starts()));
    runner_.finish(first);
    offer(std::move(first));
    climb();
    if (!feasible(best_)) restore();
  }

  // The global search uses half of the budget; the rest is for the local searches after it.
  void globally() {
    const Optimizer& optimizer = find_optimizer(options_.global);
    if (!optimizer.info.global)
      throw InputError("solver '" + options_.global + "' does not search globally");
    const SolverPlan plan{&optimizer, runner_.take_stage(), runner_.left() / 2,
                          runner_.unit_start()};
    best_ = run_solver(runner_.problem(), options_, runner_.deadline(), runner_.scaling(),
                       plain_formulation(runner_.problem(), runner_.scaling()), plan);
    best_.report.stop = StopReason::finished;  // its share was used up, not the budget
    runner_.book(best_);
  }

  std::vector<std::vector<double>> starts() const {
    std::vector<std::vector<double>> list{runner_.unit_start()};
    if (best_.best) list.insert(list.begin(), runner_.scaling().to_unit(best_.design));
    const std::size_t n = runner_.scaling().size();
    if (n == 0) return list;
    const std::size_t more = std::max<std::size_t>(options_.starts, 1) - 1;
    for (auto& u : sobol_points(n, more, options_.seed)) list.push_back(std::move(u));
    return list;
  }

  SolverRun best_of(std::vector<SolverRun> runs) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (!runs[i].best) continue;
      if (!runs[best].best || clearly_better(*runs[i].best, *runs[best].best)) best = i;
    }
    return std::move(runs[best]);
  }

  // Differences within the solvers' own accuracy do not count: the first of equals wins.
  bool clearly_better(const Candidate& a, const Candidate& b) const {
    const double t = options_.feasibility_tolerance;
    if (a.violation <= t && b.violation <= t) return a.f < b.f - 1e-10 * (1.0 + std::abs(b.f));
    return better(a, b, t);
  }

  void offer(SolverRun run) {
    if (!run.best) return;
    const bool first = !best_.best;
    const bool certifies = run.certified && run.certified->certificate.passed;
    const bool equal = !first && !clearly_better(*best_.best, *run.best);
    if (first || clearly_better(*run.best, *best_.best) || (certifies && !passed() && equal))
      best_ = std::move(run);
  }

  // Each solver of the sequence starts from the best design. The first certified design ends it.
  void climb() {
    for (const std::string& name : ladder_.rungs) {
      if (runner_.exhausted() || runner_.scaling().size() == 0) return;
      if (passed() && !ladder_.to_the_top) return;
      const Optimizer& optimizer = find_optimizer(name);
      if (!optimizer.info.available) continue;
      const auto start =
          best_.best ? runner_.scaling().to_unit(best_.design) : runner_.unit_start();
      SolverRun run = runner_.run(optimizer, start, true);
      runner_.finish(run);
      offer(std::move(run));
      const bool top = ladder_.to_the_top;
      if (!feasible(best_) && name == "ipopt" && !top) return;  // feasibility comes first
    }
  }

  // If no feasible design is known, searches for feasibility only and continues from there.
  void restore() {
    if (runner_.exhausted()) return;
    auto from = starts();
    if (best_.best) from.insert(from.begin(), runner_.scaling().to_unit(best_.design));
    const auto found = elastic_search(runner_, from);
    if (!found) return;
    least_infeasible_ = found->z;
    if (runner_.exhausted()) return;
    SolverRun run = runner_.run(find_optimizer("nlopt:slsqp"), found->z, true);
    if (!feasible(run)) return;
    runner_.finish(run);
    offer(std::move(run));
    climb();
  }

  Outcome outcome() const {
    if (!best_.best) return runner_.without_design();
    const bool ok = feasible(best_) ||
                    (best_.certified &&
                     best_.certified->certificate.infeasibility <= options_.feasibility_tolerance);
    if (ok && passed()) return Outcome::optimal;
    if (cut_short()) return Outcome::budget;
    return ok ? Outcome::feasible : Outcome::infeasible;
  }

  bool cut_short() const {
    return runner_.exhausted() ||
           (options_.solver != "auto" && runner_.stop_reason() != StopReason::finished);
  }

  Result conclude() {
    Result result;
    result.outcome = outcome();
    if (result.outcome == Outcome::infeasible && options_.analyse_infeasible) explain(result);
    result.stop = result.outcome == Outcome::budget ? runner_.stop_reason() : StopReason::finished;
    if (result.outcome == Outcome::budget && result.stop == StopReason::finished)
      result.stop = StopReason::evaluations;
    result.design = best_.design;
    if (best_.certified) {
      result.certificate = best_.certified->certificate;
      result.evaluation = best_.certified->point.evaluation;
    } else {
      result.certificate.reason = best_.best || !runner_.counters().all_failed()
                                      ? kCutShort
                                      : "no design could be evaluated";
    }
    if (best_.solver != nullptr) result.solver = best_.solver->name;
    result.counters = runner_.counters();
    std::erase_if(result.counters.failures, [](const auto& f) { return f.second == 0; });
    result.stages = runner_.stages();
    result.stages_used = runner_.next_stage() - options_.first_stage;
    result.seconds = runner_.deadline().elapsed();
    return result;
  }

  void explain(Result& result) {
    std::vector<double> unit = least_infeasible_;
    if (unit.empty()) {  // for a solver chosen by name, the elastic solve starts from its answer
      const auto found = elastic_search(runner_, {runner_.scaling().to_unit(best_.design)});
      if (!found) return;
      unit = found->z;
    }
    result.infeasibility = explain_infeasible(runner_, unit);
    move_to(result.infeasibility.design);
    if (!result.infeasibility.relaxations.empty()) return;
    // The elastic solve found a feasible design, or the budget ended before it could decide.
    result.outcome = outcome();
    result.infeasibility = {};
  }

  // Returns the least infeasible design, if the budget allows its evaluation.
  void move_to(const std::vector<double>& design) {
    SolverRun look;
    look.session = std::make_unique<Session>(runner_.problem(), options_, runner_.deadline(),
                                             runner_.take_stage(), runner_.left());
    try {
      if (auto certified = certify_in(*look.session, runner_.scaling(), design)) {
        best_.design = design;
        best_.certified = std::move(certified);
      }
    } catch (const Stop&) {
    }
    runner_.book(look);
  }

  StageRunner runner_;
  const SolveOptions& options_;
  const Ladder& ladder_;
  SolverRun best_;
  std::vector<double> least_infeasible_;
};

// Observers need not be thread-safe: a lock serializes their calls.
Observer serialized(const Observer& observer) {
  if (!observer) return {};
  auto lock = std::make_shared<std::mutex>();
  return [observer, lock](const Observation& o) {
    const std::lock_guard<std::mutex> guard(*lock);
    observer(o);
  };
}

void complete_explanation(const Problem& problem, const SolveOptions& options,
                          const Deadline& deadline, Result& result) {
  SolveOptions rest = options;
  rest.first_stage += result.stages_used;
  Causes causes =
      find_causes(problem, rest, deadline, cost_of_causes(result.counters, options.budget),
                  std::move(result.infeasibility));
  result.infeasibility = std::move(causes.infeasibility);
  result.counters.add(causes.counters);
  result.stages_used += causes.stages_used;
  result.seconds = deadline.elapsed();
}

}  // namespace

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::optimal: return "optimal";
    case Outcome::feasible: return "feasible";
    case Outcome::infeasible: return "infeasible";
    case Outcome::budget: return "budget";
    case Outcome::failed: return "failed";
  }
  return "unknown";
}

Result solve_continuous(const Problem& problem, const SolveOptions& options,
                        const Deadline& deadline, const Ladder& ladder) {
  return ContinuousSolve(problem, options, deadline, ladder).run();
}

Result solve_plainly(const Problem& problem, const SolveOptions& options,
                     const Deadline& deadline) {
  const bool integers = std::any_of(problem.variables.begin(), problem.variables.end(),
                                    [](const Variable& v) { return v.integer; });
  return integers ? integer_search(problem, options, deadline)
                  : solve_continuous(problem, options, deadline);
}

Result solve(const Problem& problem, const SolveOptions& options) {
  validate(problem);
  if (problem.objectives.size() != 1)
    throw InputError("solve: the problem has " + std::to_string(problem.objectives.size()) +
                     " objectives; a front needs pareto_front");
  if (options.solver != "auto") find_optimizer(options.solver);
  if (!options.global.empty()) find_optimizer(options.global);
  SolveOptions own = options;
  own.observer = serialized(options.observer);
  const Deadline deadline(options.budget.seconds);
  Result result = solve_plainly(problem, own, deadline);
  if (!result.infeasibility.relaxations.empty())
    complete_explanation(problem, own, deadline, result);
  return result;
}

}  // namespace twum::optim
