// SPDX-License-Identifier: Apache-2.0
#include <twum/core/worn_in.hpp>

#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "metrics/motor_parts.hpp"
#include "model/track.hpp"

#include <twum/base/error.hpp>
#include <twum/base/gauss_rule.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

namespace twum::inline v0_1 {

using namespace core;

namespace {

using M = Metric;

constexpr int kAutoNodes = 16;

// A stretch of the track as a motor of one slice.
struct TrackSlice {
  double radius, width;  // [m]
  double amplitude;      // of the wave there [m]
  double load;           // [N]
};

MotorDesign motor_of(const MotorDesign& design, const TrackSlice& slice) {
  MotorDesign one;
  one.stator.wavelengths = design.stator.wavelengths;
  one.stator.contact_radius = slice.radius, one.stator.contact_width = slice.width;
  one.stator.neutral_plane_distance = get(design, Parameter::neutral_plane_distance);
  one.stator.frequency = drive_frequency(design);
  one.stator.amplitude = slice.amplitude;
  one.layer = design.layer;
  one.friction = design.friction;
  one.preload = slice.load;
  return one;
}

// A number with its derivatives by the slice's load and by the speed.
struct Moving {
  double value, by_load, by_speed;
};
struct SliceNumbers {
  Moving intensity;  // friction power per area
  Moving torque;
};

// Nothing where the slice has no such point.
std::optional<SliceNumbers> numbers_of(const MotorDesign& design, const TrackSlice& slice,
                                       double speed) try {
  const Motor motor(motor_of(design, slice));
  const MetricRequest asked[] = {{M::wear_intensity_at, Argument::speed, speed},
                                 {M::torque_at, Argument::speed, speed}};
  const auto found = differentiate(motor, asked);
  const SpeedDerivative by_speed = differentiate_in_speed(motor, speed);
  for (const MetricDerivative& one : found)
    if (one.value.status != MetricStatus::ok || one.smoothness == Smoothness::undefined) return {};
  if (by_speed.smoothness == Smoothness::undefined) return {};
  constexpr std::size_t kLoad = index_of(Parameter::preload);
  const double area = 2 * std::numbers::pi * slice.radius * slice.width;
  return SliceNumbers{
      {found[0].value.value, found[0].gradient[kLoad], by_speed.friction_power / area},
      {found[1].value.value, found[1].gradient[kLoad], by_speed.torque}};
} catch (const InputError&) {  // a load beyond the range of the parameter
  return {};
}

// Disturbances of the depths decay if sum of f_j D_j eta_j^2 > 0 wherever sum of f_j eta_j = 0, with the stiffness f_j = dF_j / dd.
// D_j = f_j dw_j/dF_j, and the sum over all but one positive D_j is positive there if the sum of dF_j/dw_j is negative.
bool is_stable(const std::vector<SliceNumbers>& slices) {
  int falling = 0;
  double sum = 0;
  for (const SliceNumbers& one : slices) {
    if (!(one.intensity.by_load > 0)) ++falling;
    sum += 1 / one.intensity.by_load;
  }
  return falling == 0 || (falling == 1 && sum < 0);
}

// The speed of the rotor under a load; nothing without one.
std::optional<double> speed_under(const Motor& motor, const LoadPoint& load) {
  if (load.argument == Argument::speed) return load.at;
  if (load.argument != Argument::torque) return {};
  const MetricValue found = evaluate(motor, {M::speed_at, Argument::torque, load.at});
  return found.status == MetricStatus::ok ? std::optional(found.value) : std::nullopt;
}

// The design with the wave that it has at a speed as its given one.
std::optional<MotorDesign> with_wave_at(const MotorDesign& design, double speed) {
  if (!design.stator.voltage) return design;
  const MetricValue found = evaluate(Motor(design), {M::amplitude_at, Argument::speed, speed});
  if (found.status != MetricStatus::ok) return {};
  MotorDesign given = design;
  given.stator.voltage.reset();
  given.stator.amplitude = found.value;
  return given;
}

std::vector<TrackSlice> even_slices(const Motor& motor) {
  std::vector<TrackSlice> slices;
  for (const Slice<double>& one : MotorParts::model(motor).slices())
    if (one.load > 0) slices.push_back({one.radius, one.width, one.amplitude, one.load});
  return slices;
}

bool is_one_slice(const MotorDesign& design) { return design.stator.radial_slices == 1; }

}  // namespace

const char* to_string(WearStability stability) noexcept {
  switch (stability) {
    case WearStability::even: return "wears-evenly";
    case WearStability::uneven: return "wears-unevenly";
    case WearStability::unknown: return "unknown";
  }
  return "";
}

WearStability wear_stability(const MotorDesign& design, const LoadPoint& load) {
  const HeldTraps traps;
  const Motor motor(design);
  if (is_one_slice(design) || design.stator.radial_motion) return WearStability::unknown;
  const auto speed = speed_under(motor, load);
  const auto given = speed ? with_wave_at(motor.design(), *speed) : std::nullopt;
  if (!given) return WearStability::unknown;
  std::vector<SliceNumbers> numbers;
  for (const TrackSlice& slice : even_slices(Motor(*given))) {
    const auto found = numbers_of(*given, slice, *speed);
    if (!found) return WearStability::unknown;
    numbers.push_back(*found);
  }
  return is_stable(numbers) ? WearStability::even : WearStability::uneven;
}

namespace {

// Gauss nodes of the whole track: points of the material, which stay where zones and contact change.
std::vector<TrackSlice> material_slices(const Motor& motor) {
  const Stator& stator = motor.design().stator;
  const DrivenMotor<double>& m = MotorParts::model(motor);
  const int given = std::abs(stator.radial_slices);
  const int nodes = stator.radial_slices == kAutoSlices ? kAutoNodes : given;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width;
  std::vector<TrackSlice> slices;
  for (const GaussRule::Node& node : gauss_rule(nodes).nodes) {
    const double radius = inner + node.place * stator.contact_width;
    slices.push_back({radius, node.weight * stator.contact_width,
                      stator.amplitude * (1 + shape_excess(m, radius)),
                      node.weight * motor.design().preload});
  }
  return slices;
}

// The unknowns of (V3.4): the loads of the slices, the speed, and the intensity that all have.
struct WornInState {
  std::vector<TrackSlice> slices;
  double speed, intensity;
};

struct WornInStep {
  std::vector<double> loads;
  double speed, intensity;
};

// Newton's step: dF_j = (dw - (w_j - w) - w_Omega dOmega) / w_F with sum of dF_j and sum of dT_j as they have to be.
WornInStep newton_step(const WornInState& at, const std::vector<SliceNumbers>& numbers,
                       double preload, const LoadPoint& load) {
  double inverse = 0, speed_share = 0, missing = preload;
  double torque_inverse = 0, torque_speed = 0, lacking = load.at;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const auto& [w, T] = numbers[j];
    const double off = (w.value - at.intensity) / w.by_load;
    inverse += 1 / w.by_load, speed_share += w.by_speed / w.by_load;
    missing += off - at.slices[j].load;
    torque_inverse += T.by_load / w.by_load;
    torque_speed += T.by_speed - T.by_load * w.by_speed / w.by_load;
    lacking += T.by_load * off - T.value;
  }
  WornInStep step{{}, 0, missing / inverse};
  if (load.argument == Argument::torque) {
    const double determinant = inverse * torque_speed + speed_share * torque_inverse;
    step.intensity = (missing * torque_speed + lacking * speed_share) / determinant;
    step.speed = (lacking * inverse - missing * torque_inverse) / determinant;
  }
  for (const auto& [w, T] : numbers)
    step.loads.push_back((step.intensity - (w.value - at.intensity) - w.by_speed * step.speed) /
                         w.by_load);
  return step;
}

// The largest part of a step that changes no load or speed by more than a half.
double allowed_part(const WornInState& at, const WornInStep& step) {
  double part = 1;
  const auto limit = [&](double by, double of) {
    if (std::fabs(by) > 0.5 * std::fabs(of)) part = std::fmin(part, 0.5 * std::fabs(of / by));
  };
  for (std::size_t j = 0; j < step.loads.size(); ++j) limit(step.loads[j], at.slices[j].load);
  if (at.speed != 0) limit(step.speed, at.speed);
  return part;
}

double size_of(const WornInState& at, const WornInStep& step) {
  double size = at.speed != 0 ? std::fabs(step.speed / at.speed) : 0;
  for (std::size_t j = 0; j < step.loads.size(); ++j)
    size = std::fmax(size, std::fabs(step.loads[j] / at.slices[j].load));
  return size;
}

std::optional<std::vector<SliceNumbers>> numbers_at(const MotorDesign& design,
                                                    const WornInState& at) {
  std::vector<SliceNumbers> numbers;
  for (const TrackSlice& slice : at.slices) {
    const auto found = numbers_of(design, slice, at.speed);
    if (!found || found->intensity.by_load == 0) return {};
    numbers.push_back(*found);
  }
  return numbers;
}

double torque_of(const std::vector<SliceNumbers>& numbers) {
  double sum = 0;
  for (const SliceNumbers& one : numbers) sum += one.torque.value;
  return sum;
}

WornIn answer_of(const MotorDesign& design, const WornInState& at,
                 const std::vector<SliceNumbers>& numbers) {
  const double r = design.stator.contact_radius, tilt = std::tan(design.rotor.taper);
  WornIn found{MetricStatus::ok, at.speed, torque_of(numbers), at.intensity, {}};
  double least = HUGE_VAL;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const TrackSlice& slice = at.slices[j];
    const Motor one(motor_of(design, slice));
    const double depth = one.contact().max_pressure * design.layer.thickness /
                         design.layer.youngs_modulus;  // (T3.1)
    const double worn =
        slice.amplitude - design.stator.amplitude - (slice.radius - r) * tilt - depth;
    least = std::fmin(least, worn);
    found.slices.push_back({slice.radius, slice.load, depth, worn});
  }
  for (WornInSlice& slice : found.slices) slice.worn -= least;
  return found;
}

// Newton's method from a state; nothing where it does not settle.
std::optional<WornInState> solved(const MotorDesign& design, WornInState at,
                                  const LoadPoint& load) {
  constexpr int kMostSteps = 40;
  constexpr double kSettled = 1e-12, kNearly = 1e-9;  // then rounding may keep steps from shrinking
  double last = HUGE_VAL;
  for (int i = 0; i < kMostSteps; ++i) {
    const auto numbers = numbers_at(design, at);
    if (!numbers) return {};
    const WornInStep step = newton_step(at, *numbers, design.preload, load);
    const double size = size_of(at, step);
    if (!std::isfinite(size)) return {};
    if (size <= kSettled || (size < kNearly && size >= last)) return at;
    const double part = allowed_part(at, step);
    for (std::size_t j = 0; j < at.slices.size(); ++j) at.slices[j].load += part * step.loads[j];
    at.speed += part * step.speed, at.intensity += part * step.intensity;
    last = size;
  }
  return {};
}

}  // namespace

WornIn worn_in(const MotorDesign& design, const LoadPoint& load) {
  const HeldTraps traps;
  const Motor motor(design);
  const auto speed = speed_under(motor, load);
  if (is_one_slice(design) || design.stator.voltage || design.stator.radial_motion || !speed)
    return {.status = MetricStatus::undefined};
  const auto found = solved(motor.design(), {material_slices(motor), *speed, 0}, load);
  const auto numbers = found ? numbers_at(motor.design(), *found) : std::nullopt;
  if (!numbers || !is_stable(*numbers)) return {.status = MetricStatus::not_converged};
  return answer_of(motor.design(), *found, *numbers);
}

}  // namespace twum::inline v0_1
