// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/scan.hpp>

#include "problem/session.hpp"

#include <twum/optim/low_discrepancy.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::optim {
namespace {

// relative to the objective; larger than the tolerance of a search
constexpr double kClearly = 1e-6;

class FurtherLook {
 public:
  FurtherLook(const Problem& problem, const SolveOptions& options, Result found)
      : problem_(problem), options_(options), found_(std::move(found)) {}

  Result run() {
    const bool feasible = found_.outcome == Outcome::optimal || found_.outcome == Outcome::feasible;
    if (!feasible || found_.stop != StopReason::finished || options_.scan == 0)
      return std::move(found_);
    before_ = objective(found_.evaluation);
    found_.scan.before = found_.evaluation.values.front();
    sample();
    if (best_) follow();
    // A better design is known, so this one is not an optimum.
    if (best_ && !found_.scan.replaced) found_.outcome = Outcome::feasible;
    return std::move(found_);
  }

 private:
  struct Sample {
    std::vector<double> design;
    double objective;
  };

  // The smaller the better.
  double objective(const Evaluation& evaluation) const {
    const double sign = problem_.objectives.front().sense == Sense::maximize ? -1.0 : 1.0;
    return sign * evaluation.values.front();
  }

  bool feasible(const Evaluation& evaluation) const {
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const double value = evaluation.values[1 + i];
      const Constraint& limit = problem_.constraints[i];
      if (!(limit.lower <= value && value <= limit.upper)) return false;
    }
    return true;
  }

  std::size_t left() const {
    const std::size_t all = options_.budget.evaluations;
    return all - std::min(all, found_.counters.evaluations);
  }

  void sample() {
    const Deadline deadline(options_.budget.seconds - found_.seconds);
    Session session(problem_, options_, deadline, options_.first_stage + found_.stages_used++,
                    left());
    try {
      // Other seeds are those of the starts and of the first design that can be evaluated.
      for (const auto& unit : sobol_points(problem_.variables.size(),
                                           std::min(options_.scan, left()), options_.seed + 2))
        look_at(session, design_at(problem_, unit));
    } catch (const Stop& stop) {
      found_.stop = stop.reason;
    }
    found_.counters.add(session.counters());
    found_.seconds += deadline.elapsed();
  }

  void look_at(Session& session, std::vector<double> design) {
    const Evaluation& evaluation = session.at(design, false);
    Scan& scan = found_.scan;
    ++scan.designs;
    if (!evaluation.ok() || !feasible(evaluation)) return;
    ++scan.feasible;
    const double value = objective(evaluation);
    if (!(value < before_ - kClearly * std::abs(before_))) return;
    ++scan.better;
    if (!best_ || value < best_->objective) best_ = Sample{std::move(design), value};
  }

  // A search from the best sample; its answer is at least as good as that design, which it has seen.
  void follow() {
    if (left() == 0 || found_.stop != StopReason::finished) return;
    Problem there = problem_;
    for (std::size_t j = 0; j < there.variables.size(); ++j) {
      Variable& variable = there.variables[j];
      variable.start = best_->design[j];
      if (variable.integer) variable.lower = variable.upper = variable.start;
    }
    SolveOptions options = options_;
    options.starts = 1;
    options.analyse_infeasible = false;
    options.first_stage += found_.stages_used;
    options.budget.evaluations = left();
    options.budget.seconds -= found_.seconds;
    take(solve(there, options));
  }

  void take(Result better) {
    const bool usable = better.outcome == Outcome::optimal || better.outcome == Outcome::feasible ||
                        better.outcome == Outcome::budget;
    const bool beats = usable && !better.evaluation.values.empty() && feasible_of(better) &&
                       objective(better.evaluation) < before_;
    better.counters.add(found_.counters);
    better.stages.insert(better.stages.begin(), found_.stages.begin(), found_.stages.end());
    better.stages_used += found_.stages_used;
    better.seconds += found_.seconds;
    if (!beats) {
      found_.counters = std::move(better.counters);
      found_.stages = std::move(better.stages);
      found_.stages_used = better.stages_used;
      found_.seconds = better.seconds;
      return;
    }
    better.scan = found_.scan;
    better.scan.replaced = true;
    found_ = std::move(better);
  }

  bool feasible_of(const Result& result) const {
    return result.certificate.infeasibility <= options_.feasibility_tolerance;
  }

  const Problem& problem_;
  const SolveOptions& options_;
  Result found_;
  double before_{kInfinity};
  std::optional<Sample> best_;
};

double at_unit(const Variable& v, double u) {
  const double x = v.scale == Scale::log ? v.lower * std::pow(v.upper / v.lower, u)
                                         : v.lower + u * (v.upper - v.lower);
  if (!v.integer) return std::clamp(x, v.lower, v.upper);
  // Each whole number gets an equal part of the range.
  const double least = std::ceil(v.lower);
  const double most = std::floor(v.upper);
  return std::min(most, least + std::floor(u * (most - least + 1)));
}

}  // namespace

std::vector<double> design_at(const Problem& problem, std::span<const double> unit) {
  std::vector<double> design;
  for (std::size_t j = 0; j < unit.size(); ++j)
    design.push_back(at_unit(problem.variables[j], unit[j]));
  return design;
}

Result look_further(const Problem& problem, const SolveOptions& options, Result found) {
  return FurtherLook(problem, options, std::move(found)).run();
}

}  // namespace twum::optim
