// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/statistic.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

constexpr double kWorthTelling =
    0.01;  // share of the failures from which a limit is named in a sentence
// of the most valuable tolerance; cheaper ones may be loosened
constexpr double kCheapTolerance = 0.05;

Json robust_limit_json(const RobustLimit& limit) {
  Json importance = Json::object();
  for (const NamedValue& one : limit.importance) importance[one.name] = number_json(one.value);
  return {{"text", limit.text},
          {"sense", limit.at_least ? "at least" : "at most"},
          {"target", limit.target},
          {"beta", number_json(limit.beta)},
          {"probability", number_json(limit.probability)},
          {"share", number_json(limit.share)},
          {"importance", importance},
          {"converged", limit.converged}};
}

Json statistic_json(const RobustStatistic& statistic) {
  return {{"text", statistic.text},
          {"unit", statistic.unit},
          {"lower", number_json(statistic.lower)},
          {"upper", number_json(statistic.upper)},
          {"value", number_json(statistic.value.value)},
          {"low", number_json(statistic.value.low)},
          {"high", number_json(statistic.value.high)}};
}

Json density_json(const RobustDensity& density) {
  return {{"metric", density.metric},
          {"unit", density.unit},
          {"lower", number_json(density.lower)},
          {"upper", number_json(density.upper)},
          {"first", number_json(density.first)},
          {"width", number_json(density.width)},
          {"motors", density.motors},
          {"nominal", density.nominal}};
}

std::string spread_words(const RobustTolerance& tolerance) {
  return tolerance.unit == "%" ? rounded_text(tolerance.spread, 4) + " %"
                               : engineering(tolerance.spread, tolerance.unit);
}

const RobustTolerance* dearest(const RobustReport& report) {
  const auto most = std::max_element(report.tolerances.begin(), report.tolerances.end(),
                                     [](const RobustTolerance& a, const RobustTolerance& b) {
                                       return std::fabs(a.gain) < std::fabs(b.gain);
                                     });
  return most == report.tolerances.end() || !(most->gain != 0) ? nullptr : &*most;
}

// "52 % violate wear_intensity_at(80 rpm) <= 5 kW/m^2, 46 % violate no_load_speed >= 100 rpm"
std::string failing_words(const RobustReport& report) {
  std::vector<const RobustLimit*> list;
  for (const RobustLimit& limit : report.limits)
    if (limit.share >= kWorthTelling) list.push_back(&limit);
  std::stable_sort(list.begin(), list.end(),
                   [](const auto* a, const auto* b) { return a->share > b->share; });
  std::string text;
  for (const RobustLimit* limit : list)
    text += (text.empty() ? "" : ", ") + percent_words(limit->share, 2) + " violate " + limit->text;
  return text;
}

std::string price_words(const RobustReport& report, const Goal& goal) {
  std::string text =
      "Without tolerances the optimum is " + engineering(report.nominal_objective, goal.unit);
  if (std::isfinite(report.nominal_yield.value))
    text += ", and " + percent_words(report.nominal_yield.value, 3) + " of its motors would pass";
  const double price = std::fabs(report.nominal_objective - report.objective);
  return text + ": the tolerances cost " + engineering(price, goal.unit, 3) + " (" +
         percent_words(price / std::fabs(report.nominal_objective), 2) + ").\n";
}

std::string risk_table(const RobustReport& report) {
  TextTable table{{{"limit", "motors that violate it", "of the failures", "index", "mostly by"}}};
  for (const RobustLimit& limit : report.limits) {
    const auto most = std::max_element(
        limit.importance.begin(), limit.importance.end(),
        [](const NamedValue& a, const NamedValue& b) { return a.value < b.value; });
    const bool known = most != limit.importance.end() && limit.converged;
    table.rows.push_back({limit.text, percent_words(limit.probability, 3),
                          percent_words(limit.share, 2), rounded_text(limit.beta, 3),
                          known ? most->name + " (" + percent_words(most->value, 2) + ")"
                                : "worst point not found exactly"});
  }
  return "\n" + aligned(table);
}

// Names tolerances that may be loosened because they have little effect.
std::string loose_words(const RobustReport& report, const RobustTolerance& most) {
  std::vector<std::string> names;
  for (const RobustTolerance& one : report.tolerances)
    if (std::fabs(one.gain) < kCheapTolerance * std::fabs(most.gain)) names.push_back(one.name);
  if (names.empty()) return {};
  const bool one = names.size() == 1;
  return std::string(one ? "That of " : "Those of ") + enumeration(names) +
         (one ? " costs" : " each cost") +
         " less than 5 % of it: try twice the spread and solve again.\n";
}

// "0.012 % (0.0105 % to 0.0135 %)"
std::string sampled_words(const Estimate& gain) {
  if (std::isnan(gain.value)) return "-";
  return percent_words(gain.value, 2) + " (" + percent_words(gain.low, 2) + " to " +
         percent_words(gain.high, 2) + ")";
}

std::string price_table(const RobustReport& report, const Goal& goal) {
  if (report.prices_of_yields.empty()) return {};
  TextTable table{{{"yield", goal.metric}}};
  for (const optim::YieldPrice& one : report.prices_of_yields)
    table.rows.push_back({percent_words(one.yield), engineering(one.objective, goal.unit)});
  return "\n" + aligned(table);
}

std::string tolerance_table(const RobustReport& report, const Goal& goal) {
  TextTable table{{{"tolerance", "spread", "1 % tighter gains", "yield gains, same design",
                    "by the failing motors"}}};
  for (const RobustTolerance& one : report.tolerances)
    table.rows.push_back(
        {one.name, spread_words(one),
         std::isnan(one.gain) ? "-" : goal_change_words(one.gain * (goal.maximize ? 1 : -1), goal),
         percent_words(one.yield_gain, 2), sampled_words(one.sampled_gain)});
  return "\n" + aligned(table);
}

}  // namespace

namespace {

// " (15 failing per million)", where that is easier to read than nines.
std::string failing_per_million(double share) {
  constexpr double kFew = 1e-3;
  if (!(share < 1 && 1 - share < kFew)) return {};
  return " (" + rounded_text(1e6 * (1 - share), 2) + " failing per million)";
}

}  // namespace

Json robust_yield_json(const RobustYield& yield) {
  return {{"text", yield.text},
          {"target", number_json(yield.target)},
          {"value", number_json(yield.share.value)},
          {"low", number_json(yield.share.low)},
          {"high", number_json(yield.share.high)},
          {"samples", yield.samples},
          {"weighted", yield.weighted},
          {"verdict", yield.verdict.empty() ? Json(nullptr) : Json(yield.verdict)}};
}

std::string yield_words(const RobustYield& yield) {
  const std::string what = yield.text == "yield" ? "all limits" : yield.text;
  std::string text = percent_words(yield.share.value) + " of the motors keep " + what +
                     failing_per_million(yield.share.value) + ": " +
                     percent_words(yield.share.low) + " to " + percent_words(yield.share.high) +
                     " by " + std::to_string(yield.samples) +
                     (yield.weighted ? " new random motors about the worst points, weighted"
                                     : " new random motors");
  if (std::isfinite(yield.target))
    text += "; " + percent_words(yield.target) + " wanted: " + yield.verdict;
  return text + ".\n";
}

// Of a share near one, what is missing has two digits: 99.9985 %.
std::string percent_words(double share, int digits) {
  constexpr int kMost = 12;  // as many as are not rounding
  if (share > 0.9) digits = std::max(digits, 3);
  if (share > 0.9 && share < 1)
    digits = std::clamp(2 + static_cast<int>(std::floor(-std::log10(1 - share))), digits, kMost);
  return rounded_text(100 * share, digits) + " %";
}

bool is_share(const Goal& goal) {
  return is_statistic(goal.metric) && parse_statistic(goal.metric).unit() == "1";
}

std::string goal_change_words(double change, const Goal& goal) {
  if (!is_share(goal)) return change_words(change, goal.unit);
  return (change > 0 ? "+" : "") + percent_words(change, 3);
}

Json robust_json(const RobustReport& report) {
  Json json{{"target", nullptr}, {"yield", nullptr}};
  if (!report.yields.empty()) {
    json["target"] = number_json(report.yields.front().target);
    json["yield"] = robust_yield_json(report.yields.front());
  }
  json["yields"] = Json::array();
  for (const RobustYield& yield : report.yields) json["yields"].push_back(robust_yield_json(yield));
  json["statistics"] = Json::array();
  for (const RobustStatistic& one : report.statistics)
    json["statistics"].push_back(statistic_json(one));
  json["nominal"] = {{"design", values_json(report.nominal_design)},
                     {"objective", number_json(report.nominal_objective)},
                     {"yield", number_json(report.nominal_yield.value)}};
  json["price"] = number_json(std::fabs(report.nominal_objective - report.objective));
  json["price_of_yield"] = number_json(report.price_of_yield);
  json["price_over_yield"] = Json::array();
  for (const optim::YieldPrice& one : report.prices_of_yields)
    json["price_over_yield"].push_back(
        {{"yield", number_json(one.yield)}, {"objective", number_json(one.objective)}});
  json["largest_yield"] = number_json(report.largest_yield);
  json["limits"] = Json::array();
  for (const RobustLimit& limit : report.limits) json["limits"].push_back(robust_limit_json(limit));
  json["tolerances"] = Json::array();
  for (const RobustTolerance& one : report.tolerances)
    json["tolerances"].push_back(
        {{"name", one.name},
         {"sd", number_json(one.unit == "%" ? one.spread / 100 : one.spread)},
         {"unit", one.unit == "%" ? "1" : one.unit},
         {"gain_per_percent_tighter", number_json(one.gain)},
         {"yield_per_percent", number_json(one.yield_gain)},
         {"yield_per_percent_sampled",
          {{"value", number_json(one.sampled_gain.value)},
           {"low", number_json(one.sampled_gain.low)},
           {"high", number_json(one.sampled_gain.high)}}}});
  json["rounds"] = Json::array();
  for (const optim::RobustRoundReport& round : report.rounds)
    json["rounds"].push_back({{"samples", round.products},
                              {"risk", number_json(round.risk)},
                              {"error", number_json(round.error)},
                              {"objective", number_json(round.objective)}});
  Json delta = Json::object();
  for (const RobustLimit& limit : report.limits) delta[limit.text] = number_json(limit.delta);
  json["correction"] = {
      {"kappa", number_json(report.rounds.empty() ? 0 : report.rounds.back().kappa)},
      {"delta", delta}};
  json["aimed"] = report.aimed;
  json["lost"] = report.lost;
  json["densities"] = Json::array();
  for (const RobustDensity& density : report.densities)
    json["densities"].push_back(density_json(density));
  return json;
}

std::string robust_words(const RobustReport& report, const Goal& goal) {
  std::string text;
  if (std::isfinite(report.largest_yield))
    text += "The wanted yield cannot be reached: the largest found is " +
            percent_words(report.largest_yield) +
            ". The design that has it follows; tighten a tolerance or loosen a limit.\n";
  for (const RobustYield& yield : report.yields) text += yield_words(yield);
  for (const RobustStatistic& one : report.statistics)
    text += one.text + " is " + engineering(one.value.value, one.unit) + " (" +
            engineering(one.value.low, one.unit) + " to " + engineering(one.value.high, one.unit) +
            " by new random motors).\n";
  if (std::isfinite(report.nominal_objective)) text += price_words(report, goal);
  const std::string failing = failing_words(report);
  if (!failing.empty()) text += "Of the failing motors " + failing + ".\n";
  if (const RobustTolerance* most = dearest(report);
      most != nullptr && !std::isfinite(report.largest_yield))
    text += "The tolerance of " + most->name + " (" + spread_words(*most) +
            ") costs most; solve again with a tighter one to see what it is worth.\n" +
            loose_words(report, *most);
  if (report.price_of_yield > 0)
    text += "0.1 % more yield costs " + engineering(0.001 * report.price_of_yield, goal.unit, 3) +
            ".\n";
  std::uint64_t lost = 0;
  for (const auto& [reason, count] : report.lost) lost += count;
  if (lost > 0)
    text += counted(lost, "new random motor") + " without an answer, counted as failing.\n";
  return text + risk_table(report) + tolerance_table(report, goal) + price_table(report, goal);
}

}  // namespace twum::studies
