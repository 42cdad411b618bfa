// SPDX-License-Identifier: Apache-2.0
#include "metrics/worn_motors.hpp"

#include "metrics/differentiator.hpp"

#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;

// Metrics of one operating point, which a followed wave answers.
bool is_of_point(const MetricRequest& request) {
  if (request.warm_at || request.worn_at || request.metric == M::ceramic_stress_at) return false;
  const MetricInfo& row = info(request.metric);
  return request.metric == M::speed_at ||
         (row.argument == Argument::speed_or_torque && !row.needs_thermal && !row.needs_wear);
}

MotorDesign under_voltage(MotorDesign design, const std::optional<double>& voltage) {
  if (voltage && design.stator.voltage) design.stator.voltage = voltage;
  return design;
}

bool is_same(double a, double b) {
  constexpr double kSame = 1e-8;  // both are known far better
  return std::fabs(a - b) <= kSame * std::fabs(b);
}

}  // namespace

WornMotors::WornMotors(const MotorDesign& design, const std::optional<double>& voltage)
    : design_(under_voltage(design, voltage)), voltage_(voltage) {}

const Motor& WornMotors::at(double depth) {
  if (!last_ || last_->first != depth) last_.emplace(depth, Motor(worn_design(design_, depth)));
  return last_->second;
}

// On the line through the two nearest depths.
LoadWave WornMotors::Path::near(double depth) const {
  auto a = waves.lower_bound(depth);
  if (a != waves.end() && a->first == depth) return a->second;
  if (waves.size() == 1) return waves.begin()->second;
  if (a == waves.begin()) ++a;
  if (a == waves.end()) --a;
  const auto b = std::prev(a);
  const double share = (depth - b->first) / (a->first - b->first);
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  return {between(b->second.amplitude, a->second.amplitude),
          between(b->second.speed, a->second.speed)};
}

WornMotors::Path* WornMotors::path_of(const MetricRequest& request) {
  const LoadPoint load{request.argument, request.at, request.torque};
  if (!follows_ || !is_of_point(request) || !follows_wave(design_, load)) return nullptr;
  for (Path& path : paths_)
    if (path.load == load) return &path;
  return &paths_.emplace_back(Path{load, {}});
}

std::unique_ptr<const FollowedCurve> WornMotors::followed(Path& path, double depth) {
  if (path.waves.empty()) return {};
  auto curve = FollowedCurve::from(at(depth).design(), path.load, path.near(depth));
  if (curve)
    path.waves.insert_or_assign(depth, LoadWave{curve->motor().mean.amplitude, curve->speed()});
  return curve;
}

std::optional<LoadWave> WornMotors::searched(const LoadPoint& load, double depth) {
  const bool at_torque = load.argument == Argument::torque;
  std::vector<MetricRequest> asked{{M::amplitude_at, load.argument, load.at}};
  if (at_torque) asked.push_back({M::speed_at, load.argument, load.at});
  const auto found = twum::evaluate(at(depth), asked);
  for (const MetricValue& one : found)
    if (one.status != MetricStatus::ok) return {};
  const double speed = at_torque ? found.back().value : load.at;
  return speed > 0 ? std::optional(LoadWave{found.front().value, speed}) : std::nullopt;
}

template <typename Answers, typename Answer, typename Ask, typename Search, typename... More>
std::vector<Answer> WornMotors::answers(double depth, std::span<const MetricRequest> requests,
                                        Ask ask, Search search, More... more) {
  std::vector<Answer> found(requests.size());
  std::vector<MetricRequest> left;
  std::vector<std::size_t> places;
  std::optional<Answers> point;
  const Path* of = nullptr;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    Path* path = path_of(requests[i]);
    if (path && path != of) {
      point.reset(), of = path;
      if (auto curve = followed(*path, depth)) point.emplace(at(depth), std::move(curve), more...);
    }
    if (path && point)
      found[i] = ask(*point, requests[i], path->waves.at(depth).speed);
    else
      left.push_back(requests[i]), places.push_back(i);
  }
  const std::vector<Answer> searched_anew = search(left);
  for (std::size_t i = 0; i < places.size(); ++i) found[places[i]] = searched_anew[i];
  for (const MetricRequest& request : left)
    if (Path* path = path_of(request); path && !path->waves.contains(depth))
      if (const auto wave = searched(path->load, depth)) path->waves.emplace(depth, *wave);
  return found;
}

std::vector<MetricValue> WornMotors::evaluate(double depth,
                                              std::span<const MetricRequest> requests) {
  return answers<Evaluator, MetricValue>(
      depth, requests,
      [](Evaluator& point, const MetricRequest& request, double speed) {
        return point.evaluate_at(request.metric, speed);
      },
      [&](std::span<const MetricRequest> left) { return twum::evaluate(at(depth), left); });
}

std::vector<MetricDerivative> WornMotors::differentiate(double depth,
                                                        std::span<const MetricRequest> requests,
                                                        bool fixed) {
  return answers<Differentiator, MetricDerivative>(
      depth, requests,
      [](Differentiator& point, const MetricRequest& request, double speed) {
        const bool at_torque = request.argument == Argument::torque;
        return point.differentiate_at(request.metric, speed,
                                      at_torque ? std::optional(request.at) : std::nullopt);
      },
      [&](std::span<const MetricRequest> left) {
        return twum::differentiate(at(depth), left, fixed);
      },
      fixed);
}

bool WornMotors::confirm_or_stop_following(double depth) {
  for (const Path& path : paths_) {
    const auto known = path.waves.find(depth);
    if (known == path.waves.end()) continue;
    const auto wave = searched(path.load, depth);
    if (wave && is_same(wave->amplitude, known->second.amplitude) &&
        is_same(wave->speed, known->second.speed))
      continue;
    paths_.clear(), follows_ = false;
    return false;
  }
  return true;
}

}  // namespace twum::inline v0_1::core
