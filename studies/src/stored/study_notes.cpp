// SPDX-License-Identifier: Apache-2.0
#include "stored/study_notes.hpp"

#include "entries/never_defined.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/studies/run_options.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

bool varies_amplitude(const StudyFile& file) {
  const auto varied = [](const auto& asked) {
    std::vector<Parameter> list;
    if constexpr (requires { asked.variables; }) list = parameters_of(asked.variables);
    if constexpr (requires { asked.family->parameter; })
      if (asked.family) list.push_back(asked.family->parameter);
    return std::find(list.begin(), list.end(), Parameter::amplitude) != list.end();
  };
  return std::visit(varied, file.asked);
}

std::string duration_words(double seconds) {
  if (seconds < 100) return rounded_text(seconds, 2) + " s";
  if (seconds < 6000) return rounded_text(seconds / 60, 2) + " min";
  return std::to_string(std::lround(seconds / 3600)) + " h";
}

}  // namespace

std::vector<std::string> notes_of(const StudyFile& file, const StudyKindRun& kind) {
  std::vector<std::string> notes = kind.notes();
  if (file.motor.design.stator.voltage && varies_amplitude(file))
    notes.emplace_back(
        "amplitude varied: it replaces the motor's voltage and does not follow the load; vary "
        "voltage or frequency instead to keep the drive");
  return notes;
}

std::vector<std::string> study_notes(const StudyFile& file) {
  const std::unique_ptr<StudyKindRun> kind = make_kind(file);
  std::vector<std::string> notes = notes_of(file, *kind);
  for (std::string& note : kind->notes_before()) notes.push_back(std::move(note));
  for (std::string& note : range_notes(file.asked, file.motor.design, file.study, file.path))
    notes.push_back(std::move(note));
  return notes;
}

std::string pace_note(const StudyFile& file) {
  constexpr double kLong = 60;  // [s]
  const std::optional<Pace> pace = make_kind(file)->pace();
  if (!pace) return {};
  const double longest = pace->seconds * static_cast<double>(pace->evaluations);
  if (longest < kLong) return {};
  return "an evaluation of this motor takes about " + engineering(pace->seconds, "s", 3) +
         ", so that the budget of " + std::to_string(pace->evaluations) +
         " evaluations (solver: max_evaluations) lasts about " + duration_words(longest) +
         " on one processor, or several times as long where other designs take longer";
}

}  // namespace twum::inline v0_1::studies
