// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <span>
#include <vector>

// Motors at which a search once took a wrong turn; all but one are under a voltage.
namespace {

using namespace twum;
using namespace twum::test;

using Values = std::vector<ParameterValue>;

MotorDesign motor_with(const Values& values) {
  return with(driven_motor_with_layer(), std::span<const ParameterValue>(values));
}

double value(const MotorDesign& design, Metric metric) {
  const MetricValue found = evaluate(Motor(design), {metric});
  CAPTURE(static_cast<int>(found.status));
  CHECK(found.status == MetricStatus::ok);
  return found.value;
}

}  // namespace

TEST_CASE("a branch that ends at a fold does not go on as another wave", "[core][driven][limit]") {
  using P = Parameter;
  const MotorDesign motor = motor_with(
      {{P::loss_factor, 0.2}, {P::density, 0}, {P::quality_factor, 153}, {P::loss_tangent, 0.01}});
  const auto no_load = [&](double voltage) {
    const MotorDesign design = with(motor, P::voltage, voltage);
    CHECK(evaluate(Motor(design), {Metric::stall_torque}).status == MetricStatus::pulled_out);
    return value(design, Metric::no_load_speed);
  };
  // Beyond the fold the extrapolated amplitude came within 2 % of the dead wave's at voltages from 30.32106 to 30.32118 V. A
  // smooth function is a straight line over 0.1 mV but for 1e-9 of itself.
  const double low = no_load(30.3210), high = no_load(30.3213);
  for (const double voltage : {30.32107, 30.32112, 30.321178, 30.32120}) {
    CAPTURE(voltage);
    const double between = low + (high - low) * (voltage - 30.3210) / 0.0003;
    CHECK(no_load(voltage) == Approx(between).epsilon(1e-8));
  }
}

TEST_CASE("folds closer than two samples of the force are found", "[core][driven][reference]") {
  using P = Parameter;
  const MotorDesign motor = motor_with({{P::frequency, 40217.87877519329},
                                        {P::voltage, 56.69924953866218},
                                        {P::modal_mass, 0.04248607169417348},
                                        {P::quality_factor, 94.42905501130046},
                                        {P::force_factor, 0.246198076911357},
                                        {P::thickness, 0.00102424027677033},
                                        {P::youngs_modulus, 1355767445.6937985},
                                        {P::density, 5189.238613801288},
                                        {P::loss_factor, 2},
                                        {P::kinetic_friction, 0.5269308144346365},
                                        {P::static_friction, 0.5269308144346365},
                                        {P::preload, 251.52218690548852}});
  // By another program's scan of H over the amplitude, which states five digits.
  CHECK(value(motor, Metric::start_voltage) == Approx(405.66).margin(0.006));
  CHECK(value(motor, Metric::hold_voltage) == Approx(405.28).margin(0.006));
}

TEST_CASE("a start voltage at a kink of the force has the derivative of the kink (D3.5)",
          "[core][driven][derivative]") {
  using P = Parameter;
  const MotorDesign motor = motor_with({{P::frequency, 41156.616685625384},
                                        {P::voltage, 184.77782482502835},
                                        {P::modal_mass, 0.018449717831559936},
                                        {P::quality_factor, 118.87300442156256},
                                        {P::force_factor, 0.41061770675957066},
                                        {P::thickness, 0.0005627357128412013},
                                        {P::youngs_modulus, 572998494.8021063},
                                        {P::loss_factor, 0.05},
                                        {P::kinetic_friction, 0.20106589117740717},
                                        {P::static_friction, 0.20106589117740717},
                                        {P::preload, 106.37415849896057}});
  // The formula for an extremum (D3.3) missed the differences by up to 60 %.
  const GradientCheck check =
      against_differences(motor, {{Metric::start_voltage}, {Metric::hold_voltage}}, 5e-6);
  CAPTURE(check.where);
  CHECK(check.compared > 20);
  CHECK(check.worst <= 5e-6);
}

TEST_CASE("a track of nearly rigid undamped contacts has few slices", "[core][annulus][limit]") {
  using P = Parameter;
  MotorDesign design = ring_motor();
  design.layer = {};
  design.layer.poisson_ratio = 0.3;
  const Values values{{P::wavelengths, 30},
                      {P::contact_radius, 0.0501306},
                      {P::contact_width, 0.00204313},
                      {P::neutral_plane_distance, 0.00584068},
                      {P::frequency, 26766.7},
                      {P::amplitude, 9.9105e-7},
                      {P::thickness, 1.37813e-5},
                      {P::youngs_modulus, 4.6069e11},
                      {P::density, 1411.7},
                      {P::loss_factor, 0},
                      {P::shape_exponent, 1},
                      {P::shape_root, 0.0160399},
                      {P::radial_slices, kAutoSlices},
                      {P::preload, 7.7206e6}};
  design = with(design, std::span<const ParameterValue>(values));
  // Each slice follows tens of thousands of zones; hundreds of them would take a quarter of an hour.
  CHECK(Motor(design).radial_slices() == -8);  // what `auto` chose
}
