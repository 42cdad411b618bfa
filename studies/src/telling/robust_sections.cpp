// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

/// Of the gain of the most valuable tolerance; cheaper ones may be loosened.
constexpr double kCheapTolerance = 0.05;
/// A share that misses 1 by less is told by the failing motors in a million as well.
constexpr double kFewFail = 1e-3;
/// The price of the yield is told for so much of it, and its picture begins here.
constexpr double kYieldStep = 0.001, kLeastYield = 0.895;
/// The largest yield whose price is computed.
constexpr double kMostYield = 0.999;

// Whether motors of the design were drawn after the search.
bool verified(const RobustReport& report) {
  return !report.yields.empty() || !report.statistics.empty();
}

bool reached(const RobustReport& report) { return !std::isfinite(report.largest_yield); }

Phrase interval(const Estimate& e, const auto& part) {
  return {part(e.value), " (", part(e.low), " to ", part(e.high), ")"};
}

Phrase statistic_phrase(const RobustStatistic& one) {
  const auto value = [&](double v) { return value_part(v, one.unit); };
  return {"The ",
          name_part(one.text),
          " is ",
          value(one.value.value),
          " (",
          value(one.value.low),
          " to ",
          value(one.value.high),
          ", from motors drawn after the search)."};
}

Phrase price_phrase(const RobustReport& report, const Goal& goal) {
  const double price = std::fabs(report.nominal_objective - report.objective);
  Phrase phrase{"Without tolerances the optimum has ", a_name_part(goal.metric), " of ",
                goal_part(goal, report.nominal_objective)};
  if (report.nominal_yield.value < 1)
    append(phrase,
           {", but only ", share_part(report.nominal_yield.value, 2), " of its motors would pass"});
  constexpr double kNothing = 1e-6;  // of the goal; a search ends within less
  if (price <= kNothing * std::fabs(report.nominal_objective))
    append(phrase, {". The tolerances cost nothing."});
  else
    append(phrase, {". The tolerances cost ", goal_part(goal, price, 3), " (",
                    share_part(price / std::fabs(report.nominal_objective), 2), ")."});
  return phrase;
}

std::vector<Phrase> lost_phrase(const RobustReport& report) {
  std::uint64_t lost = 0;
  for (const auto& [reason, count] : report.lost) lost += count;
  if (lost == 0) return {};
  return {{counted(lost, "motor") + " of the sample could not be computed; counted as failing."}};
}

// The other yields and statistics, and what the tolerances cost against the optimum without them.
Section against_nominal(const RobustReport& report, const Goal& goal) {
  Section section{{"Comparison with the optimum without tolerances"}};
  const std::size_t told = reached(report) ? 1 : 0;  // in the headline
  for (std::size_t i = told; i < report.yields.size(); ++i)
    section.sentences.push_back(yield_phrase(report.yields[i]));
  for (const RobustStatistic& one : report.statistics)
    section.sentences.push_back(statistic_phrase(one));
  if (std::isfinite(report.nominal_objective))
    section.sentences.push_back(price_phrase(report, goal));
  for (const Phrase& phrase : parts_sentence(report.parts, report.part_count))
    section.sentences.push_back(phrase);
  for (const Phrase& phrase : lost_phrase(report)) section.sentences.push_back(phrase);
  return section;
}

// A limit is drawn unless it is far from all motors.
std::vector<Guide> limit_guides(const RobustDensity& density, double first, double last) {
  std::vector<Guide> guides;
  for (const double limit : {density.lower, density.upper})
    if (limit > first - (last - first) && limit < last + (last - first))
      guides.push_back(
          {limit, {limit == density.lower ? "≥ " : "≤ ", value_part(limit, density.unit)}});
  return guides;
}

// One metric: shares of the motors in bins, and those of the optimum without tolerances as an outline.
Section density(const RobustReport& report, std::size_t i) {
  const RobustDensity& density = report.densities[i];
  const std::string other =
      std::isfinite(report.nominal_objective) ? "optimum without tolerances" : "original motor";
  const std::string where = "robust/densities/" + std::to_string(i) + "/";
  Numbers edges{"", {}}, keep{"", {}}, fail{"", {}};
  for (std::size_t k = 0; k <= density.motors.size(); ++k)
    edges.values.push_back(density.first + static_cast<double>(k) * density.width);
  for (std::size_t k = 0; k < density.motors.size(); ++k) {
    const double middle = edges.values[k] + 0.5 * density.width;
    const bool keeps = middle >= density.lower && middle <= density.upper;
    keep.values.push_back(keeps ? density.motors[k] : 0);
    fail.values.push_back(keeps ? 0 : density.motors[k]);
  }
  Chart chart{
      "density-" + density.metric,
      {"spread of ", name_part(density.metric)},
      {{name_part(density.metric)}, density.unit, false, edges.values.front(), edges.values.back()},
      {{"motors per bin"}, "%", true},
      {{"keeps the limit", Stroke::bars, edges, keep},
       {"violates the limit", Stroke::bars, edges, fail, "c1"},
       {other, Stroke::outline, edges, {where + "nominal", density.nominal}, "ink"}},
      limit_guides(density, edges.values.front(), edges.values.back()),
      {},
      density.lower,
      density.upper};
  Section section{
      {name_part(density.metric)},
      {"Distribution over the motors of the robust design; the outline shows the " + other + "."}};
  section.charts = {chart};
  section.wide = false;
  return section;
}

Table risk_table(const RobustReport& report) {
  Table table{
      "risk", {{"limit"}, {"motors that violate it"}, {"share of the failures"}, {"index"}}, {}};
  for (const NamedValue& one : report.limits.front().importance)
    table.heads.push_back({name_part(one.name)});
  for (const RobustLimit& limit : report.limits) {
    table.rows.push_back({{limit_part(limit.text)},
                          {share_part(limit.probability, 3)},
                          {share_part(limit.share, 3)},
                          {value_part(limit.beta, "1", 3)}});
    for (const NamedValue& one : limit.importance)
      table.rows.back().push_back({share_part(limit.converged ? one.value : std::nan(""), 2)});
  }
  return table;
}

// Which limits fail, and through which tolerance.
Section risk(const RobustReport& report) {
  Section section{{"Causes of failures"},
                  {"Share of the failing motors that violate each limit",
                   report.parts.empty() ? ", and the part of it that each tolerance causes" : "",
                   ". The index is the number of standard deviations between the design and the "
                   "limit."}};
  section.bars.name = "risk";
  section.bars.title = {"limits that the failing motors violate"};
  section.bars.axis = {"share of the failing motors"};
  section.bars.unit = "%";
  section.bars.of = 2;
  section.bars.full = 1;
  for (const RobustLimit& limit : report.limits)
    if (!limit.converged)
      section.sentences.push_back(
          {"The worst point of ", limit_part(limit.text),
           " was not found exactly, so the causes of its failures are unknown."});
  section.tables = {risk_table(report)};
  return section;
}

Part spread_part(const RobustTolerance& one) {
  return one.unit == "%" ? share_part(one.spread / 100) : value_part(one.spread, one.unit);
}

// "0.0047 % (0.003 % to 0.0064 %)": counted from the failing motors, without any derivative.
Phrase sampled_phrase(const Estimate& gain) {
  if (std::isnan(gain.value)) return {share_part(gain.value)};
  return interval(gain, [](double share) { return share_part(share, 2); });
}

// In order of the gain.
std::vector<RobustTolerance> by_gain(const RobustReport& report) {
  std::vector<RobustTolerance> list = report.tolerances;
  const auto gain = [](const RobustTolerance& one) {
    return std::isnan(one.gain) ? -1 : std::fabs(one.gain);
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const auto& a, const auto& b) { return gain(a) > gain(b); });
  return list;
}

// What to tighten, and what may be loosened because it has little effect.
std::vector<Phrase> advice(const std::vector<RobustTolerance>& list) {
  const RobustTolerance& most = list.front();
  if (!(std::fabs(most.gain) > 0)) return {};
  Phrase phrase{"Tighten the tolerance of the ", name_part(most.name), " (", spread_part(most),
                ") first. Solve again with a tighter tolerance to see the gain."};
  std::vector<Part> cheap;
  for (const RobustTolerance& one : list)
    if (std::fabs(one.gain) < kCheapTolerance * std::fabs(most.gain))
      cheap.push_back(name_part(one.name));
  if (cheap.empty()) return {phrase};
  append(phrase, {cheap.size() == 1 ? " That of " : " Those of "});
  append(phrase, listed(cheap));
  append(phrase, {cheap.size() == 1 ? " costs" : " each cost", " less than ",
                  share_part(kCheapTolerance), " of it: try twice the spread, and solve again."});
  return {phrase};
}

// What each tolerance costs.
Section costs(const RobustReport& report, const Goal& goal) {
  Section section{{"Cost of the tolerances"},
                  {"Gain in ", name_part(goal.metric),
                   " if a tolerance is 1 % tighter (3 % becomes 2.97 %), to first order. For a "
                   "large change solve again."}};
  if (!report.parts.empty())
    append(section.note, {" Gains that follow from failures are not known in advance with measured "
                          "parts; the last column counts failing motors."});
  if (report.price_of_yield > 0)
    append(section.note, {" ", share_part(kYieldStep), " more yield costs ",
                          goal_part(goal, kYieldStep * report.price_of_yield, 3), "."});
  section.bars.name = "tolerances";
  section.bars.title = {"cost of each tolerance"};
  section.bars.axis = {name_part(goal.metric), " gained per 1 % tighter tolerance"};
  section.bars.unit = goal_axis(goal).unit;
  section.bars.of = 2;
  const std::vector<RobustTolerance> list = by_gain(report);
  if (reached(report)) section.sentences = advice(list);
  Table table{"tolerances",
              {{"tolerance"},
               {"spread"},
               {"gain if 1 % tighter"},
               {"gain in yield, same design"},
               {"estimated from failing motors"}},
              {}};
  for (const RobustTolerance& one : list)
    table.rows.push_back({{name_part(one.name)},
                          {spread_part(one)},
                          {goal_part(goal, one.gain, 3)},
                          {share_part(one.yield_gain, 2)},
                          sampled_phrase(one.sampled_gain)});
  section.tables = {table};
  return section;
}

Chart price_chart(const RobustReport& report, const Goal& goal) {
  Numbers yields{"robust/price_over_yield/*/yield", {}},
      goals{"robust/price_over_yield/*/objective", {}};
  for (const optim::YieldPrice& one : report.prices_of_yields) {
    yields.values.push_back(one.yield);
    goals.values.push_back(one.objective);
  }
  Chart chart{
      "yield", {"cost of the yield"}, {{"yield"}, "%", false, kLeastYield, 1}, goal_axis(goal)};
  chart.series = {{"", Stroke::line, yields, goals}, {"", Stroke::dots, yields, goals}};
  if (reached(report) && !report.yields.empty() && std::isfinite(report.objective))
    chart.marks = {{report.yields.front().target, report.objective, {"this design"}}};
  return chart;
}

// The goal over the yield; it ends at the largest yield.
Section price_of_yield(const RobustReport& report, const Goal& goal) {
  Section section{
      {"Cost of the yield"},
      {"The best ", name_part(goal.metric),
       " for each share of motors that keep all limits, with all variables optimized again."}};
  const double last = report.prices_of_yields.back().yield;
  if (last < kMostYield)
    append(section.note,
           {" It ends at the largest yield within the ranges, ", share_part(last), "."});
  if (report.prices_of_yields.size() > 1) section.charts = {price_chart(report, goal)};
  Table table{"yield-price", {{"yield"}, {name_part(goal.metric)}}, {}};
  for (const optim::YieldPrice& one : report.prices_of_yields)
    table.rows.push_back({{share_part(one.yield)}, {goal_part(goal, one.objective)}});
  section.tables = {table};
  return section;
}

const char* verdict_words(const std::string& verdict) {
  if (verdict == "holds") return " This reaches the required share, ";
  if (verdict == "broken") return " This is below the required share, ";
  return " The sample is too small to distinguish this from the required share, ";
}

}  // namespace

Phrase yield_phrase(const RobustYield& yield) {
  const double share = yield.share.value;
  Phrase phrase{strong(share_part(share)), " of the motors keep ",
                yield.text == "yield" ? Part("all limits") : limit_part(yield.text)};
  if (share < 1 && 1 - share < kFewFail)
    phrase.push_back(", " + about(1e6 * (1 - share)) + " in a million fail");
  append(phrase, {" (", share_part(yield.share.low), " to ", share_part(yield.share.high),
                  ", from " + std::to_string(yield.samples) + " motors drawn after the search" +
                      (yield.weighted ? " near the worst points, and weighted" : "") + ")."});
  if (std::isfinite(yield.target))
    append(phrase, {verdict_words(yield.verdict), share_part(yield.target), "."});
  return phrase;
}

std::vector<Phrase> parts_sentence(const std::string& table, std::uint64_t count) {
  if (table.empty()) return {};
  return {{"Each motor is one of the " + counted(count, "measured part") + " in " + quoted(table) +
           "."}};
}

Phrase robust_sentence(const RobustReport& report) {
  if (!reached(report))
    return {strong("The required yield cannot be reached"), "; the largest found is ",
            share_part(report.largest_yield),
            ". The design shown has this yield. Tighten a tolerance or loosen a limit."};
  if (!verified(report))
    return {
        "The search ended before any motors were drawn, so it is not known how many keep the "
        "limits."};
  return report.yields.empty() ? statistic_phrase(report.statistics.front())
                               : yield_phrase(report.yields.front());
}

std::vector<Section> robust_sections(const RobustReport& report, const Goal& goal) {
  if (!verified(report)) return {};
  std::vector<Section> list;
  if (Section first = against_nominal(report, goal); !first.sentences.empty())
    list.push_back(std::move(first));
  for (std::size_t i = 0; i < report.densities.size(); ++i) list.push_back(density(report, i));
  if (!report.limits.empty()) list.push_back(risk(report));
  if (!report.tolerances.empty()) list.push_back(costs(report, goal));
  if (!report.prices_of_yields.empty()) list.push_back(price_of_yield(report, goal));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
