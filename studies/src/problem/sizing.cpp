// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/sizing.hpp>

#include "problem/held_duty.hpp"
#include "problem/multi_start.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>

#include <algorithm>
#include <cctype>
#include <numbers>

namespace twum::inline v0_1::studies {
namespace {

double named_quantity(const char* name, std::string_view text, const Expected& expected) {
  try {
    return parse_quantity(text, expected);
  } catch (const InputError& error) {
    throw InputError(std::string(name) + ": " + error.what());
  }
}

// Unlike speed_at(load), the torque at a speed also exists for motors that cannot carry the load.
std::string duty_limit(const DutyPoint& duty) {
  if (!duty.text.empty()) return duty.text;
  return "torque_at(" + number_text(duty.speed) + " rad/s) >= " + number_text(duty.torque) + " N.m";
}

// Metrics that depend on the wave and have no argument, with those at a point.
constexpr std::pair<const char*, const char*> kOfTheWave[] = {
    {"max_pressure", "max_pressure_at"},
    {"layer_aspect", "layer_aspect_at"},
    {"ceramic_stress", "ceramic_stress_at"}};

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The text with each whole word `name` replaced.
std::string with_word(std::string text, std::string_view name, const std::string& other) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
    const std::size_t end = at + name.size();
    const bool whole =
        (at == 0 || !is_of_name(text[at - 1])) && (end == text.size() || !is_of_name(text[end]));
    if (whole) text.replace(at, name.size(), other);
    at += whole ? other.size() : name.size();
  }
  return text;
}

std::string at_point(std::string text, const DutyPoint& point) {
  for (const auto& [name, at] : kOfTheWave)
    text = with_word(std::move(text), name, at + ("(" + held_arguments(point) + ")"));
  return text;
}

std::string at_worst(std::string text, std::span<const DutyPoint> duty, bool maximize) {
  for (const auto& [name, at] : kOfTheWave) {
    std::string all;
    for (const DutyPoint& point : duty)
      all += (all.empty() ? "" : ", ") + (at + ("(" + held_arguments(point) + ")"));
    if (duty.size() > 1) all = (maximize ? "min(" : "max(") + all + ")";
    text = with_word(std::move(text), name, all);
  }
  return text;
}

}  // namespace

const char* to_string(DutyDrive drive) { return drive == DutyDrive::follows ? "follows" : "fixed"; }

std::string held_arguments(const DutyPoint& point) {
  const std::string rpm = rounded_text(point.speed * 30 / std::numbers::pi, 10) + " rpm";
  const bool exact = parse_quantity(rpm, {"rad/s", "100 rpm"}) == point.speed;
  return number_text(point.torque) + " N.m, " + (exact ? rpm : number_text(point.speed) + " rad/s");
}

DesignProblem held_at(DesignProblem problem, std::span<const DutyPoint> duty) {
  problem.held.assign(duty.begin(), duty.end());
  std::vector<MotorLimit> limits;
  for (const MotorLimit& limit : problem.limits) {
    std::vector<std::string> texts;
    for (const DutyPoint& point : duty)
      if (std::string text = at_point(limit.text, point);
          std::find(texts.begin(), texts.end(), text) == texts.end())
        texts.push_back(std::move(text));
    for (const std::string& text : texts)
      limits.push_back(text == limit.text ? limit
                       : limit.tolerance_text.empty()
                           ? parse_limit(text)
                           : with_tolerance(parse_limit(text), limit.tolerance_text));
  }
  problem.limits = std::move(limits);
  for (DesignObjective& goal : problem.objectives) {
    if (goal.statistic) continue;
    const std::string text = at_worst(goal.metric.text, duty, goal.maximize);
    if (text != goal.metric.text) goal.metric = parse_metric(text);
  }
  return problem;
}

DesignAnswer solve(const DesignProblem& problem, const optim::SolveOptions& options) {
  DesignAnswer answer{solve_from_starts(motor_problem(problem), options), problem.motor};
  if (!answer.search.design.empty()) answer.motor = motor_of(problem, answer.search.design);
  return answer;
}

DesignFront solve_front(const DesignProblem& problem, const optim::ParetoOptions& options) {
  DesignFront front{optim::pareto_front(motor_problem(problem), options), {}};
  for (const optim::FrontPoint& point : front.search.points)
    front.motors.push_back(motor_of(problem, point.design));
  return front;
}

DutyPoint duty_point(std::string_view torque, std::string_view speed) {
  return {named_quantity("torque", torque, {"N.m", "0.5 N.m"}),
          named_quantity("speed", speed, {"rad/s", "100 rpm"}),
          "torque_at(" + std::string(speed) + ") >= " + std::string(torque)};
}

DesignAnswer size(const DesignProblem& problem, std::span<const DutyPoint> duty,
                  const optim::SolveOptions& options, DutyDrive drive) {
  if (duty.empty()) throw InputError("a duty needs at least one operating point");
  DesignProblem sized = problem;
  if (sized.objectives.empty()) sized.minimize("max_pressure");
  if (drive == DutyDrive::follows) return solve(held_at(sized, duty), options);
  sized.limits.clear();
  for (const DutyPoint& point : duty) sized.limit(duty_limit(point));
  sized.limits.insert(sized.limits.end(), problem.limits.begin(), problem.limits.end());
  return solve(sized, options);
}

DesignAnswer size(const DesignProblem& problem, std::initializer_list<DutyPoint> duty,
                  const optim::SolveOptions& options, DutyDrive drive) {
  return size(problem, std::span(duty.begin(), duty.size()), options, drive);
}

DesignAnswer size(const DesignProblem& problem, const DutyPoint& duty,
                  const optim::SolveOptions& options, DutyDrive drive) {
  return size(problem, std::span(&duty, 1), options, drive);
}

}  // namespace twum::inline v0_1::studies
