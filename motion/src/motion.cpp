// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/motion.hpp>

#include "motion_run.hpp"

#include <twum/core/parameters.hpp>

namespace twum::motion {

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

Motion simulate(const MotorDesign& design, const MotionTask& task) {
  return MotionRun(design, task).run();
}

}  // namespace twum::motion
