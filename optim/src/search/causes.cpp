// SPDX-License-Identifier: Apache-2.0
#include "search/causes.hpp"

#include "problem/restated.hpp"
#include "problem/tolerance.hpp"
#include "search/solve_continuous.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::inline v0_1::optim {
namespace {

using Rows = std::vector<std::size_t>;

// How far a range is extended at most. The upper end moves up to `highest`, and no further than ten times the larger
// of the range's width and the end itself: designs beyond that have little to do with the question. A logarithmic
// scale cannot cross zero.
double farthest_end(const Variable& v, Side side) {
  constexpr double kTimes = 10.0;
  const double end = side == Side::upper ? v.upper : v.lower;
  const double step = kTimes * std::max(v.upper - v.lower, std::abs(end));
  if (side == Side::upper) return std::min(v.highest, end + step);
  const double far = v.scale == Scale::log ? end / (1.0 + kTimes) : end - step;
  return std::max(v.lowest, far);
}

// Replaces the range by its extension beyond the end; the range as asked contains no feasible design.
bool extend(Variable& v, Side side) {
  // Each value of an integer variable needs a separate search.
  constexpr double kWholeNumbers = 8.0;
  if (std::isnan(side == Side::upper ? v.highest : v.lowest)) return false;
  const double far = farthest_end(v, side);
  const double one = v.integer ? 1.0 : 0.0;
  if (side == Side::upper) {
    v.start = v.lower = v.upper + one;
    v.upper = v.integer ? std::min(std::floor(far), v.lower + kWholeNumbers - 1.0) : far;
  } else {
    v.start = v.upper = v.lower - one;
    v.lower = v.integer ? std::max(std::ceil(far), v.upper - kWholeNumbers + 1.0) : far;
  }
  return v.lower < v.upper || (v.integer && v.lower == v.upper);
}

class Investigation {
 public:
  Investigation(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                std::size_t most)
      : problem_(problem), options_(options), deadline_(deadline), most_(most) {
    options_.solver = "auto";
    options_.global.clear();
    options_.solver_options.clear();
    options_.jobs = 1;  // restated problems evaluate in one thread
    options_.starts = std::min(options.starts, kStarts);
  }

  Causes run(Infeasibility found) {
    told().design = design_ = found.design;
    told().relaxations = found.relaxations;
    told().certified = found.certified;
    for (Relaxation& limit : told().relaxations) {
      sharpen(limit);
      if (!causes_.feasible.empty()) return std::move(causes_);
    }
    Rows remaining(problem_.constraints.size());
    std::iota(remaining.begin(), remaining.end(), std::size_t{0});
    // Limits that are impossible on their own are removed one after the other; then the remaining ones are explained.
    while (take_impossible(found, remaining)) found = explain_rest(remaining);
    for (const std::string& name : found.conflict) told().conflict.push_back(name);
    for (const RangeEnd& end : found.ranges) add_range(end);
    for (const RangeEnd& end : whole_number_ends(found.design)) add_range(end);
    move_each_end();
    return std::move(causes_);
  }

 private:
  static constexpr std::size_t kStarts = 4;

  Infeasibility& told() { return causes_.infeasibility; }

  bool exhausted() const {
    return causes_.stop != StopReason::finished || options_.stop.stop_requested() ||
           deadline_.passed() || share() == 0;
  }

  // A share of the remaining evaluations, so that no question uses up those of the others.
  std::size_t share() const {
    return causes_.counters.evaluations < most_
               ? (most_ - causes_.counters.evaluations) / questions_
               : 0;
  }

  Result ask(const Problem& problem, const Observer& observer, bool explain) {
    SolveOptions options = options_;
    options.observer = observer;
    options.analyse_infeasible = explain;
    options.budget.evaluations = share();
    options.first_stage += causes_.stages_used;
    Result result = solve_plainly(problem, options, deadline_);
    causes_.counters.add(result.counters);
    causes_.stages_used += result.stages_used;
    if (result.stop == StopReason::requested || result.stop == StopReason::seconds)
      causes_.stop = result.stop;
    return result;
  }

  // The least excess of a limit under all others. The first search for it began at one design only.
  void sharpen(Relaxation& limit) {
    if (!(limit.amount_alone > 0.0) || exhausted()) return;
    const auto found = std::ranges::find(problem_.constraints, limit.name, &Constraint::name);
    const auto row = static_cast<std::size_t>(found - problem_.constraints.begin());
    if (std::isfinite(found->lower) && std::isfinite(found->upper))
      return;  // its other side must hold
    Rows others(problem_.constraints.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(row));
    const Result best = best_value(row, limit.side, std::move(others));
    if (!is_found(best)) return;
    if (keeps(*found, limit.side, best)) causes_.feasible = best.design;
    limit.amount_alone = std::min(limit.amount_alone, excess(*found, limit.side, best));
  }

  // Moves the limits that are impossible by themselves from `remaining` to the report. False if there is none.
  bool take_impossible(const Infeasibility& found, Rows& remaining) {
    const std::size_t before = remaining.size();
    for (const Relaxation& limit : found.relaxations) {
      if (limit.amount == 0.0 || possible_without(limit, found)) continue;
      const auto row = std::ranges::find_if(
          remaining, [&](std::size_t i) { return problem_.constraints[i].name == limit.name; });
      if (row == remaining.end() || !impossible(*row, limit.side)) continue;
      told().conflict.push_back(limit.name);
      remaining.erase(row);
    }
    return remaining.size() < before;
  }

  // A design exists that keeps this limit if moving another one alone makes the problem feasible.
  static bool possible_without(const Relaxation& limit, const Infeasibility& found) {
    return std::ranges::any_of(found.relaxations, [&](const Relaxation& other) {
      return other.name != limit.name && std::isfinite(other.amount_alone);
    });
  }

  bool impossible(std::size_t row, Side side) {
    if (side != Side::equal) return impossible_side(row, side);
    return impossible_side(row, Side::lower) || impossible_side(row, Side::upper);
  }

  // Looks for the best value of one limit's response without any other limit, and reports it if the
  // limit is out of reach.
  bool impossible_side(std::size_t row, Side side) {
    if (exhausted()) return false;
    const Result best = best_value(row, side, {});
    const Constraint& c = problem_.constraints[row];
    if (!is_found(best) || keeps(c, side, best)) return false;
    Impossible found{c.name,
                     side,
                     bound_of(c, side),
                     best.evaluation.values[0],
                     best.outcome == Outcome::optimal,
                     {},
                     best.design};
    for (const RangeEnd& end : ends_of(best)) found.ends.push_back(add_range(end));
    told().impossible.push_back(std::move(found));
    return true;
  }

  // The best value of one limit's response under some of the limits.
  Result best_value(std::size_t row, Side side, Rows limits) {
    const std::size_t response = problem_.objectives.size() + row;
    const Sense sense = side == Side::lower ? Sense::maximize : Sense::minimize;
    Restated best =
        restate(problem_, {Question::About::response, response, sense, std::move(limits)},
                options_.observer);
    start_at(best.problem, design_);
    return ask(best.problem, best.observer, false);
  }

  static bool is_found(const Result& result) {
    return result.outcome == Outcome::optimal || result.outcome == Outcome::feasible;
  }

  static double bound_of(const Constraint& c, Side side) {
    return side == Side::lower ? c.lower : c.upper;
  }

  static double excess(const Constraint& c, Side side, const Result& best) {
    const double value = best.evaluation.values[0];
    return side == Side::lower ? c.lower - value : value - c.upper;
  }

  bool keeps(const Constraint& c, Side side, const Result& best) const {
    const double terms = term_magnitude(problem_, 0, best.evaluation, best.design);
    return excess(c, side, best) <=
           limit_tolerance(c, bound_of(c, side), terms, options_.feasibility_tolerance);
  }

  // Ends of ranges that restrain an optimum, and those at which its integer variables are.
  std::vector<RangeEnd> ends_of(const Result& result) const {
    std::vector<RangeEnd> ends;
    for (const Activity& a : result.certificate.limits)
      if (a.is_bound && a.multiplier > 0.0) ends.push_back({a.name, a.side, a.limit});
    for (RangeEnd& end : whole_number_ends(result.design)) ends.push_back(std::move(end));
    return ends;
  }

  std::vector<RangeEnd> whole_number_ends(std::span<const double> design) const {
    std::vector<RangeEnd> ends;
    for (std::size_t j = 0; j < design.size(); ++j) {
      const Variable& v = problem_.variables[j];
      const double low = std::ceil(v.lower), high = std::floor(v.upper);
      if (!v.integer || low == high) continue;
      if (design[j] == low) ends.push_back({v.name, Side::lower, v.lower});
      if (design[j] == high) ends.push_back({v.name, Side::upper, v.upper});
    }
    return ends;
  }

  // Its position in the report.
  std::size_t add_range(const RangeEnd& end) {
    auto& ranges = told().ranges;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (ranges[i].variable == end.variable && ranges[i].side == end.side) return i;
    ranges.push_back(end);
    return ranges.size() - 1;
  }

  // No multiplier shows whether a whole number is held back by the end where it is, so such an end is
  // reported only if moving it alone helps.
  void move_each_end() {
    for (std::size_t i = 0; i < told().ranges.size();) {
      RangeEnd& end = told().ranges[i];
      const auto v = std::ranges::find(problem_.variables, end.variable, &Variable::name);
      questions_ = told().ranges.size() - i;
      end.limit_alone =
          end_alone(static_cast<std::size_t>(v - problem_.variables.begin()), end.side);
      if (v->integer && std::isnan(end.limit_alone))
        drop_range(i);
      else
        ++i;
    }
  }

  void drop_range(std::size_t position) {
    told().ranges.erase(told().ranges.begin() + static_cast<std::ptrdiff_t>(position));
    for (Impossible& limit : told().impossible) {
      std::erase(limit.ends, position);
      for (std::size_t& end : limit.ends)
        if (end > position) --end;
    }
  }

  // Where one end of a range has to be so that a design keeps every limit, by a search beyond that end.
  // Its designs lie outside the ranges, so the observer is not told of them.
  double end_alone(std::size_t variable, Side side) {
    if (exhausted()) return std::nan("");
    Question nearest{Question::About::variable, variable,
                     side == Side::upper ? Sense::minimize : Sense::maximize,
                     Rows(problem_.constraints.size())};
    std::iota(nearest.constraints.begin(), nearest.constraints.end(), std::size_t{0});
    Restated moved = restate(problem_, nearest, {});
    start_at(moved.problem, design_);
    if (!extend(moved.problem.variables[variable], side)) return std::nan("");
    const Result result = ask(moved.problem, {}, false);
    const bool feasible = result.certificate.infeasibility <= options_.feasibility_tolerance;
    return feasible ? result.design[variable] : std::nan("");
  }

  // What is left to explain without the limits that are impossible by themselves.
  Infeasibility explain_rest(const Rows& remaining) {
    if (remaining.empty() || exhausted()) return {};
    Restated rest =
        restate(problem_, {Question::About::response, 0, problem_.objectives[0].sense, remaining},
                options_.observer);
    start_at(rest.problem, design_);
    return ask(rest.problem, rest.observer, true).infeasibility;
  }

  static void start_at(Problem& problem, std::span<const double> design) {
    for (std::size_t j = 0; j < design.size(); ++j) problem.variables[j].start = design[j];
  }

  const Problem& problem_;
  SolveOptions options_;
  const Deadline& deadline_;
  std::size_t most_;
  std::vector<double> design_;
  std::size_t questions_{
      // number of questions that share the remaining evaluations; the true number is not known beforehand
      4};
  Causes causes_;
};

}  // namespace

std::size_t cost_of_causes(const Counters& search, const Budget& budget) {
  constexpr std::size_t kLeast =
      3000;  // a search that soon sees that it is in vain leaves the causes open
  const std::size_t used = std::min(search.evaluations, budget.evaluations);
  return std::min(std::max(3 * used, kLeast), budget.evaluations - used);
}

Causes find_causes(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                   std::size_t most, Infeasibility found) {
  return Investigation(problem, options, deadline, most).run(std::move(found));
}

}  // namespace twum::inline v0_1::optim
