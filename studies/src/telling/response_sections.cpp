// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>
#include <twum/motors/frequency_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace twum::inline v0_1::studies::telling {
namespace {

using ResponseMember = FrequencyResult::Member;

struct Quantity {
  const char* name;
  const char* column;  // of frequency_columns()
};

constexpr std::array kResponses{Quantity{"wave amplitude", "amplitude"},
                                Quantity{"speed", "speed"},
                                Quantity{"torque", "torque"},
                                Quantity{"electrical power", "electrical_power"},
                                Quantity{"output power", "output_power"},
                                Quantity{"current of a phase", "phase_current"}};

const FrequencyColumn& column_of(const Quantity& quantity) {
  return *std::ranges::find_if(frequency_columns(), [&](const FrequencyColumn& column) {
    return std::string_view(column.name) == quantity.column;
  });
}

// "voltage 80 V"; the motor alone has no name.
Phrase member_phrase(const FrequencyResult& answer, const ResponseMember& member) {
  if (!answer.family) return {"motor"};
  return {name_part(answer.family->name), " ", value_part(member.value, answer.family->unit)};
}

void add_branches(Chart& chart, const FrequencyResult& answer, const FrequencyColumn& column,
                  std::size_t i) {
  const std::string name =
      answer.family ? written(member_phrase(answer, answer.members[i]), Writing::read) : "";
  const std::vector<ResponseBranch>& branches = answer.members[i].branches;
  for (std::size_t k = 0; k < branches.size(); ++k) {
    const std::string where =
        "responses/" + std::to_string(i) + "/branches/" + std::to_string(k) + "/";
    Series series{name,
                  branches[k].stable ? Stroke::line : Stroke::dashes,
                  {where + "frequency", {}},
                  {where + column.name, {}},
                  colour_of(i)};
    for (const ResponsePoint& point : branches[k].points) {
      series.x.values.push_back(point.frequency);
      series.y.values.push_back(column.value(point));
    }
    chart.series.push_back(std::move(series));
  }
}

// Where slow sweeps leave a wave and go on with another one.
void add_jumps(Chart& chart, const ResponseMember& member, const FrequencyColumn& column) {
  for (const FrequencyResult::Jumped& one : member.jumps)
    if (one.jump.to)
      chart.series.push_back({"jump",
                              Stroke::path,
                              {"", {one.jump.from.frequency, one.jump.to->frequency}},
                              {"", {column.value(one.jump.from), column.value(*one.jump.to)}},
                              "c1"});
}

// From the pull-out to the drive.
void add_margin(Chart& chart, const ResponseMember& member) {
  const double end = std::max(member.pull_out_below.value_or(member.frequency), chart.x.low);
  if (end < member.frequency) chart.shaded = {{end, member.frequency, "margin"}};
}

// The wave at the drive's own frequency, and the last one before its pull-out; the first chart has their frequencies.
void add_marks(Chart& chart, const ResponseMember& member, const FrequencyColumn& column,
               bool alone, const std::string& colour) {
  if (!member.running || !std::isfinite(column.value(*member.running))) return;
  const bool first = std::string_view(column.name) == kResponses.front().column;
  const auto text = [&](const char* words, const char* more, double frequency) {
    return !alone   ? Phrase{}
           : !first ? Phrase{words}
                    : Phrase{words, more, value_part(frequency, "Hz")};
  };
  chart.marks.push_back({member.frequency, column.value(*member.running),
                         text("drive", " at ", member.frequency), colour, true, alone});
  for (const ResponseBranch& branch : member.branches)
    for (const ResponsePoint& point : branch.points)
      if (branch.stable && member.pull_out_below && point.frequency == *member.pull_out_below) {
        chart.marks.push_back({point.frequency, column.value(point),
                               text("pull-out", " below ", point.frequency), colour});
        return;
      }
}

Chart response_chart(const FrequencyResult& answer, const Quantity& quantity) {
  const FrequencyColumn& column = column_of(quantity);
  Chart chart{quantity.column,
              {quantity.name},
              {{"frequency"}, "Hz", false, answer.from, answer.to},
              {{quantity.name}, column.unit, true}};
  const bool alone = answer.members.size() == 1;
  for (std::size_t i = 0; i < answer.members.size(); ++i) add_branches(chart, answer, column, i);
  if (alone) add_jumps(chart, answer.members.front(), column);
  if (alone) add_margin(chart, answer.members.front());
  for (std::size_t i = 0; i < answer.members.size(); ++i)
    add_marks(chart, answer.members[i], column, alone, alone ? "ink" : colour_of(i));
  return chart;
}

// Of the load that is given the other number follows.
Section responses(const FrequencyResult& answer) {
  Section section{{answer.members.size() == 1 ? "response" : "responses"},
                  {"Solid lines are stable waves, dashed lines unstable ones. The dots are the "
                   "drive and, where "
                   "there is one, the pull-out at a lower frequency."}};
  const std::string_view given = answer.load.given == Argument::speed ? "speed" : "torque";
  for (const Quantity& quantity : kResponses)
    if (quantity.column != given) section.charts.push_back(response_chart(answer, quantity));
  return section;
}

Part squeal_part(const ResponseMember& member) {
  if (!member.running) return "-";
  const double rate = member.running->backward.squeal_rate;
  if (std::isnan(rate)) return "unknown";
  return rate > 0 ? value_part(rate, "1/s") : Part("no");
}

Section margins(const FrequencyResult& answer) {
  Section section{{"Margin"},
                  {"Distance of the drive from the frequency at which its wave pulls out, and, if "
                   "the motor squeals, the growth rate of the backward wave."}};
  Table table{"margins",
              {{"motor"},
               {"drive"},
               {"running wave"},
               {"speed"},
               {"pulls out below"},
               {"margin"},
               {"squeals"}},
              {}};
  for (const ResponseMember& member : answer.members) {
    const double ends = member.pull_out_below.value_or(std::nan(""));
    std::vector<Phrase> row{member_phrase(answer, member), {value_part(member.frequency, "Hz", 5)}};
    if (member.running)
      row.insert(row.end(), {{value_part(member.running->point.amplitude, "m")},
                             {value_part(member.running->point.speed, "rad/s")}});
    else
      row.insert(row.end(), {{"no steady wave"}, {"-"}});
    row.insert(row.end(),
               {{member.pull_out_below ? value_part(ends, "Hz", 5) : Part("not in the range")},
                {value_part(member.frequency - ends, "Hz")},
                {squeal_part(member)}});
    table.rows.push_back(std::move(row));
  }
  section.tables = {table};
  return section;
}

Phrase wave_phrase(const std::optional<ResponsePoint>& wave) {
  if (!wave) return {"no steady wave"};
  return {value_part(wave->point.amplitude, "m"), ", ", value_part(wave->point.speed, "rad/s")};
}

Section jumps(const FrequencyResult& answer) {
  Section section{{"Jumps"}, {"Frequencies at which a slow sweep jumps from one wave to another."}};
  Table table{"jumps", {{"motor"}, {"sweep"}, {"frequency"}, {"from"}, {"to"}}, {}};
  for (const ResponseMember& member : answer.members)
    for (const FrequencyResult::Jumped& one : member.jumps)
      table.rows.push_back({member_phrase(answer, member),
                            {one.rising ? "up" : "down"},
                            {value_part(one.jump.from.frequency, "Hz", 5)},
                            wave_phrase(one.jump.from),
                            wave_phrase(one.jump.to)});
  if (table.rows.empty())
    section.sentences = {{"A slow sweep over the range does not jump."}};
  else
    section.tables = {table};
  return section;
}

}  // namespace

std::vector<Section> sections_of(const FrequencyResult& answer, const Sources& /*sources*/) {
  if (answer.members.empty()) return {};
  return {responses(answer), margins(answer), jumps(answer)};
}

}  // namespace twum::inline v0_1::studies::telling
