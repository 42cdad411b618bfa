// SPDX-License-Identifier: Apache-2.0
// Derivatives of what follows from the motor's temperatures, and searches for them.
#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/steady_heat.hpp>

#include "support/csv_rows.hpp"
#include "support/heat_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/plate_motors.hpp"

#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

// Every heat metric at a load, and some of the warm motor.
std::vector<MetricRequest> heat_requests(const LoadPoint& at) {
  std::vector<MetricRequest> list;
  for (const Metric m :
       {Metric::stator_temperature_at, Metric::rotor_temperature_at, Metric::housing_temperature_at,
        Metric::contact_temperature_at, Metric::temperature_margin_at})
    list.push_back({m, at.argument, at.at, at.torque});
  for (const Metric m : {Metric::electrical_power_at, Metric::friction_power_at,
                         Metric::amplitude_at, Metric::output_power_at})
    list.push_back({m, at.argument, at.at, at.torque, at});
  list.push_back({Metric::stall_torque, Argument::none, 0, 0, at});
  list.push_back({Metric::thermal_time_constant});
  return list;
}

// Exact derivatives beside Richardson's differences of solutions, in all parameters in use that are not zero or whole. With steps of
// 3e-4 they leave 1e-12 of the fifth derivative and 1e-12 / 3e-4 of the rounding errors of the solutions: 1e-8.
void check_derivatives(const MotorDesign& design, const std::vector<MetricRequest>& requests,
                       double tolerance) {
  const auto exact = differentiate(Motor(design), requests);
  int compared = 0;
  for (const ParameterInfo& row : parameter_table()) {
    const double x = get(design, row.parameter);
    if (row.integer || row.parameter == Parameter::static_friction ||
        !in_use(design, row.parameter) || x == 0)
      continue;
    // An absolute temperature moves by kelvins.
    const double scale = row.absolute ? 20 : std::fabs(x), step = 3e-4 * scale;
    const auto at = [&](double by) {
      return values_of(with(design, row.parameter, x + by), requests);
    };
    const auto p1 = at(step), m1 = at(-step), p2 = at(2 * step), m2 = at(-2 * step);
    for (std::size_t k = 0; k < requests.size(); ++k) {
      CAPTURE(row.name, info(requests[k].metric).name, requests[k].warm_at.has_value());
      REQUIRE(exact[k].value.status == MetricStatus::ok);
      REQUIRE(exact[k].smoothness == Smoothness::smooth);
      const double one = (p1[k] - m1[k]) / (2 * step), two = (p2[k] - m2[k]) / (4 * step);
      const double slope = (4 * one - two) / 3;
      const double unit = (std::fabs(exact[k].value.value) + std::fabs(slope * scale)) / scale;
      CHECK(std::fabs(exact[k].gradient[index_of(row.parameter)] - slope) <= tolerance * unit);
      ++compared;
    }
  }
  CHECK(compared > 200);
}

}  // namespace

TEST_CASE("derivatives of temperatures are those of solving again in a second program (H6.1)",
          "[core][heat][derivative][differential]") {
  const MotorDesign design = with_table(warm_motor());
  const std::vector<MetricRequest> asked{metric_at_torque(Metric::stator_temperature_at, 0.5),
                                         metric_at_torque(Metric::contact_temperature_at, 0.5)};
  const auto found = differentiate(Motor(design), asked);
  const std::map<std::string, std::size_t> metric{{"T_s [K]", 0}, {"T_c [K]", 1}};
  const std::map<std::string, Parameter> parameter{
      {"voltage [V]", Parameter::voltage},
      {"preload [N]", Parameter::preload},
      {"housing_ambient [W/K]", Parameter::conductance_housing_ambient}};
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/derivatives.csv")) {
    if (row.word("quantity") == "slow eigenvalue [1/s]") {
      const double slowest = -1 / steady_heat(design, heat_load(0.5)).time_constant;
      CHECK(std::fabs(slowest - row["value"]) <= row["tolerance"]);
      ++rows;
    }
    if (!metric.contains(row.word("quantity"))) continue;
    CAPTURE(row.word("quantity"), row.word("by"));
    const Parameter by = parameter.at(row.word("by"));
    CHECK(std::fabs(found[metric.at(row.word("quantity"))].gradient[index_of(by)] - row["value"]) <=
          row["tolerance"]);
    ++rows;
  }
  CHECK(rows == 6);
}

TEST_CASE("every derivative of a warm motor is that of differences (H6.1)",
          "[core][heat][derivative][differential]") {
  MotorDesign design = with_table(warm_motor());
  design.thermal->stator.temperature_limit = kZero + 80;
  design.thermal->housing.temperature_limit = kZero + 70;
  design.thermal->contact_temperature_limit = kZero + 120;
  SECTION("at a torque") { check_derivatives(design, heat_requests(heat_load(0.5)), 1e-7); }
  SECTION("at a speed") { check_derivatives(design, heat_requests({Argument::speed, 9}), 1e-7); }
  SECTION("where the drive holds a torque at a speed") {
    check_derivatives(design, heat_requests({Argument::both, 9, 0.4}), 1e-7);
  }
  SECTION("with the lining by its material, the reference at ambient and a drive that tracks") {
    design.thermal->conductances.lining.reset();
    design.layer.conductivity = 0.25;
    design.thermal->reference.reset();
    design.stator.frequency_ratio = 1.046;
    design.thermal->housing.temperature_limit = kZero + 90;  // the stator's is the nearest limit
    // by the ratio itself, of which 3e-4 is a tenth of the way to the resonance, 1e-6
    check_derivatives(design, heat_requests(heat_load(0.5)), 1e-6);
  }
  SECTION("with a network that follows from the stator") {
    MotorDesign plate = with_table(warm_plate_motor());
    plate.thermal->housing.temperature_limit = kZero + 300;
    // A plate is solved to 1e-12 of its frequency, of which 3e-4 is a tenth of the way to the resonance.
    check_derivatives(plate, heat_requests(heat_load(0.3)), 1e-5);
  }
  SECTION("with moduli given outright") {
    design.layer.given_shear_modulus = 0.33e9;
    design.layer.given_shear_viscosity = 60;
    design.thermal->drift.shear_viscosity = -2e-3;
    check_derivatives(design, heat_requests(heat_load(0.5)), 1e-7);
  }
}

TEST_CASE("static friction fades with the kinetic one, whichever derivative is asked (H3.1, H6.1)",
          "[core][heat][derivative][differential]") {
  MotorDesign design = with_table(warm_motor());
  design.friction.threshold = 1.1 * design.friction.kinetic;
  const std::vector<MetricRequest> asked{{Metric::contact_temperature_at, Argument::speed, 9}};
  const auto value = [&](double kinetic, double threshold) {
    MotorDesign moved = design;
    moved.friction = {kinetic, threshold};
    return values_of(moved, asked)[0];
  };
  const double mu = design.friction.kinetic, mu0 = design.friction.threshold, h = 1e-4 * mu;
  const double together = (value(mu + h, 1.1 * (mu + h)) - value(mu - h, 1.1 * (mu - h))) / (2 * h),
               alone = (value(mu + h, mu0) - value(mu - h, mu0)) / (2 * h),
               threshold = (value(mu, mu0 + h) - value(mu, mu0 - h)) / (2 * h);
  const auto in_ratio = differentiate(Motor(design), asked, false)[0].gradient,
             fixed = differentiate(Motor(design), asked, true)[0].gradient;
  constexpr std::size_t kKinetic = index_of(Parameter::kinetic_friction),
                        kStatic = index_of(Parameter::static_friction);
  // The differences leave h^2 of the third derivative, 1e-8, and rounding errors of 1e-10 / h, 1e-5.
  const double tolerance = 1e-4 * std::fabs(together);
  CHECK(std::fabs(in_ratio[kKinetic] - together) <= tolerance);
  CHECK(std::fabs(fixed[kKinetic] - alone) <= tolerance);
  CHECK(std::fabs(fixed[kStatic] - threshold) <= tolerance);
  CHECK(std::fabs(in_ratio[kStatic] - threshold) <= tolerance);
}

TEST_CASE("one node has the derivatives of differences (H1.10, H6.1)",
          "[core][heat][derivative][differential]") {
  MotorDesign design = with_table(warm_motor());
  const ThermalDrift drift = design.thermal->drift;
  design.thermal = Thermal{};
  design.thermal->drift = drift;
  design.thermal->ambient = kZero + 30;
  design.thermal->reference = kZero + 20;
  design.thermal->one_node = OneNode{40, 0.4, 660};
  design.thermal->housing.temperature_limit = kZero + 90;
  check_derivatives(design, heat_requests(heat_load(0.5)), 1e-7);
}

TEST_CASE("a stator by its geometry drifts as its plate's numbers (H3.1)",
          "[core][heat][derivative][differential]") {
  MotorDesign design = with_heat(plate_motor());
  ThermalDrift& a = design.thermal->drift;
  a.resonance_frequency = -2e-4, a.force_factor = 5e-4, a.blocked_capacitance = 4e-3;
  // The same motor with the plate's numbers as modal data, and one slice of the track, which has no shape.
  MotorDesign plain = design;
  plain.stator.radial_slices = design.stator.radial_slices = 1;
  plain.stator.geometry.reset();
  std::vector<ParameterValue> numbers;
  for (const Parameter p :
       {Parameter::resonance_frequency, Parameter::modal_mass, Parameter::force_factor,
        Parameter::blocked_capacitance, Parameter::neutral_plane_distance})
    numbers.emplace_back(p, get(design, p));
  plain = with(plain, numbers);
  const double torque = 0.3 * evaluate(Motor(design), {Metric::max_torque}).value;
  const std::vector<MetricRequest> asked{metric_at_torque(Metric::stator_temperature_at, torque)};
  const auto of_plate = differentiate(Motor(design), asked).front(),
             of_modes = differentiate(Motor(plain), asked).front();
  REQUIRE(of_plate.value.status == MetricStatus::ok);
  CHECK(part_off(of_plate.value.value, of_modes.value.value) <= 1e-10);
  for (const Parameter p :
       {Parameter::voltage, Parameter::preload, Parameter::drift_resonance_frequency,
        Parameter::drift_force_factor, Parameter::conductance_stator_housing}) {
    CAPTURE(info(p).name);
    CHECK(part_off(of_plate.gradient[index_of(p)], of_modes.gradient[index_of(p)]) <= 1e-7);
  }
  // By a dimension of the plate, which all its numbers follow.
  const Parameter p = Parameter::substrate_thickness;
  const double x = get(design, p);
  const double step = 1e-5 * x;
  const double slope = (values_of(with(design, p, x + step), asked)[0] -
                        values_of(with(design, p, x - step), asked)[0]) /
                       (2 * step);
  CHECK(part_off(of_plate.gradient[index_of(p)], slope) <= 1e-5);  // the difference's bend
}

TEST_CASE("the continuous torque keeps the limit, and moves with it (H6.1, H6.2)",
          "[core][heat][property]") {
  MotorDesign design = with_table(warm_motor());
  design.thermal->stator.temperature_limit = kZero + 65;
  const Motor motor(design);
  for (const MetricRequest& asked :
       {MetricRequest{Metric::continuous_torque},
        MetricRequest{Metric::continuous_torque_at, Argument::speed, 8.0}}) {
    CAPTURE(info(asked.metric).name);
    const MetricDerivative found = differentiate(motor, asked);
    REQUIRE(found.value.status == MetricStatus::ok);
    const double torque = found.value.value;
    const MetricRequest temperature =
        asked.argument == Argument::none
            ? metric_at_torque(Metric::stator_temperature_at, torque)
            : MetricRequest{Metric::stator_temperature_at, Argument::both, asked.at, torque};
    CHECK(std::fabs(evaluate(motor, temperature).value - kZero - 65) <= 1e-7);
    for (const Parameter p :
         {Parameter::voltage, Parameter::stator_temperature_limit,
          Parameter::conductance_housing_ambient, Parameter::ambient_temperature}) {
      CAPTURE(info(p).name);
      const double x = get(design, p), h = info(p).absolute ? 0.05 : 1e-3 * x;
      const double low = evaluate(Motor(with(design, p, x - h)), asked).value,
                   high = evaluate(Motor(with(design, p, x + h)), asked).value;
      const double slope = (high - low) / (2 * h);
      // the difference leaves h^2 / 6 of the third derivative, some 1e-6 of the slope
      CHECK(std::fabs(found.gradient[index_of(p)] - slope) <= 2e-5 * std::fabs(slope));
    }
  }
}

TEST_CASE("below its start temperature a motor needs more voltage than it has (H3.1)",
          "[core][heat][property]") {
  MotorDesign design = warm_motor();
  design.thermal->drift.resonance_frequency = -2.2e-4;
  const MetricDerivative found = differentiate(Motor(design), {Metric::start_temperature});
  REQUIRE(found.value.status == MetricStatus::ok);
  // by hand: the motor with the resonance of that temperature needs just its voltage to start
  MotorDesign there = driven_motor_with_layer();
  there.stator.quality_factor = 153;
  there.stator.resonance_frequency = 39e3 * (1 - 2.2e-4 * (found.value.value - kZero - 20));
  CHECK(part_off(evaluate(Motor(there), {Metric::start_voltage}).value, 120) <= 1e-9);
  for (const Parameter p :
       {Parameter::voltage, Parameter::frequency, Parameter::reference_temperature,
        Parameter::drift_resonance_frequency}) {
    CAPTURE(info(p).name);
    const double x = get(design, p), h = info(p).absolute ? 0.1 : 1e-5 * std::fabs(x);
    const double low = evaluate(Motor(with(design, p, x - h)), {Metric::start_temperature}).value,
                 high = evaluate(Motor(with(design, p, x + h)), {Metric::start_temperature}).value;
    const double slope = (high - low) / (2 * h);
    CHECK(std::fabs(found.gradient[index_of(p)] - slope) <= 1e-4 * std::fabs(slope));
  }
}

TEST_CASE("where friction fades the continuous torque ends at a fold (H6.3)",
          "[core][heat][derivative][property]") {
  const MotorDesign design = fading_motor();
  const MetricDerivative found =
      differentiate(Motor(design), MetricRequest{Metric::continuous_torque});
  REQUIRE(found.value.status == MetricStatus::ok);
  const double torque = found.value.value;
  CHECK(steady_heat(design, heat_load((1 - 1e-5) * torque)).status == MetricStatus::ok);
  CHECK(steady_heat(design, heat_load((1 + 1e-5) * torque)).status ==
        MetricStatus::no_steady_temperature);
  for (const Parameter p : {Parameter::preload, Parameter::voltage, Parameter::ambient_temperature,
                            Parameter::conductance_housing_ambient}) {
    CAPTURE(info(p).name);
    const double x = get(design, p), h = info(p).absolute ? 0.1 : 1e-3 * x;
    const std::vector<MetricRequest> asked{{Metric::continuous_torque}};
    const double slope = (values_of(with(design, p, x + h), asked)[0] -
                          values_of(with(design, p, x - h), asked)[0]) /
                         (2 * h);
    // 1e-4 of the fold's own accuracy, and the bend of the difference
    CHECK(std::fabs(found.gradient[index_of(p)] - slope) <= 5e-4 * std::fabs(slope));
  }
}
