// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies::telling {
namespace {

using MovedMotor = MotionResult::Member;
using motion::MotionEvent;
using motion::MotionEventKind;
using motion::MotionSample;

// The sample at which the drive is switched off first, or the last one.
const MotionSample& settled(const MovedMotor& motor) {
  const auto& samples = motor.motion.samples;
  const auto off = std::ranges::find_if(samples, [](const MotionSample& s) { return s.off; });
  if (samples.empty()) return motor.motion.last;
  return off == samples.end() || off == samples.begin() ? samples.back() : *(off - 1);
}

std::optional<double> time_of(const MovedMotor& motor, MotionEventKind kind, double from) {
  for (const MotionEvent& event : motor.motion.events)
    if (event.kind == kind && event.time >= from) return event.time;
  return {};
}

// When the rotor first has a speed, of either sign: "after" a time, linear between samples, or "within" one where the samples before and
// after that are too far apart to tell.
std::optional<Phrase> time_to(const MovedMotor& motor, double speed) {
  constexpr double kFine =
      0.2;  // share of the time between two samples, of which a line leaves a part
  const auto& samples = motor.motion.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double before = std::abs(samples[i - 1].speed), here = std::abs(samples[i].speed);
    if (!(before < speed && here >= speed)) continue;
    const double begin = samples[i - 1].time, end = samples[i].time;
    if (end - begin > kFine * end) return Phrase{"within ", strong(time_part(end))};
    return Phrase{"after ",
                  strong(time_part(std::lerp(begin, end, (speed - before) / (here - before))))};
  }
  return {};
}

// The speed up to a sample: its mean over the last tenth of the time, how far it goes from there, and how much the mean has changed
// from the tenth before, in parts of it.
struct LastSpeed {
  double mean, swing, change;
};

LastSpeed last_speed(const MovedMotor& motor, const MotionSample& at) {
  const auto of_tenth = [&](double from, double to) {
    double sum = 0, low = HUGE_VAL, high = -HUGE_VAL;
    int count = 0;
    for (const MotionSample& s : motor.motion.samples)
      if (s.time >= from * at.time && s.time <= to * at.time)
        sum += s.speed, ++count, low = std::min(low, s.speed), high = std::max(high, s.speed);
    return count == 0 ? std::pair(at.speed, 0.0) : std::pair(sum / count, 0.5 * (high - low));
  };
  const auto [mean, swing] = of_tenth(0.9, 1);
  const double before = of_tenth(0.8, 0.9).first;
  return {mean, swing, mean == 0 ? 0 : (mean - before) / std::abs(mean)};
}

// A speed that no encoder resolves: a turn takes a week.
constexpr double kResting = 1e-5;  // [rad/s]
constexpr double kSettled = 0.02;  // share of the speed

bool runs(const MovedMotor& motor) {
  return settled(motor).larger_wave() > 3 * motor.opening_amplitude;
}

bool is_positioned(const MotionResult& answer) {
  return answer.reference && answer.reference->kind == MotionControl::Kind::position;
}

// "The motor", or "With load_inertia 0 kg.m^2 the motor".
Phrase subject(const MotionResult& answer, const MovedMotor& motor, const std::string& name) {
  if (!answer.family) return {"The " + name};
  Phrase phrase{"With "};
  append(phrase, family_phrase(answer.family, motor.value));
  append(phrase, {" the " + name});
  return phrase;
}

Phrase distance_phrase(double value, double reference, const std::string& unit) {
  constexpr double kSame = 1e-4;  // as numbers are shown
  if (std::abs(value - reference) <= kSame * std::abs(reference)) return {", its reference"};
  return {", ", value_part(std::abs(value - reference), unit, 2), " from its reference"};
}

Phrase position_sentence(const MotionResult& answer, const MovedMotor& motor) {
  const double angle = motor.motion.last.angle;
  Phrase phrase = subject(answer, motor, "rotor");
  append(phrase, {" ends at ", strong(value_part(angle, "rad"))});
  append(phrase, distance_phrase(angle, answer.reference->value, "rad"));
  append(phrase, {"."});
  return phrase;
}

Phrase running_sentence(const MotionResult& answer, const MovedMotor& motor) {
  const MotionSample& at = settled(motor);
  Phrase phrase = subject(answer, motor, "motor");
  append(phrase, {" "});
  if (!runs(motor)) {
    append(phrase, {bad("does not run"), ": after ", time_part(at.time), " its wave is ",
                    value_part(at.amplitude, "m", 3), " and its speed ",
                    value_part(at.speed, "rad/s", 3), "."});
    return phrase;
  }
  if (std::abs(at.speed) < kResting) {
    append(phrase, {bad("does not turn"), ": its wave is ", value_part(at.larger_wave(), "m", 3),
                    " after ", time_part(at.time), "."});
    return phrase;
  }
  const auto [mean, swing, change] = last_speed(motor, at);
  const bool settling = std::abs(change) > kSettled,
             ripples = !settling && swing > kSettled * std::abs(mean);
  const double speed = ripples ? mean : at.speed;
  append(phrase, {"turns at ", strong(value_part(speed, "rad/s")), ripples ? " on average" : ""});
  if (answer.reference) append(phrase, distance_phrase(speed, answer.reference->value, "rad/s"));
  if (settling) {
    append(phrase, {" after ", time_part(at.time), " and is still becoming ",
                    (change > 0) == (mean > 0) ? "faster." : "slower."});
    return phrase;
  }
  if (ripples)
    append(phrase, {", with a ripple of ", value_part(swing, "rad/s", 2), " to both sides"});
  const double level = answer.reference ? answer.reference->value : at.speed;
  if (const auto reached = time_to(motor, 0.9 * std::abs(level))) {
    append(phrase,
           {answer.reference ? "; it reaches 90 % of the reference " : "; it has 90 % of that "});
    append(phrase, *reached);
  }
  append(phrase, {"."});
  return phrase;
}

Phrase stopping_sentence(const MovedMotor& motor) {
  const auto stopped = time_of(motor, MotionEventKind::held, *motor.off_at);
  if (!stopped)
    return {"It still turns at ", value_part(motor.motion.last.speed, "rad/s", 3), ", ",
            time_part(motor.motion.end - *motor.off_at), " after the drive was switched off."};
  const auto off = std::ranges::find_if(motor.motion.events, [&](const MotionEvent& event) {
    return event.kind == MotionEventKind::switched_off && event.time == *motor.off_at;
  });
  Phrase phrase{"It stops ", strong(time_part(*stopped - *motor.off_at)),
                " after the drive is switched off"};
  if (off != motor.motion.events.end())
    append(phrase, {", ", value_part(motor.motion.last.angle - off->angle, "rad", 3), " further"});
  append(phrase, {"."});
  return phrase;
}

// The first motor that has no answer or does not run, or the first one.
const MovedMotor& told_motor(const MotionResult& answer) {
  const auto odd = std::ranges::find_if(answer.members, [&](const MovedMotor& motor) {
    return motor.motion.status != "ok" || (!is_positioned(answer) && !runs(motor));
  });
  return odd == answer.members.end() ? answer.members.front() : *odd;
}

}  // namespace

Headline headline_of(const MotionResult& answer, const StudyResult& /*result*/) {
  const MovedMotor& motor = told_motor(answer);
  std::vector<Phrase> sentences;
  const bool complete = motor.motion.status == "ok";
  if (!complete)
    sentences.push_back({"The motion ", bad("ends early"), ", after ", time_part(motor.motion.end),
                         ": " + reason_of(motor.motion.status) + "."});
  const bool moves = is_positioned(answer) || runs(motor);
  sentences.push_back(is_positioned(answer) ? position_sentence(answer, motor)
                                            : running_sentence(answer, motor));
  if (complete && motor.off_at && !is_positioned(answer) && runs(motor) &&
      std::abs(settled(motor).speed) >= kResting)
    sentences.push_back(stopping_sentence(motor));
  return {complete && moves ? Headline::Look::plain : Headline::Look::bad,
          "",
          sentences,
          {},
          {},
          "points",
          "without an answer"};
}

}  // namespace twum::inline v0_1::studies::telling
