// SPDX-License-Identifier: Apache-2.0
#include "metrics/followed_wave.hpp"

#include "drive/running_wave.hpp"
#include "metrics/motor_curve.hpp"
#include "point/slice_count.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::inline v0_1::core {
namespace {

constexpr int kMostSteps = 8;
constexpr double kLongestStep =
    0.2;  // of amplitude and speed: a longer step may lead to another wave
constexpr double kSettled = 1e-12;  // likewise; what a step leaves is of the order of its square

// Slices of `auto` are those of a wave with the amplitude nearby.
DrivenWaves waves_near(const MotorDesign& design, double amplitude) {
  MotorDesign given = design;  // the amplitude may exceed the range of the parameter
  given.stator.voltage.reset();
  given.stator.amplitude = amplitude;
  return {design, track_rule(given)};
}

struct WaveStep {
  double amplitude, speed;  // relative

  double size() const { return std::max(std::fabs(amplitude), std::fabs(speed)); }
};

// Solves H + H_A dA + H_Omega dOmega = Theta u_0 and T + T_A dA + T_Omega dOmega = T_L; at a speed the first alone.
WaveStep newton_step(const DrivenWaves::LevelSlopes& s, double drive, const LoadWave& at,
                     const std::optional<double>& torque) {
  using contact::kInAmplitude, contact::kInSpeed;
  const double missing = drive - s.in_amplitude.wave.force();
  const double h_a = s.in_amplitude.force_slope(), h_s = s.force_per_speed;
  if (!torque) return {missing / h_a / at.amplitude, 0};
  const auto& t = s.numbers.torque;
  const double lacking = *torque - t.v;
  const double determinant = h_a * t.d[kInSpeed] - h_s * t.d[kInAmplitude];
  return {(missing * t.d[kInSpeed] - lacking * h_s) / determinant / at.amplitude,
          (lacking * h_a - missing * t.d[kInAmplitude]) / determinant / at.speed};
}

}  // namespace

bool follows_wave(const MotorDesign& design, const LoadPoint& load) {
  return design.stator.voltage && design.stator.branch == Branch::running &&
         (load.argument == Argument::torque || load.argument == Argument::speed);
}

std::unique_ptr<const FollowedCurve> FollowedCurve::at_speed(const DrivenWaves& waves,
                                                             double speed) {
  auto found = running_point(waves, speed);
  if (!found) return {};
  return std::unique_ptr<const FollowedCurve>(new FollowedCurve(*std::move(found), speed));
}

std::unique_ptr<const FollowedCurve> FollowedCurve::from(const MotorDesign& design,
                                                         const LoadPoint& load,
                                                         const LoadWave& near) {
  const DrivenWaves waves = waves_near(design, near.amplitude);
  const std::optional<double> torque =
      load.argument == Argument::torque ? std::optional(load.at) : std::nullopt;
  LoadWave wave = near;
  std::optional<WarmStart> start;
  double last = kLongestStep;
  for (int i = 0; i < kMostSteps; ++i) {
    DrivenWaves::LevelSlopes s =
        waves.slopes(wave.amplitude, wave.speed, start ? &*start : nullptr);
    if (s.solved.status != PointStatus::ok) return {};
    const WaveStep step = newton_step(s, waves.drive(), wave, torque);
    if (step.size() <= kSettled) {
      const bool stays = waves.stability(s.in_amplitude).stable();
      if (!stays || (torque && !(s.torque_per_speed < 0))) return {};
      return std::unique_ptr<const FollowedCurve>(
          new FollowedCurve({waves.motor(wave.amplitude), std::move(s.solved)}, wave.speed));
    }
    if (!(step.size() < last)) return {};
    last = step.size();
    wave.amplitude *= 1 + step.amplitude, wave.speed *= 1 + step.speed;
    start = s.solved.start();
  }
  return {};
}

CurvePoint FollowedCurve::point(double, const WarmStart*, double) const {
  throw SearchFailure{MetricStatus::unresolved};
}

CurveSlope FollowedCurve::slope(double, const WarmStart*) const {
  throw SearchFailure{MetricStatus::unresolved};
}

}  // namespace twum::inline v0_1::core
