// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"

#include "results/calibration_words.hpp"
#include "results/search_words.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

using Bound = CalibrateResult::Bound;
using Notes = std::vector<std::string>;

// Root mean squares of what was measured and of what the motor gives [N m].
struct Sizes {
  double measured{0};
  double fitted{0};
};

Sizes sizes_of(const CalibrateResult& result) {
  Sizes sizes;
  for (const CalibrateResult::Point& point : result.data) {
    sizes.measured += point.value * point.value;
    sizes.fitted += point.fitted * point.fitted;
  }
  const auto count = static_cast<double>(result.data.size());
  return {std::sqrt(sizes.measured / count), std::sqrt(sizes.fitted / count)};
}

// Torques of the other sign that would fit in size: a test stand that counts the load as negative, or turns the other way.
bool reversed_signs(const CalibrateResult& result, Notes& notes) {
  const auto share = [&](auto&& has) {
    return static_cast<double>(std::count_if(result.data.begin(), result.data.end(), has)) /
           static_cast<double>(result.data.size());
  };
  constexpr double kMost = 0.5;
  const bool negative = share([](const auto& point) { return point.value < 0; }) > kMost;
  const bool opposite =
      share([](const auto& point) { return point.value * point.fitted <= 0; }) > kMost;
  if (!negative || !opposite) return false;
  const bool backward = share([](const auto& point) { return point.at < 0; }) > kMost;
  notes.push_back(
      backward
          ? "The signs of speed and torque look reversed: both are negative at most points. Give "
            "both as positive numbers where the motor drives."
          : "The signs of torque look reversed: most are negative, where the motor drives. A "
            "torque is "
            "positive where the motor drives its load.");
  return true;
}

// A unit taken for another shows in sizes or in signs.
void add_unit_hints(const CalibrateResult& result, Notes& notes) {
  const bool torques = std::all_of(result.data.begin(), result.data.end(),
                                   [](const auto& point) { return point.torque(); });
  if (!torques) return;
  if (reversed_signs(result, notes)) return;
  constexpr double kFar = 3;
  const Sizes sizes = sizes_of(result);
  const double ratio = sizes.measured / sizes.fitted;
  if (sizes.measured > 0 && sizes.fitted > 0 && (ratio > kFar || ratio < 1 / kFar))
    notes.push_back(
        "The measured torques are " + about(ratio > 1 ? ratio : 1 / ratio) + " times " +
        (ratio > 1 ? "larger" : "smaller") + " than those of the motor (root mean squares " +
        engineering(sizes.measured, "N.m", 3) + " and " + engineering(sizes.fitted, "N.m", 3) +
        "): check the unit of torque in the data file.");
  const auto opposite = static_cast<std::size_t>(
      std::count_if(result.data.begin(), result.data.end(),
                    [](const auto& point) { return point.value * point.fitted < 0; }));
  if (2 * opposite > result.data.size())
    notes.push_back("At " + std::to_string(opposite) + " of " +
                    counted(result.data.size(), "point") +
                    " the motor brakes where a driving torque was measured, or drives where a "
                    "braking one was: check the unit of speed in the data file.");
}

// A motor takes power from its terminals, so that conductance and resistance are positive.
void add_reversed_parts(const CalibrateResult& result, Notes& notes) {
  for (const std::string part : {"conductance", "resistance"}) {
    const auto of_part = [&](const auto& point) { return point.quantity == part; };
    const auto reversed = [&](const auto& point) { return of_part(point) && point.value < 0; };
    if (2 * std::ranges::count_if(result.data, reversed) >
        std::ranges::count_if(result.data, of_part))
      notes.push_back("The signs of " + part +
                      " look reversed: most are negative, but a motor takes power from its "
                      "terminals. Give the column 'sign: reversed' under 'columns'.");
  }
}

// "torque at 105 rpm", "no_load_speed"
std::string reading_of(const CalibrateResult::Point& point) {
  return point.torque() ? "torque" + place_words(point) : place_words(point).substr(4);
}

// " It misses the torque at 100 rpm by 60 mN.m, 12 % of it. ..."
std::string missed_words(const CalibrateResult& result) {
  const CalibrateResult::Point* point = result.missed();
  if (point == nullptr) return {};
  const double part = std::fabs(point->residual / point->value);
  return " It misses the " + reading_of(*point) + " by " +
         engineering(std::fabs(point->residual), point->unit, 3) +
         (std::isfinite(part) ? ", " + about(100 * part) + " % of it" : "") +
         ". Without standard deviations, and with fewer than " +
         std::to_string(CalibrateResult::kKnownScatter) +
         " points more than parameters, a deviation of 5 % of the number or of 2 % of the largest "
         "number is accepted.";
}

void add_misfit(const CalibrateResult& result, Notes& notes) {
  if (!result.poor()) return;
  std::string text = "The fit is poor: the residuals";
  const bool offset = result.shifted() && result.offset->p <= result.chance();
  if (offset)
    text +=
        " of " + column_name(*result.offset) + " share an offset: " + offset_words(*result.offset);
  else if (result.chi_square && result.chi_square_p < kUnlikely)
    text += " are larger than the standard deviations given";
  else if (result.worst_kind)
    text += " of " + result.worst_kind->quantity + " are larger than the standard deviations given";
  else if (result.neighbours && result.neighbours->p < kUnlikely && result.alike())
    text +=
        " of " +
        (result.neighbours_of.quantity == "torque_at" ? "torque" : result.neighbours_of.quantity) +
        " are nearly equal: the motor misses each of these numbers by the same amount";
  else if (result.neighbours && result.neighbours->p < kUnlikely)
    text += " keep their sign over whole stretches of " + result.neighbours_of.over;
  else
    text += " are large";
  if (!offset && result.misfit() > 0)
    text += ", " + about(100 * result.misfit()) + " % of the largest " +
            (result.columns.size() > 1      ? "of a column"
             : result.data.front().torque() ? "torque"
                                            : result.data.front().quantity) +
            " (root mean square)";
  notes.push_back(text + "." + missed_words(result) +
                  " Possible causes: " + (offset ? "an instrument that was not zeroed, " : "") +
                  "an effect that the model leaves out, a parameter that should be "
                  "estimated too, a wrong point or a wrong unit. The intervals are not reliable.");
}

// Widened intervals are told with the reason, so that nobody wonders about their width.
void add_serial(const CalibrateResult& result, Notes& notes) {
  if (!result.serial || result.poor()) return;
  notes.push_back(
      "Neighbouring residuals are correlated (coefficient about " +
      about(result.serial->correlation) +
      "), so the points count as fewer. The intervals take this into account: they are up to " +
      about(result.serial->widening) +
      " times as wide as with independent errors. If the errors drift with time, measure the "
      "points in random order.");
}

// Deviations that are stated too large hide a misfit, and widen intervals that stand on them.
void add_smallness(const CalibrateResult& result, Notes& notes) {
  if (!result.chi_square || 1 - result.chi_square_p >= kRare) return;
  notes.emplace_back(
      "The residuals are smaller than the standard deviations given: the probability of so small a "
      "chi-square is less than 1 %. Check the standard deviations.");
}

void add_outliers(const CalibrateResult& result, Notes& notes) {
  constexpr std::size_t kMost = 5;
  constexpr double kFar = 1000;
  const std::string remedy = result.huber
                                 ? "Under 'loss: huber' it has little weight. Check the reading."
                                 : "Check the reading. Then leave out its line, or write 'loss: "
                                   "huber', which gives outliers little weight.";
  for (std::size_t k = 0; k < std::min(kMost, result.outliers.size()); ++k) {
    const CalibrateResult::Outlier& one = result.outliers[k];
    const CalibrateResult::Point& point = result.data[one.point];
    const double size = std::fabs(one.distance);
    const std::string where =
        point.where.empty() ? "point " + std::to_string(one.point + 1) : point.where;
    notes.push_back("Outlier " + where + ": " + "its " + reading_of(point) + " is " +
                    (size > kFar ? "more than 1000" : rounded_text(size, 2)) +
                    " standard deviations " + (one.distance > 0 ? "above" : "below") +
                    " the motor that the other points give (p = " + rounded_text(one.p, 2) + ")." +
                    (k == 0 ? " " + remedy : ""));
  }
  if (result.outliers.size() > kMost)
    notes.push_back(counted(result.outliers.size() - kMost, "more outlier") +
                    ": see 'outliers' in summary.json.");
}

void add_undetermined(const CalibrateResult::Undetermined& set, Notes& notes) {
  if (set.names.size() == 1) {
    notes.push_back("The data do not determine " + set.names[0] +
                    ": give it in the motor; do not estimate it.");
    return;
  }
  std::string text = enumeration(set.names) +
                     " act only in combination: the data cannot distinguish them. Give one of them "
                     "in the motor; do not estimate it.";
  if (std::isfinite(set.undone_by))
    text += " 1 % more " + set.names[0] + " is compensated by " +
            rounded_text(std::fabs(set.undone_by), 3) + " % " +
            (set.undone_by < 0 ? "less " : "more ") + set.names[1] + ".";
  notes.push_back(std::move(text));
}

// The change of the motor that the data determine least.
void add_combination(const CalibrateResult::Combination& combination, bool folded, Notes& notes) {
  if (combination.parts.size() < 2 && combination.unseen) return;  // told with its name
  std::string text = combination_words(combination);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  constexpr double kNothing = 1e-3;  // standard deviations
  if (combination.unseen && folded)
    text +=
        " fits nearly as well: close to the estimates no measured number changes to first order. "
        "Farther away the numbers do change; the intervals show by how much the parameters may "
        "differ.";
  else if (combination.unseen || combination.effect < kNothing)
    text += " fits equally well: to first order no measured number changes.";
  else if (std::isfinite(combination.effect))
    text += (combination.effect < 1 ? " fits nearly as well: "
                                    : " is the change that the data determine least: ") +
            std::string("the measured numbers change by ") + rounded_text(combination.effect, 2) +
            " standard deviations (root mean square).";
  else
    text += " is the change that the data determine least.";
  notes.push_back(std::move(text));
}

void add_several(const CalibrateResult& result, Notes& notes) {
  if (result.equals() < 2) return;
  notes.push_back("The data cannot distinguish " + std::to_string(result.equals()) +
                  " different motors, listed in the table of optima. Measure where their curves "
                  "differ most, or narrow the ranges.");
}

// Pairs that are determined, but hardly apart.
void add_correlated(const CalibrateResult& result, Notes& notes) {
  constexpr double kStrong = 0.95;
  const std::size_t n = result.estimates.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const double c = result.correlation[i * n + j];
      if (std::fabs(c) > kStrong)
        notes.push_back(result.estimates[i].parameter.name + " and " +
                        result.estimates[j].parameter.name +
                        " are strongly correlated: coefficient " + rounded_text(c, 4) + ".");
    }
  }
}

// "-1 % kinetic_friction"
std::string follower_words(const CalibrateResult::Estimate& e) {
  std::vector<std::string> parts;
  for (const CalibrateResult::Follower& follower : e.followers)
    parts.push_back((follower.percent > 0 ? "+" : "") + rounded_text(follower.percent, 2) + " % " +
                    follower.name);
  return enumeration(parts);
}

void add_held(const CalibrateResult& result, Notes& notes) {
  for (const CalibrateResult::Estimate& e : result.estimates) {
    if (e.bound == Bound::none) continue;
    std::string text = e.parameter.name + " is at its " + end_word(e.bound) +
                       ": the other estimates and their intervals are valid for " +
                       engineering(e.parameter.value, e.parameter.unit) + ".";
    const std::string followers = follower_words(e);
    if (!followers.empty()) text += " If it were 1 % larger, they would change: " + followers + ".";
    notes.push_back(std::move(text));
  }
}

void add_wide(const CalibrateResult& result, Notes& notes) {
  std::vector<std::string> wide;
  std::vector<std::string> little;
  std::vector<std::string> cut;
  for (const CalibrateResult::Estimate& e : result.estimates) {
    if (e.bound != Bound::none || !std::isfinite(e.low)) continue;
    if (wider_than_range(e))
      wide.push_back(e.parameter.name);
    else if (!CalibrateResult::of_use(e))
      little.push_back(e.parameter.name);
    if (e.low_cut != e.high_cut) cut.push_back(e.parameter.name);
  }
  if (!wide.empty())
    notes.push_back("The points hardly determine " + enumeration(wide) + ": " +
                    (wide.size() == 1 ? "its interval is wider than its range."
                                      : "their intervals are wider than their ranges."));
  if (!little.empty())
    notes.push_back("The points determine only poorly " + enumeration(little) + ": the ends of " +
                    (little.size() == 1 ? "its interval" : "their intervals") +
                    " differ by more than a factor of 3.");
  if (!cut.empty())
    notes.push_back("The interval of " + enumeration(cut) +
                    " ends at the end of its range: the points allow values beyond it.");
}

void add_starts(const CalibrateResult& result, Notes& notes) {
  const std::size_t count = result.starts.size();
  const auto short_of =
      std::count_if(result.starts.begin(), result.starts.end(),
                    [](const auto& s) { return s.outcome != optim::Outcome::optimal; });
  if (result.optima.size() == 1 && short_of == 0 && count > 1)
    notes.push_back("All " + std::to_string(count) + " starts ended in the same " +
                    (result.undetermined.empty() ? "optimum." : "valley."));
  if (result.optima.size() > 1)
    notes.push_back(std::to_string(count) + " starts ended in " +
                    std::to_string(result.optima.size()) +
                    " different optima; the first in the table has the smallest residuals.");
  if (count > 1 && 2 * result.optima.size() > count)
    notes.push_back("With so many optima, more starts may find a better one: try starts: " +
                    std::to_string(10 * result.optima.size()) + ".");
  if (short_of > 0)
    notes.push_back(std::to_string(short_of) + " of " + counted(count, "start") +
                    " did not reach an optimum; summary.json says why.");
}

void add_unfinished(const CalibrateResult& result, Notes& notes) {
  if (!result.unfinished.empty())
    notes.push_back("The search ended before it reached the smallest residuals: " +
                    result.unfinished + ". Run the study again with more starts.");
}

void add_freedom(const CalibrateResult& result, Notes& notes) {
  if (result.degrees_of_freedom == 0)
    notes.emplace_back(
        "There are as many points as parameters, so there are no residuals that show how good the "
        "estimates are.");
  if (result.exact) notes.emplace_back("The points lie on the curve to rounding.");
  if (result.exact && !result.stated)
    notes.emplace_back(
        "They show no scatter, and the intervals contain none. If you measured them, give the "
        "accuracy of the instrument as standard deviations and write 'scatter: stated'.");
  if (result.static_ratio != 1)
    notes.push_back("static_friction is " + rounded_text(result.static_ratio, 4) +
                    " times kinetic_friction, as in the motor, and changed with it.");
}

}  // namespace

const char* end_word(Bound bound) { return bound == Bound::min ? "min" : "max"; }

bool wider_than_range(const CalibrateResult::Estimate& e) {
  if (e.bound != Bound::none || !std::isfinite(e.low)) return false;
  if (e.low_cut && e.high_cut) return true;
  return e.scale == optim::Scale::log ? e.high / e.low > e.max / e.min
                                      : e.high - e.low > e.max - e.min;
}

std::vector<std::string> calibration_notes(const CalibrateResult& result) {
  Notes notes;
  if (result.estimates.empty()) return notes;
  if (result.at_bounds())
    notes.emplace_back(
        "Every parameter is at an end of its range, so nothing was fitted. Check the units in the "
        "heading of the data file, then the ranges.");
  add_reversed_parts(result, notes);
  if (result.at_bounds() || result.poor()) add_unit_hints(result, notes);
  if (!result.at_bounds()) add_misfit(result, notes);
  add_serial(result, notes);
  add_smallness(result, notes);
  add_outliers(result, notes);
  add_several(result, notes);
  for (const auto& set : result.undetermined) add_undetermined(set, notes);
  for (const auto& combination : result.combinations)
    add_combination(combination, result.folded, notes);
  add_wide(result, notes);
  add_correlated(result, notes);
  if (!result.at_bounds()) add_held(result, notes);
  add_unfinished(result, notes);
  add_freedom(result, notes);
  add_starts(result, notes);
  return notes;
}

}  // namespace twum::inline v0_1::studies
