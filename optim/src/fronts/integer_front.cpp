// SPDX-License-Identifier: Apache-2.0
#include "fronts/integer_front.hpp"

#include "fronts/front.hpp"
#include "search/solve_continuous.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kMostCombinations = 64;  // as solve() enumerates

bool is_free(const Variable& v) { return v.integer && v.lower < v.upper; }

double combinations(const Problem& problem) {
  double product = 1;
  for (const Variable& v : problem.variables) {
    if (is_free(v)) product *= std::floor(v.upper) - std::ceil(v.lower) + 1;
  }
  return product;
}

std::vector<std::vector<double>> values_of(const Problem& problem, const Front& front) {
  std::vector<std::vector<double>> values;
  for (const FrontPoint& point : front.points)
    values.push_back(minimized(problem, point.evaluation));
  return values;
}

void keep(Front& front, const std::vector<std::size_t>& places) {
  std::vector<FrontPoint> kept;
  for (const std::size_t i : places) kept.push_back(std::move(front.points[i]));
  front.points = std::move(kept);
}

// Solves one combination after the other and collects their points.
class IntegerFront {
 public:
  IntegerFront(const Problem& problem, const ParetoOptions& options)
      : problem_(problem), options_(options), deadline_(options.solve.budget.seconds) {
    for (std::size_t j = 0; j < problem.variables.size(); ++j) {
      if (is_free(problem.variables[j])) integers_.push_back(j);
    }
    left_ = static_cast<std::size_t>(combinations(problem));
  }

  Front run() {
    Problem fixed = problem_;
    for (const std::size_t j : integers_)
      hold(fixed.variables[j], std::ceil(problem_.variables[j].lower));
    do {
      visit(fixed);
    } while (!cut_ && next(fixed));
    conclude();
    return std::move(whole_);
  }

 private:
  static void hold(Variable& variable, double value) { variable.lower = variable.upper = value; }

  // The next combination; false after the last.
  bool next(Problem& fixed) const {
    for (const std::size_t j : integers_) {
      const double value = fixed.variables[j].lower + 1;
      if (value <= problem_.variables[j].upper) {
        hold(fixed.variables[j], value);
        return true;
      }
      hold(fixed.variables[j], std::ceil(problem_.variables[j].lower));
    }
    return false;
  }

  void visit(const Problem& fixed) {
    ParetoOptions options = options_;
    const std::size_t spent = whole_.counters.evaluations;
    const std::size_t budget = options_.solve.budget.evaluations;
    options.solve.budget.evaluations = spent < budget ? (budget - spent) / left_-- : 0;
    options.solve.budget.seconds -= deadline_.elapsed();
    options.solve.first_stage += whole_.stages_used;
    cut_ = options.solve.budget.evaluations == 0 || deadline_.passed() ||
           options_.solve.stop.stop_requested();
    if (cut_) return;
    Front front = pareto_front(fixed, options);
    whole_.counters.add(front.counters);
    whole_.stages_used += front.stages_used;
    if (front.outcome == Outcome::budget) whole_.stop = front.stop;
    outcomes_.push_back(front.outcome);
    if (front.outcome == Outcome::infeasible && whole_.infeasibility.design.empty())
      whole_.infeasibility = std::move(front.infeasibility);
    std::move(front.points.begin(), front.points.end(), std::back_inserter(whole_.points));
  }

  bool all(std::initializer_list<Outcome> of) const {
    return std::all_of(outcomes_.begin(), outcomes_.end(), [&](Outcome outcome) {
      return std::find(of.begin(), of.end(), outcome) != of.end();
    });
  }

  Outcome outcome() const {
    if (cut_ || !all({Outcome::optimal, Outcome::feasible, Outcome::infeasible, Outcome::failed}))
      return Outcome::budget;
    if (whole_.points.empty())
      return all({Outcome::failed}) ? Outcome::failed : Outcome::infeasible;
    const bool certified =
        std::all_of(whole_.points.begin(), whole_.points.end(),
                    [](const FrontPoint& point) { return point.certificate.passed; });
    return certified && all({Outcome::optimal, Outcome::infeasible}) ? Outcome::optimal
                                                                     : Outcome::feasible;
  }

  // Keeps the requested number of nondominated points, in order.
  void choose() {
    keep(whole_, nondominated(values_of(problem_, whole_)));
    std::stable_sort(whole_.points.begin(), whole_.points.end(), [&](const auto& a, const auto& b) {
      return minimized(problem_, a.evaluation) < minimized(problem_, b.evaluation);
    });
    if (whole_.points.size() <= options_.points) return;
    measure(whole_, problem_, options_.reference);
    std::vector<double> reference = whole_.reference;
    for (std::size_t k = 0; k < reference.size(); ++k) {
      if (problem_.objectives[k].sense == Sense::maximize) reference[k] = -reference[k];
    }
    const auto values = values_of(problem_, whole_);
    const bool exact = problem_.objectives.size() == 2 && options_.points > 1;
    auto places = exact ? best_subset(values, options_.points, reference)
                        : greedy_subset(values, options_.points, reference);
    std::sort(places.begin(), places.end());
    keep(whole_, places);
  }

  void conclude() {
    whole_.outcome = outcome();
    if (!whole_.points.empty()) {
      whole_.infeasibility = {};
      choose();
      measure(whole_, problem_, options_.reference);
    }
    if (cut_)
      whole_.stop = options_.solve.stop.stop_requested() ? StopReason::requested
                    : deadline_.passed()                 ? StopReason::seconds
                                                         : StopReason::evaluations;
    whole_.seconds = deadline_.elapsed();
  }

  const Problem& problem_;
  const ParetoOptions& options_;
  Deadline deadline_;
  std::vector<std::size_t> integers_;
  std::size_t left_{1};  // combinations
  std::vector<Outcome> outcomes_;
  Front whole_;
  bool cut_{false};  // the budget ended before the last combination
};

}  // namespace

bool has_free_integers(const Problem& problem) {
  return std::any_of(problem.variables.begin(), problem.variables.end(), is_free);
}

Front integer_front(const Problem& problem, const ParetoOptions& options) {
  if (const double count = combinations(problem); count > kMostCombinations)
    throw InputError("the integer variables have " + std::to_string(static_cast<long long>(count)) +
                     " combinations; a front by gradients solves each, at most 64: narrow their "
                     "bounds, or take nsga2");
  return IntegerFront(problem, options).run();
}

}  // namespace twum::inline v0_1::optim
