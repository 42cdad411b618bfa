// SPDX-License-Identifier: Apache-2.0
#include "oscillating/period_watch.hpp"

#include "watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

MotionEvent event_at(MotionEventKind kind, const MotionSample& s) {
  return {kind, s.time, s.speed, s.angle, s.amplitude};
}

}  // namespace

std::vector<MotionEvent> PeriodWatch::events(const MotionSample& before, const MotionSample& here) {
  std::vector<MotionEvent> found;
  watch_rest(here, found);
  watch_wave(before, here, found);
  return found;
}

void PeriodWatch::watch_rest(const MotionSample& here, std::vector<MotionEvent>& found) {
  if (here.held != held_) {
    held_ = here.held;
    found.push_back(event_at(held_ ? MotionEventKind::held : MotionEventKind::released, here));
    largest_ = held_ ? largest_ : here.larger_wave();
    side_ = 0;
  }
  // Slower than a thousandth of the crest of a wave that opens the contact it creeps, or rings on the layer.
  const double crest = model_->crest_per_amplitude * 2 * std::numbers::pi * here.frequency *
                       model_->full_contact_amplitude;
  if (held_ || std::abs(here.speed) < 1e-3 * crest) return;
  const double side = here.speed > 0 ? 1 : -1;
  if (side * side_ < 0) found.push_back(event_at(MotionEventKind::reversed, here));
  side_ = side;
}

void PeriodWatch::watch_wave(const MotionSample& before, const MotionSample& here,
                             std::vector<MotionEvent>& found) {
  const double started = kStarted * model_->full_contact_amplitude, wave = here.larger_wave();
  const double pulled_out = std::min(largest_ / 3, started);
  if (!here.off && before.larger_wave() < started && wave >= started)
    found.push_back(event_at(MotionEventKind::started, here));
  if (!here.off && largest_ > started && wave <= pulled_out) {
    found.push_back(event_at(MotionEventKind::pulled_out, here));
    largest_ = 0;
  }
  largest_ = std::max(largest_, wave);
  // Torque in the direction of the larger wave, while the rotor turns with it.
  const double forward = here.amplitude >= here.backward_amplitude ? 1 : -1;
  const double margin = kOverrunShare * model_->holding_torque, torque = forward * here.torque;
  const bool along = !held_ && forward * here.speed > 0;
  if (along && !overruns_ && torque < -margin) {
    found.push_back(event_at(MotionEventKind::overruns, here));
    overruns_ = true;
  }
  if (torque > 0) overruns_ = false;
}

}  // namespace twum::inline v0_1::motion
