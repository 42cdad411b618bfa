// SPDX-License-Identifier: Apache-2.0
#include "results/motion_notes.hpp"
#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/number.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace twum::inline v0_1::studies::telling {
namespace {

using MovedMotor = MotionResult::Member;
using motion::MotionEvent;
using motion::MotionEventKind;
using motion::MotionSample;

constexpr std::size_t kMarked = 10;  // events in a chart
constexpr std::size_t kTold = 20;    // events in a table; a beating wave may have hundreds

const char* event_words(MotionEventKind kind) {
  switch (kind) {
    case MotionEventKind::held: return "comes to rest and is held";
    case MotionEventKind::released: return "leaves rest";
    case MotionEventKind::reversed: return "reverses";
    case MotionEventKind::started: return "the wave starts";
    case MotionEventKind::pulled_out: return "the wave pulls out";
    case MotionEventKind::overruns: return "the rotor drives the wave";
    case MotionEventKind::switched_off: return "the drive is switched off";
    case MotionEventKind::switched_on: return "the drive is switched on";
    case MotionEventKind::swapped: return "the phases are swapped";
    case MotionEventKind::squeals: return "a backward wave grows";
    case MotionEventKind::bounces: return "the rotor begins to hop";
    case MotionEventKind::too_fast: return "too fast for a periodic contact";
  }
  return "";
}

// Without a rotor that drives the wave again: it may do so at each beat of the wave.
std::vector<MotionEvent> told_events(const MovedMotor& motor) {
  std::vector<MotionEvent> told;
  for (const MotionEvent& event : motor.motion.events) {
    const bool again = event.kind == MotionEventKind::overruns && !told.empty() &&
                       told.back().kind == MotionEventKind::overruns;
    if (!again) told.push_back(event);
  }
  return told;
}

Section events(const MotionResult& answer) {
  Section section{{"Events"}, {}};
  Table table{"events", {{"motor"}, {"time"}, {"event"}, {"angle"}, {"speed"}, {"amplitude"}}, {}};
  table.keys = 3;
  if (answer.family) table.typed = 4;  // a long name and all of them are wider than a terminal
  for (const MovedMotor& motor : answer.members) {
    const std::vector<MotionEvent> told = told_events(motor);
    for (std::size_t i = 0; i < std::min(kTold, told.size()); ++i)
      table.rows.push_back({family_phrase(answer.family, motor.value),
                            {time_part(told[i].time)},
                            {event_words(told[i].kind)},
                            {value_part(told[i].angle, "rad", 3)},
                            {value_part(told[i].speed, "rad/s", 3)},
                            {value_part(told[i].amplitude, "m", 3)}});
    if (told.size() > kTold)
      section.remarks.push_back(
          {"The first ", count_part(kTold), " of ", count_part(told.size()), " events are shown."});
    for (const MotionNote& note : motion_notes(motor.motion))
      section.remarks.push_back({"Note " + note.name + ": " + note.text});
  }
  section.tables = {table};
  return section;
}

Section measures(const MotionResult& answer) {
  Section section{{"Measures"}, {}};
  Table table{"measures", {{"motor"}, {"measure"}, {"value"}}, {}};
  for (const MovedMotor& motor : answer.members)
    for (const MotionResult::Measure& one : motor.measures) {
      const Part number = std::isnan(one.value) ? Part("-")
                          : one.unit == "s"     ? time_part(one.value)
                          : one.unit == "1"     ? share_part(one.value)
                                                : value_part(one.value, one.unit);
      table.rows.push_back({family_phrase(answer.family, motor.value), {one.text}, {number}});
    }
  table.keys = 2;
  section.tables = {table};
  return section;
}

// What a chart shows over time.
struct Course {
  const char* name;
  const char* title;
  const char* unit;
  double (*of)(const MotionSample&);
  bool zero{true};
};
constexpr Course kSpeed{"speed", "speed", "rad/s", [](const MotionSample& s) { return s.speed; }};
constexpr Course kCourses[] = {
    {"angle", "angle", "rad", [](const MotionSample& s) { return s.angle; }},
    {"amplitude", "amplitude of the wave", "m", [](const MotionSample& s) { return s.amplitude; }},
    {"backward_amplitude", "backward amplitude", "m",
     [](const MotionSample& s) { return s.backward_amplitude; }},
    {"torque", "torque of the contact", "N.m", [](const MotionSample& s) { return s.torque; }},
    {"voltage", "voltage at a phase", "V", [](const MotionSample& s) { return s.voltage; }},
    {"frequency", "frequency of the drive", "Hz", [](const MotionSample& s) { return s.frequency; },
     false}};

Chart course_chart(const MotionResult& answer, const Course& course) {
  const TimeUnit unit = time_unit(answer.duration);
  Chart chart{course.name,
              {course.title},
              {{"time"}, unit.unit, false, 0, answer.duration / unit.seconds},
              {{course.title}, course.unit, course.zero}};
  for (std::size_t k = 0; k < answer.members.size(); ++k) {
    const MovedMotor& motor = answer.members[k];
    const std::string name = answer.family
                                 ? written(family_phrase(answer.family, motor.value), Writing::read)
                                 : std::string{};
    Series series{name, Stroke::line, {}, {}, colour_of(k)};
    for (const MotionSample& s : motor.motion.samples) {
      if (std::isnan(course.of(s))) continue;
      series.x.values.push_back(s.time / unit.seconds);
      series.y.values.push_back(course.of(s));
    }
    if (!series.x.values.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

// Events on the line of the speed, of the motor alone; a rotor that drives the wave may do so at each beat. A loop that switches
// the drive again and again has too many to be read: the table tells them.
void mark_events(Chart& chart, const MotionResult& answer) {
  if (answer.family) return;
  const double seconds = time_unit(answer.duration).seconds;
  for (const MotionEvent& event : answer.members.front().motion.events)
    if (event.kind != MotionEventKind::overruns)
      chart.marks.push_back({event.time / seconds, event.speed, {event_words(event.kind)}});
  if (chart.marks.size() > kMarked) chart.marks.clear();
}

// The error bar of the oscillating engine.
Phrase step_error_remark(const MotionResult& answer, const MovedMotor& motor) {
  Phrase phrase = answer.family ? Phrase{"With "} : Phrase{};
  if (answer.family) append(phrase, family_phrase(answer.family, motor.value));
  const MotionResult::StepError& error = *motor.step_error;
  append(phrase,
         {answer.family ? " discretization errors: speed " : "Discretization errors: speed ",
          value_part(error.speed, "rad/s", 2), ", angle ", value_part(error.angle, "rad", 2),
          ", amplitude ", value_part(error.amplitude, "m", 2),
          ". These are the largest differences over time from a motion with half as many contact "
          "points and time steps."});
  return phrase;
}

Section courses(const MotionResult& answer) {
  Section section{{"Over time"}, {}};
  section.charts = {course_chart(answer, kSpeed)};
  mark_events(section.charts.front(), answer);
  for (const MovedMotor& motor : answer.members)
    if (motor.step_error) section.remarks.push_back(step_error_remark(answer, motor));
  for (const Course& course : kCourses) {
    Chart chart = course_chart(answer, course);
    if (!chart.series.empty()) section.charts.push_back(std::move(chart));
  }
  return section;
}

}  // namespace

constexpr double kLeastGainMargin = 2;                      // 6 dB
constexpr double kLeastPhaseMargin = std::numbers::pi / 4;  // 45 degrees

std::string decibels(double factor) {
  return std::isfinite(factor) ? rounded_text(20 * std::log10(factor), 3) + " dB" : "unlimited";
}

std::string degrees(double angle) {
  return std::isfinite(angle) ? rounded_text(angle * 180 / std::numbers::pi, 3) + " deg"
                              : "unlimited";
}

Section loops(const MotionResult& answer) {
  Section section{{"Control loop"}, {}};
  Table table{"loop",
              {{"motor"},
               {"kp"},
               {"ki"},
               {"output"},
               {"speed"},
               {"gain margin"},
               {"phase margin"},
               {"crossover"}},
              {}};
  table.keys = 1;
  for (const MovedMotor& motor : answer.members) {
    if (!motor.loop) continue;
    const MotionResult::Loop& loop = *motor.loop;
    const std::string unit = loop.actuator == motion::Actuator::voltage ? "V" : "Hz";
    table.rows.push_back({family_phrase(answer.family, motor.value),
                          {value_part(loop.gains.proportional, unit + ".s/rad")},
                          {value_part(loop.gains.integral, unit + "/rad")},
                          {value_part(loop.plant.output, unit)},
                          {value_part(loop.plant.speed, "rad/s")},
                          {decibels(loop.margins.gain)},
                          {degrees(loop.margins.phase)},
                          {value_part(loop.margins.crossover, "Hz", 3)}});
    if (loop.margins.gain < kLeastGainMargin || loop.margins.phase < kLeastPhaseMargin)
      section.remarks.push_back(
          {bad("The margins are small"),
           ": below 6 dB or 45 deg the loop oscillates, and a motor that differs from its file may "
           "make it unstable. Use smaller gains, or a shorter sample time or delay."});
  }
  section.remarks.push_back(
      {"Gains and margins are those of the motor at the largest reference; at lower speeds the "
       "loop is slower."});
  section.tables = {table};
  return section;
}

std::vector<Section> sections_of(const MotionResult& answer, const Sources& /*sources*/) {
  if (answer.members.empty()) return {};
  std::vector<Section> sections{courses(answer)};
  const auto any = [&](auto has) { return std::ranges::any_of(answer.members, has); };
  if (any([](const MovedMotor& motor) { return motor.loop.has_value(); }))
    sections.push_back(loops(answer));
  if (any([](const MovedMotor& motor) { return !motor.measures.empty(); }))
    sections.push_back(measures(answer));
  if (any([](const MovedMotor& motor) { return !motor.motion.events.empty(); }))
    sections.push_back(events(answer));
  return sections;
}

}  // namespace twum::inline v0_1::studies::telling
