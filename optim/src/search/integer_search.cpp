// SPDX-License-Identifier: Apache-2.0
#include "search/integer_search.hpp"

#include "certificate/certify.hpp"
#include "problem/scaling.hpp"
#include "search/solve_continuous.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace twum::inline v0_1::optim {
namespace {

using Whole = std::vector<double>;  // one value for each integer variable

class IntegerSearch {
 public:
  IntegerSearch(const Problem& problem, const SolveOptions& options, const Deadline& deadline)
      : problem_(problem), options_(options), deadline_(deadline), scaling_(problem) {
    const auto start = start_design(problem);
    for (std::size_t j = 0; j < problem.variables.size(); ++j) {
      const Variable& v = problem.variables[j];
      if (!v.integer) continue;
      integers_.push_back(j);
      start_.push_back(start[j]);
    }
  }

  Result run() {
    if (combinations() <= kEnumerate)
      enumerate();
    else
      descend();
    if (options_.analyse_infeasible && complete_ && best_.outcome == Outcome::infeasible) explain();
    Result result = std::move(best_);
    result.counters = total_.counters;
    result.stages = std::move(total_.stages);
    result.stages_used = total_.stages_used;
    result.seconds = deadline_.elapsed();
    if (complete_) return result;
    if (best_at_.empty()) result.certificate.reason = kCutShort;
    if (!result.counters.all_failed()) {
      result.outcome = Outcome::budget;
      result.stop = why_cut_short();
    }
    return result;
  }

 private:
  static constexpr double kEnumerate = 64;

  double low(std::size_t i) const { return std::ceil(problem_.variables[integers_[i]].lower); }
  double high(std::size_t i) const { return std::floor(problem_.variables[integers_[i]].upper); }

  double combinations() const {
    double product = 1.0;
    for (std::size_t i = 0; i < integers_.size(); ++i) product *= high(i) - low(i) + 1.0;
    return product;
  }

  StopReason why_cut_short() const {
    if (options_.stop.stop_requested()) return StopReason::requested;
    return deadline_.passed() ? StopReason::seconds : StopReason::evaluations;
  }

  void enumerate() {
    Whole at;
    for (std::size_t i = 0; i < integers_.size(); ++i) at.push_back(low(i));
    while (visit(at)) {
      std::size_t i = 0;
      while (i < at.size() && at[i] >= high(i)) {
        at[i] = low(i);
        ++i;
      }
      if (i == at.size()) return;
      at[i] += 1.0;
    }
    complete_ = false;
  }

  void descend() {
    Whole at = start_;
    if (!visit(at)) complete_ = false;
    while (complete_) {
      const Whole from = best_at_;
      for (std::size_t i = 0; i < at.size() && complete_; ++i) {
        for (const double step : {-1.0, 1.0}) {
          Whole next = from;
          next[i] += step;
          if (next[i] < low(i) || next[i] > high(i) || seen_.contains(next)) continue;
          complete_ = visit(next);
          if (!complete_) break;
        }
      }
      if (best_at_ == from) return;
    }
  }

  // Solves with these integers, in separate stages.
  Result solve_at(const Whole& at, bool analyse) {
    Problem fixed = problem_;
    for (std::size_t i = 0; i < at.size(); ++i)
      fixed.variables[integers_[i]].lower = fixed.variables[integers_[i]].upper = at[i];
    SolveOptions options = options_;
    options.budget.evaluations -= total_.counters.evaluations;
    options.first_stage += total_.stages_used;
    options.analyse_infeasible = analyse;
    Result result = solve_continuous(fixed, options, deadline_);
    total_.counters.add(result.counters);
    total_.stages.insert(total_.stages.end(), result.stages.begin(), result.stages.end());
    total_.stages_used += result.stages_used;
    return result;
  }

  bool exhausted() const {
    return total_.counters.evaluations >= options_.budget.evaluations || deadline_.passed() ||
           options_.stop.stop_requested();
  }

  // Solves the least infeasible combination again, with an explanation of its limits.
  void explain() {
    if (exhausted()) return;
    Result told = solve_at(best_at_, true);
    if (told.outcome == Outcome::infeasible || rank(told) == 2) best_ = std::move(told);
  }

  // False if the budget is too small for this combination.
  bool visit(const Whole& at) {
    seen_[at] = true;
    if (exhausted()) return false;
    Result result = solve_at(at, false);
    // Also with a certified optimum: other starts may lead to better ones.
    const bool cut = exhausted() || result.stop != StopReason::finished;
    if (!scaled_ && !result.evaluation.jacobian.empty()) {
      scaling_.scale_responses(result.design, result.evaluation);
      scaled_ = true;
    }
    if (best_at_.empty() || beats(result)) {
      best_ = std::move(result);
      best_at_ = at;
    }
    return !cut;
  }

  // Feasible results come first, then infeasible ones, then those without a design.
  int rank(const Result& r) const {
    if (r.evaluation.values.empty()) return 0;
    return r.certificate.infeasibility <= options_.feasibility_tolerance ? 2 : 1;
  }

  // The largest violation on the same scale for all combinations. Violations in certificates are scaled by the
  // gradients of one combination, so they cannot be compared.
  double violation(const Result& r) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const Constraint& c = problem_.constraints[i];
      const std::size_t row = problem_.objectives.size() + i;
      const double value = r.evaluation.values[row];
      const double excess = std::max(c.lower - value, value - c.upper);
      largest = std::max(largest, scaling_.factor(row) * excess);
    }
    return largest;
  }

  bool beats(const Result& r) const {
    if (rank(r) != rank(best_)) return rank(r) > rank(best_);
    if (rank(r) == 0) return false;
    if (rank(r) == 1) return violation(r) < violation(best_);
    const double sign = problem_.objectives[0].sense == Sense::maximize ? -1.0 : 1.0;
    return sign * r.evaluation.values[0] < sign * best_.evaluation.values[0];
  }

  const Problem& problem_;
  const SolveOptions& options_;
  const Deadline& deadline_;
  Scaling scaling_;
  bool scaled_{false};
  std::vector<std::size_t> integers_;
  Whole start_;
  std::map<Whole, bool> seen_;
  Result best_;
  Whole best_at_;
  Result total_;
  bool complete_{true};
};

}  // namespace

Result integer_search(const Problem& problem, const SolveOptions& options,
                      const Deadline& deadline) {
  return IntegerSearch(problem, options, deadline).run();
}

}  // namespace twum::inline v0_1::optim
