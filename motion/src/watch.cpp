// SPDX-License-Identifier: Apache-2.0
#include "watch.hpp"

#include "zero_in_step.hpp"

#include <algorithm>

namespace twum::inline v0_1::motion {

double Watch::pull_out_amplitude() const {
  const double started = kStarted * equations_->model().full_contact_amplitude;
  return std::min(largest_ / 3, started);
}

bool Watch::looks_for(MotionEventKind kind) const {
  const double started = kStarted * equations_->model().full_contact_amplitude;
  switch (kind) {
    case MotionEventKind::started: return !equations_->stretch().off;
    case MotionEventKind::pulled_out: return !equations_->stretch().off && largest_ > started;
    default: return !equations_->mode().held && !overruns_;
  }
}

double Watch::distance(MotionEventKind kind, double time, const Integrator& integrator) const {
  const std::vector<double> y = integrator.at(time);
  const MotionModel& m = equations_->model();
  const double a = equations_->amplitude(time, y);
  if (kind == MotionEventKind::started) return kStarted * m.full_contact_amplitude - a;
  if (kind == MotionEventKind::pulled_out) return a - pull_out_amplitude();
  const Mode& mode = equations_->mode();
  const double torque = m.inertia * integrator.at(time, 1)[kSpeed] +
                        equations_->load(time, y[kAngle]) + m.load_damping * y[kSpeed] +
                        mode.side * m.load_friction;  // (M2.2)
  const double forward = equations_->stretch().direction;
  return mode.side == forward ? forward * torque + kOverrunShare * m.holding_torque
                              : m.holding_torque;
}

std::vector<MotionEvent> Watch::events(const Integrator& integrator, double begin) {
  const double end = integrator.time();
  std::vector<MotionEvent> found;
  for (const auto kind :
       {MotionEventKind::started, MotionEventKind::pulled_out, MotionEventKind::overruns}) {
    if (!looks_for(kind)) continue;
    const auto at = [&](double time) { return distance(kind, time, integrator); };
    if (!(at(begin) > 0 && at(end) <= 0)) continue;
    const double time = falls_through_zero(begin, end, at);
    const std::vector<double> y = integrator.at(time);
    found.push_back({kind, time, y[kSpeed], y[kAngle], equations_->amplitude(time, y)});
    if (kind == MotionEventKind::pulled_out) largest_ = 0;
    if (kind == MotionEventKind::overruns) overruns_ = true;
  }
  largest_ = std::max(largest_, equations_->amplitude(end, integrator.y()));
  // Looks again once the wave drives the rotor.
  if (overruns_ && distance(MotionEventKind::overruns, end, integrator) >
                       kOverrunShare * equations_->model().holding_torque)
    overruns_ = false;
  std::ranges::sort(found, {}, &MotionEvent::time);
  return found;
}

}  // namespace twum::inline v0_1::motion
