// SPDX-License-Identifier: Apache-2.0
// The plan of the first measurements (L6.1, L6.2), and columns with a scatter of their own (L9.1).
#include "calibrate_support.hpp"
#include "support/motor_files.hpp"

#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

// A study without data.
StudyFile unmeasured(const ScratchFolder& folder, const std::string& motor,
                     const std::string& variables) {
  std::ofstream(folder.path("study.yaml"))
      << "twum: 1\nmotor: " << motor_path(motor) << "\nstudy: {kind: calibrate, variables: {"
      << variables << "}}\n";
  return read_study_file(folder.path("study.yaml"));
}

// What a bench would read of a motor where the plan says, without error, with these standard deviations.
std::string read_at(const MotorDesign& motor, const CalibrateResult& plan) {
  std::map<std::string, double> deviations;
  for (const auto& one : plan.columns) deviations[one.quantity] = one.deviation;
  std::string csv = "speed,torque,torque_sd,preload\n";
  for (const auto& planned : plan.plan) {
    double preload = get(motor, Parameter::preload);
    for (const NamedValue& set : planned.point.set)
      if (set.name == "preload") preload = set.value;
    const Motor at(with(motor, Parameter::preload, preload));
    csv += number(planned.point.at) + "," + number(at.operating_point(planned.point.at).torque) +
           "," + number(deviations.at("torque_at")) + "," + number(preload) + "\n";
  }
  return csv;
}

}  // namespace

TEST_CASE("ten planned first measurements shrink the ranges as much as the plan says (L6.2)",
          "[studies][calibrate][identity]") {
  const ScratchFolder folder;
  const StudyFile file = unmeasured(folder, "ring-60", kThree);
  const Run run(file);
  CHECK(run.answer.outcome == "done");
  const CalibrateResult& result = run.result();
  REQUIRE(result.plan.size() == 10);
  CHECK_THAT(run.text(), Contains("The first measurements") && Contains("torque_at("));
  CHECK_THAT(run.json(), Contains("\"scatter\":\"assumed\"") && Contains("\"data\":[]"));

  Case measured;
  measured.more = "starts: 1, scatter: stated";
  const Run fit(measured.file(read_at(file.motor.design, result)));
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& range = result.estimates[j];
    const auto& estimate = fit.result().estimates[j];
    const double width =
        range.scale == optim::Scale::log ? std::log(range.max / range.min) : range.max - range.min;
    const double deviation =
        estimate.deviation / (range.scale == optim::Scale::log ? estimate.parameter.value : 1);
    // A number that may be anywhere in its range has the deviation width / sqrt(12). The plan knows the ranges besides:
    // below 2e-2 of the variance with these ten.
    CHECK(result.plan.back().widths[j] ==
          Approx(std::sqrt(12.0) * deviation / width).epsilon(2e-2));
  }
}

TEST_CASE("ten planned first measurements leave narrower intervals than ten evenly spaced ones",
          "[studies][calibrate]") {
  const ScratchFolder folder;
  const StudyFile file = unmeasured(folder, "ring-60", kThree);
  const MotorDesign& motor = file.motor.design;
  const Run run(file);
  // The same instrument at ten speeds from rest to no-load.
  const double deviation = run.result().columns.front().deviation;
  const double last = evaluate(Motor(motor), MetricRequest{Metric::no_load_speed}).value;
  std::string even = "speed,torque,torque_sd\n";
  for (int k = 0; k < 10; ++k)
    even += number(last * k / 9) + "," + number(Motor(motor).operating_point(last * k / 9).torque) +
            "," + number(deviation) + "\n";
  Case measured;
  measured.more = "starts: 1, scatter: stated";
  const Run planned(measured.file(read_at(motor, run.result())));
  const Run spaced(measured.file(even));
  double product = 1;
  for (std::size_t j = 0; j < 3; ++j)
    product *= planned.result().estimates[j].deviation / spaced.result().estimates[j].deviation;
  // 0.656 when this was written (1.26 for the friction, 0.48 for the amplitude and 0.47 for the modulus).
  CHECK(std::cbrt(product) < 0.7);
}

TEST_CASE("of a driven motor current and power are planned as well", "[studies][calibrate]") {
  const ScratchFolder folder;
  const Run run(unmeasured(folder, "drive-60",
                           "force_factor: {min: 0.3 N/V, max: 0.9 N/V}, quality_factor: {min: 50, "
                           "max: 400}, kinetic_friction: {min: 0.1, max: 0.4}"));
  CHECK(run.result().columns.size() == 3);
  CHECK(run.result().plan.size() == 10);
  // Each of the widths falls, and friction takes a torque.
  const auto& widths = run.result().plan.back().widths;
  for (const double width : widths) CHECK(width < 0.5);
}

TEST_CASE("columns without standard deviations are weighed by their own scatter (L9.1)",
          "[studies][calibrate]") {
  // Torque to 4 mN.m and no-load speed to 0.5 rpm; the table does not say so.
  const MotorDesign truth = with(Case().design(), kTruth);
  const Motor motor(truth);
  optim::Random random(3, 0, 0);
  const auto normal = [&] {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
  };
  const double no_load = evaluate(motor, MetricRequest{Metric::no_load_speed}).value / kRpm;
  std::string csv = "speed [rpm],torque,no_load_speed [rpm]\n";
  for (int i = 0; i < 40; ++i) {
    const double rpm = 20 + 3 * i;
    csv += number(rpm) + "," + number(motor.operating_point(rpm * kRpm).torque + 4e-3 * normal()) +
           "," + number(no_load + 0.5 * normal()) + "\n";
  }
  Case one;
  one.more = "starts: 2, scatter: by-column";
  const Run run(one.file(csv));
  CHECK(run.answer.outcome == "fitted");
  REQUIRE(run.result().columns.size() == 2);
  // Of 40 numbers a deviation is known to 11 %; three of these.
  CHECK(run.result().columns[0].deviation == Approx(4e-3).epsilon(0.35));
  CHECK(run.result().columns[1].deviation == Approx(0.5 * kRpm).epsilon(0.35));
  CHECK_THAT(run.text(),
             Contains("Scatter of each column, from its residuals: torque (points.csv)"));
  for (std::size_t j = 0; j < kTruth.size(); ++j) {
    CHECK(run.result().estimates[j].low < kTruth[j].second);
    CHECK(run.result().estimates[j].high > kTruth[j].second);
  }
  // The rows of an interrupted run lead to the same end.
  const Run again(one.file(csv), 2, run.rows());
  CHECK(again.json() == run.json());
  CHECK(same_rows(again.rows(), run.rows()));
}

TEST_CASE("a column too short for a scatter of its own is refused with its place",
          "[studies][calibrate][errors]") {
  Case one;
  one.more = "scatter: by-column";
  CHECK_THROWS_WITH(
      make_kind(one.file("speed,torque,no_load_speed\n1,1,\n2,1,\n3,1,\n4,1,\n5,1,15\n")),
      Contains("points.csv:1:14: no_load_speed: 1 number; 'scatter: by-column' needs 6 or more") &&
          Contains("points.csv:1:7: torque: 5 numbers; "));
  one.more = "scatter: by-column, loss: huber";
  CHECK_THROWS_WITH(one.file("speed,torque\n"),
                    Contains("study.loss: 'huber' together with 'scatter: by-column'"));
}

TEST_CASE("a planned impedance names its frequency, and no preload", "[studies][calibrate]") {
  // Frequencies of the data, or that of the motor where the data give none.
  const std::string variables =
      "resonance_frequency: {min: 38 kHz, max: 40 kHz}, quality_factor: {min: 50, max: 400}";
  Case one;
  one.motor = "drive-60";
  one.variables = variables;
  one.more = "starts: 1, scatter: stated";
  const Run circle(
      one.file("frequency [Hz],impedance [ohm],impedance_sd [ohm]\n38900,900,9\n39000,800,8\n39100,"
               "1100,11\n"));
  REQUIRE(circle.result().plan.size() == 10);
  for (const auto& planned : circle.result().plan) {
    REQUIRE(planned.point.set.size() == 1);
    CHECK(planned.point.set[0].name == "frequency");
    const double f = planned.point.set[0].value;
    CHECK((f == 38900 || f == 39000 || f == 39100));
  }
  one.variables = "quality_factor: {min: 50, max: 400}";
  const Run bare(one.file("impedance [ohm],impedance_sd [ohm]\n900,9\n910,9\n"));
  for (const auto& planned : bare.result().plan) {
    REQUIRE(planned.point.set.size() == 1);
    CHECK(planned.point.set[0].value == get(one.design(), Parameter::frequency));
  }
  CHECK_THAT(bare.text(), Contains("impedance, frequency 40.8 kHz"));
}

TEST_CASE("a temperature is planned where no part of the motor is above its limit",
          "[studies][calibrate][heat]") {
  Case bench;
  bench.motor = "warm-60";
  bench.variables =
      "conductance_housing_ambient: {min: 0.05 W/K, max: 1 W/K, scale: log}, "
      "conductance_stator_housing: {min: 0.1 W/K, max: 3 W/K, scale: log}";
  bench.more = "starts: 1, scatter: stated";
  const StudyFile file = bench.file(
      "torque [N.m],stator_temperature_at [degC],stator_temperature_at_sd [K],"
      "housing_temperature_at [degC],housing_temperature_at_sd [K]\n"
      "0.2,53.4,0.3,46.2,0.3\n0.5,56.2,0.3,49.6,0.3\n0.8,65.6,0.3,56.2,0.3\n");
  const Run run(file);
  MotorDesign fitted = file.motor.design;
  for (const auto& one : run.result().estimates)
    fitted = with(fitted, *find_parameter(one.parameter.name), one.parameter.value);
  const auto margin = [](const MotorDesign& design, double torque) {
    return evaluate(Motor(design),
                    MetricRequest{Metric::temperature_margin_at, Argument::torque, torque});
  };
  // The largest voltage and nine tenths of the torque would be too hot.
  const double most = 0.9 * evaluate(Motor(fitted), MetricRequest{Metric::max_torque}).value;
  const double volts = 1.25 * get(fitted, Parameter::voltage);
  CHECK(margin(with(fitted, Parameter::voltage, volts), most).value < 0);
  REQUIRE(run.result().plan.size() == 10);
  for (const auto& planned : run.result().plan) {
    MotorDesign design = fitted;
    for (const NamedValue& one : planned.point.set)
      design = with(design, *find_parameter(one.name), one.value);
    CHECK(margin(design, planned.point.at).value >= 0);
  }
}
