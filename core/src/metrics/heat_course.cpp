// SPDX-License-Identifier: Apache-2.0
#include "metrics/heat_course.hpp"

#include "curve/curve.hpp"
#include "metrics/heat_metrics.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

constexpr double kReturned = 1e-6;  // [K]
constexpr int kMostCycles = 20;

MotorDesign in_phase(const MotorDesign& design, const LoadPhase& phase) {
  MotorDesign now = design;
  if (phase.voltage && now.stator.voltage) now.stator.voltage = phase.voltage;
  return now;
}

HeatProblem problem_of(const HeatNetwork& network, double ambient,
                       const std::optional<LoadLosses>& losses) {
  if (!losses) return {network, ambient, [](const NodeTemperatures&) { return WarmLosses{}; }};
  return {network, ambient, [losses](const NodeTemperatures& x) { return losses->at(x); },
          [losses](const NodeTemperatures& x, const LoadWave& known) {
            return losses->near(x, known);
          }};
}

CoursePhase course_phase(const MotorDesign& design, const HeatNetwork& network,
                         const LoadPhase& phase) {
  std::optional<LoadLosses> losses;
  if (phase.load) losses.emplace(in_phase(design, phase), *phase.load);
  return {losses, HeatSolver(problem_of(network, design.thermal->ambient, losses)), phase.time,
          phase.voltage.has_value()};
}

void require_ok(const HeatState& state) {
  if (state.status != MetricStatus::ok) throw SearchFailure{state.status};
}

}  // namespace

PartValues<double> temperature_limits(const MotorDesign& design) {
  PartValues<double> limits;
  limits.fill(kNoLimit);
  for (std::size_t i = 0; i < kTemperatureLimits.size(); ++i)
    if (const double given = get(design, kTemperatureLimits[i]); !std::isnan(given))
      limits[i] = given;
  return limits;
}

HeatCourse::HeatCourse(const MotorDesign& design, std::span<const LoadPhase> phases)
    : ambient_(design.thermal->ambient) {
  const HeatNetwork network = network_of(design);
  for (const LoadPhase& phase : phases) phases_.push_back(course_phase(design, network, phase));
}

HeatCourse HeatCourse::searching() const {
  HeatCourse other = *this;
  for (CoursePhase& phase : other.phases_) phase.solver = phase.solver.searching();
  return other;
}

HeatCourse::Lap HeatCourse::run(const Vector3& start) const {
  Lap lap;
  Vector3 theta = start;
  NodeTemperatures guess = phases_.front().solver.cold_nodes();
  for (const CoursePhase& phase : phases_) {
    const HeatState begin = phase.solver.at_masses(theta, guess);
    require_ok(begin);
    lap.push_back(phase.solver.followed(begin, phase.time, kCourseError));
    require_ok(lap.back().back());
    theta = lap.back().back().theta, guess = lap.back().back().x;
  }
  return lap;
}

// The cycle as a map of theta with the losses of the cold motor is linear: theta = E theta + v.
Vector3 HeatCourse::first_guess() const {
  Vector3 v{};
  Matrix3 all = kIdentity3;
  for (const CoursePhase& phase : phases_) {
    const HeatSolver::Linear map = phase.solver.with_cold_losses(phase.time);
    v = plus(map.E * v, 1, map.v);
    all = map.E * all;
  }
  return inverse(plus(kIdentity3, -1, all)) * v;
}

HeatCourse::Lap HeatCourse::periodic() const {
  Vector3 theta = first_guess();
  for (int i = 0; i < kMostCycles; ++i) {
    Lap lap = run(theta);
    const Vector3 off = plus(lap.back().back().theta, -1, theta);
    if (largest(off) <= kReturned) return lap;
    Matrix3 moved = kIdentity3;
    for (const auto& states : lap) moved = states.back().moved * moved;
    theta = plus(theta, 1, inverse(plus(kIdentity3, -1, moved)) * off);
  }
  throw SearchFailure{MetricStatus::thermally_unstable};
}

double HeatCourse::temperature(const Moment& moment, std::size_t part) const {
  return phases_[moment.phase].solver.parts(moment.state)[part];
}

HeatCourse::Moment HeatCourse::moment_at(std::size_t phase, const HeatState& from,
                                         double after) const {
  if (!(after > 0)) return {phase, from.time, from};
  const HeatState state = phases_[phase].solver.advanced(from, after, kCourseError);
  require_ok(state);
  return {phase, state.time, state};
}

// The part rises at a and falls at b: its rate is zero between.
HeatCourse::Moment HeatCourse::top_between(std::size_t phase, const HeatState& a,
                                           const HeatState& b, std::size_t part) const {
  const HeatSolver& solver = phases_[phase].solver;
  const auto rate = [&](double after) {
    return solver.part_rates(moment_at(phase, a, after).state)[part];
  };
  const Bracket ends{0, b.time - a.time, solver.part_rates(a)[part], solver.part_rates(b)[part]};
  return moment_at(phase, a, closed_in("a peak of a temperature", rate, ends, 30).nearest());
}

HeatCourse::Moment HeatCourse::peak(const Lap& lap, std::size_t part) const {
  Moment best{0, 0, lap.front().front()};
  const auto keep_if_hotter = [&](const Moment& one) {
    if (temperature(one, part) > temperature(best, part)) best = one;
  };
  for (std::size_t i = 0; i < lap.size(); ++i)
    for (std::size_t k = 0; k < lap[i].size(); ++k) {
      keep_if_hotter({i, lap[i][k].time, lap[i][k]});
      const auto rate = [&](std::size_t at) {
        return phases_[i].solver.part_rates(lap[i][at])[part];
      };
      if (k > 0 && rate(k - 1) > 0 && rate(k) < 0)
        keep_if_hotter(top_between(i, lap[i][k - 1], lap[i][k], part));
    }
  return best;
}

std::optional<std::pair<HeatCourse::Moment, std::size_t>> HeatCourse::first_limit(
    const Lap& lap, const PartValues<double>& limits) const {
  std::optional<std::pair<Moment, std::size_t>> first;
  const auto excess = [&](const Moment& at, std::size_t part) {
    return temperature(at, part) - limits[part];
  };
  for (std::size_t i = 0; i < lap.size() && !first; ++i)
    for (std::size_t k = 0; k + 1 < lap[i].size() && !first; ++k)
      for (std::size_t part = 0; part < kParts; ++part) {
        if (!std::isfinite(limits[part])) continue;
        const HeatState &a = lap[i][k], &b = lap[i][k + 1];
        const HeatSolver& solver = phases_[i].solver;
        Moment to{i, b.time, b};
        if (!(excess(to, part) > 0) && solver.part_rates(a)[part] > 0 &&
            solver.part_rates(b)[part] < 0)
          to = top_between(i, a, b, part);
        const double before = excess({i, a.time, a}, part), after = excess(to, part);
        if (before >= 0) return std::pair{Moment{i, a.time, a}, part};
        if (!(after > 0)) continue;
        const auto over = [&](double time) { return excess(moment_at(i, a, time), part); };
        const double time = closed_in("the time to a limit of temperature", over,
                                      Bracket{0, to.time - a.time, before, after}, 40)
                                .nearest();
        if (!first || a.time + time < first->first.time) first = {moment_at(i, a, time), part};
      }
  return first;
}

HeatCourse::Moment HeatCourse::at(const Lap& lap, double time) const {
  std::size_t i = 0;
  while (i + 1 < lap.size() && time >= phases_[i].time) time -= phases_[i++].time;
  time += lap[i].front().time;
  const auto after =
      std::upper_bound(lap[i].begin() + 1, lap[i].end(), time,
                       [](double sought, const HeatState& state) { return sought < state.time; });
  const HeatState& before = *(after - 1);
  return moment_at(i, before, time - before.time);
}

PartValues<double> HeatCourse::mean(const Lap& lap) const {
  Sources<double> heat{};
  double period = 0;
  for (std::size_t i = 0; i < lap.size(); ++i) {
    for (std::size_t k = 0; k < kSources; ++k) heat[k] += lap[i].back().heat[k];
    period += phases_[i].time;
  }
  for (double& one : heat) one /= period;
  PartValues<double> parts = steady_parts(phases_.front().solver.matrices(), heat);
  for (double& one : parts) one += ambient_;
  return parts;
}

}  // namespace twum::inline v0_1::core
