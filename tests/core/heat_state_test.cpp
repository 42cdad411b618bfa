// SPDX-License-Identifier: Apache-2.0
// Temperatures of a motor whose parameters follow them. The reference tables are those of a second program with a contact, a
// driven stator and a fixed-point iteration of its own.
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/steady_heat.hpp>

#include "support/csv_rows.hpp"
#include "support/driven_motors.hpp"
#include "support/heat_motors.hpp"

#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

// Below the resonance, which comes towards the drive as the stator warms.
MotorDesign motor_below_resonance(double resonance) {
  MotorDesign design = warm_motor();
  design.thermal->drift.resonance_frequency = -2.2e-4;
  design.stator.voltage = 300;
  design.stator.resonance_frequency = resonance;
  return design;
}

MotorDesign motor_of(const CsvRow& row) {
  MotorDesign design = warm_motor();
  std::istringstream text(row.word("coefficients"));
  for (std::string one; text >> one;) {
    const std::size_t equals = one.find('=');
    design = with(design, *find_parameter("drift_" + one.substr(0, equals)),
                  std::stod(one.substr(equals + 1)));
  }
  if (row.word("tracking") == "1") design.stator.frequency_ratio = 40.8e3 / 39e3;
  if (!row.word("sets").empty()) {
    design.stator.voltage = 300;
    design.stator.resonance_frequency = 41.9e3;
  }
  design.thermal->ambient = kZero + row["ambient_C"];
  design.thermal->reference = kZero + row["T_ref_C"];
  return design;
}

}  // namespace

TEST_CASE("steady temperatures with drift are a second program's (H3.1, H3.2, H3.3)",
          "[core][heat][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/fixed_points.csv")) {
    CAPTURE(++rows, row.word("case"));
    const MotorDesign design = motor_of(row);
    const LoadPoint at = heat_load(row["load_Nm"]);
    if (row.word("status") == "no-steady-temperature") {
      CHECK(steady_heat(design, at).status == MetricStatus::no_steady_temperature);
      continue;
    }
    const bool unstable = row.word("status") == "unstable";
    const SteadyHeat heat =
        unstable ? steady_heat_near(design, at, kZero + row["T_s"]) : steady_heat(design, at);
    CHECK(heat.status == (unstable ? MetricStatus::thermally_unstable : MetricStatus::ok));
    // Temperatures of the other program are settled to 1e-9 K, times 1 / (1 - gain); its operating points are good to 1e-9.
    CHECK(std::fabs(heat.temperatures.stator - kZero - row["T_s"]) <= 1e-6);
    CHECK(std::fabs(heat.temperatures.rotor - kZero - row["T_r"]) <= 1e-6);
    CHECK(std::fabs(heat.temperatures.housing - kZero - row["T_h"]) <= 1e-6);
    CHECK(std::fabs(heat.temperatures.contact - kZero - row["T_c"]) <= 1e-6);
    CHECK(std::fabs(heat.temperatures.lining - kZero - row["T_l"]) <= 1e-6);
    for (const auto& [found, name] :
         {std::pair{heat.losses.friction, "P_fric"}, std::pair{heat.losses.layer, "P_layer"},
          std::pair{heat.losses.stator, "P_stator"}, std::pair{heat.losses.dielectric, "P_diel"}})
      CHECK(part_off(found, row[name]) <= 1e-7);
    // derivatives by differences in the other program
    CHECK(std::fabs(heat.gain - row["loop_gain"]) <= 1e-6);
    CHECK(part_off(heat.time_constant, row["tau_slow_s"]) <= 1e-6);
    if (unstable) continue;
    const MetricRequest speed{Metric::speed_at, Argument::torque, at.at, 0, at},
        power{Metric::electrical_power_at, Argument::torque, at.at, 0, at};
    const auto warm = evaluate(Motor(design), std::vector{speed, power});
    CHECK(part_off(warm[0].value, row["speed_rad_s"]) <= 1e-7);
    CHECK(part_off(warm[1].value, row["P_el"]) <= 1e-7);
  }
  CHECK(rows == 6);
}

TEST_CASE("without drift the losses are those of the cold motor (H3.1)", "[core][heat][limit]") {
  const MotorDesign design = warm_motor();
  const Motor motor(design);
  const double speed = evaluate(motor, metric_at_torque(Metric::speed_at, 0.5)).value;
  const OperatingPoint p = motor.operating_point(speed);
  const HeatLosses cold{p.friction_power, p.layer_loss, p.stator_loss, p.dielectric_loss};
  const SteadyHeat heat = steady_heat(design, heat_load(0.5));
  const PartTemperatures rises = steady_rises(heat_network(design), cold);
  CHECK(std::fabs(heat.temperatures.stator - kZero - 20 - rises.stator) <= 1e-9);
  CHECK(std::fabs(heat.temperatures.lining - kZero - 20 - rises.lining) <= 1e-9);
  CHECK(heat.gain == 0);
  CHECK(part_off(heat.time_constant, time_constants(heat_network(design)).back()) <= 1e-9);
}

TEST_CASE("the heat to the ambient and the output are the electrical power (H1.4)",
          "[core][heat][identity]") {
  const MotorDesign design = with_table(warm_motor());
  const SteadyHeat heat = steady_heat(design, heat_load(0.5));
  const HeatNetwork n = usual_network();
  const double T = kZero + 20, away = n.stator_ambient * (heat.temperatures.stator - T) +
                                      n.rotor_ambient * (heat.temperatures.rotor - T) +
                                      n.housing_ambient * (heat.temperatures.housing - T);
  const auto warm = evaluate(
      Motor(design), std::vector<MetricRequest>{
                         {Metric::electrical_power_at, Argument::torque, 0.5, 0, heat_load(0.5)},
                         {Metric::output_power_at, Argument::torque, 0.5, 0, heat_load(0.5)}});
  // powers balance to 1e-10 of their scale, some 50 W; the state is settled to 1e-11 K
  CHECK(std::fabs(warm[0].value - warm[1].value - away) <= 1e-8);
}

TEST_CASE("the warm-up ends at the steady state (H4.3)", "[core][heat][differential]") {
  const MotorDesign design = with_table(warm_motor());
  const SteadyHeat steady = steady_heat(design, heat_load(0.5));
  const auto points = warm_up(design, heat_load(0.5), {0, 60, 600, 20000});
  REQUIRE(points.size() == 4);
  CHECK(std::fabs(points[0].temperatures.stator - kZero - 20) <= 1e-12);
  // 35 slow time constants leave nothing; steps of 1e-3 K have settled
  CHECK(std::fabs(points[3].temperatures.stator - steady.temperatures.stator) <= 1e-4);
  CHECK(std::fabs(points[3].temperatures.contact - steady.temperatures.contact) <= 1e-4);
  CHECK(points[2].temperatures.stator < steady.temperatures.stator);
  CHECK(points[2].temperatures.stator > points[1].temperatures.stator);
}

TEST_CASE("from cold a motor comes to the first steady state, and beyond a fold to none (H3.3)",
          "[core][heat][property]") {
  // Above the resonance at ambient there is one state. Below it there are three at 41.9 kHz: the cold motor stops at the first.
  const MotorDesign below = motor_below_resonance(41.9e3);
  const SteadyHeat first = steady_heat(below, heat_load(0.3));
  const SteadyHeat last = steady_heat_near(below, heat_load(0.3), kZero + 250);
  REQUIRE(first.status == MetricStatus::ok);
  REQUIRE(last.status == MetricStatus::ok);
  CHECK(first.temperatures.stator < kZero + 60);
  CHECK(last.temperatures.stator > kZero + 240);
  // a march in time finds the same
  const auto points = warm_up(below, heat_load(0.3), {20000});
  CHECK(std::fabs(points.back().temperatures.stator - first.temperatures.stator) <= 1e-3);
  // Nearer to the resonance the first state is gone, and the motor burns at the last.
  CHECK(steady_heat(motor_below_resonance(41.6e3), heat_load(0.3)).temperatures.stator >
        kZero + 200);

  const MotorDesign fading = fading_motor();
  CHECK(steady_heat(fading, heat_load(0.77)).status == MetricStatus::ok);
  CHECK(steady_heat_near(fading, heat_load(0.77), kZero + 84).status ==
        MetricStatus::thermally_unstable);
  double last_time = HUGE_VAL;
  for (const double torque : {0.778, 0.82, 0.9}) {
    CAPTURE(torque);
    const SteadyHeat lost = steady_heat(fading, heat_load(torque));
    CHECK(lost.status == MetricStatus::no_steady_temperature);
    CHECK(lost.lost_after > 100);
    CHECK(lost.lost_after < last_time);  // the farther beyond the fold, the sooner
    last_time = lost.lost_after;
    // the motor in time loses the load then, not before
    const auto before = warm_up(fading, heat_load(torque), {0.98 * lost.lost_after});
    CHECK(before.back().status == MetricStatus::ok);
    const auto after = warm_up(fading, heat_load(torque), {1.02 * lost.lost_after});
    CHECK(after.back().status == MetricStatus::no_steady_temperature);
  }
}

TEST_CASE("a cycle with drift is a second program's (H4.3, H5.1)", "[core][heat][differential]") {
  const CsvRow row = csv_rows("heat/coupled_duty.csv").front();
  const MotorDesign design = with_table(warm_motor());
  const LoadCycle cycle =
      load_cycle(design, {{heat_load(row["load_Nm"]), row["t_on_s"]}, {{}, row["t_off_s"]}});
  REQUIRE(cycle.status == MetricStatus::ok);
  REQUIRE(cycle.states.size() == 3);
  const auto check = [&](const PartTemperatures& t, const std::string& what) {
    CHECK(std::fabs(t.stator - kZero - 20 - row[what + "_s"]) <= row["tolerance_K"]);
    CHECK(std::fabs(t.rotor - kZero - 20 - row[what + "_r"]) <= row["tolerance_K"]);
    CHECK(std::fabs(t.housing - kZero - 20 - row[what + "_h"]) <= row["tolerance_K"]);
  };
  check(cycle.states[0], "start_rise");
  check(cycle.states[1], "end_of_on");
  check(cycle.states[2], "start_rise");
}

TEST_CASE("what cannot be had says why (H3.2)", "[core][heat][errors]") {
  MotorDesign hot = with_table(warm_motor());
  hot.thermal->stator.temperature_limit = kZero + 30;
  CHECK(evaluate(Motor(hot), {Metric::continuous_torque}).status ==
        MetricStatus::too_hot_at_no_load);
  MotorDesign soft = warm_motor();
  soft.thermal->drift.youngs_modulus = -0.05;  // a tenth is left after 18 K
  CHECK(steady_heat(soft, heat_load(0.5)).status == MetricStatus::temperature_out_of_range);
  CHECK(
      evaluate(Motor(warm_motor()), metric_at_torque(Metric::temperature_margin_at, 0.5)).status ==
      MetricStatus::undefined);  // no limit
  CHECK(evaluate(Motor(driven_motor()), metric_at_torque(Metric::stator_temperature_at, 0.5))
            .status == MetricStatus::undefined);  // no thermal block
  CHECK(evaluate(Motor(warm_motor()), metric_at_torque(Metric::stator_temperature_at, 5)).status ==
        MetricStatus::unreachable);
  CHECK_THROWS_AS(steady_heat(driven_motor(), heat_load(0.5)), InputError);
  CHECK_THROWS_AS(load_cycle(warm_motor(), {}), InputError);
}
