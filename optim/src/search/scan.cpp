// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/scan.hpp>

#include "search/range_place.hpp"
#include "search/range_sample.hpp"

#include <twum/base/ordered.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {
namespace {

// Searches from samples above the answer: a narrow valley may have none below it.
constexpr std::size_t kStarts = 4;
// relative to the objective; larger than the tolerance of a search
constexpr double kClearly = 1e-6;

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) square += (a[j] - b[j]) * (a[j] - b[j]);
  return std::sqrt(square);
}

// The place of a design in the unit box.
std::vector<double> unit_of(const Problem& problem, const std::vector<double>& design) {
  std::vector<double> unit;
  for (std::size_t j = 0; j < design.size(); ++j)
    unit.push_back(place_in_range(problem.variables[j], design[j]));
  return unit;
}

class FurtherLook {
 public:
  FurtherLook(const Problem& problem, const SolveOptions& options, Result found)
      : problem_(problem),
        options_(options),
        found_(std::move(found)),
        deadline_(options.budget.seconds - found_.seconds) {
    options_.observer = serialized(options.observer);
  }

  Result run() {
    const bool feasible = found_.outcome == Outcome::optimal || found_.outcome == Outcome::feasible;
    if (!feasible || found_.stop != StopReason::finished || options_.scan == 0)
      return std::move(found_);
    before_ = objective(found_.evaluation);
    found_.scan.before = found_.evaluation.values.front();
    // One search was enough if the starts agreed with a convex problem, or one start was asked for.
    const bool several = options_.starts > 1 && found_.stages.size() > 1;
    sample();
    const bool better = found_.scan.better > 0;
    const auto from = better || several ? starts() : std::vector<Sample>{};
    // A better sample is in all likelihood the start of a better answer.
    const std::size_t alone = better ? std::min<std::size_t>(1, from.size()) : 0;
    follow(std::span(from).first(alone));
    if (!(better && found_.scan.replaced)) follow(std::span(from).subspan(alone));
    // A better design is known, so this one is not an optimum.
    if (better && !found_.scan.replaced) found_.outcome = Outcome::feasible;
    found_.seconds += deadline_.elapsed();
    return std::move(found_);
  }

 private:
  struct Sample {
    std::vector<double> unit, design;
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
    SolveOptions options = options_;
    options.first_stage += found_.stages_used;
    const Result cost = sample_range(problem_, options, deadline_, std::min(options_.scan, left()),
                                     [this](RangeDesign& d) { look_at(d); });
    if (cost.stop != StopReason::finished) found_.stop = cost.stop;
    found_.scan.designs = cost.counters.evaluations;
    found_.counters.add(cost.counters);
    found_.stages_used += cost.stages_used;
  }

  void look_at(RangeDesign& d) {
    if (!feasible(d.evaluation)) return;
    ++found_.scan.feasible;
    const double value = objective(d.evaluation);
    if (clearly_better(value)) ++found_.scan.better;
    seen_.push_back({std::move(d.place), std::move(d.design), value});
  }

  // The best samples without a better one, or the answer, within the critical distance: each may lie in a valley of its own.
  std::vector<Sample> starts() {
    const double critical = critical_distance();
    const std::vector<double> answer = unit_of(problem_, found_.design);
    std::ranges::sort(seen_, {}, &Sample::objective);
    std::vector<Sample> kept;
    for (std::size_t i = 0; i < seen_.size() && kept.size() < kStarts; ++i) {
      const auto near = [&](const std::vector<double>& other) {
        return distance(seen_[i].unit, other) < critical;
      };
      const bool below_answer = clearly_better(seen_[i].objective);
      const auto better = std::span(seen_).first(i);
      if ((below_answer || !near(answer)) && std::ranges::none_of(better, near, &Sample::unit))
        kept.push_back(seen_[i]);
    }
    return kept;
  }

  // pi^(-1/2) (Gamma(1 + n/2) sigma ln(N) / N)^(1/n) with sigma = 4, in the unit box: multi level single linkage (Rinnooy Kan and
  // Timmer 1987).
  double critical_distance() const {
    const double dimension = static_cast<double>(problem_.variables.size());
    const double count = static_cast<double>(std::max<std::size_t>(seen_.size(), 2));
    const double volume = std::tgamma(1 + dimension / 2) * 4 * std::log(count) / count;
    return std::pow(volume, 1 / dimension) / std::sqrt(std::numbers::pi);
  }

  bool clearly_better(double value) const { return value < before_ - kClearly * std::abs(before_); }

  // Searches from samples, on several threads; each has an equal share of the budget and stages of its own, so that the answers
  // do not depend on the order.
  void follow(std::span<const Sample> starts) {
    if (starts.empty() || left() < starts.size() || found_.stop != StopReason::finished) return;
    SolveOptions options = options_;
    options.starts = 1;
    options.analyse_infeasible = false;
    options.budget.evaluations = left() / starts.size();
    options.budget.seconds -= found_.seconds + deadline_.elapsed();
    const std::uint64_t first = options_.first_stage + found_.stages_used;
    run_indexed(
        {0, starts.size(), static_cast<unsigned>(options_.jobs), {}},
        [&](std::uint64_t i) {
          SolveOptions own = options;
          own.first_stage = first + kStagesOfASolve * i;
          return solve(from(starts[i]), own);
        },
        [&](std::uint64_t, std::vector<Result>& answers) {
          for (Result& answer : answers) take(std::move(answer));
        });
    found_.stages_used = first + kStagesOfASolve * starts.size() - options_.first_stage;
  }

  // The answer of a search from a sample is at least as good as that design, which it has seen.
  Problem from(const Sample& start) const {
    Problem there = problem_;
    for (std::size_t j = 0; j < there.variables.size(); ++j) {
      Variable& variable = there.variables[j];
      variable.start = start.design[j];
      if (variable.integer) variable.lower = variable.upper = variable.start;
    }
    return there;
  }

  void take(Result better) {
    const bool usable = better.outcome == Outcome::optimal || better.outcome == Outcome::feasible ||
                        better.outcome == Outcome::budget;
    const bool beats = usable && !better.evaluation.values.empty() && feasible_of(better) &&
                       clearly_better(objective(better.evaluation));
    better.counters.add(found_.counters);
    better.stages.insert(better.stages.begin(), found_.stages.begin(), found_.stages.end());
    better.seconds = found_.seconds;  // of the searches before
    if (!beats) {
      found_.counters = std::move(better.counters);
      found_.stages = std::move(better.stages);
      return;
    }
    better.scan = found_.scan;
    better.scan.replaced = true;
    found_ = std::move(better);
    before_ = objective(found_.evaluation);
  }

  bool feasible_of(const Result& result) const {
    return result.certificate.infeasibility <= options_.feasibility_tolerance;
  }

  const Problem& problem_;
  SolveOptions options_;
  Result found_;
  Deadline deadline_;
  double before_{kInfinity};
  std::vector<Sample> seen_;  // those that keep every limit
};

double at_unit(const Variable& v, double u) {
  const double x = value_in_range(v, u);
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

}  // namespace twum::inline v0_1::optim
