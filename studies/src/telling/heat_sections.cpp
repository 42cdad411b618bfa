// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/heat_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/core/metrics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies::telling {
namespace {

using Motor = HeatResult::Member;
using Steady = HeatResult::Steady;

constexpr double kMuchGain = 0.5;  // from here on a little more load may have no steady state

Phrase margin_cell(double margin) {
  Part part = value_part(margin, "K", 3);
  return {margin < 0 ? bad(part) : good(part)};
}

Phrase limit_cell(const std::optional<double>& limit) {
  return {limit ? celsius_part(*limit) : Part("none")};
}

Phrase margin_cell(const std::optional<double>& limit, double temperature) {
  return limit ? margin_cell(*limit - temperature) : Phrase{"-"};
}

// Rows for the motors that have what is told.
template <typename Has, typename Add>
void for_motors(const HeatResult& answer, Has has, Add add) {
  for (const Motor& motor : answer.members)
    if (has(motor)) add(motor);
}

Phrase gain_remark(const Steady& steady) {
  if (!(steady.gain > kMuchGain)) return {};
  return {"The losses depend on the temperature: a rise of 1 K causes a further rise of ",
          value_part(steady.gain, "K", 2),
          ". With a little more load, or a warmer ambient, there may be no steady temperature."};
}

Section temperatures(const HeatResult& answer) {
  Section section{{"Steady temperatures"}, {"Final temperatures under constant load."}};
  Table table{"steady", {{"motor"}, {"part"}, {"temperature"}, {"limit"}, {"margin"}}, {}};
  table.keys = 2;
  for_motors(answer, is_steady, [&](const Motor& motor) {
    for (std::size_t i = 0; i < parts_of(motor); ++i) {
      const double found = at(motor.steady->temperatures, kHeated[i].part);
      table.rows.push_back({heated_phrase(answer, motor),
                            {part_name(motor, i)},
                            {celsius_part(found)},
                            limit_cell(limit_of(motor, i)),
                            margin_cell(limit_of(motor, i), found)});
    }
    if (const Phrase remark = gain_remark(*motor.steady); !remark.empty())
      section.remarks.push_back(remark);
  });
  section.tables = {table};
  return section;
}

Phrase on_time_cell(const Steady& steady) {
  if (steady.on_time_status != "ok" && steady.lost_after > 0)
    return {bad("loses its load"), " after ", time_part(steady.lost_after)};
  if (steady.on_time_status == "ok") return {time_part(steady.on_time)};
  if (steady.on_time_status == "never-too-hot") return {good("without limit")};
  return {steady.on_time_status == "undefined" ? "no limit given" : steady.on_time_status};
}

Phrase share_cell(const Steady& steady) {
  if (steady.duty_limit_status == "ok") return {share_part(steady.duty_limit, 3)};
  return {steady.duty_limit_status == "undefined" ? "-" : steady.duty_limit_status};
}

Section running_times(const HeatResult& answer) {
  Section section{{"Permitted time"},
                  {"The time from cold until the first temperature limit is reached, and the "
                   "largest permitted share of the operation's period."}};
  Table table{
      "times",
      {{"motor"}, {"from cold"}, {"share of the period"}, {"loop gain"}, {"slowest time constant"}},
      {}};
  for_motors(
      answer, [](const Motor& motor) { return motor.steady.has_value(); },
      [&](const Motor& motor) {
        const Steady& steady = *motor.steady;
        table.rows.push_back({heated_phrase(answer, motor),
                              on_time_cell(steady),
                              share_cell(steady),
                              {steady.status == "ok" ? value_part(steady.gain, "1", 3) : Part("-")},
                              {time_part(motor.time_constants.back())}});
      });
  section.tables = {table};
  return section;
}

// Heat on each way in a steady state; what is negative flows the other way.
std::vector<std::pair<const char*, double>> ways_of_heat(const Motor& motor) {
  const HeatNetwork& n = motor.network;
  const PartTemperatures& t = motor.steady->temperatures;
  const HeatLosses& p = motor.steady->losses;
  const auto to_ambient = [&](double G, double T) { return G * (T - motor.ambient); };
  if (n.one_node) return {{"motor to ambient", to_ambient(n.stator_ambient, t.stator)}};
  return {
      {"contact through the teeth to the stator", n.stator_contact * (t.contact - t.stator)},
      {"contact through the lining to the rotor", n.lining * (t.contact - t.rotor) + p.layer / 2},
      {"stator to housing", n.stator_housing * (t.stator - t.housing)},
      {"rotor to housing", n.rotor_housing * (t.rotor - t.housing)},
      {"stator to ambient", to_ambient(n.stator_ambient, t.stator)},
      {"rotor to ambient", to_ambient(n.rotor_ambient, t.rotor)},
      {"housing to ambient", to_ambient(n.housing_ambient, t.housing)}};
}

Section losses(const HeatResult& answer) {
  Section section{{"Heat sources"}, {"Losses at the steady temperatures."}};
  Table table{
      "losses", {{"motor"}, {"friction"}, {"layer"}, {"stator"}, {"dielectric"}, {"all"}}, {}};
  for_motors(answer, is_steady, [&](const Motor& motor) {
    const HeatLosses& p = motor.steady->losses;
    table.rows.push_back({heated_phrase(answer, motor),
                          {value_part(p.friction, "W", 3)},
                          {value_part(p.layer, "W", 3)},
                          {value_part(p.stator, "W", 3)},
                          {value_part(p.dielectric, "W", 3)},
                          {value_part(p.sum(), "W", 3)}});
  });
  section.tables = {table};
  return section;
}

// Of one motor: the bars of a family would not compare.
Section heat_flow(const Motor& motor) {
  Section section{
      {"Heat flow"},
      {"Heat on each path in the steady state. A negative value flows in the opposite direction."}};
  Table table{"heat-flow", {{"path"}, {"heat"}}, {}};
  for (const auto& [way, watts] : ways_of_heat(motor))
    table.rows.push_back({{way}, {value_part(watts, "W", 3)}});
  section.bars = {.name = "heat-flow",
                  .title = {"heat on each path"},
                  .axis = {"heat"},
                  .unit = "W",
                  .of = 1,
                  .both_ways = true};
  section.folded = true;
  section.tables = {table};
  return section;
}

Section cold_and_warm(const HeatResult& answer) {
  Section section{{"Cold and warm"},
                  {"The motor at its reference temperature, and at its steady temperatures."}};
  Table table{"changes", {{"motor"}, {"quantity"}, {"cold"}, {"warm"}}, {}};
  table.keys = 2;
  for_motors(answer, is_steady, [&](const Motor& motor) {
    for (const HeatResult::Change& one : motor.steady->changes) {
      const bool share = one.metric.find("efficiency") != std::string::npos;
      const auto cell = [&](double value) {
        return Phrase{share ? share_part(value) : value_part(value, one.unit)};
      };
      const std::string name = one.metric.substr(0, one.metric.rfind("_at"));
      table.rows.push_back(
          {heated_phrase(answer, motor), {name_part(name)}, cell(one.cold), cell(one.warm)});
    }
  });
  section.tables = {table};
  return section;
}

void add_limits(Chart& chart, const Motor& motor, std::size_t parts) {
  for (std::size_t i = 0; i < parts; ++i)
    if (const auto limit = limit_of(motor, i))
      chart.guides.push_back(
          {in_celsius(*limit), {"limit of the " + part_name(motor, i)}, Guide::Kind::level});
}

template <typename Points>
void add_course(Chart& chart, const std::string& name, std::size_t part, const Points& points,
                double seconds, const std::string& colour) {
  // The contact is nearly as warm as the stator, which shows below broken lines.
  const bool broken = kHeated[part].part == twum::Part::contact;
  Series series{name, broken ? Stroke::dashes : Stroke::line, {}, {}, colour};
  for (const auto& point : points) {
    const double found = at(point.temperatures, kHeated[part].part);
    if (!(found > 0)) continue;  // from where the point is lost
    series.x.values.push_back(point.time / seconds);
    series.y.values.push_back(in_celsius(found));
  }
  chart.series.push_back(std::move(series));
}

Chart course_chart(const char* name, const char* title, double end) {
  return {name,
          {title},
          {{"time"}, time_unit(end).unit, false, 0, end / time_unit(end).seconds},
          {{"temperature"}, "degC", false}};
}

// All limits and temperatures are within the axis.
void fit_axis(Chart& chart) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](double value) { low = std::min(low, value), high = std::max(high, value); };
  for (const Series& one : chart.series)
    for (const double value : one.y.values) take(value);
  for (const Guide& guide : chart.guides) take(guide.at);
  if (!(low < high)) return;
  const double room = 0.05 * (high - low);
  chart.y.low = low - room, chart.y.high = high + room;
}

// All parts of the motor alone; of a family the stators.
template <typename PointsOf>
void add_courses(Chart& chart, const HeatResult& answer, double end, PointsOf points_of) {
  const double seconds = time_unit(end).seconds;
  if (!answer.family) {
    const Motor& motor = answer.members.front();
    for (std::size_t i = 0; i < parts_of(motor); ++i)
      add_course(chart, part_name(motor, i), i, points_of(motor), seconds, colour_of(i));
    add_limits(chart, motor, parts_of(motor));
    return fit_axis(chart);
  }
  for (std::size_t k = 0; k < answer.members.size(); ++k)
    add_course(chart, written(heated_phrase(answer, answer.members[k]), Writing::read), 0,
               points_of(answer.members[k]), seconds, colour_of(k));
  add_limits(chart, answer.members.front(), 1);
  fit_axis(chart);
}

Section warm_ups(const HeatResult& answer) {
  Section section{{"Warm-up"}, {"From cold under the load."}};
  if (answer.family) section.note = {"The stator from cold under the load."};
  Chart chart = course_chart("warm-up", "temperatures from cold", answer.time);
  add_courses(
      chart, answer, answer.time, [](const Motor& motor) -> const auto& { return motor.warm_up; });
  section.charts = {chart};
  Phrase constants{"Under constant losses the motor warms with the time constants "};
  const std::vector<double>& tau = answer.members.front().time_constants;
  for (std::size_t i = 0; i < tau.size(); ++i) {
    if (i > 0) append(constants, {i + 1 == tau.size() ? " and " : ", "});
    append(constants, {time_part(tau[i])});
  }
  append(constants, {"."});
  if (tau.size() == 1)
    constants[0] = "Under constant losses the motor warms with the time constant ";
  section.sentences = {constants};
  return section;
}

Section settling(const HeatResult& answer) {
  const Motor& motor = answer.members.front();
  const Steady& steady = *motor.steady;
  Section section{{"Steady states"},
                  {"Losses and heat outflow over the temperature of the stator. They are equal in "
                   "a steady state. The state is stable if above its temperature the outflow is "
                   "larger than the losses."}};
  Chart chart{"balance",
              {"losses and heat outflow"},
              {{"stator temperature"}, "degC"},
              {{"power"}, "W", true}};
  Series produced{"losses", Stroke::line, {}, {}, "c1"},
      leaving{"heat outflow", Stroke::line, {}, {}, "c0"};
  for (const HeatBalance& point : steady.balance) {
    if (point.status != MetricStatus::ok) continue;
    for (Series* one : {&produced, &leaving})
      one->x.values.push_back(in_celsius(point.temperature));
    produced.y.values.push_back(point.losses), leaving.y.values.push_back(point.leaving);
  }
  chart.series = {produced, leaving};
  Table table{"states", {{"stator"}, {"state"}, {"loop gain"}}, {}};
  for (const HeatResult::State& state : steady.states) {
    const double T = state.temperatures.stator;
    const auto above = std::ranges::lower_bound(steady.balance, T, {}, &HeatBalance::temperature);
    if (above != steady.balance.end())
      chart.marks.push_back({in_celsius(T),
                             above->leaving,
                             {state.stable ? "stable" : "unstable"},
                             state.stable ? "ink" : "c1"});
    table.rows.push_back({{celsius_part(T)},
                          {state.stable ? good("stable") : bad("unstable")},
                          {value_part(state.gain, "1", 3)}});
  }
  section.charts = {chart};
  if (table.rows.empty())
    section.sentences = {{"There is no steady state in this range."}};
  else
    section.tables = {table};
  return section;
}

Phrase phase_phrase(const LoadPhase& phase) {
  Phrase phrase = phase.load ? load_phrase(*phase.load) : Phrase{"idle"};
  if (phase.voltage) append(phrase, {" with ", value_part(*phase.voltage, "V")});
  return phrase;
}

double period_of_cycle(const HeatResult::Cycle& cycle) {
  double period = 0;
  for (const LoadPhase& phase : cycle.phases) period += phase.time;
  return period;
}

Section operations(const HeatResult& answer) {
  Section section{{"Over the operation"},
                  {"One period of the operation, once all periods are alike."}};
  Table peaks{"peaks", {{"motor"}, {"part"}, {"peak"}, {"mean"}, {"limit"}, {"margin"}}, {}};
  Table phases{"phases", {{"motor"}, {"phase"}, {"lasts"}, {"losses"}}, {}};
  peaks.keys = phases.keys = 2;
  for_motors(answer, has_cycle, [&](const Motor& motor) {
    const LoadCycle& found = motor.cycle->found;
    for (std::size_t i = 0; i < parts_of(motor); ++i) {
      const double peak = at(found.peak, kHeated[i].part);
      peaks.rows.push_back({heated_phrase(answer, motor),
                            {part_name(motor, i)},
                            {celsius_part(peak)},
                            {celsius_part(at(found.mean, kHeated[i].part))},
                            limit_cell(limit_of(motor, i)),
                            margin_cell(limit_of(motor, i), peak)});
    }
    for (std::size_t i = 0; i < motor.cycle->phases.size(); ++i)
      phases.rows.push_back({heated_phrase(answer, motor),
                             phase_phrase(motor.cycle->phases[i]),
                             {time_part(motor.cycle->phases[i].time)},
                             {value_part(found.losses[i].sum(), "W", 3)}});
  });
  if (peaks.rows.empty()) return section;
  const double period = period_of_cycle(*answer.members.front().cycle);
  Chart chart = course_chart("operation", "temperatures over the operation", period);
  add_courses(
      chart, answer, period,
      [](const Motor& motor) -> const auto& { return motor.cycle->found.course; });
  section.charts = {chart};
  section.tables = {peaks, phases};
  return section;
}

}  // namespace

std::vector<Section> sections_of(const HeatResult& answer, const Sources& /*sources*/) {
  if (answer.members.empty()) return {};
  std::vector<Section> sections;
  const bool any_steady = std::ranges::any_of(answer.members, is_steady);
  if (answer.load) {
    if (any_steady) sections.push_back(temperatures(answer));
    sections.push_back(running_times(answer));
    sections.push_back(warm_ups(answer));
    if (any_steady) sections.push_back(losses(answer));
    if (any_steady && !answer.family) sections.push_back(heat_flow(answer.members.front()));
    if (!answer.family) sections.push_back(settling(answer));
    if (any_steady) sections.push_back(cold_and_warm(answer));
  }
  if (std::ranges::any_of(answer.members, has_cycle)) sections.push_back(operations(answer));
  return sections;
}

}  // namespace twum::inline v0_1::studies::telling
