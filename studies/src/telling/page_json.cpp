// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/renderers.hpp"
#include "telling/tellings.hpp"

#include <twum/io/number.hpp>

#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

// A text, or a list of texts and {b: text}.
Json phrase_json(const Phrase& phrase) {
  Json list = Json::array();
  for (const Part& part : phrase) {
    std::string text = written(part, Writing::page);
    if (part.strong)
      list.push_back({{"b", std::move(text)}});
    else if (!list.empty() && list.back().is_string())
      list.back() = list.back().get<std::string>() + text;
    else
      list.push_back(std::move(text));
  }
  return list.size() == 1 && list.front().is_string() ? list.front() : list;
}

Json sentences_json(const std::vector<Phrase>& phrases) {
  Json list = Json::array();
  for (const Phrase& phrase : phrases) list.push_back(phrase_json(capitalized(phrase)));
  return list;
}

// Lines that may begin with a name.
Json remarks_json(const std::vector<Phrase>& phrases) {
  Json list = Json::array();
  for (const Phrase& phrase : phrases) list.push_back(phrase_json(phrase));
  return list;
}

constexpr const char* kTones[] = {"", "good", "bad"};

// What is shown, and what the saved file has: words, [words, name], [number, value] or [words, words, tone].
Json cell_json(const Phrase& phrase) {
  const std::string text = written(phrase, Writing::page);
  const Part& first = phrase.front();
  const bool one = phrase.size() == 1;
  if (one && (first.kind == Part::Kind::value || first.kind == Part::Kind::share))
    return {text, number_json(first.value)};
  if (first.tone != Tone::none) return {text, text, kTones[static_cast<std::size_t>(first.tone)]};
  return first.text == text || first.kind == Part::Kind::words ? Json(text)
                                                               : Json{text, first.text};
}

// The SI unit of all numbers of a column; empty where they differ or there are none.
std::string unit_of(const Table& table, std::size_t column) {
  std::string unit;
  for (const std::vector<Phrase>& row : table.rows) {
    if (row[column].size() != 1 || row[column].front().kind != Part::Kind::value) continue;
    if (!unit.empty() && row[column].front().text != unit) return "";
    unit = row[column].front().text;
  }
  return unit == "1" ? "" : unit;
}

Json table_json(const Table& table) {
  Json json{{"name", table.name}, {"heads", Json::array()}, {"rows", Json::array()}};
  if (table.shaded) json["shaded"] = true;
  Json units = Json::array();
  for (std::size_t i = 0; i < table.heads.size(); ++i) {
    json["heads"].push_back(written(table.heads[i], Writing::page));
    units.push_back(unit_of(table, i));
  }
  for (const std::vector<Phrase>& row : table.rows) {
    Json& cells = json["rows"].emplace_back(Json::array());
    for (const Phrase& cell : row) cells.push_back(cell_json(cell));
  }
  json["units"] = units;
  return json;
}

// A line of a picture needs no more digits.
double drawn(double value) {
  constexpr int kDigits = 7;
  return std::isfinite(value) ? parse_number(rounded_text(value, kDigits)).value_or(value) : value;
}

Json numbers_json(const Numbers& numbers) {
  if (!numbers.where.empty()) return numbers.where;
  Json list = Json::array();
  for (const double value : numbers.values) list.push_back(number_json(drawn(value)));
  return list;
}

// What is as usual is left out: a page has many charts.
Json axis_json(const Axis& axis) {
  Json json{{"name", written(axis.name, Writing::page)}, {"unit", axis.unit}};
  if (axis.zero) json["zero"] = true;
  if (std::isfinite(axis.low)) json["low"] = axis.low;
  if (std::isfinite(axis.high)) json["high"] = axis.high;
  return json;
}

constexpr const char* kStrokes[] = {"line",    "dashes", "dots", "steps", "path", "contour",
                                    "outline", "bars",   "area", "cells", "stack"};
constexpr const char* kGuides[] = {"limit", "quantile", "level"};

Json series_json(const Series& series) {
  Json json{{"name", series.name},
            {"stroke", kStrokes[static_cast<std::size_t>(series.stroke)]},
            {"colour", series.colour}};
  const auto add = [&json](const char* name, const Numbers& numbers) {
    if (!numbers.where.empty() || !numbers.values.empty()) json[name] = numbers_json(numbers);
  };
  add("x", series.x);
  add("y", series.y);
  if (!series.low.values.empty()) {
    json["low"] = numbers_json(series.low);
    json["high"] = numbers_json(series.high);
    json["band"] = series.band;
  }
  if (!series.broad.empty()) {
    json["state"] = series.state;
    json["broad"] = series.broad;
  }
  if (series.stroke == Stroke::cells) json["z"] = numbers_json(series.z);
  return json;
}

Json bounds_json(const std::vector<Bound>& bounds) {
  Json list = Json::array();
  for (const Bound& bound : bounds)
    list.push_back({{"x", bound.x},
                    {"y", bound.y},
                    {"upright", bound.upright},
                    {"least", bound.least},
                    {"broken", bound.broken},
                    {"text", written(bound.text, Writing::page)}});
  return list;
}

// Of each row a text with a letter for each cell: a, b, ... for the bands, a blank for none.
Json field_json(const Field& field) {
  Json rows = Json::array();
  for (std::size_t j = 0; j < field.rows; ++j) {
    std::string text;
    for (std::size_t i = 0; i < field.columns; ++i) {
      const signed char band = field.bands[j * field.columns + i];
      text += band < 0 ? ' ' : static_cast<char>('a' + band);
    }
    rows.push_back(std::move(text));
  }
  return {{"name", written(field.name, Writing::page)},
          {"unit", field.unit},
          {"levels", field.levels},
          {"x", {field.left, field.right}},
          {"y", {field.bottom, field.top}},
          {"rows", rows}};
}

Json chart_json(const Chart& chart) {
  Json json{{"name", chart.name},
            {"title", written(capitalized(chart.title), Writing::page)},
            {"x", axis_json(chart.x)},
            {"y", axis_json(chart.y)},
            {"series", Json::array()}};
  if (std::isfinite(chart.least)) json["least"] = chart.least;
  if (std::isfinite(chart.most)) json["most"] = chart.most;
  if (chart.one_scale) json["round"] = true;
  if (!chart.bounds.empty()) json["bounds"] = bounds_json(chart.bounds);
  for (const Series& one : chart.series) json["series"].push_back(series_json(one));
  for (const Series& one : chart.more) json["more"].push_back(series_json(one));
  if (!chart.more.empty()) json["asked"] = chart.asked;
  if (!chart.colours.name.empty()) json["colours"] = axis_json(chart.colours);
  for (const Guide& guide : chart.guides)
    json["guides"].push_back({{"at", guide.at},
                              {"text", written(guide.text, Writing::page)},
                              {"kind", kGuides[static_cast<std::size_t>(guide.kind)]}});
  for (const Mark& mark : chart.marks) {
    Json& one = json["marks"].emplace_back(Json{{"x", mark.x},
                                                {"y", mark.y},
                                                {"text", written(mark.text, Writing::page)},
                                                {"colour", mark.colour}});
    if (!mark.dot) one["dot"] = false;
    if (mark.line) one["line"] = true;
  }
  for (const Stretch& one : chart.shaded)
    json["shaded"].push_back({{"from", one.from}, {"to", one.to}, {"name", one.name}});
  if (!chart.field.levels.empty()) json["field"] = field_json(chart.field);
  return json;
}

Json parallel_json(const Parallel& parallel) {
  Json axes = Json::array();
  for (const Parallel::Quantity& one : parallel.axes)
    axes.push_back({{"name", written(one.name, Writing::page)},
                    {"unit", one.unit},
                    {"values", numbers_json(one.values)}});
  return {{"axes", axes}, {"most", kMostLines}};
}

Json section_json(const Section& section) {
  Json json{{"heading", written(capitalized(section.heading), Writing::page)},
            {"note", phrase_json(capitalized(section.note))},
            {"wide", section.wide},
            {"folded", section.folded},
            {"charts", Json::array()},
            {"sentences", sentences_json(section.sentences)},
            {"remarks", remarks_json(section.remarks)},
            {"tables", Json::array()}};
  for (const Chart& chart : section.charts)
    json["charts"].push_back(chart.series.empty() && section.columns > 0 ? Json(nullptr)
                                                                         : chart_json(chart));
  if (section.columns > 0) json["columns"] = section.columns;
  if (section.bars.of > 0)
    json["bars"] = {{"name", section.bars.name},   {"of", section.bars.of},
                    {"inner", section.bars.inner}, {"low", section.bars.low},
                    {"high", section.bars.high},   {"both_ways", section.bars.both_ways},
                    {"full", section.bars.full}};
  if (!section.parallel.axes.empty()) json["parallel"] = parallel_json(section.parallel);
  if (!section.hook.empty()) json["hook"] = section.hook;
  for (const Table& table : section.tables) json["tables"].push_back(table_json(table));
  return json;
}

constexpr const char* kLooks[] = {"good", "bad", "plain"};

}  // namespace

Json headline_json(const Headline& headline) {
  return {{"title", headline.title},
          {"look", kLooks[static_cast<std::size_t>(headline.look)]},
          {"badge", headline.badge},
          {"sentences", sentences_json(headline.sentences)},
          {"remarks", remarks_json(headline.remarks)},
          {"rows", headline.rows},
          {"unanswered", headline.unanswered}};
}

Json points_json(const Answer& answer, const Sources& sources) {
  const auto* front = std::get_if<ParetoResult>(&answer);
  if (front == nullptr) return nullptr;
  Json json = Json::array();
  for (std::size_t i = 0; i < front->front.size(); ++i)
    json.push_back({{"role", written(role_phrase(*front, i), Writing::page)},
                    {"sections", sections_json(point_sections(*front, i, sources))}});
  return json;
}

Json charts_json(const std::vector<Chart>& charts) {
  Json json = Json::array();
  for (const Chart& chart : charts) json.push_back(chart_json(chart));
  return json;
}

Json sections_json(const std::vector<Section>& sections) {
  Json json = Json::array();
  for (const Section& section : sections)
    if (section.on_page) json.push_back(section_json(section));
  return json;
}

}  // namespace twum::inline v0_1::studies::telling
