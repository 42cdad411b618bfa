// SPDX-License-Identifier: Apache-2.0
#include "entries/motion_columns.hpp"

#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>

namespace twum::inline v0_1::studies {
namespace {

using Sample = motion::MotionSample;
using Kind = MotionMeasure::Kind;

constexpr std::array kMotionColumns{
    MotionColumn{"voltage", "V", [](const Sample& s) { return s.voltage; }},
    MotionColumn{"frequency", "Hz", [](const Sample& s) { return s.frequency; }},
    MotionColumn{"load_torque", "N.m", [](const Sample& s) { return s.load_torque; }},
    MotionColumn{"amplitude", "m", [](const Sample& s) { return s.amplitude; }},
    MotionColumn{"phase_lag", "rad", [](const Sample& s) { return s.phase_lag; }},
    MotionColumn{"speed", "rad/s", [](const Sample& s) { return s.speed; }},
    MotionColumn{"angle", "rad", [](const Sample& s) { return s.angle; }},
    MotionColumn{"torque", "N.m", [](const Sample& s) { return s.torque; }},
    MotionColumn{"stator_power", "W", [](const Sample& s) { return s.stator_power; }},
    MotionColumn{"friction_power", "W", [](const Sample& s) { return s.friction_power; }},
    MotionColumn{"electrical_power", "W", [](const Sample& s) { return s.electrical_power; }},
    MotionColumn{"phase_current", "A", [](const Sample& s) { return s.phase_current; }},
    MotionColumn{"energy", "J", [](const Sample& s) { return s.energy; }},
    MotionColumn{"backward_amplitude", "m", [](const Sample& s) { return s.backward_amplitude; },
                 true},
    MotionColumn{"phase_difference", "rad", [](const Sample& s) { return s.phase_difference; },
                 true},
    MotionColumn{"held", "1", [](const Sample& s) { return s.held ? 1.0 : 0.0; }},
    MotionColumn{"off", "1", [](const Sample& s) { return s.off ? 1.0 : 0.0; }}};

struct MeasureName {
  std::string_view name;
  Kind kind;
  std::size_t arguments;
  const char* example;
};
constexpr std::array kMeasures{
    MeasureName{"time_to", Kind::time_to, 2, "time_to(speed, 90 %)"},
    MeasureName{"settling_time", Kind::settling_time, 2, "settling_time(speed, 5 %)"},
    MeasureName{"overshoot", Kind::overshoot, 1, "overshoot(speed)"},
    MeasureName{"peak", Kind::peak, 1, "peak(phase_current)"},
    MeasureName{"angle_after", Kind::angle_after, 1, "angle_after(30 ms)"},
    MeasureName{"energy", Kind::energy, 2, "energy(0 ms, 30 ms)"},
    MeasureName{"time_of", Kind::time_of, 1, "time_of(held)"}};

constexpr std::array kEvents{
    motion::MotionEventKind::held,         motion::MotionEventKind::released,
    motion::MotionEventKind::reversed,     motion::MotionEventKind::started,
    motion::MotionEventKind::pulled_out,   motion::MotionEventKind::overruns,
    motion::MotionEventKind::switched_off, motion::MotionEventKind::switched_on,
    motion::MotionEventKind::swapped,      motion::MotionEventKind::squeals,
    motion::MotionEventKind::bounces,      motion::MotionEventKind::too_fast};

const MeasureName& measure_named(std::string_view name) {
  const auto found = std::ranges::find(kMeasures, name, &MeasureName::name);
  if (found != kMeasures.end()) return *found;
  std::vector<std::string_view> names;
  for (const MeasureName& one : kMeasures) names.push_back(one.name);
  throw ValueError(quoted(name) + " is no measure of a motion", did_you_mean(name, names));
}

std::string known_word(std::string_view word, const std::vector<std::string_view>& known,
                       const char* what) {
  if (std::ranges::find(known, word) == known.end())
    throw ValueError(quoted(word) + " is no " + what, did_you_mean(word, known));
  return std::string(word);
}

std::string column_named(std::string_view name) {
  return known_word(name, motion_column_names(), "column of a motion");
}

std::string event_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto kind : kEvents) names.emplace_back(to_string(kind));
  return known_word(name, names, "event of a motion");
}

double time_in(std::string_view text) { return parse_quantity(text, {"s", "30 ms"}); }

void read_level(MotionMeasure& measure, std::string_view text) {
  if (text.ends_with('%'))
    measure.share = parse_quantity(text, {"1", "90 %"});
  else
    measure.at = parse_quantity(text, {find_motion_column(measure.column)->unit, "90 %"});
}

void read_arguments(MotionMeasure& measure, const std::vector<std::string_view>& arguments) {
  switch (measure.kind) {
    case Kind::time_to:
      measure.column = column_named(arguments[0]);
      return read_level(measure, arguments[1]);
    case Kind::settling_time:
      measure.column = column_named(arguments[0]);
      measure.share = parse_quantity(arguments[1], {"1", "5 %"});
      if (*measure.share > 0) return;
      throw ValueError("a share of 0 or less, which is never reached",
                       "expected settling_time(speed, 5 %)");
    case Kind::overshoot:
    case Kind::peak: measure.column = column_named(arguments[0]); return;
    case Kind::time_of: measure.column = event_named(arguments[0]); return;
    case Kind::angle_after: measure.at = time_in(arguments[0]); return;
    case Kind::energy:
      measure.at = time_in(arguments[0]), measure.to = time_in(arguments[1]);
      if (!(measure.at < measure.to))
        throw ValueError("an interval that ends before it begins", "expected energy(0 ms, 30 ms)");
      return;
  }
}

}  // namespace

std::span<const MotionColumn> motion_columns() { return kMotionColumns; }

const MotionColumn* find_motion_column(std::string_view name) {
  const auto found = std::ranges::find_if(
      kMotionColumns, [=](const MotionColumn& one) { return name == one.name; });
  return found == kMotionColumns.end() ? nullptr : &*found;
}

std::vector<std::string_view> motion_column_names() {
  std::vector<std::string_view> names;
  for (const MotionColumn& one : kMotionColumns) names.emplace_back(one.name);
  return names;
}

MotionMeasure motion_measure(std::string_view typed) {
  const std::string_view text = trimmed(typed);
  const std::size_t open = text.find('(');
  const MeasureName& row = measure_named(trimmed(text.substr(0, open)));
  const auto wrong = [&] {
    return ValueError(quoted(text), "expected such as " + std::string(row.example));
  };
  if (open == std::string_view::npos || !text.ends_with(')')) throw wrong();
  const auto arguments = split_list(text.substr(open + 1, text.size() - open - 2));
  if (arguments.size() != row.arguments) throw wrong();
  MotionMeasure measure;
  measure.text = text, measure.kind = row.kind;
  read_arguments(measure, arguments);
  return measure;
}

}  // namespace twum::inline v0_1::studies
