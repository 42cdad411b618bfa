// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/solve.hpp>

#include <twum/optim/low_discrepancy.hpp>

#include "search/causes.hpp"
#include "search/infeasibility.hpp"
#include "search/integer_search.hpp"
#include "search/range_sample.hpp"
#include "search/solve_continuous.hpp"
#include "search/without_derivatives.hpp"
#include "solvers/allowance.hpp"

#include <algorithm>
#include <cmath>
#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {
namespace {

// The problem within so many sizes of a design: where other starts lie does not depend on the width of a range that is
// far wider than that.
Problem surroundings(const Problem& problem, const std::vector<double>& design, double sizes) {
  Problem near = problem;
  for (std::size_t j = 0; j < design.size(); ++j) {
    Variable& v = near.variables[j];
    if (v.scale == Scale::log) continue;
    const double size = std::max(std::abs(design[j]), std::min(1.0, v.upper - v.lower));
    v.lower = std::max(v.lower, design[j] - sizes * size);
    v.upper = std::min(v.upper, design[j] + sizes * size);
  }
  return near;
}

// One solve on continuous variables (integer ones are fixed by their bounds).
class ContinuousSolve {
 public:
  ContinuousSolve(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                  const Ladder& ladder)
      : runner_(problem, options, deadline), options_(options), ladder_(ladder) {}

  Result run() {
    if (runner_.scale(StageRunner::Frame::point)) {
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

  // Where a search goes on from: what a probe found beside a stationary point, or the best design.
  const std::vector<double>& onward() const {
    if (best_.certified && best_.certified->better) return *best_.certified->better;
    return best_.best ? best_.design : runner_.start();
  }

  // A local solver that stopped short is started again where it stopped, scaled there, because its history
  // (asymptotes, Hessian) and its scales often cause that.
  void named(const Optimizer& optimizer) {
    best_ = runner_.run(optimizer, runner_.start(), true);
    runner_.finish(best_);
    for (int again = 0; again < kAgain && !optimizer.info.global; ++again)
      if (passed() || cut_short() || !best_.best || !climb_on(optimizer)) return;
  }

  // One more run from the best design. False if that was of no use.
  bool climb_on(const Optimizer& optimizer) {
    const bool found = best_.certified && best_.certified->better;
    SolverRun run = runner_.run(optimizer, onward(), true);
    runner_.finish(run);
    const bool better = run.best && clearly_better(run, best_);
    keep_if_better(std::move(run));
    return better || passed() || found;
  }

  void automatic() {
    if (!options_.global.empty()) globally();
    SolverRun first = runner_.run(find_optimizer("nlopt:slsqp"), onward(), true);
    runner_.finish(first);
    keep_if_better(std::move(first));
    if (!(passed() && looks_convex())) try_other_starts();
    climb_ladder();
    if (!feasible(best_)) restore();
  }

  // If the first half of the starts lead to one certified optimum, the others are left out.
  void try_other_starts() {
    const auto others = starts();
    const auto middle = others.begin() + std::ptrdiff_t((others.size() + 1) / 2);
    if (!lead_to_the_known({others.begin(), middle})) lead_to_the_known({middle, others.end()});
  }

  // Searches from these designs. True if all of them come to the certified optimum that is known.
  bool lead_to_the_known(const std::vector<std::vector<double>>& designs) {
    if (designs.empty() || runner_.exhausted()) return true;
    std::vector<double> known;
    if (passed()) known = best_.design;
    auto runs = runner_.run_all(find_optimizer("nlopt:slsqp"), designs, known);
    const bool agree = std::ranges::all_of(
        runs, [](const SolverRun& run) { return run.report.word == kKnownOptimum; });
    SolverRun run = best_of(std::move(runs));
    if (best_.best && !clearly_better(run, best_) && passed()) return agree;
    runner_.finish(run);
    keep_if_better(std::move(run));
    return agree;
  }

  // The global search uses half of the budget; the rest is for the local searches after it.
  void globally() {
    const Optimizer& optimizer = find_optimizer(options_.global);
    if (!optimizer.info.global)
      throw InputError("solver '" + options_.global + "' does not search globally");
    const Scaling ranges = runner_.ranges();
    const SolverPlan plan{&optimizer, runner_.take_stage(), runner_.left() / 2,
                          ranges.to_unit(runner_.start())};
    best_ = run_solver(runner_.problem(), options_, runner_.deadline(), ranges,
                       plain_formulation(runner_.problem(), ranges), plan);
    best_.report.stop = StopReason::finished;  // its share was used up, not the budget
    runner_.book(best_);
  }

  // Designs of a low-discrepancy sequence about the start; the start itself comes first if a global search took its
  // place.
  std::vector<std::vector<double>> starts() const {
    std::vector<std::vector<double>> list;
    if (!options_.global.empty()) list.push_back(runner_.start());
    const std::size_t n = runner_.scaling().size();
    if (n == 0) return list;
    // Every other one is nearer, where a wide region would show the growth of the functions far away only.
    const Scaling far(surroundings(runner_.problem(), runner_.start(), 10.0));
    const Scaling near(surroundings(runner_.problem(), runner_.start(), 2.0));
    const std::size_t more = std::max<std::size_t>(options_.starts, 1) - 1;
    for (const auto& u : sobol_points(n, more, options_.seed))
      list.push_back(list.size() % 2 == 0 ? far.to_design(u) : near.to_design(u));
    return list;
  }

  // Whether the other starts contradict nowhere that objective and limits are convex: then they would lead to the same
  // optimum.
  bool looks_convex() {
    const auto others = starts();
    if (others.empty() || runner_.exhausted()) return true;
    return runner_.looks_convex(*best_.certified, others);
  }

  SolverRun best_of(std::vector<SolverRun> runs) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (!runs[i].best) continue;
      if (!runs[best].best || clearly_better(runs[i], runs[best])) best = i;
    }
    return std::move(runs[best]);
  }

  double objective(const Candidate& a) const {
    const bool maximize = runner_.problem().objectives[0].sense == Sense::maximize;
    return maximize ? -a.values[0] : a.values[0];
  }

  // Differences within the solvers' own accuracy do not count: the first of equals wins.
  bool clearly_better(const SolverRun& a, const SolverRun& b) const {
    if (!a.best || !b.best) return a.best.has_value();
    if (feasible(a) != feasible(b)) return feasible(a);
    if (!feasible(a)) return runner_.excess(a.best->values) < runner_.excess(b.best->values);
    const double size = std::max(std::abs(objective(*a.best)), std::abs(objective(*b.best)));
    return objective(*a.best) < objective(*b.best) - 1e-10 * size;
  }

  void keep_if_better(SolverRun run) {
    if (!run.best) return;
    const bool first = !best_.best;
    const bool certifies = run.certified && run.certified->certificate.passed;
    const bool equal = !first && !clearly_better(best_, run);
    if (first || clearly_better(run, best_) || (certifies && !passed() && equal))
      best_ = std::move(run);
  }

  // Each solver of the sequence starts from the best design. The first certified design ends it.
  void climb_ladder() {
    for (const std::string& name : ladder_.rungs) {
      if (runner_.exhausted() || runner_.scaling().size() == 0) return;
      if (passed() && !ladder_.to_the_top) return;
      const Optimizer& optimizer = find_optimizer(name);
      if (!optimizer.info.available) continue;
      climb_on(optimizer);
      const bool top = ladder_.to_the_top;
      if (name == "ipopt" && !passed() && !top) {  // its own way from the start
        SolverRun run = runner_.run(optimizer, runner_.start(), true);
        runner_.finish(run);
        keep_if_better(std::move(run));
      }
      if (!feasible(best_) && name == "ipopt" && !top) return;  // feasibility comes first
    }
  }

  // If no feasible design is known, searches for feasibility only and continues from there.
  void restore() {
    if (runner_.exhausted()) return;
    auto from = starts();
    from.insert(from.begin(), runner_.start());
    if (best_.best) from.insert(from.begin(), best_.design);
    std::vector<std::vector<double>> scaled;
    for (const auto& design : from) scaled.push_back(runner_.scaling().to_unit(design));
    auto found = elastic_search(runner_, scaled);
    const double allowed = options_.feasibility_tolerance;
    if (!found || found->f > allowed || found->violation > allowed) {
      // All starts may lie in one valley of the violations, and another may be lower.
      auto other = elastic_search(runner_, least_infeasible_samples());
      if (other && (!found || other->f < found->f)) found = std::move(other);
    }
    if (!found) return;
    least_infeasible_ = found->z;
    if (!runner_.exhausted()) go_on_from(runner_.scaling().to_design(found->z));
  }

  // Of a sample of the whole range, the designs that violate the limits least, in the unit box.
  std::vector<std::vector<double>> least_infeasible_samples() {
    constexpr std::size_t kKept = 3;
    std::vector<std::pair<double, std::vector<double>>> seen;
    SolveOptions options = options_;
    options.first_stage = runner_.next_stage();
    runner_.book(sample_range(runner_.problem(), options, runner_.deadline(),
                              std::min(options_.scan, runner_.left()), [&](RangeDesign& d) {
                                seen.emplace_back(runner_.excess(d.evaluation.values),
                                                  runner_.scaling().to_unit(d.design));
                              }));
    const auto kept = std::min(kKept, seen.size());
    std::partial_sort(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(kept), seen.end());
    std::vector<std::vector<double>> units;
    for (std::size_t i = 0; i < kept; ++i) units.push_back(std::move(seen[i].second));
    return units;
  }

  // True if a search from there knows a feasible design.
  bool go_on_from(const std::vector<double>& design) {
    SolverRun run = runner_.run(find_optimizer("nlopt:slsqp"), design, true);
    if (!feasible(run)) return false;
    runner_.finish(run);
    keep_if_better(std::move(run));
    climb_ladder();
    return true;
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
    // An optimum may be certified when the budget ends before all starts were tried.
    const bool cut = result.outcome == Outcome::budget || result.outcome == Outcome::optimal;
    result.stop = cut ? runner_.stop_reason() : StopReason::finished;
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
    Explanation explained = explain_infeasible(runner_, unit);
    result.infeasibility = std::move(explained.report);
    if (!explained.feasible.empty() && !runner_.exhausted() && go_on_from(explained.feasible)) {
      result.infeasibility = {};
      result.outcome = outcome();
      return;
    }
    move_to(result.infeasibility.design);
    if (!result.infeasibility.relaxations.empty()) return;
    // The elastic solve found a feasible design, or the budget ended before it could decide.
    result.outcome = outcome();
    result.infeasibility = {};
  }

  // Makes the least infeasible design the answer, if the budget allows its certificate.
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

// Goes on from a design that keeps every limit, with the budget that is left.
Result solve_from(const Problem& problem, std::span<const double> design,
                  const SolveOptions& options, const Deadline& deadline, Result&& before) {
  Problem moved = problem;
  for (std::size_t j = 0; j < design.size(); ++j) moved.variables[j].start = design[j];
  SolveOptions rest = options;
  rest.first_stage += before.stages_used;
  rest.budget.evaluations -= std::min(rest.budget.evaluations, before.counters.evaluations);
  Result found = solve_plainly(moved, rest, deadline);
  found.counters.add(before.counters);
  found.stages_used += before.stages_used;
  found.stages.insert(found.stages.begin(), std::make_move_iterator(before.stages.begin()),
                      std::make_move_iterator(before.stages.end()));
  return found;
}

// The causes of the infeasibility, or the answer of a search that goes on, if a design keeps every limit after all.
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
  if (!causes.feasible.empty())
    result = solve_from(problem, causes.feasible, options, deadline, std::move(result));
  result.seconds = deadline.elapsed();
}

}  // namespace

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
  validate(options);
  if (problem.objectives.size() != 1)
    throw InputError("solve: the problem has " + std::to_string(problem.objectives.size()) +
                     " objectives; a front needs pareto_front");
  if (options.solver != "auto") find_optimizer(options.solver);
  if (!options.global.empty()) find_optimizer(options.global);
  SolveOptions own = options;
  own.observer = serialized(options.observer);
  const Deadline deadline(options.budget.seconds);
  if (!problem.derivatives) return solve_without_derivatives(problem, own, deadline);
  Result result = solve_plainly(problem, own, deadline);
  if (!result.infeasibility.relaxations.empty())
    complete_explanation(problem, own, deadline, result);
  return result;
}

}  // namespace twum::inline v0_1::optim
