// SPDX-License-Identifier: Apache-2.0
// The life of a motor, for programs.
#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "metrics/wear_course.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/life.hpp>
#include <twum/core/plate.hpp>

#include <cmath>
#include <limits>

namespace twum::inline v0_1 {

using namespace core;

namespace {

MotorDesign wearing(const MotorDesign& design) {
  require_motor(design);
  if (!design.wear) throw InputError("the motor needs 'wear' for its life");
  MotorDesign kept = design;
  keep_plate(kept);
  return kept;
}

Life life_under(const MotorDesign& design, const std::optional<LoadPoint>& load) try {
  const HeldTraps traps;
  const MotorDesign kept = wearing(design);
  return WearCourse(kept, load).life();
} catch (const SearchFailure& failure) {
  Life none;
  none.status = failure.status;
  return none;
}

void require_operation(const MotorDesign& design) {
  if (design.operation.empty()) throw InputError("the motor needs 'operation' for its life");
}

}  // namespace

const char* to_string(EndOfLife end) noexcept {
  switch (end) {
    case EndOfLife::none: return "none";
    case EndOfLife::depth_limit: return "depth-limit";
    case EndOfLife::limit: return "limit";
    case EndOfLife::preload_gone: return "spring-relaxed";
    case EndOfLife::worn_through: return "worn-through";
    case EndOfLife::load_lost: return "load-lost";
  }
  return "";
}

double margin_of(const WearLimit& limit, const MetricValue& found) {
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  if (is_endless(found.status)) return std::isinf(limit.upper) ? kNoEnd : -kNoEnd;
  if (found.status != MetricStatus::ok) return kNoValue;
  return std::fmin(found.value - limit.lower, limit.upper - found.value);
}

Life life(const MotorDesign& design, const LoadPoint& load) { return life_under(design, load); }

Life life(const MotorDesign& design) {
  require_operation(design);
  return life_under(design, {});
}

std::vector<WearPoint> wear_course(const MotorDesign& design, const std::optional<LoadPoint>& load,
                                   const std::vector<double>& depths) {
  const HeldTraps traps;
  if (!load) require_operation(design);
  const MotorDesign kept = wearing(design);
  return WearCourse(kept, load).points(depths);
}

MotorDesign worn_motor(const MotorDesign& design, double depth) {
  wearing(design);
  if (!(depth >= 0) || !(depth < hard_end(design).depth))
    throw InputError("a depth beyond the lining or the preload");
  return worn_design(design, depth);
}

}  // namespace twum::inline v0_1
