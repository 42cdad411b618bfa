// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/found_motors.hpp"

#include "file/worst_notes.hpp"

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

MotorFile motor_with(const StudyFile& file, const std::vector<NamedValue>& values,
                     const std::string& name) {
  std::vector<ParameterValue> replaced;
  for (const NamedValue& value : values) {
    const auto parameter = find_parameter(value.name);
    TWUM_ASSERT(parameter.has_value());
    replaced.emplace_back(*parameter, value.value);
  }
  return {file.motor.name.empty() ? name : file.motor.name + ", " + name,
          with(file.motor.design, replaced)};
}

std::string two_digits(std::size_t number) {
  return std::string(number < 10 ? "0" : "") + std::to_string(number) + ".yaml";
}

struct Finder {
  const StudyFile& file;
  const StudyResult& result;

  std::vector<FoundMotor> operator()(const OptimizeResult& answer) const {
    const bool missed = answer.robust && result.outcome == StudyOutcome::infeasible;
    if (!answer.found || missed || !keeps_limits(answer.best)) return {};
    return {{"best.yaml", "best design",
             motor_with(file, answer.best.design, "best of " + result.study)}};
  }

  std::vector<FoundMotor> operator()(const ParetoResult& answer) const {
    std::vector<FoundMotor> motors;
    const std::size_t count = answer.front.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string point = "point " + std::to_string(i + 1) + " of " + std::to_string(count);
      motors.push_back(
          {front_file(i + 1, count), point,
           motor_with(file, answer.front[i].report.design, point + " of " + result.study)});
    }
    return motors;
  }

  // Tables with values of their own have a motor each.
  std::vector<FoundMotor> operator()(const CalibrateResult& answer) const {
    std::vector<FoundMotor> motors;
    if (result.outcome != StudyOutcome::fitted && result.outcome != StudyOutcome::several)
      return motors;
    const bool one = result.outcome == StudyOutcome::fitted;
    const std::vector<std::string> files = answer.files();
    for (const CalibrateResult::Optimum& optimum : answer.optima) {
      if (!optimum.fits_as_well || (one && !motors.empty())) continue;
      for (const std::string& table : files) {
        const std::string number = std::to_string(motors.size() + 1);
        const std::string of = table.empty() ? "" : " of " + table;
        const std::string path = !one                ? optimum_file(motors.size() + 1)
                                 : files.size() == 1 ? "fitted.yaml"
                                                     : "fitted/" + two_digits(motors.size() + 1);
        motors.push_back({path, one ? "fitted motor" + of : "motor " + number + " that fits" + of,
                          motor_with(file, values_at(answer, optimum, table),
                                     one ? "fit of " + result.study + of : "fit " + number + of)});
      }
    }
    return motors;
  }

  template <typename Other>
  std::vector<FoundMotor> operator()(const Other& /*answer*/) const {
    return {};
  }

 private:
  static std::vector<NamedValue> values_at(const CalibrateResult& answer,
                                           const CalibrateResult::Optimum& optimum,
                                           const std::string& table) {
    std::vector<NamedValue> values = answer.motor_values(optimum.values, table);
    values.insert(values.end(), optimum.derived.begin(), optimum.derived.end());
    return values;
  }
};

// For kinds whose answer is about the study's motor, or about a family of it.
std::vector<FoundMotor> asked_about(const StudyFile& file, const StudyResult& result) {
  const auto* curve = std::get_if<CurveResult>(&result.answer);
  if (curve == nullptr || !curve->family) {
    const auto* uncertain = std::get_if<UncertaintyStudy>(&file.asked);
    const bool varied = uncertain != nullptr && uncertain->start.empty();
    const bool nominal = curve != nullptr || varied;
    return nominal ? std::vector<FoundMotor>{{"", "motor", file.motor}} : std::vector<FoundMotor>{};
  }
  std::vector<FoundMotor> motors;
  for (const CurveResult::Member& member : curve->members)
    motors.push_back(
        {"",
         "motor with " + curve->family->name + " " + engineering(member.value, curve->family->unit),
         motor_with(file, {{curve->family->name, curve->family->unit, member.value}}, "member")});
  return motors;
}

// A search keeps the nodes a panel that it begins with; the motor that it finds may need more.
std::string slices_note(const StudyFile& file, const std::vector<FoundMotor>& found) {
  if (file.motor.design.stator.radial_slices != kAutoSlices) return "";
  for (const FoundMotor& each : found) {
    MotorDesign design = each.motor.design;
    const int had = std::exchange(design.stator.radial_slices, kAutoSlices);
    const int needed = had == kAutoSlices ? 0 : -Motor(design).radial_slices();
    if (needed > -had)
      return each.what + " needs " + std::to_string(needed) +
             " slices a panel, but the search used " + std::to_string(std::abs(had)) +
             "; to refine it, run a study with 'start' at this result";
  }
  return "";
}

}  // namespace

std::string front_file(std::size_t number, std::size_t count) {
  const std::string text = std::to_string(number);
  const std::size_t digits = std::max(std::to_string(count).size(), std::size_t{2});
  return "front/" + std::string(digits - text.size(), '0') + text + ".yaml";
}

std::string optimum_file(std::size_t number) { return "optima/" + two_digits(number); }

std::vector<FoundMotor> found_motors(const StudyFile& file, const StudyResult& result) {
  if (result.outcome == StudyOutcome::interrupted) return {};
  return std::visit(Finder{file, result}, result.answer);
}

std::string found_motor_text(const FoundMotor& found, const StudyResult& result) {
  return "# The " + found.what + " of the study " + printable(result.study, 255) + ", twum " +
         version() + ".\n" + motor_text(found.motor);
}

std::vector<std::string> notes_on(const StudyFile& file, const StudyResult& result) {
  std::vector<FoundMotor> motors = found_motors(file, result);
  if (motors.empty()) motors = asked_about(file, result);
  WorstNotes notes;
  for (const FoundMotor& found : motors)
    notes.add(model_notes_at_length(found.motor.design), found.what);
  std::vector<std::string> texts = notes.texts();
  if (std::string note = slices_note(file, motors); !note.empty()) texts.push_back(std::move(note));
  return texts;
}

}  // namespace twum::inline v0_1::studies
