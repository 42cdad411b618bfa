// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"

#include <twum/core/motor.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <numbers>

// Studies of motors under a voltage: their answers against single motors, which no search has seen.
using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double kRpm = std::numbers::pi / 30;

MotorDesign design_with(const MotorDesign& base, const std::vector<NamedValue>& values) {
  std::vector<ParameterValue> list;
  for (const NamedValue& one : values) list.emplace_back(*find_parameter(one.name), one.value);
  return with(base, list);
}

/// Anywhere in the ranges.
MotorDesign random_design(const MotorDesign& base, const std::vector<DesignVariable>& ranges,
                          std::uint64_t number) {
  optim::Random random(11, 0, number);
  std::vector<ParameterValue> list;
  for (const DesignVariable& range : ranges)
    list.emplace_back(range.parameter, range.min + random.uniform() * (range.max - range.min));
  return with(base, list);
}

/// A motor that starts by itself has one wave at rest, the running one; below its start voltage there are three.
std::size_t waves_at_rest(MotorDesign design, double voltage) {
  design.stator.voltage = voltage;
  return Motor(design).wave_states(0).size();
}

}  // namespace

TEST_CASE("a driven motor is sized, starts by itself and keeps its efficiency", "[studies][size]") {
  const StudyFile file = narrow_example("size-driven.yaml");
  const Search s(file, 2);
  REQUIRE(s.answer.outcome == "optimal");
  CHECK(s.optimum().best.certificate.passed);
  const MotorDesign best = design_with(file.motor.design, s.optimum().best.design);
  const OperatingPoint p = Motor(best).operating_point(100 * kRpm);
  REQUIRE(p.status == PointStatus::ok);
  // Limits are kept to a millionth of themselves.
  CHECK(p.torque >= 0.5 * (1 - 1e-6));
  CHECK(p.output_power / p.electrical_power >= 0.35 * (1 - 1e-5));
  const double voltage = *best.stator.voltage;
  CHECK(voltage <= 110);
  CHECK(waves_at_rest(best, voltage * (1 + 1e-4)) == 1);
  CHECK(waves_at_rest(best, voltage * (1 - 1e-4)) == 3);
  const double pressure = value(s.optimum().best.metrics, "max_pressure");
  const auto& question = std::get<SizeStudy>(file.asked);
  int feasible = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Motor motor(random_design(file.motor.design, question.variables, i));
    const auto asked = [&](const MetricRequest& r) { return evaluate(motor, r); };
    const double start = asked({Metric::start_voltage}).value;
    const MetricValue torque = asked({Metric::torque_at, Argument::speed, 100 * kRpm}),
                      share = asked({Metric::overall_efficiency_at, Argument::torque, 0.5});
    if (!(start <= 110 && start <= *motor.design().stator.voltage && torque.value >= 0.5 &&
          share.value >= 0.35 && asked({Metric::layer_aspect}).value <= 0.1))
      continue;
    ++feasible;
    CHECK(asked({Metric::max_pressure}).value >= pressure * (1 - 1e-6));
  }
  // Three limits bind at the best motor: few random ones keep them all.
  CHECK(feasible > 4);
}

TEST_CASE("no random setting of driver and spring beats the front of efficiency and torque",
          "[studies][pareto]") {
  const StudyFile file = example_study("pareto-driven.yaml");
  const Search s(file, 2);
  CHECK(s.answer.outcome == "optimal");
  const auto& front = s.front().front;
  REQUIRE(front.size() == 20);
  for (const ParetoResult::Point& point : front) {
    CHECK(point.report.certificate.passed);
    const MotorDesign design = design_with(file.motor.design, point.report.design);
    const OperatingPoint p = Motor(design).operating_point(100 * kRpm);
    CHECK_THAT(value(point.report.metrics, "torque_at(100 rpm)"), WithinRel(p.torque, 1e-12));
    CHECK_THAT(value(point.report.metrics, "overall_efficiency_at(100 rpm)"),
               WithinRel(p.output_power / p.electrical_power, 1e-12));
  }
  const auto& question = std::get<ParetoStudy>(file.asked);
  int feasible = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const MotorDesign design = random_design(file.motor.design, question.variables, i);
    if (waves_at_rest(design, 120) != 1) continue;  // it does not start by itself
    const OperatingPoint p = Motor(design).operating_point(100 * kRpm);
    if (p.status != PointStatus::ok || !(p.output_power > 0)) continue;
    ++feasible;
    const double efficiency = p.output_power / p.electrical_power;
    for (const ParetoResult::Point& point : front)
      CHECK((value(point.report.metrics, "torque_at(100 rpm)") > p.torque * (1 - 1e-6) ||
             value(point.report.metrics, "overall_efficiency_at(100 rpm)") >
                 efficiency * (1 - 1e-6)));
  }
  CHECK(feasible > 200);
}

TEST_CASE("tolerances of resonance and voltage reach the terminals", "[studies][uncertainty]") {
  const StudyFile file = example_study("tolerances-driven.yaml");
  const Search s(file, 2);
  CHECK(s.answer.outcome == "done");
  const auto& columns = s.kind->columns();
  const auto at = [&](const StoredRow& row, const std::string& name) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == name) return row.values[i];
    FAIL("no column " << name);
    return 0.0;
  };
  double sum = 0, square = 0;
  const std::vector<StoredRow> rows = s.rows();
  REQUIRE(rows.size() == 2000);
  for (const StoredRow& row : rows) {
    const double detuned = at(row, "resonance_frequency") / 39e3 - 1;
    sum += detuned, square += detuned * detuned;
    CHECK(std::fabs(at(row, "voltage") / 120 - 1) <= 0.05);
    if (row.index % 20 != 0) continue;
    const MotorDesign design = design_with(
        file.motor.design, {{"resonance_frequency", "Hz", at(row, "resonance_frequency")},
                            {"voltage", "V", at(row, "voltage")},
                            {"preload", "N", at(row, "preload")}});
    // The load that is asked for is carried at the speed that is found, by another way to the same wave.
    const OperatingPoint p = Motor(design).operating_point(at(row, "speed_at(0.5 N.m)"));
    CHECK_THAT(p.torque, WithinRel(0.5, 1e-8));
    CHECK_THAT(at(row, "phase_current_at(0.5 N.m)"), WithinRel(p.phase_current, 1e-8));
  }
  // 2000 draws know the mean to 0.3 % / 45 and the deviation to 1.6 %; four of these.
  CHECK(std::fabs(sum / 2000) < 4 * 0.003 / std::sqrt(2000.0));
  CHECK_THAT(std::sqrt(square / 2000), WithinRel(0.003, 0.064));
}
