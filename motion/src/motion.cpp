// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/motion.hpp>

#include "motion_run.hpp"
#include "oscillating/oscillating_run.hpp"

#include <twum/core/parameters.hpp>

namespace twum::inline v0_1::motion {

const char* to_string(MotionEventKind kind) noexcept {
  switch (kind) {
    case MotionEventKind::held: return "held";
    case MotionEventKind::released: return "released";
    case MotionEventKind::reversed: return "reversed";
    case MotionEventKind::started: return "started";
    case MotionEventKind::pulled_out: return "pulled-out";
    case MotionEventKind::overruns: return "overruns";
    case MotionEventKind::switched_off: return "switched-off";
    case MotionEventKind::switched_on: return "switched-on";
    case MotionEventKind::swapped: return "swapped";
    case MotionEventKind::squeals: return "squeals";
    case MotionEventKind::bounces: return "bounces";
    case MotionEventKind::too_fast: return "motion-too-fast";
  }
  return "held";
}

MotionTask steady_drive(const MotorDesign& design, double duration) {
  MotionTask task{.duration = duration};
  if (design.stator.voltage)
    task.voltage = *design.stator.voltage;
  else
    task.amplitude = design.stator.amplitude;
  task.frequency = drive_frequency(design);
  return task;
}

std::unique_ptr<Engine> engine_of(const MotorDesign& design, const MotionTask& task) {
  if (task.engine == MotionEngine::oscillating)
    return std::make_unique<OscillatingRun>(design, task);
  return std::make_unique<MotionRun>(design, task);
}

void begin(Engine& engine, const MotionTask& task, const std::vector<Stretch>& stretches) {
  engine.begin(task.initial.steady ? before_the_first(task) : stretches.front());
}

Motion followed(Engine& engine, const MotionTask& task, const std::vector<Stretch>& stretches) {
  begin(engine, task, stretches);
  for (const Stretch& stretch : stretches)
    if (!engine.follow(stretch)) break;
  return engine.finish();
}

void require_motion(const MotorDesign& design, const MotionTask& task) {
  const std::vector<Stretch> stretches = stretches_of(task, design.stator.voltage.has_value());
  begin(*engine_of(design, task), task, stretches);
}

Motion simulate(const MotorDesign& design, const MotionTask& task) {
  const std::vector<Stretch> stretches = stretches_of(task, design.stator.voltage.has_value());
  return followed(*engine_of(design, task), task, stretches);
}

const char* to_string(AxialMotion value) noexcept {
  switch (value) {
    case AxialMotion::balanced: return "static";
    case AxialMotion::dynamic: return "dynamic";
  }
  return "unknown";
}

const char* to_string(MotionEngine value) noexcept {
  switch (value) {
    case MotionEngine::averaged: return "averaged";
    case MotionEngine::oscillating: return "oscillating";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::motion
