// SPDX-License-Identifier: Apache-2.0
#include "curve/search.hpp"
#include "metrics/motor_parts.hpp"

#include <twum/core/motor.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace twum;
using namespace twum::core;

namespace {

constexpr double kStall = 0.8, kFree = 12;     // [N m], [rad/s]
constexpr double kIdle = 0.5, kPerTorque = 3;  // input of a point: [W], [W/(N m)]

// T = kStall (1 - Omega / kFree), input = kIdle + kPerTorque T, between two speeds.
class LineCurve final : public Curve {
 public:
  explicit LineCurve(const Motor& motor, double begin = 0,
                     double end = std::numeric_limits<double>::infinity())
      : Curve(MotorParts::model(motor), Waves::each_its_own, begin), end_(end) {}

  CurvePoint point(double speed, const WarmStart* /*guess*/, double /*accuracy*/) const override {
    CurvePoint p;
    p.speed = speed;
    if (speed < begin() || speed > end_) {
      p.status = speed < begin() ? MetricStatus::no_periodic_state : MetricStatus::unresolved;
      return p;
    }
    p.torque = torque(speed);
    p.input = kIdle + kPerTorque * p.torque;
    p.signature = 1;
    return p;
  }

  CurveSlope slope(double speed, const WarmStart* guess) const override {
    const CurvePoint p = point(speed, guess, 0);
    if (!p.ok()) throw SearchFailure{p.status};
    return {speed, {p.torque, -kStall / kFree}, {p.input, -kPerTorque * kStall / kFree}, {}};
  }

 private:
  static double torque(double speed) { return kStall * (1 - speed / kFree); }

  double end_;
};

// Its crest speed gives the scale: 15.9 rad/s, so that no-load lies inside.
Motor scale(double static_over_kinetic = 1) {
  MotorDesign design;
  design.layer.given_inertia = design.layer.given_shear_viscosity = 0;  // torque without ripples
  design.stator.modal_damping = 1;
  design.friction.threshold = static_over_kinetic * design.friction.kinetic;
  return Motor(design);
}

template <typename Search>
MetricStatus failure(Search search) {
  try {
    search();
    return MetricStatus::ok;
  } catch (const SearchFailure& f) {
    return f.status;
  }
}

// Roots and slopes are found to rounding, and the line is exact: a few units in the last place. A place where the
// slope vanishes is as exact as the slope is.
constexpr double kRounding = 1e-13;

bool near(double a, double b) { return std::fabs(a - b) <= kRounding * std::fabs(b); }

}  // namespace

TEST_CASE("the search finds what a straight curve has, with jumps looked for or not",
          "[core][metrics][closed_form]") {
  for (const double ratio : {1.0, 1.2}) {
    CAPTURE(ratio);
    const Motor motor = scale(ratio);
    const LineCurve curve(motor);
    CurveSearch search(curve);
    CHECK(search.stall_torque() == kStall);
    CHECK(near(search.no_load().speed, kFree));
    CHECK(search.plateau_end() == 0);
    CHECK(search.max_torque().value == kStall);
    CHECK(search.max_torque().kind == PeakKind::rest);
    CHECK(near(search.peak_power().speed, kFree / 2));
    CHECK(near(search.peak_power().value, kStall * kFree / 4));
    CHECK(near(search.speed_at(0.3 * kStall).speed, 0.7 * kFree));
    CHECK(failure([&] { search.speed_at(1.1 * kStall); }) == MetricStatus::unreachable);
    // y = T / kStall where y (1 - y) / (kIdle + b y) is largest
    const double b = kPerTorque * kStall;
    const double y = (std::sqrt(kIdle * kIdle + kIdle * b) - kIdle) / b;
    CHECK(near(search.max_efficiency().speed, kFree * (1 - y)));
    CHECK(near(search.max_efficiency().value, kStall * kFree * y * (1 - y) / (kIdle + b * y)));
  }
}

TEST_CASE(
    "a curve that begins above rest has no stall torque, and its beginning may be its best point",
    "[core][metrics][limit]") {
  for (const double ratio : {1.0, 1.2}) {
    CAPTURE(ratio);
    const Motor motor = scale(ratio);
    const double begin = 0.7 * kFree;  // beyond the largest power of the whole line
    const LineCurve curve(motor, begin);
    CurveSearch search(curve);
    CHECK(failure([&] { search.stall_torque(); }) == MetricStatus::no_periodic_state);
    CHECK(near(search.no_load().speed, kFree));
    CHECK(search.max_torque().speed == begin);
    CHECK(near(search.max_torque().value, 0.3 * kStall));
    CHECK(search.peak_power().speed == begin);
    CHECK(near(search.peak_power().value, 0.21 * kStall * kFree));
    // no derivative: where the curve begins moves with the motor
    CHECK(search.peak_power().kind == PeakKind::kink);
    CHECK(near(search.speed_at(0.1 * kStall).speed, 0.9 * kFree));
    CHECK(failure([&] { search.speed_at(0.4 * kStall); }) == MetricStatus::unreachable);
  }
}

TEST_CASE("a curve that ends before no-load says why", "[core][metrics][error]") {
  const Motor motor = scale();
  const LineCurve curve(motor, 0, 0.8 * kFree);
  CurveSearch search(curve);
  CHECK(search.stall_torque() == kStall);
  CHECK(failure([&] { search.no_load(); }) == MetricStatus::unresolved);
  CHECK(failure([&] { search.peak_power(); }) == MetricStatus::unresolved);
}
