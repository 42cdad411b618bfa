// SPDX-License-Identifier: Apache-2.0
#include "search/stage_runner.hpp"

#include "certificate/convexity.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <optional>
#include <thread>

namespace twum::inline v0_1::optim {

StageRunner::StageRunner(const Problem& problem, const SolveOptions& options,
                         const Deadline& deadline)
    : problem_(problem),
      options_(options),
      deadline_(deadline),
      scaling_(problem),
      start_(start_design(problem)),
      next_stage_(options.first_stage) {}

std::size_t StageRunner::left() const {
  const std::size_t total = options_.budget.evaluations;
  return total > counters_.evaluations ? total - counters_.evaluations : 0;
}

// Evaluations reserved for the certificate of a solver's answer.
std::size_t StageRunner::reserve() const {
  return std::min(2 * certificate_cost(scaling_.size()), left() / 4);
}

bool StageRunner::exhausted() const {
  return stop_ == StopReason::requested || stop_ == StopReason::seconds || left() == 0 ||
         options_.stop.stop_requested() || deadline_.passed();
}

// Checks again, because a stop request or the end of the time during the last call of a stage throws nothing.
StopReason StageRunner::stop_reason() const {
  if (stop_ == StopReason::seconds) return stop_;
  if (options_.stop.stop_requested()) return StopReason::requested;
  return left() > 0 && deadline_.passed() ? StopReason::seconds : stop_;
}

Outcome StageRunner::without_design() const {
  return exhausted() && !counters_.all_failed() ? Outcome::budget : Outcome::failed;
}

void StageRunner::note_stop(StopReason reason) {
  if (reason != StopReason::finished) stop_ = reason;
}

bool StageRunner::scale(Frame frame) {
  SolverRun stage;
  stage.session = std::make_unique<Session>(problem_, options_, deadline_, next_stage_++, left());
  std::optional<FirstDesign> first;
  try {
    first = first_design(*stage.session, scaling_);
  } catch (const Stop& s) {
    stage.report.stop = s.reason;
  }
  book(stage);
  if (!first) return false;
  start_ = std::move(first->design);
  first_ = std::move(first->evaluation);
  if (frame == Frame::point) scaling_ = Scaling(problem_, search_sizes(problem_, start_));
  scaling_.scale_responses(start_, first_);
  return true;
}

SolverRun StageRunner::run(const Optimizer& optimizer, const std::vector<double>& design,
                           bool last_word) {
  const std::size_t kept = last_word ? reserve() : 0;
  const SolverPlan plan{&optimizer, next_stage_++, left() - kept, {}};
  SolverRun run = run_solver_from(problem_, options_, deadline_, plan, design, {start_, &first_});
  book(run);
  return run;
}

SolverRun StageRunner::run(const Optimizer& optimizer, const Formulation& formulation,
                           std::span<const double> start, std::size_t most) {
  const SolverPlan plan{
      &optimizer, next_stage_++, std::min(left(), most), {start.begin(), start.end()}};
  SolverRun run = run_solver(problem_, options_, deadline_, scaling_, formulation, plan);
  run.slackened = !formulation.extra_lower.empty();
  book(run);
  return run;
}

std::vector<SolverRun> StageRunner::run_all(const Optimizer& optimizer,
                                            const std::vector<std::vector<double>>& starts,
                                            std::span<const double> known) {
  // Each start has its own stage and an equal share, so that results do not depend on the order.
  const std::size_t share = (left() - reserve()) / starts.size();
  std::vector<SolverRun> runs(starts.size());
  std::vector<std::exception_ptr> errors(starts.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < starts.size(); i = next++) {
      try {
        const SolverPlan plan{&optimizer, next_stage_ + i, share, {}, known};
        runs[i] =
            run_solver_from(problem_, options_, deadline_, plan, starts[i], {start_, &first_});
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  const std::size_t threads = std::clamp<std::size_t>(options_.jobs, 1, starts.size());
  {
    std::vector<std::jthread> pool;
    for (std::size_t t = 1; t < threads; ++t) pool.emplace_back(work);
    work();
  }
  next_stage_ += starts.size();
  for (const auto& error : errors)
    if (error) std::rethrow_exception(error);
  for (SolverRun& run : runs) book(run);
  return runs;
}

Scaling StageRunner::ranges() const {
  Scaling scaling(problem_);
  scaling.scale_responses(start_, first_);
  return scaling;
}

double StageRunner::excess(const std::vector<double>& values) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
    const std::size_t r = problem_.objectives.size() + i;
    const Constraint& c = problem_.constraints[i];
    worst =
        std::max(worst, scaling_.factor(r) * std::max(c.lower - values[r], values[r] - c.upper));
  }
  return worst;
}

bool StageRunner::looks_convex(const Certified& optimum,
                               const std::vector<std::vector<double>>& designs) {
  std::vector<FirstDesign> seen{{optimum.point.design, optimum.point.evaluation}, {start_, first_}};
  SolverRun look;
  look.session = std::make_unique<Session>(problem_, options_, deadline_, next_stage_++, left());
  bool all = true;
  try {
    for (const auto& design : designs) {
      const Evaluation& e = look.session->at(design, true);
      all = all && e.ok();
      if (all) seen.push_back({design, e});
      if (!all || !agree_with_convexity(problem_, seen)) break;
    }
  } catch (const Stop& s) {
    look.report.stop = s.reason;
    all = false;
  }
  book(look);
  return all && agree_with_convexity(problem_, seen);
}

void StageRunner::allow(SolverRun& run, std::size_t wanted) {
  book(run);  // what it has used is not left
  run.session->allow(std::min(wanted, left()));
}

void StageRunner::finish(SolverRun& run) {
  if (run.certified || !run.best) return;
  allow(run, std::max(run.session->left(), 4 * certificate_cost(scaling_.size())));
  finish_run(run, scaling_);
  book(run);
}

void StageRunner::book(SolverRun& run) {
  const Counters& used = run.session->counters();
  counters_.subtract(run.booked);
  counters_.add(used);
  run.booked = used;
  note_stop(run.report.stop);
  if (run.solver == nullptr) return;
  StageReport report;
  if (run.reported)
    std::erase_if(stages_, [&](const StageReport& s) { return s.stage == run.session->stage(); });
  report.stage = run.session->stage();
  report.solver = run.solver->name;
  report.word = run.report.word;
  report.code = run.report.code;
  report.evaluations = used.evaluations;
  report.objective = std::nan("");
  if (run.best && problem_.objectives.size() == 1) {
    const double left = run.slackened ? excess(run.best->values) : 0.0;
    report.feasible = std::max(run.best->violation, left) <= options_.feasibility_tolerance;
    report.objective = run.best->values[0];
  }
  run.reported = true;
  stages_.push_back(std::move(report));
}

void StageRunner::book(const Result& nested) {
  counters_.add(nested.counters);
  stages_.insert(stages_.end(), nested.stages.begin(), nested.stages.end());
  next_stage_ += nested.stages_used;
  note_stop(nested.stop);
}

}  // namespace twum::inline v0_1::optim
