// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metrics.hpp>
#include <twum/core/motion_metrics.hpp>

#include "design/held_traps.hpp"
#include "design/workspace.hpp"
#include "metrics/differentiator.hpp"
#include "metrics/heat_metrics.hpp"
#include "metrics/held_metrics.hpp"
#include "metrics/motor_parts.hpp"
#include "metrics/wear_metrics.hpp"
#include "point/slice_count.hpp"

#include <twum/base/error.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace twum::inline v0_1 {

using namespace core;

SpeedDerivative differentiate_in_speed(const Motor& motor, double speed) {
  const HeldTraps traps;
  SpeedDerivative d;
  d.point = motor.operating_point(speed);
  if (d.point.status != PointStatus::ok) {
    d.torque = d.output_power = d.stator_power = d.friction_power = d.layer_loss =
        d.stick_fraction = std::numeric_limits<double>::quiet_NaN();
    d.smoothness = Smoothness::undefined;
    return d;
  }
  const DrivenMotor<double>& m = MotorParts::model(motor);
  const SolvedPoint solved = solve_point(m, speed);
  const auto n = solved.differentiated(m, contact::MotionDual::variable(speed, contact::kInSpeed),
                                       contact::Means::all);
  d.torque = n.torque.d[0];
  d.output_power = d.point.torque + speed * d.torque;
  d.stator_power = n.stator_power.d[0];
  d.friction_power = n.friction_power.d[0];
  d.layer_loss = n.layer_loss.d[0];
  d.stick_fraction = n.stick_fraction.d[0];
  d.smoothness = smoothness_of(m, solved, speed);
  return d;
}

namespace {

// Numbers that the wave does not enter: of a motor under a voltage it need not be followed.
bool needs_no_wave(Metric metric) {
  return metric == Metric::holding_torque || metric == Metric::coupling_factor ||
         metric == Metric::capacitance_ratio || metric == Metric::mode_separation ||
         metric == Metric::stator_mass;
}

// Numbers of the waves at rest: the running wave need not be followed over the speed.
bool needs_no_running_wave(Metric metric) {
  return metric == Metric::start_voltage || metric == Metric::hold_voltage ||
         metric == Metric::start_frequency || metric == Metric::pull_out_frequency;
}

// What provide_motion_metrics() was given.
MakeMotionMetrics make_motion_metrics = nullptr;

bool is_of_motion(const MetricRequest& request) {
  return info(request.metric).needs_motion && !request.warm_at && !request.worn_at;
}

// The speed of all requests that need the running wave, if it is one, and they are about its point.
std::optional<double> only_speed(const Motor& motor, std::span<const MetricRequest> requests) {
  const Stator& stator = motor.design().stator;
  if (!stator.voltage || stator.branch != Branch::running) return {};
  std::optional<double> speed;
  for (const MetricRequest& r : requests) {
    const bool elsewhere = is_wear(r) || is_heat(r) || is_held(r) || is_of_motion(r) ||
                           needs_no_wave(r.metric) || needs_no_running_wave(r.metric);
    if (elsewhere) continue;
    if (r.argument != Argument::speed || speed.value_or(r.at) != r.at) return {};
    speed = r.at;
  }
  return speed;
}

// Lives of a track that wears freely need the integrator of motions; its rate when new does not.
bool is_of_free_life(const MotorDesign& design, const MetricRequest& request) {
#ifdef __wasm__  // the page has no lives
  return false;
#else
  return wears_freely(design) && is_of_life(request);
#endif
}

// The answer where the library of motions is missing.
struct WithoutMotions {
  MetricValue evaluate(const MetricRequest&) const {
    return {std::numeric_limits<double>::quiet_NaN(), MetricStatus::undefined};
  }
  MetricDerivative differentiate(const MetricRequest& request, bool) const {
    return {evaluate(request), {}, Smoothness::undefined};
  }
};

// Each request to the part that answers it; parts are made when they are needed.
template <typename Answers, typename Answer>
class Parts {
 public:
  template <typename... More>
  Parts(const Motor& motor, std::span<const MetricRequest> requests, More... more)
      : motor_(motor),
        only_speed_(only_speed(motor, requests)),
        make_([=](const Motor& m, std::optional<Answers>& to) { to.emplace(m, more...); }),
        make_at_([=](const Motor& m, std::unique_ptr<const FollowedCurve> known,
                     std::optional<Answers>& to) { to.emplace(m, std::move(known), more...); }),
        make_at_rest_([=](const Motor& m, std::optional<Answers>& to) {
          to.emplace(m, std::make_unique<const RestCurve>(*MotorParts::at_rest(m)), more...);
        }) {}

  // @param ask  by each of the parts
  template <typename Ask>
  Answer answer(const MetricRequest& request, Ask ask) {
    if (is_of_free_life(motor_.design(), request) && !make_motion_metrics) return ask(no_motions_);
    if (is_of_free_life(motor_.design(), request)) return ask(of_motions());
    if (is_wear(request)) return ask(made(wear_, motor_.design()));
    if (is_heat(request)) return ask(made(heat_, motor_));
    if (is_held(request)) return ask(made(held_, motor_.design()));
    if (is_of_motion(request) && make_motion_metrics) return ask(of_motions());
    if (motor_.design().stator.voltage && needs_no_wave(request.metric)) {
      if (!still_) still_.emplace(without_drive(motor_.design()));
      if (!of_still_) make_(*still_, of_still_);
      return ask(*of_still_);
    }
    if (motor_.design().stator.voltage && needs_no_running_wave(request.metric) && !of_motor_) {
      if (!of_rest_) make_at_rest_(motor_, of_rest_);
      return ask(*of_rest_);
    }
    return ask(of_motor());
  }

 private:
  template <typename Part, typename Of>
  static Part& made(std::optional<Part>& part, const Of& of) {
    return part ? *part : part.emplace(of);
  }
  Answers& of_motor() {
    if (of_motor_) return *of_motor_;
    auto known =
        only_speed_ ? FollowedCurve::at_speed(MotorParts::waves(motor_), *only_speed_) : nullptr;
    known ? make_at_(motor_, std::move(known), of_motor_) : make_(motor_, of_motor_);
    return *of_motor_;
  }
  MotionMetrics& of_motions() {
    if (!motion_) motion_ = make_motion_metrics(motor_.design());
    return *motion_;
  }

  const Motor& motor_;
  std::optional<HeldMetrics> held_;
  std::optional<HeatMetrics> heat_;
  std::optional<WearMetrics> wear_;
  WithoutMotions no_motions_;
  std::unique_ptr<MotionMetrics> motion_;
  std::optional<double> only_speed_;
  std::function<void(const Motor&, std::optional<Answers>&)> make_;
  std::function<void(const Motor&, std::unique_ptr<const FollowedCurve>, std::optional<Answers>&)>
      make_at_;
  std::function<void(const Motor&, std::optional<Answers>&)> make_at_rest_;
  std::optional<Motor> still_;
  std::optional<Answers> of_motor_, of_still_, of_rest_;
};

}  // namespace

bool provide_motion_metrics(MakeMotionMetrics make) noexcept {
  make_motion_metrics = make;
  return true;
}

bool has_motion_metrics() noexcept { return make_motion_metrics != nullptr; }

namespace {

void evaluate_into(std::span<MetricValue> values, const Motor& motor,
                   std::span<const MetricRequest> requests) {
  const HeldTraps traps;
  Parts<Evaluator, MetricValue> parts(motor, requests);
  for (std::size_t i = 0; i < requests.size(); ++i)
    values[i] = parts.answer(requests[i], [&](auto& to) { return to.evaluate(requests[i]); });
}

}  // namespace

std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests) {
  std::vector<MetricValue> values(requests.size());
  evaluate_into(values, motor, requests);
  return values;
}

MetricValue evaluate(const Motor& motor, const MetricRequest& request) {
  MetricValue value;
  evaluate_into({&value, 1}, motor, {&request, 1});
  return value;
}

#ifndef __wasm__
void evaluate(const Motor& motor, std::span<const MetricRequest> requests,
              std::span<MetricValue> values, Workspace& workspace) {
  if (values.size() != requests.size())
    throw InputError(std::to_string(requests.size()) +
                     " metrics need as many places for values, not " +
                     std::to_string(values.size()));
  const WorkIn scope(workspace);
  evaluate_into(values, motor, requests);
}
#endif

MetricValue evaluate_at_share(const Motor& motor, Metric metric, double share) {
  const HeldTraps traps;
  return Evaluator(motor).evaluate_at_share(metric, share);
}

MetricDerivative differentiate(const Motor& motor, const MetricRequest& request,
                               bool fixed_static_friction) {
  return differentiate(motor, std::span(&request, 1), fixed_static_friction).front();
}

std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction) {
  const HeldTraps traps;
  Parts<Differentiator, MetricDerivative> parts(motor, requests, fixed_static_friction);
  std::vector<MetricDerivative> derivatives;
  derivatives.reserve(requests.size());
  for (const MetricRequest& request : requests)
    derivatives.push_back(parts.answer(request, [&](auto& to) {
      if constexpr (requires { to.differentiate(request); })
        return to.differentiate(request);
      else
        return to.differentiate(request, fixed_static_friction);
    }));
  return derivatives;
}

MetricValue evaluate_beyond_drive(const Motor& motor, const MetricRequest& request) {
  const HeldTraps traps;
  return HeldMetrics(motor.design(), true).evaluate(request);
}

MetricDerivative differentiate_beyond_drive(const Motor& motor, const MetricRequest& request,
                                            bool fixed_static_friction) {
  const HeldTraps traps;
  return HeldMetrics(motor.design(), true).differentiate(request, fixed_static_friction);
}

MetricDerivative differentiate_at_share(const Motor& motor, Metric metric, double share,
                                        bool fixed_static_friction) {
  const HeldTraps traps;
  return Differentiator(motor, fixed_static_friction).differentiate_at_share(metric, share);
}

}  // namespace twum::inline v0_1
