// SPDX-License-Identifier: Apache-2.0
// Parameters with a value of their own in each of several tables of measurements.
#include "calibrate_support.hpp"
#include "entries/resolved_study.hpp"
#include "kinds/sample/found_motors.hpp"
#include "support/motor_files.hpp"

#include <twum/studies/fit_curves.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

const char* const kKinetic = "kinetic_friction: {min: 0.05, max: 0.5}";
const char* const kModulus = "youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}";

// One study of two tables.
struct Benches {
  ScratchFolder folder;
  std::string motor{"ring-60"};
  std::string variables{std::string(kKinetic) + ", " + kModulus};
  std::string per_file{"kinetic_friction"};
  std::string data{"[a.csv, b.csv]"};
  std::string more{"starts: 1"};

  StudyFile file(const std::string& a, const std::string& b) const {
    std::ofstream(folder.path("a.csv")) << a;
    std::ofstream(folder.path("b.csv")) << b;
    std::ofstream(folder.path("study.yaml"))
        << "twum: 1\nmotor: " << motor_path(motor) << "\nstudy: {kind: calibrate, data: " << data
        << ", variables: {" << variables << "}, per_file: [" << per_file << "], " << more << "}\n";
    return read_study_file(folder.path("study.yaml"));
  }
};

MotorDesign bench(double friction) {
  const std::vector<ParameterValue> values{{Parameter::kinetic_friction, friction},
                                           {Parameter::youngs_modulus, 2.2e9}};
  return with(Case().design(), values);
}

// Torques of a bench that has friction alone: T = mu F r while all of the contact slips.
std::string plateau(double torque) {
  std::string csv = "speed [rpm],torque\n";
  for (int i = 1; i <= 4; ++i) csv += number(i) + "," + number(torque) + "\n";
  return csv;
}

std::vector<std::string> names_of(const CalibrateResult& result) {
  std::vector<std::string> names;
  for (const auto& e : result.estimates) names.push_back(e.parameter.name);
  return names;
}

}  // namespace

TEST_CASE("frictions of two benches and the modulus of their one layer are found",
          "[studies][calibrate]") {
  const Benches two;
  const StudyFile exact = two.file(points_of(bench(0.23)), points_of(bench(0.19)));
  const Run run(exact);
  CHECK(run.answer.outcome == "fitted");
  const auto& e = run.result().estimates;
  CHECK(names_of(run.result()) == std::vector<std::string>{"kinetic_friction (a.csv)",
                                                           "kinetic_friction (b.csv)",
                                                           "youngs_modulus"});
  CHECK(run.result().degrees_of_freedom == 2 * 28 - 3);
  // The search ends where its steps are below 1e-9 of the parameters.
  CHECK(e[0].parameter.value == Approx(0.23).epsilon(1e-7));
  CHECK(e[1].parameter.value == Approx(0.19).epsilon(1e-7));
  CHECK(e[2].parameter.value == Approx(2.2e9).epsilon(1e-7));
  CHECK_THAT(run.json(),
             Contains("\"kinetic_friction (b.csv)\":{") && Contains("\"file\":\"b.csv\""));
  CHECK_THAT(run.text(), Contains("\nkinetic_friction (a.csv)  0.23"));

  StudyResult stored;
  stored.outcome = run.answer.outcome;
  stored.answer = run.answer.answer;
  const auto motors = found_motors(exact, stored);
  REQUIRE(motors.size() == 2);
  CHECK(motors[0].file == "fitted/01.yaml");
  CHECK(motors[1].what == "fitted motor of b.csv");
  CHECK(motors[1].motor.design.friction.kinetic == Approx(0.19).epsilon(1e-7));
  CHECK(motors[0].motor.design.friction.kinetic == Approx(0.23).epsilon(1e-7));

  const Run noisy(two.file(points_of(bench(0.23), 4e-3, 1), points_of(bench(0.19), 4e-3, 2)));
  CHECK(noisy.answer.outcome == "fitted");
  const double truth[] = {0.23, 0.19, 2.2e9};
  // Four standard deviations: normal noise leaves them once in 16,000 times. The modulus is estimated in its logarithm.
  for (std::size_t j = 0; j < 3; ++j)
    CHECK(std::fabs(noisy.result().estimates[j].parameter.value - truth[j]) <
          4 * noisy.result().estimates[j].deviation);
}

TEST_CASE("with every parameter per file a study is one study for each file",
          "[studies][calibrate][identity]") {
  // Errors whose neighbours are not alike: the intervals of neither study are widened by a correlation of its own.
  const auto tables_of = [](unsigned seed) {
    return std::array{points_of(bench(0.23), 4e-3, seed), points_of(bench(0.19), 4e-3, seed + 1)};
  };
  Case one;
  Benches two;
  one.variables = two.variables;
  const auto file_of = [&](const std::string& table) { return one.file(table); };
  two.per_file = "youngs_modulus, kinetic_friction";
  const auto is_serial = [&](unsigned seed) {
    const auto tables = tables_of(seed);
    return Run(two.file(tables[0], tables[1])).result().serial ||
           Run(file_of(tables[0])).result().serial || Run(file_of(tables[1])).result().serial;
  };
  unsigned seed = 1;
  while (seed < 40 && is_serial(seed)) seed += 2;
  REQUIRE(seed < 40);
  const auto tables = tables_of(seed);
  const Run both(two.file(tables[0], tables[1]));
  REQUIRE(both.result().estimates.size() == 4);
  CHECK(both.result().degrees_of_freedom == 2 * 28 - 4);
  for (std::size_t k = 0; k < 2; ++k) {
    const Run alone(file_of(tables[k]));
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& joint = both.result().estimates[2 * j + k];
      // Two searches, each to 1e-13 of its sum of squares: about the root of it.
      CHECK(joint.parameter.value ==
            Approx(alone.result().estimates[j].parameter.value).epsilon(1e-6));
      // The scatter is that of all residuals; the rest of a standard deviation is the table's own.
      CHECK(joint.deviation / both.result().residual_deviation ==
            Approx(alone.result().estimates[j].deviation / alone.result().residual_deviation)
                .epsilon(1e-5));
    }
    // Numbers of different tables have nothing to do with each other.
    CHECK(std::fabs(both.result().correlation[0 * 4 + 1]) < 1e-9);
  }
}

TEST_CASE("a measurement on one of two motors says nothing about the other (L6.2)",
          "[studies][calibrate][identity]") {
  Benches two;
  two.per_file = "youngs_modulus, kinetic_friction";
  const Run run(two.file(points_of(bench(0.23), 4e-3, 3), points_of(bench(0.19), 4e-3, 4)));
  REQUIRE(run.result().plan.size() == 10);
  std::vector<double> widths(4, 1.0);
  for (const auto& planned : run.result().plan) {
    CAPTURE(planned.file);
    REQUIRE((planned.file == "a.csv" || planned.file == "b.csv"));
    for (std::size_t j = 0; j < 4; ++j) {
      // Its gradient by the parameters of the other motor is 0, and so is their covariance, to rounding.
      if (run.result().estimates[j].file == planned.file)
        CHECK(planned.widths[j] <= widths[j]);
      else
        CHECK(planned.widths[j] == Approx(widths[j]).epsilon(1e-9));
    }
    widths = planned.widths;
  }
  CHECK_THAT(run.text(), Contains(" rpm), preload 200 N (b.csv)"));
}

TEST_CASE("each table has a curve of its own with the band of its parameters (L2.4)",
          "[studies][calibrate][closed-form]") {
  Benches two;
  two.variables = kKinetic;
  two.motor = "elastic-layer";
  const StudyFile file = two.file("speed [rpm],torque\n1,0.80\n2,0.81\n3,0.79\n",
                                  "speed [rpm],torque\n1,0.70\n2,0.71\n4,0.70\n");
  const Run run(file);
  const auto curves = fit_curves(file, run.result());
  REQUIRE(curves.size() == 2);
  const MotorDesign motor = file.motor.design;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& e = run.result().estimates[k];
    CHECK(curves[k].file == e.file);
    CHECK(curves[k].points.size() == 3);
    CHECK(curves[k].at.back() == Approx((k == 0 ? 3 : 4) * kRpm).epsilon(1e-12));
    // T = mu F r where all of the contact slips (C8.5); its band is the interval of mu times F r.
    // The problem is linear: the interval is that of (L2.1), and half of it the half width of (L2.4).
    CHECK(e.high - e.low == Approx(2 * run.result().student_t * e.deviation).epsilon(1e-9));
    const double lever = motor.preload * motor.stator.contact_radius;
    for (std::size_t i = 0; i < curves[k].at.size(); ++i) {
      CHECK(curves[k].value[i] == Approx(e.parameter.value * lever).epsilon(1e-9));
      CHECK(curves[k].low[i] == Approx(e.low * lever).epsilon(1e-9));
      CHECK(curves[k].high[i] == Approx(e.high * lever).epsilon(1e-9));
    }
  }
}

TEST_CASE("each bench's friction makes up for the preload (L5.1)",
          "[studies][calibrate][closed-form]") {
  Benches two;
  two.variables = kKinetic;
  const Run run(two.file(plateau(0.8), plateau(0.7)));
  const MotorDesign motor = Case().design();
  REQUIRE(run.result().estimates.size() == 2);
  const auto move = std::find_if(run.result().moves.begin(), run.result().moves.end(),
                                 [](const Move& m) { return m.held.name == "preload"; });
  REQUIRE(move != run.result().moves.end());
  for (std::size_t k = 0; k < 2; ++k) {
    const double friction = run.result().estimates[k].parameter.value;
    // The contact's width moves the mean of the track by less than a thousandth of the radius.
    CHECK(
        friction ==
        Approx((k == 0 ? 0.8 : 0.7) / (motor.preload * motor.stator.contact_radius)).epsilon(1e-3));
    // Differences of steps of 1e-5: their square, and rounding over them.
    CHECK(move->slopes[k] == Approx(-friction / move->held.value).epsilon(1e-7));
  }
}

TEST_CASE("a table that does not see its own parameter is named", "[studies][calibrate]") {
  Benches two;
  two.motor = "elastic-layer";
  two.per_file = "youngs_modulus";
  Case elastic;
  elastic.motor = two.motor;
  const MotorDesign motor = elastic.design();
  const double torque = Motor(motor).operating_point(kRpm).torque;
  const Run run(two.file(points_of(motor), plateau(torque)));
  CHECK(run.answer.outcome == "undetermined");
  CHECK_THAT(run.text(), Contains("The data do not determine youngs_modulus (b.csv)"));
  CHECK(run.result().undetermined.size() == 1);
}

TEST_CASE("a study of several tables is known by what each of them holds", "[studies][calibrate]") {
  const Benches two, same, other;
  const ResolvedStudy resolved = resolve(two.file(plateau(0.8), plateau(0.7)));
  REQUIRE(resolved.files.size() == 2);
  CHECK(resolved.hash() == resolve(same.file(plateau(0.8), plateau(0.7))).hash());
  CHECK(resolved.hash() != resolve(other.file(plateau(0.8), plateau(0.6))).hash());
  CHECK(resolved.hash() != resolve(other.file(plateau(0.9), plateau(0.7))).hash());
  const std::string text = resolved.text(two.folder.path("result"));
  CHECK_THAT(text, Contains("data: [inputs/a.csv, inputs/b.csv]\n"));
}

TEST_CASE("values per file that cannot be are refused", "[studies][calibrate][errors]") {
  const auto complaint = [](const Benches& two) -> std::string {
    try {
      two.file(plateau(0.8), plateau(0.7));
    } catch (const InputError& error) {
      return error.what();
    }
    return "ok";
  };
  CHECK(complaint({}) == "ok");
  Benches wrong;
  wrong.per_file = "amplitude";
  CHECK_THAT(complaint(wrong), Contains("study.per_file: amplitude is not estimated"));
  wrong.per_file = "kinetic_friction, mu";
  CHECK_THAT(complaint(wrong), Contains("kinetic_friction is named twice"));
  wrong.per_file = "frction";
  CHECK_THAT(complaint(wrong), Contains("unknown parameter 'frction'"));
  wrong.per_file = "kinetic_friction";
  wrong.data = "a.csv";
  CHECK_THAT(complaint(wrong), Contains("two tables or more, each with a name of its own"));
  wrong.data = "[a.csv, ./a.csv]";
  CHECK_THAT(complaint(wrong), Contains("two tables or more, each with a name of its own"));
  wrong.data = "[a.csv, b.csv]";
  wrong.more = "derived: {preload: \"700 N * kinetic_friction\"}";
  CHECK_THAT(complaint(wrong), Contains("study.per_file: given together with 'derived'"));
}
