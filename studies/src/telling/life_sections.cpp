// SPDX-License-Identifier: Apache-2.0
#include "telling/free_track_section.hpp"
#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies::telling {
namespace {

using Worn = LifeResult::Member;

constexpr double kHour = 3600;

bool has_life(const Worn& motor) { return motor.status == "ok"; }

// Wear that localizes has no life, but a way to there.
bool has_history(const Worn& motor) { return has_life(motor) || motor.free.has_value(); }

Phrase worn_phrase(const LifeResult& answer, const Worn& motor) {
  return family_phrase(answer.family, motor.value);
}

Phrase ended_phrase(const Worn& motor) {
  const auto ended = std::ranges::find_if(motor.limits, &LifeResult::Limit::ended);
  return end_phrase(motor.life.end, ended == motor.limits.end() ? "" : ended->text);
}

Phrase why_none(const Worn& motor) {
  if (motor.status == "does-not-wear") return {good("does not wear")};
  return {bad("no life"), ": " + reason_of(motor.status)};
}

Section lives(const LifeResult& answer) {
  Section section{{"Life"}, {"Wear depth at the end of the life, and the time until then."}};
  Table table{"lives", {{"motor"}, {"depth"}, {"time"}, {"revolutions"}, {"end of life"}}, {}};
  for (const Worn& motor : answer.members) {
    std::vector<Phrase> row{worn_phrase(answer, motor)};
    if (has_life(motor))
      row.insert(row.end(), {{value_part(motor.life.depth, "m")},
                             {time_part(motor.life.seconds)},
                             {value_part(motor.life.revolutions, "1")},
                             ended_phrase(motor)});
    else
      row.insert(row.end(), {{"-"}, {"-"}, {"-"}, why_none(motor)});
    table.rows.push_back(std::move(row));
  }
  section.tables = {table};
  return section;
}

Phrase slice_remark() {
  return {"The motor has one slice, ", bad("which is not valid for wear"),
          ": one slice leaves out the sliding that the different speeds over the width of the "
          "track cause. For the example drive-60 it gives a half to a thirteenth of the wear. Set ",
          name_part("radial_slices"), ": auto."};
}

Phrase uneven_remark(bool free) {
  return {"Even wear is ", bad("not stable"),
          " under this load if each radius wears by itself (wears-unevenly): a radius that is a "
          "little less worn takes over the load.",
          free ? "" : " The life takes the track to wear evenly."};
}

double hours_of(const LifeResult::Point& point) { return point.wear.seconds / kHour; }

// Of the motor alone: how far each limit is kept, as a share of what the new motor had.
Section margins(const Worn& motor) {
  Section section{{"Margins over the life"},
                  {"Margin to each limit, as a share of the margin of the new motor. The first "
                   "limit whose margin reaches zero ends the life."}};
  Chart chart{"margins",
              {"remaining margin of each limit"},
              {{"time"}, "h", true},
              {{"margin"}, "%", true}};
  for (std::size_t j = 0; j < motor.limits.size(); ++j) {
    Series series{written({limit_part(motor.limits[j].text)}, Writing::read),
                  Stroke::line,
                  {},
                  {},
                  colour_of(j)};
    for (const LifeResult::Point& point : motor.points) {
      if (!std::isfinite(point.margins[j])) continue;
      series.x.values.push_back(hours_of(point));
      series.y.values.push_back(point.margins[j]);
    }
    if (motor.limits[j].ended && !series.x.values.empty())
      chart.marks.push_back({series.x.values.back(), series.y.values.back(), {"end"}, "ink"});
    chart.series.push_back(std::move(series));
  }
  section.charts = {chart};
  return section;
}

Series along(const LifeResult& answer, std::size_t k, const std::vector<double>& values) {
  Series series{answer.family ? written(worn_phrase(answer, answer.members[k]), Writing::read) : "",
                Stroke::line,
                {},
                {},
                colour_of(k)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    series.x.values.push_back(hours_of(answer.members[k].points[i]));
    series.y.values.push_back(values[i]);
  }
  return series;
}

template <typename ValueOf>
Chart course_of_life(const LifeResult& answer, const std::string& name, const std::string& unit,
                     ValueOf value_of) {
  Chart chart{"life-" + name, {name_part(name)}, {{"time"}, "h", true}, {{name_part(name)}, unit}};
  for (std::size_t k = 0; k < answer.members.size(); ++k) {
    std::vector<double> values;
    for (const LifeResult::Point& point : answer.members[k].points)
      values.push_back(value_of(point));
    chart.series.push_back(along(answer, k, values));
  }
  return chart;
}

bool has_numbers(const Chart& chart) {
  return std::ranges::any_of(chart.series, [](const Series& one) { return !one.y.values.empty(); });
}

Section courses(const LifeResult& answer) {
  Section section{{"Over the life"},
                  {"The motor at its reference temperature, as its track wears."}};
  section.charts.push_back(course_of_life(
      answer, "depth", "m", [](const LifeResult::Point& point) { return point.wear.depth; }));
  for (std::size_t i = 0; i < answer.columns.size(); ++i) {
    const StoredColumn& column = answer.columns[i];
    section.charts.push_back(
        course_of_life(answer, column.name, column.unit,
                       [i](const LifeResult::Point& point) { return point.metrics[i]; }));
  }
  Chart warm = course_of_life(
      answer, "contact_temperature", "degC",
      [](const LifeResult::Point& p) { return in_celsius(p.wear.contact_temperature); });
  if (has_numbers(warm)) section.charts.push_back(std::move(warm));
  return section;
}

Series over_radius(const std::string& name, const std::vector<LifeResult::AtRadius>& profile,
                   std::size_t colour) {
  Series series{name, Stroke::line, {}, {}, colour_of(colour)};
  for (const LifeResult::AtRadius& one : profile) {
    series.x.values.push_back(1e3 * one.radius);
    series.y.values.push_back(1e9 * kHour * one.rate);
  }
  return series;
}

// Of the motor alone.
Section over_track(const Worn& motor) {
  Section section{{"Wear across the track"},
                  {"The rate at which each radius would wear by itself, at the reference "
                   "temperature. The life takes the track to wear evenly, at the mean of this "
                   "rate. Where the rate differs most from the mean, the real track becomes "
                   "uneven."}};
  Chart chart{"wear-profile",
              {"rate of wear over the radius"},
              {{"radius"}, "mm"},
              {{"rate of wear"}, "nm/h", true}};
  chart.series = {over_radius("new", motor.profile_new, 0),
                  over_radius("worn", motor.profile_worn, 1)};
  section.charts = {chart};
  return section;
}

// Of the motor alone.
Section after_run_in(const WornIn& state, double preload) {
  Section section{
      {"After run-in"},
      {{"If each radius wears by itself, all wear at the same rate after run-in, which "
        "removes about as much as the wave presses into the layer. The rotor then turns "
        "at ",
        value_part(state.speed, "rad/s"), " under ", value_part(state.torque, "N.m"), "."}}};
  Table table{"worn-in", {{"radius"}, {"share of the preload"}, {"worn by run-in"}}, {}};
  Chart chart{
      "run-in-profile", {"depth worn by run-in"}, {{"radius"}, "mm"}, {{"depth"}, "nm", true}};
  Series series{"", Stroke::line, {}, {}, colour_of(0)};
  for (const WornInSlice& slice : state.slices) {
    table.rows.push_back({{value_part(slice.radius, "m", 4)},
                          {share_part(slice.load / preload)},
                          {value_part(slice.worn, "m", 3)}});
    series.x.values.push_back(1e3 * slice.radius), series.y.values.push_back(1e9 * slice.worn);
  }
  chart.series = {series};
  section.tables = {table}, section.charts = {chart};
  return section;
}

Section new_and_worn(const LifeResult& answer) {
  Section section{{"New and worn"}, {"The motor when new and at the end of its life."}};
  Table table{"new-and-worn", {{"motor"}, {"quantity"}, {"new"}, {"worn"}}, {}};
  table.keys = 2;
  for (const Worn& motor : answer.members) {
    if (motor.points.empty()) continue;
    const LifeResult::Point &first = motor.points.front(), &last = motor.points.back();
    const auto add = [&](const std::string& name, const std::string& unit, double a, double b) {
      table.rows.push_back({worn_phrase(answer, motor),
                            {name_part(name)},
                            {value_part(a, unit)},
                            {value_part(b, unit)}});
    };
    for (std::size_t i = 0; i < answer.columns.size(); ++i)
      add(answer.columns[i].name, answer.columns[i].unit, first.metrics[i], last.metrics[i]);
    add("preload", "N", first.wear.preload, last.wear.preload);
    add("thickness", "m", first.wear.thickness, last.wear.thickness);
    table.rows.push_back({worn_phrase(answer, motor),
                          {name_part("wear_rate")},
                          {value_part(first.wear.rate * kHour, "m/h")},
                          {value_part(last.wear.rate * kHour, "m/h")}});
    if (std::isfinite(first.wear.contact_temperature))
      table.rows.push_back({worn_phrase(answer, motor),
                            {name_part("contact_temperature")},
                            {celsius_part(first.wear.contact_temperature)},
                            {celsius_part(last.wear.contact_temperature)}});
  }
  section.tables = {table};
  return section;
}

// The motor that lives longest.
const Worn& longest(const LifeResult& answer) {
  return *std::ranges::max_element(answer.members, {}, [](const Worn& motor) {
    return motor.status == "does-not-wear" ? HUGE_VAL : has_life(motor) ? motor.life.seconds : -1;
  });
}

}  // namespace

Headline headline_of(const LifeResult& answer, const StudyResult& /*result*/) {
  const Worn& motor = longest(answer);
  Phrase phrase = answer.load ? Phrase{"Under "} : Phrase{"In its operation"};
  if (answer.load) append(phrase, load_phrase(*answer.load));
  if (answer.family)
    append(phrase, {", with "}), append(phrase, worn_phrase(answer, motor)), append(phrase, {","});
  append(phrase, {" the motor "});
  if (has_life(motor)) {
    append(phrase, {answer.family ? "has the longest life, " : "has a life of ",
                    strong(time_part(motor.life.seconds)), " or ",
                    value_part(motor.life.revolutions, "1"), " revolutions, until "});
    append(phrase, ended_phrase(motor));
  } else if (motor.status == "does-not-wear") {
    append(phrase, {"does not wear: nothing slips in its contact"});
  } else {
    append(phrase, {"has "}), append(phrase, why_none(motor));
  }
  append(phrase, {"."});
  std::vector<Phrase> remarks;
  if (motor.one_slice) remarks.push_back(slice_remark());
  if (motor.stability == WearStability::uneven)
    remarks.push_back(uneven_remark(motor.free.has_value()));
  const bool none = !has_life(motor) && motor.status != "does-not-wear";
  return {none ? Headline::Look::bad : Headline::Look::plain,
          "",
          {phrase},
          remarks,
          {},
          "points",
          "without a life"};
}

std::vector<Section> sections_of(const LifeResult& answer, const Sources& /*sources*/) {
  if (answer.members.empty()) return {};
  std::vector<Section> sections{lives(answer)};
  if (std::ranges::none_of(answer.members, has_history)) return sections;
  if (!answer.family && has_life(answer.members.front()) && !answer.members.front().limits.empty())
    sections.push_back(margins(answer.members.front()));
  sections.push_back(courses(answer));
  const Worn& first = answer.members.front();
  if (!answer.family && first.free) sections.push_back(free_track_section(*first.free));
  if (!answer.family && !first.free && !first.profile_new.empty())
    sections.push_back(over_track(first));
  if (!answer.family && !first.free && first.worn_in)
    sections.push_back(after_run_in(*first.worn_in, first.points.front().wear.preload));
  sections.push_back(new_and_worn(answer));
  return sections;
}

}  // namespace twum::inline v0_1::studies::telling
