// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"
#include "results/calibration_words.hpp"
#include "telling/curve_charts.hpp"
#include "telling/fit_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace twum::inline v0_1::studies::telling {
namespace {

using Reading = CalibrateResult::Point;
using Fitted = CalibrateResult::Estimate;

// "speed at 500 mN·m, preload 160 N"
Phrase reading_phrase(const Reading& point) {
  std::string name = point.quantity;
  if (point.argument != Argument::none)
    name += "(" + engineering(point.at, point.argument == Argument::speed ? "rad/s" : "N.m") +
            (point.after ? ", " + engineering(*point.after, "s") : "") + ")";
  Phrase phrase{name_part(name)};
  for (const NamedValue& set : point.set)
    append(phrase, {", ", name_part(set.name), " ", value_part(set.value, set.unit)});
  return phrase;
}

// Remarks, and the correlations of many parameters, need the whole width of a page.
bool needs_width(const CalibrateResult& answer) {
  constexpr std::size_t kFew = 4;
  return answer.estimates.size() > kFew ||
         std::ranges::any_of(answer.estimates,
                             [&](const Fitted& e) { return !estimate_remark(answer, e).empty(); });
}

Section estimates(const CalibrateResult& answer) {
  Section section{{"Estimates with intervals of ", share_part(answer.confidence, 3)}};
  section.wide = needs_width(answer);
  const bool remarks = std::ranges::any_of(
      answer.estimates, [&](const Fitted& e) { return !estimate_remark(answer, e).empty(); });
  Table table{"estimates", {{"parameter"}, {"value"}, {"low"}, {"high"}}, {}};
  if (remarks) table.heads.push_back({"remark"});
  for (const Fitted& e : answer.estimates) {
    const int digits = interval_digits(e.low, e.high);
    table.rows.push_back({estimate_name(e)});
    for (const double value : {e.parameter.value, e.low, e.high})
      table.rows.back().push_back({value_part(value, e.parameter.unit, digits)});
    if (remarks) table.rows.back().push_back({bad(estimate_remark(answer, e))});
  }
  for (const NamedValue& value : answer.derived)
    section.sentences.push_back(
        {name_part(value.name), " is derived: ", value_part(value.value, value.unit), "."});
  section.tables = {table};
  return section;
}

std::vector<Section> correlation(const CalibrateResult& answer) {
  const std::size_t n = answer.estimates.size();
  if (n < 2) return {};
  Section section{{"Correlation of the estimates"},
                  {"Near 1 or -1 the data hardly distinguish the two parameters."}};
  if (answer.folded)
    append(section.note, {" A dash marks an unknown value: " + fold_words() + "."});
  section.wide = needs_width(answer);
  Table table{"correlation", {{"parameter"}}, {}};
  table.shaded = true;
  for (std::size_t i = 0; i < n; ++i) {
    table.heads.push_back(estimate_name(answer.estimates[i]));
    table.rows.push_back({estimate_name(answer.estimates[i])});
    for (std::size_t j = 0; j < n; ++j) {
      const double value = i == j ? 1 : answer.correlation[i * n + j];
      table.rows.back().push_back({value_part(std::round(100 * value) / 100 + 0.0, "1")});
    }
  }
  section.tables = {table};
  return {section};
}

// A root mean square in its unit, or in standard deviations.
Phrase rms_phrase(double rms, const std::string& unit) {
  if (unit != "1") return {value_part(rms, unit, 3)};
  return {value_part(rms, unit, 3), " standard deviations"};
}

Phrase residual_phrase(const CalibrateResult& answer) {
  const bool mixed = answer.unit == "1";  // then the largest is that in standard deviations
  const auto size = [&](const Reading& point) {
    if (!point.counts) return -1.0;
    return std::fabs(point.residual) * (mixed ? std::sqrt(point.weight) : 1);
  };
  const Reading& largest = *std::ranges::max_element(answer.data, {}, size);
  const auto left_out = static_cast<std::size_t>(
      std::ranges::count_if(answer.data, [](const Reading& point) { return !point.counts; }));
  Phrase phrase{counted(answer.data.size() - left_out, "point") +
                (left_out > 0 ? " without " + counted(left_out, "outlier") : "") +
                ", residual rms "};
  append(phrase, rms_phrase(answer.residual_rms, answer.unit));
  append(phrase, {", largest ", value_part(largest.residual + 0.0, largest.unit, 3), " of "});
  append(phrase, reading_phrase(largest));  // -0 + 0 is 0
  append(phrase, {" (measured - fitted)."});
  return phrase;
}

// Below this the integral of (L4.1) is no more than its own error.
Phrase chance_phrase(double p) {
  constexpr double kLeast = 1e-6;
  if (p < kLeast) return {"p < ", value_part(kLeast, "1")};
  return {"p = ", value_part(p, "1", 2)};
}

Phrase with_chance(Phrase phrase, double p) {
  append(phrase, chance_phrase(p));
  append(phrase, {"."});
  return phrase;
}

Phrase neighbour_phrase(const CalibrateResult& answer) {
  const auto& of = answer.neighbours_of;
  const std::string count = std::to_string(answer.neighbours->count);
  const std::string quantity = quantity_words(of.quantity), over = of.over;
  if (answer.alike())
    return with_chance(
        {"The " + count + " residuals of " + quantity + " in order of ", name_part(over),
         " are nearly equal; independent residuals would be as similar with "},
        answer.neighbours->p);
  return with_chance(
      {"Neighbouring residuals of " + quantity + " in order of ", name_part(over), ": correlation ",
       value_part(answer.neighbours->correlation, "1", 2), " of " + count + " points, "},
      answer.neighbours->p);
}

Phrase chi_square_phrase(const Phrase& of, double chi_square, const std::string& count, double p) {
  Phrase phrase = of;
  append(phrase, {": chi-square ", value_part(chi_square, "1"), count + ", "});
  return with_chance(std::move(phrase), p);
}

std::vector<Phrase> test_phrases(const CalibrateResult& answer) {
  std::vector<Phrase> list{residual_phrase(answer)};
  if (!answer.columns.empty()) {
    list.push_back({"Scatter of each column, from its residuals: "});
    for (const CalibrateResult::ColumnScatter& one : answer.columns)
      append(list.back(), {&one == &answer.columns.front() ? "" : ", ",
                           quantity_words(one.quantity) + " (" + one.table + ") ",
                           value_part(one.deviation, one.unit, 3)});
    append(list.back(), {"."});
  }
  if (answer.chi_square)
    list.push_back(
        chi_square_phrase({"Scatter against the standard deviations given"}, *answer.chi_square,
                          " with " + counted(answer.counting_freedom(), "degree") + " of freedom",
                          answer.chi_square_p));
  if (answer.worst_kind)
    list.push_back(chi_square_phrase(
        {quantity_words(answer.worst_kind->quantity) + " alone"}, answer.worst_kind->chi_square,
        " for " + counted(answer.worst_kind->count, "number"), answer.worst_kind->p));
  if (answer.neighbours) list.push_back(neighbour_phrase(answer));
  if (answer.offset)
    list.push_back(with_chance(
        {"Offset of " + column_name(*answer.offset) + ": " + offset_words(*answer.offset) + ", "},
        answer.offset->p));
  return list;
}

Table optima_table(const CalibrateResult& answer) {
  Table table{"optima", {{"starts"}, {"residual rms"}}, {}};
  for (const Fitted& e : answer.estimates) table.heads.push_back(estimate_name(e));
  table.heads.push_back({"remark"});
  for (const CalibrateResult::Optimum& optimum : answer.optima) {
    table.rows.push_back(
        {{count_part(optimum.starts)}, {rms_phrase(optimum.residual_rms, answer.unit)}});
    for (std::size_t j = 0; j < optimum.values.size(); ++j)
      table.rows.back().push_back(
          {value_part(optimum.values[j], answer.estimates[j].parameter.unit)});
    table.rows.back().push_back({&optimum == &answer.optima.front() ? "the answer"
                                 : optimum.fits_as_well             ? "fits equally well"
                                 : optimum.same_valley              ? "same valley"
                                                                    : "-"});
  }
  return table;
}

Section fit_quality(const CalibrateResult& answer) {
  Section section{{"Quality of the fit"}};
  section.sentences = test_phrases(answer);
  if (answer.optima.size() > 1) section.tables = {optima_table(answer)};
  return section;
}

Section points(const CalibrateResult& answer) {
  const bool stated =
      std::ranges::any_of(answer.data, [](const Reading& p) { return p.deviation > 0; });
  std::map<std::size_t, double> outliers;
  for (const CalibrateResult::Outlier& one : answer.outliers) outliers[one.point] = one.p;
  Section section{{"Points"}};
  section.wide = stated || !outliers.empty();
  Table table{"points", {{"quantity"}, {"measured"}, {"fitted"}, {"residual"}}, {}};
  if (stated) table.heads.push_back({"in standard deviations"});
  if (!outliers.empty()) table.heads.push_back({"remark"});
  for (std::size_t i = 0; i < answer.data.size(); ++i) {
    const Reading& point = answer.data[i];
    table.rows.push_back({reading_phrase(point),
                          {named_part(point.quantity, point.value, point.unit)},
                          {named_part(point.quantity, point.fitted, point.unit)},
                          {value_part(point.residual, point.unit, 3)}});
    if (stated)
      table.rows.back().push_back({value_part(
          point.deviation > 0 ? point.residual / point.deviation : std::nan(""), "1", 2)});
    if (outliers.empty()) continue;
    const auto found = outliers.find(i);
    Phrase remark{bad(found == outliers.end() ? "" : "outlier, ")};
    if (found != outliers.end()) append(remark, chance_phrase(found->second));
    table.rows.back().push_back(remark);
  }
  section.tables = {table};
  return section;
}

// What the first measurements were planned with.
std::vector<Phrase> planned_phrases(const CalibrateResult& answer) {
  Phrase phrase{"Planned for the motor with "};
  for (const Fitted& e : answer.estimates)
    append(phrase, {&e == &answer.estimates.front() ? "" : ", ", name_part(e.parameter.name), " ",
                    value_part(e.parameter.value, e.parameter.unit)});
  append(phrase, {"; standard deviations assumed, 1 % of the largest value of each kind: "});
  for (const CalibrateResult::ColumnScatter& one : answer.columns)
    append(phrase, {&one == &answer.columns.front() ? "" : ", ", quantity_words(one.quantity), " ",
                    value_part(one.deviation, one.unit, 3)});
  append(phrase, {"."});
  return {phrase,
          {"Measure a few of these points, name their table under 'data:', and run the study "
           "again. The plan then takes the measured points into account."}};
}

// What to measure next, and the widths of the intervals after it.
std::vector<Section> plan(const CalibrateResult& answer) {
  const bool first = answer.unmeasured;
  if (answer.plan.empty()) {
    Section none{{"The first measurements"}};
    none.sentences = {
        {"No measurement can be planned: the motor has no value at any of the candidate points."}};
    return first ? std::vector{none} : std::vector<Section>{};
  }
  Section section{{first ? "The first measurements" : "The next measurements"},
                  {std::string("The measurement that narrows the intervals most comes first. The "
                               "widths are those after the measurement, relative to ") +
                   (first ? "the ranges." : "the present widths.")}};
  if (first) section.sentences = planned_phrases(answer);
  Table table{"plan", {{first ? "measure" : "measure next"}, {"all"}}, {}};
  for (const Fitted& e : answer.estimates) table.heads.push_back(estimate_name(e));
  for (const CalibrateResult::Planned& planned : answer.plan) {
    table.rows.push_back({reading_phrase(planned.point), {share_part(planned.mean, 3)}});
    if (!planned.file.empty()) append(table.rows.back().front(), {" (" + planned.file + ")"});
    for (const double width : planned.widths) table.rows.back().push_back({share_part(width, 3)});
  }
  section.tables = {table};
  return {section};
}

Section fitted_page() {
  Section section{{"Motor file of the fit"}};
  section.hook = "motor file";
  return section;
}

}  // namespace

std::vector<Section> sections_of(const CalibrateResult& answer, const Sources& sources) {
  std::vector<Section> list;
  const auto add = [&](std::vector<Section> more) {
    std::ranges::move(more, std::back_inserter(list));
  };
  if (answer.unmeasured) {
    add(plan(answer));
    add(motor_sections(sources));
    return list;
  }
  if (answer.estimates.empty()) return {points(answer)};
  if (sources.study != nullptr) add(fit_sections(answer, *sources.study));
  list.push_back(estimates(answer));
  add(correlation(answer));
  add(profile_sections(answer));
  add(residual_sections(answer));
  add({fit_quality(answer), points(answer)});
  std::vector<NamedValue> values;
  for (const Fitted& e : answer.estimates) values.push_back(e.parameter);
  add(moves_sections(values, answer.moves, "", answer.folded ? fold_words() : "", sources));
  add(plan(answer));
  add(torque_sections({answer.files().size() > 1 ? "The fitted motors" : "The fitted motor"},
                      sources));
  add(curve_sections(sources));
  list.push_back(fitted_page());
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
