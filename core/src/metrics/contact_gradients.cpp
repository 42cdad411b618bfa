// SPDX-License-Identifier: Apache-2.0
#include <twum/core/contact_gradients.hpp>

#include "design/held_traps.hpp"
#include "design/layer_properties.hpp"
#include "metrics/direction_slopes.hpp"
#include "model/mapped_motor.hpp"
#include "model/motor_model.hpp"
#include "point/point_derivatives.hpp"
#include "point/slice_count.hpp"

#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>

namespace twum::inline v0_1 {

using namespace core;

struct ContactDifferentiator::Parts {
  MotorDesign design;
  TrackRule track;
  std::vector<DirectionSlope> slopes;

  ContactGradients::Number number(const ModelDual& dual) const {
    constexpr auto kAmplitude = static_cast<int>(model_index(Parameter::amplitude));
    return {dual.v, dual.d[kAmplitude], dual.d[kSpeedDirection], in_parameters(dual, slopes)};
  }
};

ContactDifferentiator::ContactDifferentiator(const MotorDesign& design,
                                             bool fixed_static_friction) {
  const HeldTraps held;
  if (design.stator.radial_slices == kAutoSlices)
    throw InputError("radial_slices must be a number for derivatives of a contact, but is 'auto'");
  const Motor possible(design);
  parts_ = std::make_shared<const Parts>(
      Parts{design, track_rule(design), direction_slopes(design, fixed_static_friction)});
}

ContactGradients ContactDifferentiator::at(double amplitude, double speed) const {
  const HeldTraps held;
  const ModelDual A =
      ModelDual::variable(amplitude, static_cast<int>(model_index(Parameter::amplitude)));
  const DrivenMotor<ModelDual> moving =
      differentiated_motor(parts_->design, amplitude, parts_->track);
  const DrivenMotor<double> motor = mapped<double>(moving, [](const ModelDual& x) { return x.v; });
  ContactGradients found;
  const SolvedPoint point = solve_point(motor, speed);
  found.status = point.status;
  if (point.status != PointStatus::ok) return found;
  const PointNumbers<ModelDual> n = point.differentiated(moving, speed_variable<ModelDual>(speed));
  for (const Slice<double>& s : motor.slices()) {
    const double bed = 2 * s.radius * s.width * motor.youngs / thickness_at(motor, s.radius);
    found.normal_per_amplitude += bed * s.shape * s.edge.sin;
    found.normal_per_height -= bed * s.contact.half_angle;
  }
  found.torque = parts_->number(n.torque);
  found.reactive_force = parts_->number(n.reactive_force);
  found.active_force = parts_->number(n.stator_power / (moving.omega * A));  // (D1.2)
  return found;
}

}  // namespace twum::inline v0_1
