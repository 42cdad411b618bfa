// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/map_surface.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

namespace twum::inline v0_1::studies::telling {
namespace {

using Member = MapResult::Member;
using Point = MapResult::Point;

// An efficiency is told in per cent.
bool is_share(const StoredColumn& column) {
  return column.name.find("efficiency") != std::string::npos;
}

Part column_part(const StoredColumn& column, double value, int digits = 4) {
  return is_share(column) ? share_part(value, digits) : value_part(value, column.unit, digits);
}

// "voltage 80 V"; the motor alone has no name.
Phrase member_phrase(const MapResult& answer, const Member& member) {
  if (!answer.family) return {"motor"};
  return {name_part(answer.family->name), " ", value_part(member.value, answer.family->unit)};
}

Phrase map_point_phrase(const Point& point) {
  return {value_part(point.torque, "N.m"), " at ", value_part(point.speed, "rad/s")};
}

// The point of the best efficiency under a load; null if none is held.
const Point* best_of(const MapResult& answer, const Member& member) {
  const Point* best = nullptr;
  for (const Point& point : member.points)
    if (point.status == "ok" && point.torque > 0 &&
        (best == nullptr || point.values[answer.efficiency] > best->values[answer.efficiency]))
      best = &point;
  return best;
}

double largest_torque(const Member& member) {
  double largest = std::nan("");
  for (const MapResult::Corner& corner : member.envelope)
    largest = std::fmax(largest, corner.torque);
  return largest;
}

// The place of a column; the number of columns if there is none.
std::size_t place_of(const MapResult& answer, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(answer.columns, name, &StoredColumn::name) -
                                  answer.columns.begin());
}

// Whether a drive holds a point, why not, and what would do.
Phrase reason_phrase(const MapResult& answer, const MapResult::Duty& duty) {
  const std::string& status = duty.at.status;
  const Part needed = value_part(duty.needed, duty.unit);
  if (status == "ok" && duty.at.values[place_of(answer, "held_by_control_only")] != 0)
    return {good("held"), " only with speed control: with a constant drive this point is unstable"};
  if (status == "ok") return {good("held")};
  if (status == "torque-out-of-reach") return {bad("not held"), ": friction carries ", needed};
  if (status == "voltage-too-low") return {bad("not held"), ": it needs ", needed};
  if (status == "amplitude-too-low") return {bad("not held"), ": it needs a wave of ", needed};
  if (status == "outside-frequency-range") return {bad("not held"), ": it needs ", needed};
  if (status == "unstable-amplitude") return {bad("not held"), ": the wave is unstable"};
  return {bad("not held"), ": the wave could not be computed"};
}

void add_contours(Chart& chart, const ValueGrid& grid, const StoredColumn& column) {
  const std::vector<double>& levels = chart.field.levels;
  for (std::size_t k = 1; k + 1 < levels.size(); ++k) {
    const std::vector<ContourLine> lines = contour_lines(grid, levels[k]);
    for (const ContourLine& line : lines)
      chart.series.push_back({"", Stroke::contour, {"", line.x}, {"", line.y}, "ink"});
    if (lines.empty()) continue;
    // Beside each other the labels of neighbours would meet.
    const ContourLine& longest = lines.front();
    const std::size_t at = longest.x.size() * (k % 2 == 0 ? 2 : 3) / 5;
    chart.marks.push_back(
        {longest.x[at], longest.y[at], {column_part(column, levels[k], 3)}, "ink", false});
  }
}

// The largest torque at a speed, between those of the map.
double largest_at(const Member& member, double speed) {
  const auto next = std::ranges::lower_bound(member.envelope, speed, {}, &MapResult::Corner::speed);
  if (next == member.envelope.begin()) return next->torque;
  if (next == member.envelope.end()) return std::nan("");
  const MapResult::Corner& before = *(next - 1);
  return std::lerp(before.torque, next->torque,
                   (speed - before.speed) / (next->speed - before.speed));
}

// Points of one output power, T = P / Omega, that the drive holds.
void add_power_lines(Chart& chart, const MapResult& answer, const Member& member) {
  double most = 0;
  for (const MapResult::Corner& corner : member.envelope)
    if (corner.torque > 0) most = std::fmax(most, corner.torque * corner.speed);
  const std::vector<double> levels = round_levels({0, most});
  for (std::size_t k = 2; k + 1 < levels.size(); k += 2) {
    ContourLine line;
    for (int i = 0; i <= 200; ++i) {
      const double speed = answer.speed * (i + 1) / 201, torque = levels[k] / speed;
      if (!(torque <= std::fmin(answer.torque, largest_at(member, speed)))) continue;
      line.x.push_back(speed), line.y.push_back(torque);
    }
    if (line.x.size() < 20) continue;
    const std::size_t at = line.x.size() * 7 / 8;
    chart.series.push_back({"output power", Stroke::contour, {"", line.x}, {"", line.y}, "c1"});
    chart.marks.push_back({line.x[at], line.y[at], {value_part(levels[k], "W", 3)}, "c1", false});
  }
}

void add_envelope(Chart& chart, const Member& member) {
  Series line{"largest torque", Stroke::line, {}, {}, "ink"};
  for (const MapResult::Corner& corner : member.envelope) {
    line.x.values.push_back(corner.speed);
    line.y.values.push_back(corner.torque);
  }
  if (member.largest_speed > line.x.values.back()) {
    line.x.values.push_back(member.largest_speed);
    line.y.values.push_back(0);
  }
  chart.series.push_back(std::move(line));
}

Field field_of(const MapResult& answer, const ValueGrid& grid) {
  const StoredColumn& column = answer.columns[answer.shown];
  Field field{{name_part(column.name)},
              is_share(column) ? "%" : column.unit,
              round_levels(grid.values),
              grid.columns,
              grid.rows,
              grid.left,
              grid.right,
              grid.bottom,
              grid.top,
              {}};
  for (const double value : grid.values) {
    const auto above = std::ranges::upper_bound(field.levels, value);
    const auto band = std::max<std::ptrdiff_t>(above - field.levels.begin() - 1, 0);
    field.bands.push_back(std::isfinite(value) ? static_cast<signed char>(band)
                                               : static_cast<signed char>(-1));
  }
  return field;
}

Chart map_chart(const MapResult& answer, std::size_t number) {
  const Member& member = answer.members[number];
  const StoredColumn& column = answer.columns[answer.shown];
  const std::string which = answer.family ? "-" + std::to_string(number + 1) : "";
  Chart chart{"map-" + column.name + which,
              {name_part(column.name)},
              {{"speed"}, "rad/s", true, 0, answer.speed},
              {{"torque"}, "N.m", true, 0, answer.torque}};
  if (answer.family)
    append(chart.title, {", "}), append(chart.title, member_phrase(answer, member));
  const ValueGrid grid = MapSurface(answer, member, answer.shown).fine(answer);
  chart.field = field_of(answer, grid);
  add_envelope(chart, member);
  add_contours(chart, grid, column);
  add_power_lines(chart, answer, member);
  for (const MapResult::Duty& duty : member.duty)
    chart.marks.push_back({duty.at.speed, duty.at.torque, map_point_phrase(duty.at),
                           duty.at.status == "ok" ? "ink" : "c1"});
  return chart;
}

Section map_section(const MapResult& answer, std::size_t number) {
  Section section{
      member_phrase(answer, answer.members[number]),
      {"At each point the drive is adjusted to hold the torque at the speed. Thin lines are "
       "contours; coloured lines are contours of the output power, as in the key."}};
  if (!answer.family)
    section.heading = {name_part(answer.columns[answer.shown].name), " over speed and torque"};
  section.charts = {map_chart(answer, number)};
  return section;
}

std::vector<std::size_t> places_of(const MapResult& answer, std::span<const char* const> names) {
  std::vector<std::size_t> places;
  for (const char* name : names)
    if (const std::size_t place = place_of(answer, name); place < answer.columns.size())
      places.push_back(place);
  return places;
}

// A row for each motor and point, with these columns of the map behind those of the table.
void add_duty_rows(Table& table, const MapResult& answer, std::span<const char* const> names,
                   bool first) {
  const std::vector<std::size_t> places = places_of(answer, names);
  for (const std::size_t place : places)
    table.heads.push_back({name_part(answer.columns[place].name)});
  for (const Member& member : answer.members)
    for (const MapResult::Duty& duty : member.duty) {
      std::vector<Phrase> row{member_phrase(answer, member), map_point_phrase(duty.at)};
      if (first)
        row.insert(row.end(), {reason_phrase(answer, duty), {value_part(duty.torque_left, "N.m")}});
      for (const std::size_t place : places)
        row.push_back({column_part(answer.columns[place], duty.at.values[place])});
      table.rows.push_back(std::move(row));
    }
}

Section duties(const MapResult& answer) {
  constexpr std::array kDrive{"drive_frequency", "drive_voltage", "amplitude"};
  constexpr std::array kPower{"phase_current", "electrical_power", "overall_efficiency",
                              "efficiency", "wear_intensity"};
  Section section{{"The duty"}, {"Requirements of the motor at the duty points."}};
  Table drive{"duty", {{"motor"}, {"point"}, {"drive"}, {"torque margin"}}, {}};
  Table power{"duty-power", {{"motor"}, {"point"}}, {}};
  drive.keys = power.keys = 2;
  add_duty_rows(drive, answer, kDrive, true);
  add_duty_rows(power, answer, kPower, false);
  section.tables = {drive, power};
  return section;
}

std::string reason_words(const std::string& status) {
  static const std::map<std::string, const char*> kWords{
      {"torque-out-of-reach", "need more friction"},
      {"voltage-too-low", "need more voltage"},
      {"amplitude-too-low", "need a larger wave"},
      {"outside-frequency-range", "need another frequency"},
      {"unstable-amplitude", "have no stable wave"}};
  const auto known = kWords.find(status);
  return known == kWords.end() ? status : known->second;
}

std::string points_text(const std::map<std::string, std::uint64_t>& reasons) {
  std::string text;
  for (const auto& [reason, count] : reasons)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + reason_words(reason);
  return text;
}

Section ends(const MapResult& answer) {
  Section section{{"Limits of the drive"},
                  {"The best point of the map, the largest torque and speed that the drive holds, "
                   "and the reasons for the points that it does not hold."}};
  Table table{"ends",
              {{"motor"},
               {"best ", name_part(answer.columns[answer.efficiency].name)},
               {"at"},
               {"largest torque"},
               {"largest speed"},
               {"points held"},
               {"not held"}},
              {}};
  for (const Member& member : answer.members) {
    std::map<std::string, std::uint64_t> reasons;
    std::uint64_t held = 0;
    for (const Point& point : member.points)
      point.status == "ok" ? ++held : ++reasons[point.status];
    const Point* best = best_of(answer, member);
    table.rows.push_back(
        {member_phrase(answer, member),
         {best ? column_part(answer.columns[answer.efficiency], best->values[answer.efficiency])
               : Part("-")},
         best ? map_point_phrase(*best) : Phrase{"-"},
         {value_part(largest_torque(member), "N.m")},
         {value_part(member.largest_speed, "rad/s")},
         {count_part(held)},
         {reasons.empty() ? Part("-") : Part(points_text(reasons))}});
  }
  section.tables = {table};
  return section;
}

Phrase duty_sentence(const MapResult& answer) {
  std::size_t asked = 0, held = 0;
  for (const Member& member : answer.members)
    for (const MapResult::Duty& duty : member.duty) ++asked, held += duty.at.status == "ok";
  if (asked == 0) return {};
  if (held == asked) return {asked == 1 ? "It holds the duty." : "It holds every duty."};
  return {"It holds ", bad(std::to_string(held) + " of " + counted(asked, "duty point")), "."};
}

}  // namespace

Headline headline_of(const MapResult& answer, const StudyResult& /*result*/) {
  const Member* best = nullptr;
  for (const Member& member : answer.members) {
    const Point* point = best_of(answer, member);
    if (point == nullptr) continue;
    const Point* known = best == nullptr ? nullptr : best_of(answer, *best);
    if (known == nullptr || point->values[answer.efficiency] > known->values[answer.efficiency])
      best = &member;
  }
  if (best == nullptr)
    return {Headline::Look::bad,
            "",
            {{strong("The drive holds no load"), " at the points of the map."}},
            {}};
  const Point& point = *best_of(answer, *best);
  const StoredColumn& column = answer.columns[answer.efficiency];
  Phrase first{"The best ", name_part(column.name), " is ",
               strong(column_part(column, point.values[answer.efficiency])), ", with "};
  append(first, map_point_phrase(point));
  if (answer.family) append(first, {" and "}), append(first, member_phrase(answer, *best));
  append(first, {"; the drive holds at most ", strong(value_part(largest_torque(*best), "N.m")),
                 " and ", strong(value_part(best->largest_speed, "rad/s")), "."});
  std::vector<Phrase> sentences{first};
  const Phrase duty = duty_sentence(answer);
  if (!duty.empty()) sentences.push_back(duty);
  const bool broken = duty.size() > 1;
  return {broken ? Headline::Look::bad : Headline::Look::plain,
          "",
          sentences,
          {},
          {},
          "points",
          "not held"};
}

std::vector<Section> sections_of(const MapResult& answer, const Sources& /*sources*/) {
  std::vector<Section> sections;
  for (std::size_t i = 0; i < answer.members.size(); ++i)
    sections.push_back(map_section(answer, i));
  if (sections.empty()) return {};
  if (!answer.members.front().duty.empty()) sections.push_back(duties(answer));
  sections.push_back(ends(answer));
  return sections;
}

}  // namespace twum::inline v0_1::studies::telling
