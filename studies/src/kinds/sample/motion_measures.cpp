// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/motion_measures.hpp"

#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace twum::inline v0_1::studies {
namespace {

using Sample = motion::MotionSample;
using Samples = std::span<const Sample>;

// The sample at a time; none if the motion ended before it.
const Sample* sample_at(Samples samples, double time) {
  const auto found = std::ranges::lower_bound(samples, time, {}, &Sample::time);
  return found != samples.end() && found->time == time ? &*found : nullptr;
}

// The last sample before a time, or at it.
const Sample* last_until(Samples samples, double time) {
  const auto next = std::ranges::upper_bound(samples, time, {}, &Sample::time);
  return next == samples.begin() ? nullptr : &*(next - 1);
}

// When a number first reaches a level, linear between two samples.
double time_to(Samples samples, const MotionColumn& column, double level) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double here = column.of(samples[i]);
    const bool reached = level < 0 ? here <= level : here >= level;
    if (!reached) continue;
    if (i == 0) return samples[0].time;
    const double before = column.of(samples[i - 1]);
    const double share = here == before ? 1 : (level - before) / (here - before);
    return std::lerp(samples[i - 1].time, samples[i].time, share);
  }
  return kNoValue;
}

// When a number came to stay within a share of a level, linear between two samples; none if it is outside at the end.
double settling_time(Samples samples, const MotionColumn& column, double level, double share) {
  const auto outside = [&](const Sample& s) {
    return std::abs(column.of(s) - level) - share * std::abs(level);
  };
  if (!(outside(samples.back()) <= 0)) return kNoValue;
  for (std::size_t i = samples.size() - 1; i-- > 0;) {
    const double here = outside(samples[i]);
    if (!(here > 0)) continue;
    const double way = here / (here - outside(samples[i + 1]));
    return std::lerp(samples[i].time, samples[i + 1].time, way);
  }
  return samples.front().time;
}

// Between two samples only the speed's is known.
double largest(const motion::Motion& motion, const MotionColumn& column) {
  if (std::string_view(column.name) == "speed") return motion.fastest;
  double found = 0;
  for (const Sample& s : motion.samples)
    if (std::abs(column.of(s)) > std::abs(found)) found = column.of(s);
  return found;
}

// Of what is settled; 0 where it is less than the error of a motion.
double overshoot(double largest, double settled) {
  constexpr double kMotionError = 1e-6;  // docs/theory/motion.md, section 8
  const double ratio = largest / settled - 1;
  return std::abs(ratio) < kMotionError ? 0 : ratio;
}

double difference(const Sample* begin, const Sample* end, const MotionColumn& column) {
  return begin != nullptr && end != nullptr ? column.of(*end) - column.of(*begin) : kNoValue;
}

bool is_controlled(const MotionColumn& column, const MeasureBase& base) {
  if (!base.reference) return false;
  const bool speed = base.reference->kind == MotionControl::Kind::speed;
  return std::string_view(column.name) == (speed ? "speed" : "angle");
}

double number_of(const MotionMeasure& asked, const motion::Motion& motion,
                 const MeasureBase& base) {
  using Kind = MotionMeasure::Kind;
  const Samples samples = motion.samples;
  if (samples.empty()) return kNoValue;
  const MotionColumn* column = find_motion_column(asked.column);
  const Sample* last_on = last_until(samples, base.last_on);
  const Sample* last = &samples.back();
  const auto level = [&] {
    return is_controlled(*column, base) ? base.reference->value : column->of(*last_on);
  };
  switch (asked.kind) {
    case Kind::time_to:
      return time_to(samples, *column, asked.share ? *asked.share * level() : asked.at);
    case Kind::settling_time:
      return settling_time({samples.data(), last_on + 1}, *column, level(), *asked.share);
    case Kind::overshoot: return overshoot(largest(motion, *column), level());
    case Kind::peak: return largest(motion, *column);
    case Kind::angle_after:
      return difference(sample_at(samples, asked.at), last, *find_motion_column("angle"));
    case Kind::energy:
      return difference(sample_at(samples, asked.at), sample_at(samples, asked.to),
                        *find_motion_column("energy"));
    case Kind::time_of: {
      const auto event = std::ranges::find_if(motion.events, [&](const motion::MotionEvent& one) {
        return asked.column == to_string(one.kind);
      });
      return event == motion.events.end() ? kNoValue : event->time;
    }
  }
  return kNoValue;
}

std::string unit_of(const MotionMeasure& asked) {
  using Kind = MotionMeasure::Kind;
  switch (asked.kind) {
    case Kind::time_to:
    case Kind::settling_time:
    case Kind::time_of: return "s";
    case Kind::overshoot: return "1";
    case Kind::peak: return find_motion_column(asked.column)->unit;
    case Kind::angle_after: return "rad";
    case Kind::energy: return "J";
  }
  return "1";
}

}  // namespace

std::vector<double> times_of(const MotionMeasure& measure) {
  using Kind = MotionMeasure::Kind;
  if (measure.kind == Kind::angle_after) return {measure.at};
  if (measure.kind == Kind::energy) return {measure.at, measure.to};
  return {};
}

MotionResult::StepError step_error(Samples fine, Samples coarse) {
  MotionResult::StepError error{0, 0, 0};
  for (std::size_t i = 0; i < std::min(fine.size(), coarse.size()); ++i) {
    const Sample &a = fine[i], &b = coarse[i];
    error.speed = std::max(error.speed, std::abs(a.speed - b.speed));
    error.angle = std::max(error.angle, std::abs(a.angle - b.angle));
    error.amplitude = std::max({error.amplitude, std::abs(a.amplitude - b.amplitude),
                                std::abs(a.backward_amplitude - b.backward_amplitude)});
  }
  return error;
}

std::vector<MotionResult::Measure> measured(const std::vector<MotionMeasure>& asked,
                                            const motion::Motion& motion, const MeasureBase& base) {
  std::vector<MotionResult::Measure> found;
  for (const MotionMeasure& one : asked)
    found.push_back({one.text, unit_of(one), number_of(one, motion, base)});
  return found;
}

}  // namespace twum::inline v0_1::studies
