// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

// The motors of an answer; of a front each has the place of its point.
struct AnswerMotors {
  const StudyResult& result;
  std::size_t points;
  FrontCurves front;
  std::vector<MotorCurve> curves{};

  MotorCurve* add(const std::string& name, const std::vector<NamedValue>& values) {
    std::optional<MotorCurve> curve = motor_curve(name, result.design, values, points);
    if (!curve) return nullptr;
    curve->place = curves.size();
    curves.push_back(std::move(*curve));
    return &curves.back();
  }

  void add_own() { add(result.motor.empty() ? "motor" : result.motor, {}); }

  void operator()(const CurveResult& answer) {
    if (!answer.family) return add_own();
    const StoredColumn& of = *answer.family;
    for (const CurveResult::Member& member : answer.members)
      add(written({name_part(of.name), " ", value_part(member.value, of.unit)}, Writing::read),
          {{of.name, of.unit, member.value}});
  }

  void operator()(const ParetoResult& answer) {
    for (std::size_t i = 0; i < answer.front.size(); ++i) {
      const std::string role = written(role_phrase(answer, i), Writing::read);
      if (role.empty() && front == FrontCurves::ends) continue;
      MotorCurve* curve = add(role.empty() ? "point " + std::to_string(i + 1) : role,
                              answer.front[i].report.design);
      if (curve == nullptr) continue;
      curve->place = i;
      curve->whole = false;
    }
  }

  void operator()(const OptimizeResult& answer) {
    add("before", answer.before_design);
    if (answer.found) add("best design", answer.best.design);
  }

  void operator()(const CalibrateResult& answer) {
    for (const std::string& file : answer.files())
      add(file.empty() ? "fitted motor" : file, answer.motor_values(file));
  }

  void operator()(const SensitivityResult& /*answer*/) { add_own(); }
  void operator()(const UncertaintyResult& /*answer*/) { add_own(); }

  // Answers of many designs, or of one motor in other quantities.
  template <typename Other>
  void operator()(const Other& /*answer*/) {}
};

}  // namespace

std::optional<MotorCurve> motor_curve(const std::string& name, const MotorDesign& base,
                                      const std::vector<NamedValue>& values, std::size_t points) {
  std::vector<ParameterValue> replaced;
  for (const NamedValue& value : values)
    if (const auto parameter = find_parameter(value.name); parameter && std::isfinite(value.value))
      replaced.emplace_back(*parameter, value.value);
  try {
    MotorCurve curve{name, Motor(with(base, replaced))};
    for (const double speed : curve_speeds(curve.motor, points))
      curve.points.push_back(curve.motor.operating_point(speed));
    return curve;
  } catch (const InputError&) {
    return {};  // a design that is not admissible has no curve
  }
}

std::vector<MotorCurve> motor_curves(const StudyResult& result, std::size_t points,
                                     FrontCurves front) {
  AnswerMotors motors{result, points, front};
  std::visit(motors, result.answer);
  return std::move(motors.curves);
}

}  // namespace twum::inline v0_1::studies::telling
