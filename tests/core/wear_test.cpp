// SPDX-License-Identifier: Apache-2.0
// Even wear: rates, lives, ends, and their derivatives, beside a second program's tables and closed forms.
#include <catch2/catch.hpp>

#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/worn_in.hpp>

#include "support/csv_rows.hpp"
#include "support/heat_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/test_motors.hpp"
#include "support/wearing_motors.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;

namespace {

constexpr double kHour = 3600;

}  // namespace

TEST_CASE("the rate is that of Archard's law with the friction power (V1.1, V2.1)",
          "[core][wear][identity]") {
  const MotorDesign design = wearing(driven_with_slices(1));
  const auto value = [&](Metric metric) {
    return evaluate(Motor(design), metric_at_torque(metric, 0.5)).value;
  };
  const double area =
      2 * std::numbers::pi * design.stator.contact_radius * design.stator.contact_width;
  const double expected =
      1e-6 * kWearUnit / design.friction.kinetic * value(Metric::friction_power_at) / area;
  // the same quotient in another order: a few roundings
  CHECK(std::fabs(value(Metric::wear_rate_at) - expected) <= 1e-14 * expected);
}

TEST_CASE("lives of a driven motor are those of a second program (V2.3)",
          "[core][wear][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/life_even_driven.csv")) {
    const std::string point = row.word("point");
    if (point.find("N.m") == std::string::npos) continue;
    const double torque = std::stod(point);
    const MotorDesign design = wearing(driven_with_slices(static_cast<int>(row["radial_slices"])),
                                       row["spring_N_per_m"], row["k_mm3_per_Nm"]);
    CAPTURE(row["radial_slices"], torque, row["spring_N_per_m"]);
    const Life found = life(design, torque_load(torque));
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(found.end == EndOfLife::depth_limit);
    const double rate =
        evaluate(Motor(design), metric_at_torque(Metric::wear_rate_at, torque)).value;
    CHECK(std::fabs(rate * kHour * 1e6 / row["rate0_um_per_h"] - 1) <= 1e-6);
    CHECK(std::fabs(found.seconds / kHour / row["hours_to_100um"] - 1) <= 1e-6);
    CHECK(std::fabs(found.revolutions / row["revolutions_to_100um"] - 1) <= 1e-6);
    ++rows;
  }
  CHECK(rows >= 3);
}

TEST_CASE("depths over time at a speed are those of a second program (V2.2, V2.3)",
          "[core][wear][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/wear_flat.csv")) {
    if (row.word("motor") != "elastic-layer radial_slices=1" || row.word("load") != "{'Om': 3.0}")
      continue;
    MotorDesign design = wearing(elastic(ring_motor()), row["spring_N_per_m"], 0);
    // s chi of 0: the stator wears; of 1: the lining
    (row["s_times_chi"] == 0 ? design.wear->stator_specific_wear : *design.wear->specific_wear) =
        row["k_mm3_per_Nm"] * kWearUnit;
    const double depth = row["depth_um"] * 1e-6;
    std::vector<double> depths;
    for (int i = 0; i <= 20; ++i) depths.push_back(depth * i / 20);
    const WearPoint end = wear_course(design, LoadPoint{Argument::speed, 3, 0}, depths).back();
    CAPTURE(row["spring_N_per_m"], row["hours"]);
    CHECK(std::fabs(end.seconds / kHour / row["hours"] - 1) <= 1e-6);
    CHECK(std::fabs(end.rate * kHour * 1e6 / row["rate_um_per_h"] - 1) <= 1e-6);
    CHECK(std::fabs(end.preload / row["preload"] - 1) <= 1e-9);
    CHECK(std::fabs(end.thickness / row["thickness"] - 1) <= 1e-9);
    ++rows;
  }
  CHECK(rows >= 4);
}

TEST_CASE("a start voltage beyond the drive's ends a life (V2.7)", "[core][wear][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/life_even_driven.csv")) {
    const std::string point = row.word("point");
    if (point.find("N.m") == std::string::npos || !(row["depth_at_start_voltage_120V"] > 0))
      continue;
    MotorDesign design = wearing(driven_with_slices(static_cast<int>(row["radial_slices"])),
                                 row["spring_N_per_m"], row["k_mm3_per_Nm"]);
    design.wear->until = {{{Metric::start_voltage}, -HUGE_VAL, 120, ""}};
    CAPTURE(row["radial_slices"], point);
    const Life found = life(design, torque_load(std::stod(point)));
    REQUIRE(found.end == EndOfLife::limit);
    CHECK(std::fabs(found.depth / row["depth_at_start_voltage_120V"] - 1) <= 1e-6);
    CHECK(std::fabs(found.seconds / kHour / row["hours_to_start_voltage_120V"] - 1) <= 1e-6);
    ++rows;
  }
  CHECK(rows >= 1);
}

TEST_CASE("rates on the way are those of the worn motors by themselves",
          "[core][wear][differential]") {
  const MotorDesign design = wearing(driven_with_slices(8), 1e5);
  const LoadPoint load =
      GENERATE(LoadPoint{Argument::torque, 0.5, 0}, LoadPoint{Argument::torque, 0.9, 0},
               LoadPoint{Argument::speed, 9, 0}, LoadPoint{Argument::speed, 0, 0});
  const auto course = wear_course(design, load, {0, 3e-6, 40e-6, 41e-6, 100e-6});
  for (const WearPoint& point : course) {
    CAPTURE(load.at, point.depth);
    REQUIRE(point.status == MetricStatus::ok);
    const MetricRequest asked{Metric::wear_rate_at, load.argument, load.at};
    const double alone = evaluate(Motor(worn_motor(design, point.depth)), asked).value;
    // the wave is known to 1e-12 of its amplitude, and the wear moves some ten times as much
    CHECK(std::fabs(point.rate / alone - 1) <= 1e-10);
  }
}

TEST_CASE("times on the way are the lives to the depths there (V2.3)", "[core][wear][identity]") {
  MotorDesign design = wearing(driven_with_slices(GENERATE(8, kAutoSlices)), 1e5);
  const LoadPoint load = torque_load(0.5);
  std::vector<double> depths;
  for (int i = 0; i <= 20; ++i) depths.push_back(100e-6 * i / 20);
  const auto course = wear_course(design, load, depths);
  for (const std::size_t i : {1, 7, 20}) {
    design.wear->depth_limit = depths[i];
    const Life there = life(design, load);
    CAPTURE(i);
    // the polynomial through 21 rates leaves 1e-8 of the whole, a twentieth of which is the first
    CHECK(std::fabs(course[i].seconds / there.seconds - 1) <= 1e-7);
    CHECK(std::fabs(course[i].revolutions / there.revolutions - 1) <= 1e-7);
  }
}

TEST_CASE("k scales the time and nothing else (C15.2)", "[core][wear][scaling]") {
  MotorDesign design = wearing(driven_with_slices(1), 1e5);
  const Life once = life(design, torque_load(0.5));
  *design.wear->specific_wear *= 4;
  const Life faster = life(design, torque_load(0.5));
  CHECK(faster.depth == once.depth);
  CHECK(std::fabs(4 * faster.seconds / once.seconds - 1) <= 1e-14);
  CHECK(std::fabs(4 * faster.revolutions / once.revolutions - 1) <= 1e-14);
}

TEST_CASE("small contacts with a spring lose their preload exponentially (C15.1)",
          "[core][wear][limit]") {
  // 1.6 N: the half angle is small, and only crest speed and rotor speed count; the second program found 4.5e-4
  MotorDesign design = wearing(elastic(ring_motor()), 8e5 / 100);
  design.preload = 1.6;
  design.wear->depth_limit = 100e-6;
  const LoadPoint load{Argument::speed, 3, 0};
  const Life found = life(design, load);
  REQUIRE(found.status == MetricStatus::ok);
  const Stator& s = design.stator;
  const double omega = 2 * std::numbers::pi * s.frequency;
  const double crest =
      omega * s.amplitude * s.neutral_plane_distance * s.wavelengths / s.contact_radius;
  const double slip = crest - 3 * s.contact_radius;
  const double area = 2 * std::numbers::pi * s.contact_radius * s.contact_width;
  const double F = design.preload, k = *design.wear->specific_wear,
               kF = design.wear->preload_spring;
  const double expected = -std::log1p(-found.depth * kF / F) * area / (k * kF * slip);
  CHECK(std::fabs(found.seconds / expected - 1) <= 5e-3);
}

TEST_CASE("a mission is the mean of its loads (V2.1)", "[core][wear][identity]") {
  MotorDesign design = wearing(driven_with_slices(1));
  const auto rate_at = [&](double torque) {
    return evaluate(Motor(design), metric_at_torque(Metric::wear_rate_at, torque)).value;
  };
  design.operation = {{torque_load(0.8), 30, {}}, {torque_load(0.5), 60, {}}, {{}, 110, {}}};
  const auto course = wear_course(design, {}, {0});
  const double expected = (30 * rate_at(0.8) + 60 * rate_at(0.5)) / 200;
  CHECK(std::fabs(course[0].rate / expected - 1) <= 1e-14);
  // An operation that is one load for ever is that load.
  design.operation = {{torque_load(0.5), 60, {}}};
  CHECK(life(design).seconds == life(design, torque_load(0.5)).seconds);
}

TEST_CASE("a mission's life is that of an integration over time (V2.1, V2.3)",
          "[core][wear][differential]") {
  MotorDesign design = wearing(driven_with_slices(1), 1e5);
  design.operation = {{torque_load(0.8), 1, {}}, {torque_load(0.5), 3, {}}, {{}, 4, {}}};
  const auto rate = [&](double depth) {
    const Motor worn(worn_motor(design, depth));
    const auto at = [&](double torque) {
      return evaluate(worn, metric_at_torque(Metric::wear_rate_at, torque)).value;
    };
    return (at(0.8) + 3 * at(0.5)) / 8;
  };
  // The classical method of Runge and Kutta, which leaves (1 / 20)^4 / 120 of the change of the rate over the life, a fifth
  const Life found = life(design);
  constexpr int kSteps = 20;
  const double h = found.seconds / kSteps;
  double depth = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = rate(depth), b = rate(depth + h / 2 * a), c = rate(depth + h / 2 * b),
                 d = i + 1 < kSteps ? rate(depth + h * c) : rate(*design.wear->depth_limit);
    depth += h / 6 * (a + 2 * b + 2 * c + d);
  }
  CHECK(std::fabs(depth / *design.wear->depth_limit - 1) <= 1e-7);
}

TEST_CASE("a contact that sticks all through does not wear", "[core][wear][limit]") {
  MotorDesign design = wearing(ring_motor());
  design.layer.given_shear_modulus = 1e7;
  design.layer.given_inertia = 0;
  design.friction = {1, 1};
  design.preload = 8 * full_contact_load(design);
  REQUIRE(Motor(design).locks_at_rest());
  const Life found = life(design, {Argument::speed, 0, 0});
  CHECK(found.status == MetricStatus::does_not_wear);
  CHECK(std::isinf(found.seconds));
  CHECK(found.end == EndOfLife::none);
  const MetricValue asked = evaluate(Motor(design), {Metric::life_at, Argument::speed, 0});
  CHECK(asked.status == MetricStatus::does_not_wear);
}

TEST_CASE("what ends a life is told", "[core][wear]") {
  MotorDesign design = wearing(driven_with_slices(1));
  SECTION("the spring") {
    design.wear->preload_spring = 1e7;  // 170 N are gone after 17 um
    const Life found = life(design, {Argument::speed, 5, 0});
    CHECK((found.end == EndOfLife::preload_gone || found.end == EndOfLife::load_lost));
    CHECK(found.depth <= 17e-6);
  }
  SECTION("the load") {
    design.wear->preload_spring = 5e6;
    const Life found = life(design, torque_load(0.8));
    REQUIRE(found.end == EndOfLife::load_lost);
    const auto carries = [&](double depth) {
      return evaluate(Motor(worn_motor(design, depth)), metric_at_torque(Metric::speed_at, 0.8))
                 .status == MetricStatus::ok;
    };
    CHECK(carries(found.depth * (1 - 1e-9)));
    CHECK(!carries(found.depth * (1 + 1e-9)));
  }
  SECTION("a limit that the new motor breaks") {
    design.wear->until = {{{Metric::holding_torque}, 1e3, HUGE_VAL, ""}};
    const Life found = life(design, torque_load(0.5));
    CHECK(found.end == EndOfLife::limit);
    CHECK(found.seconds == 0);
  }
  SECTION("nothing, where all sticks") {
    MotorDesign stuck = wearing(elastic(ring_motor()));
    stuck.friction = {5, 5};
    const MetricValue found = evaluate(Motor(stuck), {Metric::life_at, Argument::torque, 0});
    // either the wave still slips somewhere, or the life has no end; what sticks does not wear
    const double friction =
        evaluate(Motor(stuck), {Metric::friction_power_at, Argument::torque, 0}).value;
    CHECK((friction > 0) == (found.status == MetricStatus::ok));
  }
}

TEST_CASE("a worn metric is that of the worn motor", "[core][wear]") {
  const MotorDesign design = wearing(driven_with_slices(1), 1e5);
  MetricRequest request{Metric::stall_torque};
  request.worn_at = torque_load(0.5);
  const Life end = life(design, torque_load(0.5));
  const double expected =
      evaluate(Motor(worn_motor(design, end.depth)), {Metric::stall_torque}).value;
  CHECK(evaluate(Motor(design), request).value == expected);
  CHECK(worn_motor(design, 50e-6).layer.thickness == design.layer.thickness - 50e-6);
  CHECK(worn_motor(design, 50e-6).preload == design.preload - 5);
}

TEST_CASE("derivatives of lives are those of solving again (V2.7)",
          "[core][wear][derivative][differential]") {
  MotorDesign design = wearing(driven_with_slices(1), 1e5);
  design.wear->lining_youngs_modulus = 3e9;
  design.wear->stator_specific_wear = 1e-8 * kWearUnit;
  design.friction.threshold = design.friction.kinetic;
  std::vector<MetricRequest> requests{metric_at_torque(Metric::wear_rate_at, 0.5),
                                      metric_at_torque(Metric::life_at, 0.5),
                                      metric_at_torque(Metric::life_revolutions_at, 0.5)};
  SECTION("that end by their depth") {
    MetricRequest worn{Metric::stall_torque};
    worn.worn_at = torque_load(0.5);
    requests.push_back(worn);
  }
  SECTION("that end by a limit") {
    design.wear->until = {{metric_at_torque(Metric::speed_at, 0.5), -HUGE_VAL, 0, ""}};
    const double now = evaluate(Motor(design), design.wear->until[0].request).value;
    const double later =
        evaluate(Motor(worn_motor(design, 50e-6)), design.wear->until[0].request).value;
    design.wear->until[0].lower = later < now ? later : -HUGE_VAL;
    design.wear->until[0].upper = later < now ? HUGE_VAL : later;
    MetricRequest worn{Metric::stall_torque};
    worn.worn_at = torque_load(0.5);
    requests.push_back(worn);
  }
  SECTION("with temperatures") {
    design = wearing(with_table(warm_motor()), 1e5);
    design.thermal->drift.specific_wear = 0.01;
    requests.pop_back();
  }
  const auto exact = differentiate(Motor(design), requests);
  int compared = 0;
  for (const ParameterInfo& row : parameter_table()) {
    const double x = get(design, row.parameter);
    if (row.integer || row.parameter == Parameter::static_friction || row.absolute ||
        !in_use(design, row.parameter) || x == 0)
      continue;
    const double h = 1e-4 * std::fabs(x);
    const auto at = [&](double by) {
      return values_of(with(design, row.parameter, x + by), requests);
    };
    const auto p1 = at(h), m1 = at(-h), p2 = at(2 * h), m2 = at(-2 * h);
    for (std::size_t k = 0; k < requests.size(); ++k) {
      CAPTURE(row.name, info(requests[k].metric).name, requests[k].worn_at.has_value());
      REQUIRE(exact[k].smoothness == Smoothness::smooth);
      const double slope = (8 * (p1[k] - m1[k]) - (p2[k] - m2[k])) / (12 * h);
      // differences of integrals that are good to 1e-9, over 1e-4 of the parameter
      const double unit = std::fabs(slope) + std::fabs(exact[k].value.value / x);
      CHECK(std::fabs(exact[k].gradient[index_of(row.parameter)] - slope) <= 2e-5 * unit);
      ++compared;
    }
  }
  CHECK(compared > 60);
}

TEST_CASE(
    "derivatives of lives in an operation with temperatures are those of solving again (V2.7)",
    "[core][wear][heat][derivative][differential]") {
  MotorDesign design = wearing(with_table(warm_motor()), 1e5);
  design.thermal->drift.specific_wear = 0.01;
  design.friction.threshold = design.friction.kinetic;
  design.operation = {{torque_load(0.8), 30, {}}, {torque_load(0.5), 60, 110.0}, {{}, 110, {}}};
  const std::vector<MetricRequest> requests{{Metric::life}, {Metric::life_revolutions}};
  const auto exact = differentiate(Motor(design), requests);
  for (const Parameter parameter :
       {Parameter::voltage, Parameter::preload_spring, Parameter::ambient_temperature,
        Parameter::conductance_housing_ambient, Parameter::thickness}) {
    const double x = get(design, parameter), h = 1e-3 * x;
    const auto above = values_of(with(design, parameter, x + h), requests),
               below = values_of(with(design, parameter, x - h), requests);
    for (std::size_t k = 0; k < requests.size(); ++k) {
      CAPTURE(info(parameter).name, info(requests[k].metric).name);
      REQUIRE(exact[k].smoothness == Smoothness::smooth);
      const double slope = (above[k] - below[k]) / (2 * h);
      // the difference leaves a millionth of the bend, which is some ten times the slope; lives are known to 1e-8
      const double unit = std::fabs(slope) + std::fabs(exact[k].value.value / x);
      CHECK(std::fabs(exact[k].gradient[index_of(parameter)] - slope) <= 5e-5 * unit);
    }
  }
}

TEST_CASE("heat and wear together are those of a second program",
          "[core][wear][heat][differential]") {
  for (const CsvRow& row : csv_rows("heat/coupled_life.csv")) {
    const std::string mode = row.word("mode");
    if (mode == "no coefficients") continue;
    MotorDesign design = with_table(warm_motor());
    design.stator.radial_slices = 8;
    if (mode == "tracking") design.stator.frequency_ratio = 40.8 / 39;
    design.thermal->drift.specific_wear = 0.01;
    design.thermal->conductances.lining.reset();
    design.layer.conductivity = 0.25;
    design = wearing(design, 1e5);
    const Life found = life(design, torque_load(0.5));
    CAPTURE(mode, found.seconds / kHour);
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(std::fabs(found.seconds / kHour / row["life_h"] - 1) <= 1e-4);
  }
}

namespace {

// A number behind a word of a case, such as "T" in "{'T': 0.8}" or "taper=" in "p=1.0 taper=0.0001".
std::optional<double> number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return {};
  return std::stod(text.substr(at + word.size()));
}

MotorDesign case_motor(const CsvRow& row) {
  MotorDesign design = elastic_layer(static_cast<int>(row["N"]));
  const std::string given = row.word("params");
  const auto set = [&](const char* word, double& value) {
    value = number_after(given, word).value_or(value);
  };
  set("p=", design.stator.radial_shape.exponent);
  set("root=", design.stator.radial_shape.root);
  set("taper=", design.rotor.taper);
  set("E=", design.layer.youngs_modulus);
  set("G=", *design.layer.given_shear_modulus);
  set("h=", design.layer.thickness);
  set("mu=", design.friction.kinetic);
  set(" f=", design.stator.frequency);
  set(" A=", design.stator.amplitude);
  set(" F=", design.preload);
  design.friction.threshold = design.friction.kinetic;
  return design;
}

}  // namespace

TEST_CASE("worn-in states are those of a second program (V3.4)", "[core][wear][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/wear_worn_in.csv")) {
    const std::string load = row.word("load");
    const auto torque = number_after(load, "'T': ");
    const LoadPoint at = torque ? torque_load(*torque)
                                : LoadPoint{Argument::speed, *number_after(load, "'Om': "), 0};
    const MotorDesign design = case_motor(row);
    CAPTURE(row.word("case"));
    const WornIn found = worn_in(design, at);
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(std::fabs(found.speed / row["speed"] - 1) <= 1e-7);
    CHECK(std::fabs(found.intensity / design.friction.kinetic / row["w_W_per_m2_over_mu"] - 1) <=
          1e-7);
    const auto depths = row.list("depth_m"), shares = row.list("load_share");
    REQUIRE(found.slices.size() == depths.size());
    for (std::size_t j = 0; j < depths.size(); ++j) {
      CHECK(std::fabs(found.slices[j].depth / depths[j] - 1) <= 1e-7);
      CHECK(std::fabs(found.slices[j].load / design.preload / shares[j] - 1) <= 1e-7);
    }
    ++rows;
  }
  CHECK(rows == 6);
}

TEST_CASE("even wear is stable at high loads only (V3.7, C15.3)", "[core][wear][differential]") {
  // integrations of a second program: unstable up to the lower torque, stable from the upper one
  const auto changes_between = [](const MotorDesign& design, double unstable, double stable) {
    for (const double torque : {0.5 * unstable, unstable})
      CHECK(wear_stability(design, torque_load(torque)) == WearStability::uneven);
    for (const double torque : {stable, 1.05 * stable})
      CHECK(wear_stability(design, torque_load(torque)) == WearStability::even);
  };
  changes_between(elastic_layer(8), 0.6, 0.7);
  MotorDesign drive_60 = elastic(driven_with_slices(8));
  drive_60.stator.voltage.reset();
  drive_60.stator.amplitude = 1.736e-6;
  changes_between(drive_60, 0.7, 0.75);
  CHECK(wear_stability(driven_with_slices(1), torque_load(0.5)) == WearStability::unknown);
  CHECK(wear_stability(driven_with_slices(8), torque_load(5)) == WearStability::unknown);
  CHECK(worn_in(driven_with_slices(8), torque_load(0.5)).status == MetricStatus::undefined);
}
