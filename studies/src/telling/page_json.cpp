// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/renderers.hpp"
#include "telling/tellings.hpp"

namespace twum::studies::telling {
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

Json phrases_json(const std::vector<Phrase>& phrases) {
  Json list = Json::array();
  for (const Phrase& phrase : phrases) list.push_back(phrase_json(capitalized(phrase)));
  return list;
}

// As a cell of studies/page/table.js: what is shown, and what the saved file has.
Json cell_json(const Phrase& phrase) {
  const std::string text = written(phrase, Writing::page);
  const Part& first = phrase.front();
  if (first.kind == Part::Kind::value || first.kind == Part::Kind::share)
    return {{"text", text}, {"value", number_json(first.value)}};
  return {{"text", text}, {"value", first.text}, {"words", true}};
}

Json table_json(const Table& table) {
  Json heads = Json::array(), rows = Json::array();
  for (const Phrase& head : table.heads) heads.push_back(written(head, Writing::page));
  for (const std::vector<Phrase>& row : table.rows) {
    rows.push_back(Json::array());
    for (const Phrase& cell : row) rows.back().push_back(cell_json(cell));
  }
  return {{"name", table.name}, {"heads", heads}, {"rows", rows}};
}

Json numbers_json(const Numbers& numbers) {
  return numbers.where.empty() ? Json(numbers.values) : Json(numbers.where);
}

Json axis_json(const Axis& axis) {
  return {{"name", written(axis.name, Writing::page)},
          {"unit", axis.unit},
          {"zero", axis.zero},
          {"low", number_json(axis.low)},
          {"high", number_json(axis.high)}};
}

constexpr const char* kStrokes[] = {"line", "outline", "bars"};

Json chart_json(const Chart& chart) {
  Json json{{"name", chart.name},
            {"title", written(chart.title, Writing::page)},
            {"x", axis_json(chart.x)},
            {"y", axis_json(chart.y)},
            {"least", number_json(chart.least)},
            {"most", number_json(chart.most)},
            {"series", Json::array()},
            {"guides", Json::array()},
            {"marks", Json::array()}};
  for (const Series& one : chart.series)
    json["series"].push_back({{"name", one.name},
                              {"stroke", kStrokes[static_cast<std::size_t>(one.stroke)]},
                              {"x", numbers_json(one.x)},
                              {"y", numbers_json(one.y)}});
  for (const Guide& guide : chart.guides)
    json["guides"].push_back({{"at", guide.at}, {"text", written(guide.text, Writing::page)}});
  for (const Mark& mark : chart.marks)
    json["marks"].push_back(
        {{"x", mark.x}, {"y", mark.y}, {"text", written(mark.text, Writing::page)}});
  return json;
}

Json section_json(const Section& section) {
  Json json{{"heading", written(section.heading, Writing::page)},
            {"note", written(section.note, Writing::page)},
            {"wide", section.wide},
            {"folded", section.folded},
            {"charts", Json::array()},
            {"sentences", phrases_json(section.sentences)},
            {"tables", Json::array()}};
  for (const Chart& chart : section.charts) json["charts"].push_back(chart_json(chart));
  if (section.bars.of > 0)
    json["bars"] = {{"name", section.bars.name},   {"of", section.bars.of},
                    {"inner", section.bars.inner}, {"low", section.bars.low},
                    {"high", section.bars.high},   {"both_ways", section.bars.both_ways},
                    {"full", section.bars.full}};
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
          {"sentences", phrases_json(headline.sentences)},
          {"remarks", phrases_json(headline.remarks)}};
}

Json points_json(const Answer& answer) {
  const auto* front = std::get_if<ParetoResult>(&answer);
  if (front == nullptr) return nullptr;
  Json json = Json::array();
  for (std::size_t i = 0; i < front->front.size(); ++i) {
    std::string yields;
    for (const RobustYield& yield : front->front[i].yields)
      yields += (yields.empty() ? "" : " ") + written(yield_phrase(yield), Writing::page);
    json.push_back({{"name", written(point_phrase(*front, i), Writing::page)}, {"yields", yields}});
  }
  return json;
}

Json sections_json(const std::vector<Section>& sections) {
  Json json = Json::array();
  for (const Section& section : sections) json.push_back(section_json(section));
  return json;
}

}  // namespace twum::studies::telling
