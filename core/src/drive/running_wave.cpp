// SPDX-License-Identifier: Apache-2.0
#include "drive/running_wave.hpp"

#include "drive/force_line.hpp"

namespace twum::inline v0_1::core {
namespace {

// Whatever piece of the curve it is on, if that begins above rest.
bool may_run(const CurveNode& wave) { return wave.stable() && wave.behind; }

bool drives(const CurveNode& wave) { return wave.solved.numbers.torque > 0; }

// A piece that begins at rest has the name of its wave there. Where that of the largest wave is dead, the curve is followed down
// from a wave at a speed: it runs if its piece begins at a fold.
bool begins_above_rest(const DrivenWaves& waves, const CurveNode& wave, double speed) {
  const double unit = waves.crest_speed_per_amplitude() * wave.amplitude;
  const WaveCurve curve(ForcePlane::of_speed(waves, unit),
                        {{-HUGE_VAL, 0}, {HUGE_VAL, speed / unit}}, kRules.speed);
  const auto start = curve.solve_at({wave.at.x, speed / unit}, &wave.start);
  const auto turned = [](const Vector<CurveNode>& down) {
    return down.back().fold || (down.size() > 1 && down.end()[-2].fold);
  };
  return start && turned(curve.follow(*start, false, turned));
}

}  // namespace

std::optional<MotorPoint> running_point(const DrivenWaves& waves, double speed) {
  if (!(speed >= 0) || waves.has_static_excess()) return {};
  const auto wave = ForceLine::largest_held(waves, speed);
  if (!wave || !may_run(*wave) || !drives(*wave) || wave->rise < kRules.doubtful) return {};
  const auto at_rest = ForceLine::largest_held(waves, 0);
  const bool is_met_at_rest = at_rest && may_run(*at_rest);
  if (!is_met_at_rest && !begins_above_rest(waves, *wave, speed)) return {};
  MotorPoint point{waves.motor(wave->amplitude), {}};
  point.solved = solve_point(point.motor, speed, &wave->start);
  return point.solved.status == PointStatus::ok ? std::optional(std::move(point)) : std::nullopt;
}

}  // namespace twum::inline v0_1::core
