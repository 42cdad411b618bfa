// SPDX-License-Identifier: Apache-2.0
// Cycles of loads with losses that follow the temperatures.
#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "metrics/heat_course.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/core/steady_heat.hpp>

namespace twum::inline v0_1 {

using namespace core;

namespace {

HeatLosses mean_of(const std::vector<HeatState>& states, double time) {
  const Sources<double>& heat = states.back().heat;
  return {heat[0] / time, heat[1] / time, heat[2] / time, heat[3] / time};
}

CyclePoint point_of(const HeatCourse& course, const HeatCourse::Lap& lap, double time) {
  const HeatCourse::Moment at = course.at(lap, time);
  const Sources<double>& p = at.state.p;
  return {
      time, parts_of(course.phases()[at.phase].solver.parts(at.state)), {p[0], p[1], p[2], p[3]}};
}

LoadCycle cycle_of(const HeatCourse& course, const std::vector<double>& times) {
  const HeatCourse::Lap lap = course.periodic();
  LoadCycle cycle;
  for (std::size_t i = 0; i < lap.size(); ++i) {
    cycle.states.push_back(parts_of(course.phases()[i].solver.parts(lap[i].front())));
    cycle.losses.push_back(mean_of(lap[i], course.phases()[i].time));
  }
  cycle.states.push_back(parts_of(course.phases().back().solver.parts(lap.back().back())));
  PartValues<double> peak;
  for (std::size_t part = 0; part < kParts; ++part)
    peak[part] = course.temperature(course.peak(lap, part), part);
  cycle.peak = parts_of(peak);
  cycle.mean = parts_of(course.mean(lap));
  for (const double time : times) cycle.course.push_back(point_of(course, lap, time));
  return cycle;
}

}  // namespace

LoadCycle load_cycle(const MotorDesign& design, const std::vector<LoadPhase>& phases,
                     const std::vector<double>& times) try {
  const HeldTraps traps;
  require_motor(design);
  if (!design.thermal) throw InputError("the motor needs 'thermal' for its temperatures");
  if (phases.empty()) throw InputError("a cycle needs at least one phase");
  for (const LoadPhase& phase : phases)
    if (!(phase.time > 0)) throw InputError("a phase of a cycle needs a time of more than 0 s");
  MotorDesign kept = design;
  keep_plate(kept);
  return cycle_of(HeatCourse(kept, phases), times);
} catch (const SearchFailure& failure) {
  LoadCycle none;
  none.status = failure.status;
  return none;
}

}  // namespace twum::inline v0_1
