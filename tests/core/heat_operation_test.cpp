// SPDX-License-Identifier: Apache-2.0
// Cycles of loads: peaks, means, on-times and duty limits.
#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/steady_heat.hpp>

#include "support/heat_motors.hpp"
#include "support/metric_requests.hpp"

#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

const std::vector<LoadPhase> kPhases{
    {heat_load(0.8), 120, {}}, {{}, 40, {}}, {{{Argument::both, 6, 0.3}}, 60, 100}, {{}, 90, {}}};

MotorDesign with_limits(MotorDesign design) {
  design.thermal->stator.temperature_limit = kZero + 45;
  design.thermal->housing.temperature_limit = kZero + 70;
  return design;
}

MotorDesign without_drift() {
  MotorDesign design = with_limits(warm_motor());
  design.thermal->drift = {};
  return design;
}

MotorDesign as_one_node(MotorDesign design) {
  design.thermal->rotor = design.thermal->housing = {};
  design.thermal->stator.heat_capacity.reset();
  design.thermal->conductances = {};
  design.thermal->one_node = OneNode{40, 0.5, 660};
  return design;
}

HeatLosses cold_losses(const MotorDesign& design, const LoadPhase& phase) {
  if (!phase.load) return {};
  MotorDesign now = design;
  if (phase.voltage) now.stator.voltage = phase.voltage;
  const auto at = [&](Metric metric) {
    const LoadPoint& load = *phase.load;
    return evaluate(Motor(now), {metric, load.argument, load.at, load.torque, {}}).value;
  };
  return {at(Metric::friction_power_at), at(Metric::layer_loss_at), at(Metric::stator_loss_at),
          at(Metric::dielectric_loss_at)};
}

// Central differences to the fourth order, with steps of a hundredth of the parameter: they leave some 1e-4 of the slope, and 1e-6
// of the value over the step, 1e-4 of the value over the parameter.
void check_by_differences(const MotorDesign& design, const MetricRequest& request,
                          std::initializer_list<Parameter> parameters, double tolerance) {
  const MetricDerivative exact = differentiate(Motor(design), request);
  REQUIRE(exact.value.status == MetricStatus::ok);
  REQUIRE(exact.smoothness == Smoothness::smooth);
  for (const Parameter p : parameters) {
    const double x = get(design, p), scale = info(p).absolute ? 20 : std::fabs(x);
    const double h = 1e-2 * scale;
    const auto at = [&](double by) {
      return evaluate(Motor(with(design, p, x + by)), request).value;
    };
    const double slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    CAPTURE(info(request.metric).name, info(p).name, slope, exact.gradient[index_of(p)]);
    const double unit = std::fabs(slope) + std::fabs(exact.value.value) * 0.1 / scale;
    CHECK(std::fabs(exact.gradient[index_of(p)] - slope) <= tolerance * unit);
  }
}

}  // namespace

TEST_CASE("without drift a cycle of loads is one of constant losses (H5.1, H5.2)",
          "[core][heat][identity]") {
  const MotorDesign design = without_drift();
  std::vector<HeatPhase> constant;
  for (const LoadPhase& phase : kPhases)
    constant.push_back({cold_losses(design, phase), phase.time});
  const HeatCycle expected = heat_cycle(heat_network(design), constant);
  const LoadCycle found = load_cycle(design, kPhases);
  REQUIRE(found.status == MetricStatus::ok);
  const double ambient = design.thermal->ambient;
  for (const Part part : {Part::stator, Part::rotor, Part::housing, Part::contact, Part::lining}) {
    CAPTURE(static_cast<int>(part));
    // Newton's method ends at 1e-6 K, of a cycle whose slowest mode keeps a part of it; the contact jumps where the load begins
    if (part != Part::contact && part != Part::lining)
      CHECK(std::fabs(at(found.states[0], part) - ambient - at(expected.start, part)) <= 1e-5);
    CHECK(std::fabs(at(found.peak, part) - ambient - at(expected.peak, part)) <= 1e-5);
    CHECK(std::fabs(at(found.mean, part) - ambient - at(expected.mean, part)) <= 1e-5);
  }
  for (std::size_t i = 0; i < kPhases.size(); ++i)
    CHECK(std::fabs(found.losses[i].sum() - constant[i].losses.sum()) <= 1e-9);
}

TEST_CASE("the mean over a cycle is the steady state of its mean losses (H5.2)",
          "[core][heat][identity]") {
  const MotorDesign design = with_limits(with_table(warm_motor()));
  const LoadCycle found = load_cycle(design, kPhases);
  REQUIRE(found.status == MetricStatus::ok);
  HeatLosses mean;
  double period = 0;
  for (std::size_t i = 0; i < kPhases.size(); ++i) {
    mean.friction += found.losses[i].friction * kPhases[i].time;
    mean.layer += found.losses[i].layer * kPhases[i].time;
    mean.stator += found.losses[i].stator * kPhases[i].time;
    mean.dielectric += found.losses[i].dielectric * kPhases[i].time;
    period += kPhases[i].time;
  }
  mean = {mean.friction / period, mean.layer / period, mean.stator / period,
          mean.dielectric / period};
  const PartTemperatures steady = steady_rises(heat_network(design), mean);
  CHECK(std::fabs(found.mean.stator - kZero - 20 - steady.stator) <= 1e-6);
  CHECK(std::fabs(found.mean.housing - kZero - 20 - steady.housing) <= 1e-6);
  CHECK(found.peak.stator > found.mean.stator);
}

TEST_CASE("peaks are metrics of the operation", "[core][heat]") {
  MotorDesign design = with_limits(with_table(warm_motor()));
  CHECK(evaluate(Motor(design), {Metric::stator_peak_temperature}).status ==
        MetricStatus::undefined);
  design.operation = kPhases;
  const LoadCycle cycle = load_cycle(design, kPhases);
  const auto value = [&](Metric metric) { return evaluate(Motor(design), {metric}).value; };
  CHECK(value(Metric::stator_peak_temperature) == cycle.peak.stator);
  CHECK(value(Metric::rotor_peak_temperature) == cycle.peak.rotor);
  CHECK(value(Metric::housing_peak_temperature) == cycle.peak.housing);
  CHECK(value(Metric::contact_peak_temperature) == cycle.peak.contact);
  // A phase that goes on for ever is the steady state, of the metrics of the warm motor too.
  design.operation = {{heat_load(0.5), 1e5, {}}};
  const auto steady = evaluate(Motor(design), metric_at_torque(Metric::stator_temperature_at, 0.5));
  CHECK(std::fabs(value(Metric::stator_peak_temperature) - steady.value) <= 1e-4);
  const MetricRequest mean{Metric::stall_torque, Argument::none, 0, 0,
                           LoadPoint{Argument::none, 0, 0}};
  const MetricRequest at{Metric::stall_torque, Argument::none, 0, 0, heat_load(0.5)};
  CHECK(std::fabs(evaluate(Motor(design), mean).value - evaluate(Motor(design), at).value) <=
        1e-6 * evaluate(Motor(design), at).value);
}

TEST_CASE("a node whose torque the motor does not carry has no network",
          "[core][heat][edge_case]") {
  MotorDesign design = as_one_node(without_drift());
  CHECK(motor_network(design).has_value());
  design.thermal->one_node->torque = 50;
  CHECK(!motor_network(design));
  const auto way = warm_up(design, heat_load(0.5), {0, 60});
  REQUIRE(way.size() == 1);
  CHECK(way.front().status == MetricStatus::unreachable);
}

TEST_CASE("the time to a limit is that of the warm-up (H4.2)", "[core][heat]") {
  const MetricRequest request = metric_at_torque(Metric::on_time_at, 0.5);
  SECTION("without drift") {
    const MotorDesign design = without_drift();
    const HeatLosses losses = cold_losses(design, {heat_load(0.5), 1, {}});
    const double expected = time_to_rise(heat_network(design), losses, Part::stator,
                                         kZero + 45 - design.thermal->ambient);
    // steps of 0.001 K of a rise of some 0.03 K/s
    CHECK(std::fabs(evaluate(Motor(design), request).value - expected) <= 1e-6 * expected);
  }
  SECTION("of one node, by its closed form") {
    MotorDesign design = as_one_node(without_drift());
    design.thermal->stator.temperature_limit = kZero + 45;
    const double expected = 660 * std::log(40.0 / (40.0 - 25.0));
    CHECK(std::fabs(evaluate(Motor(design), request).value - expected) <= 1e-6 * expected);
    design.thermal->stator.temperature_limit = kZero + 61;  // above the steady rise of 40 K
    CHECK(evaluate(Motor(design), request).status == MetricStatus::never_too_hot);
  }
  SECTION("with drift, in the warm-up beside it") {
    const MotorDesign design = with_limits(with_table(warm_motor()));
    const MetricValue time = evaluate(Motor(design), request);
    REQUIRE(time.status == MetricStatus::ok);
    const auto there = warm_up(design, heat_load(0.5), {time.value});
    CHECK(std::fabs(there.front().temperatures.stator - (kZero + 45)) <= 1e-3);
  }
  SECTION("without any limit it is not defined") {
    MotorDesign design = with_table(warm_motor());
    design.thermal->stator.temperature_limit.reset();
    design.thermal->rotor.temperature_limit.reset();
    design.thermal->housing.temperature_limit.reset();
    design.thermal->contact_temperature_limit.reset();
    CHECK(evaluate(Motor(design), request).status == MetricStatus::undefined);
  }
}

TEST_CASE("the duty limit just keeps the limits in its cycle (H5.3)", "[core][heat]") {
  const MetricRequest request = metric_at_torque(Metric::duty_limit_at, 0.5);
  SECTION("without drift") {
    MotorDesign design = without_drift();
    design.operation = {{heat_load(0.2), 90, {}}, {{}, 30, {}}};
    const HeatLosses on = cold_losses(design, {heat_load(0.5), 1, {}});
    std::array<std::optional<double>, kParts> limits{};
    limits[0] = kZero + 45 - design.thermal->ambient;
    limits[2] = kZero + 70 - design.thermal->ambient;
    const double expected = duty_limit(heat_network(design), on, {}, 120, limits);
    CHECK(std::fabs(evaluate(Motor(design), request).value - expected) <= 1e-6);
  }
  SECTION("of one node, by its closed form") {
    MotorDesign design = as_one_node(without_drift());
    design.thermal->stator.temperature_limit = kZero + 45;
    design.operation = {{{}, 300, {}}};
    const double share = evaluate(Motor(design), request).value;
    const double peak = 40 * std::expm1(-share * 300 / 660) / std::expm1(-300.0 / 660);
    CHECK(std::fabs(peak - 25) <= 1e-5);
  }
  SECTION("with drift, by the cycle beside it") {
    MotorDesign design = with_limits(with_table(warm_motor()));
    design.operation = {{{}, 120, {}}};
    const MetricValue share = evaluate(Motor(design), request);
    REQUIRE(share.status == MetricStatus::ok);
    REQUIRE(share.value < 1);
    const LoadCycle cycle = load_cycle(
        design, {{heat_load(0.5), share.value * 120, {}}, {{}, (1 - share.value) * 120, {}}});
    CHECK(std::fabs(cycle.peak.stator - (kZero + 45)) <= 1e-5);
  }
  SECTION("1 where the steady state keeps them") {
    MotorDesign design = with_table(warm_motor());
    design.thermal->stator.temperature_limit = kZero + 100;
    design.operation = {{{}, 120, {}}};
    CHECK(evaluate(Motor(design), request).value == 1);
  }
}

TEST_CASE("derivatives over an operation are those of differences (H6.4, H6.5)",
          "[core][heat][derivative][differential]") {
  const std::initializer_list<Parameter> all{Parameter::voltage,
                                             Parameter::preload,
                                             Parameter::thickness,
                                             Parameter::kinetic_friction,
                                             Parameter::modal_mass,
                                             Parameter::stator_heat_capacity,
                                             Parameter::rotor_heat_capacity,
                                             Parameter::conductance_lining,
                                             Parameter::conductance_housing_ambient,
                                             Parameter::conductance_stator_contact,
                                             Parameter::drift_resonance_frequency,
                                             Parameter::drift_kinetic_friction,
                                             Parameter::ambient_temperature};
  // what enters the losses, the network, and how the motor follows
  const std::initializer_list<Parameter> some{Parameter::voltage, Parameter::thickness,
                                              Parameter::stator_heat_capacity,
                                              Parameter::drift_resonance_frequency};
  MotorDesign design = with_limits(with_table(warm_motor()));
  SECTION("peaks") {
    design.operation = kPhases;
    check_by_differences(design, {Metric::stator_peak_temperature}, all, 1e-3);
    for (const Metric peak : {Metric::rotor_peak_temperature, Metric::housing_peak_temperature,
                              Metric::contact_peak_temperature})
      check_by_differences(design, {peak}, some, 1e-3);
  }
  SECTION("the warm motor at mean temperatures") {
    design.operation = kPhases;
    check_by_differences(
        design, {Metric::stall_torque, Argument::none, 0, 0, LoadPoint{Argument::none, 0, 0}}, some,
        1e-3);
  }
  SECTION("the time to a limit") {
    check_by_differences(design, metric_at_torque(Metric::on_time_at, 0.5), some, 1e-3);
  }
  SECTION("the duty limit") {
    design.operation = {{{}, 120, {}}};
    check_by_differences(design, metric_at_torque(Metric::duty_limit_at, 0.5), some, 1e-3);
  }
  SECTION("of one node") {
    design = as_one_node(design);
    design.thermal->stator.temperature_limit = kZero + 45;
    design.operation = kPhases;
    const std::initializer_list<Parameter> node{
        Parameter::voltage,         Parameter::preload,
        Parameter::one_node_rise,   Parameter::one_node_time_constant,
        Parameter::one_node_torque, Parameter::drift_resonance_frequency};
    check_by_differences(design, {Metric::stator_peak_temperature}, node, 1e-3);
    check_by_differences(design, metric_at_torque(Metric::on_time_at, 0.5), node, 1e-3);
  }
}

TEST_CASE("losses and the heat that leaves are equal in a steady state alone (H3.4)",
          "[core][heat][identity]") {
  const MotorDesign design = with_table(warm_motor());
  const double steady = steady_heat(design, heat_load(0.5)).temperatures.stator;
  const auto found = heat_balance(design, heat_load(0.5), {steady - 5, steady, steady + 5});
  for (const HeatBalance& one : found) REQUIRE(one.status == MetricStatus::ok);
  CHECK(found[0].losses > found[0].leaving);  // stable: it warms below
  CHECK(std::fabs(found[1].losses - found[1].leaving) <= 1e-6 * found[1].losses);
  CHECK(found[2].losses < found[2].leaving);
}

TEST_CASE("the course of a cycle passes its states", "[core][heat]") {
  const MotorDesign design = with_table(warm_motor());
  const LoadCycle found = load_cycle(design, kPhases, {0, 60, 120, 160, 310});
  REQUIRE(found.course.size() == 5);
  const auto near = [](const PartTemperatures& a, const PartTemperatures& b) {
    return std::fabs(a.stator - b.stator) + std::fabs(a.rotor - b.rotor) +
           std::fabs(a.housing - b.housing);
  };
  CHECK(near(found.course[0].temperatures, found.states[0]) <= 1e-9);
  CHECK(near(found.course[2].temperatures, found.states[1]) <= 1e-9);
  CHECK(near(found.course[3].temperatures, found.states[2]) <= 1e-9);
  CHECK(near(found.course[4].temperatures, found.states[4]) <= 1e-9);
  CHECK(found.course[1].temperatures.stator > found.states[0].stator);
  CHECK(found.course[1].temperatures.stator < found.states[1].stator);
}

namespace {

MetricRequest after(Metric metric, double torque, double time) {
  MetricRequest request = metric_at_torque(metric, torque);
  request.after = time;
  return request;
}

}  // namespace

TEST_CASE("a temperature after a time is that of the warm-up (H4.1, H4.3)", "[core][heat]") {
  const auto value = [](const MotorDesign& design, const MetricRequest& request) {
    const MetricValue found = evaluate(Motor(design), request);
    REQUIRE(found.status == MetricStatus::ok);
    return found.value;
  };
  SECTION("without drift, by the modes of the network") {
    const MotorDesign design = without_drift();
    const HeatLosses losses = cold_losses(design, {heat_load(0.5), 1, {}});
    for (const double time : {1e-3, 30.0, 512.0, 700.0, 1e4}) {
      const PartTemperatures rises = rises_after(heat_network(design), {}, losses, time);
      CAPTURE(time);
      // Steps are exact where losses stay; those at temperatures a little apart agree to 1e-9 of 15 W and 4 K/W.
      CHECK(std::fabs(value(design, after(Metric::stator_temperature_at, 0.5, time)) -
                      design.thermal->ambient - rises.stator) <= 1e-6);
      CHECK(std::fabs(value(design, after(Metric::housing_temperature_at, 0.5, time)) -
                      design.thermal->ambient - rises.housing) <= 1e-6);
      CHECK(std::fabs(value(design, after(Metric::contact_temperature_at, 0.5, time)) -
                      design.thermal->ambient - rises.contact) <= 1e-6);
    }
  }
  SECTION("of one node, by its closed form") {
    const MotorDesign design = as_one_node(without_drift());
    for (const double time : {1.0, 660.0, 5000.0})
      CHECK(std::fabs(value(design, after(Metric::stator_temperature_at, 0.5, time)) -
                      design.thermal->ambient + 40 * std::expm1(-time / 660)) <= 1e-6);
  }
  SECTION("at the beginning ambient, at the end steady") {
    const MotorDesign design = with_table(warm_motor());
    for (const Metric metric : {Metric::stator_temperature_at, Metric::rotor_temperature_at,
                                Metric::housing_temperature_at}) {
      CHECK(value(design, after(metric, 0.5, 0)) == Approx(design.thermal->ambient).epsilon(1e-14));
      const double steady = value(design, metric_at_torque(metric, 0.5));
      // Twenty slow time constants of 600 s and the error of all steps, 1e-5 K each, that the network forgets.
      CHECK(std::fabs(value(design, after(metric, 0.5, 12000)) - steady) <= 1e-3);
      CHECK(value(design, after(metric, 0.5, HUGE_VAL)) == steady);
      CHECK(std::fabs(value(design, after(metric, 0.5, 1e9)) - steady) <= 1e-3);
    }
    CHECK(evaluate(Motor(design), after(Metric::stator_temperature_at, 0.5, -1)).status ==
          MetricStatus::out_of_range);
    CHECK(evaluate(Motor(design), after(Metric::stator_temperature_at, 50, 10)).status ==
          MetricStatus::unreachable);
  }
  SECTION("up to where the load is lost") {
    // 0.82 N.m is lost after 1,140 s, by an integration of another program.
    const MotorDesign design = fading_motor();
    CHECK(value(design, after(Metric::stator_temperature_at, 0.82, 1100)) >
          value(design, after(Metric::stator_temperature_at, 0.82, 1000)));
    CHECK(evaluate(Motor(design), after(Metric::stator_temperature_at, 0.82, 1200)).status !=
          MetricStatus::ok);
  }
}

TEST_CASE("derivatives of a temperature after a time do not depend on what else is asked (H6.4)",
          "[core][heat][derivative][differential]") {
  const MotorDesign design = with_table(warm_motor());
  const std::initializer_list<Parameter> some{Parameter::voltage,
                                              Parameter::thickness,
                                              Parameter::kinetic_friction,
                                              Parameter::stator_heat_capacity,
                                              Parameter::conductance_housing_ambient,
                                              Parameter::conductance_stator_housing,
                                              Parameter::drift_resonance_frequency,
                                              Parameter::ambient_temperature};
  for (const double time : {20.0, 300.0, 3000.0})
    check_by_differences(design, after(Metric::stator_temperature_at, 0.5, time), some, 1e-3);
  check_by_differences(design, after(Metric::contact_temperature_at, 0.5, 100), some, 1e-3);
  check_by_differences(design, after(Metric::rotor_temperature_at, 0.5, 100), some, 1e-3);
  const std::vector<MetricRequest> together{after(Metric::housing_temperature_at, 0.5, 900),
                                            after(Metric::stator_temperature_at, 0.5, 30),
                                            after(Metric::stator_temperature_at, 0.5, 700)};
  const Motor motor(design);
  const auto all = differentiate(motor, together);
  for (std::size_t i = 0; i < together.size(); ++i) {
    const MetricDerivative alone = differentiate(motor, together[i]);
    CHECK(all[i].value.value == alone.value.value);
    CHECK(all[i].gradient == alone.gradient);
  }
}
