// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/wear_profile.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

constexpr int kRadii = 33;
constexpr int kPhases = 2000;

std::optional<double> speed_under(const Motor& motor, const LoadPoint& load) {
  if (load.argument == Argument::speed) return load.at;
  if (load.argument != Argument::torque) return {};
  const MetricValue found = evaluate(motor, {Metric::speed_at, Argument::torque, load.at});
  return found.status == MetricStatus::ok ? std::optional(found.value) : std::nullopt;
}

// Mean over the wave of the friction power per area.
double friction_power(const ContactFields& fields) {
  double sum = 0;
  for (const FieldSample& s : fields.samples)
    sum += std::fabs(s.traction * (s.layer_velocity - s.stator_velocity));
  return sum / static_cast<double>(fields.samples.size());
}

}  // namespace

std::vector<LifeResult::AtRadius> wear_profile(const MotorDesign& design, const LoadPoint& load) {
  std::vector<LifeResult::AtRadius> profile;
  const Motor motor(design);
  const auto speed = speed_under(motor, load);
  if (motor.radial_slices() == 1 || !speed) return profile;
  const Wear& wear = *design.wear;
  const double k = wear.specific_wear.value_or(0) + wear.stator_specific_wear;
  const double middle = design.stator.contact_radius, width = design.stator.contact_width;
  for (int i = 0; i < kRadii; ++i) {
    const double radius = middle + width * (i / (kRadii - 1.0) - 0.5);
    const ContactFields fields = motor.fields(*speed, kPhases, radius);
    if (fields.point.status != PointStatus::ok) return {};
    profile.push_back({radius, k / design.friction.kinetic * friction_power(fields)});
  }
  return profile;
}

}  // namespace twum::inline v0_1::studies
