// SPDX-License-Identifier: Apache-2.0
// The library as a program sees it: through the umbrella header alone.
#include <twum/twum.hpp>

#include <catch2/catch.hpp>

#include <cstdio>
#include <thread>

using namespace twum;
using namespace twum::studies;
using Catch::Matchers::Contains;

namespace {

DesignProblem question() {
  DesignProblem problem{MotorDesign{}};
  problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
  problem.limit("wear_intensity_at(100 rpm) <= 5 kW/m^2").limit("no_load_speed <= 180 rpm");
  return problem;
}

}  // namespace

TEST_CASE("a question in five lines has its closed-form answer", "[library][closed-form]") {
  DesignProblem problem{MotorDesign{}};
  problem.vary(Parameter::preload, 10, 500);
  problem.minimize("preload").limit("holding_torque >= 0.53 N.m");
  const DesignAnswer best = solve(problem);
  CHECK(best.search.outcome == optim::Outcome::optimal);
  // mu_0 F_N r = 0.53; feasibility is 1e-8 of the limit's change over the box, about 500 N.
  CHECK(best.motor.preload == Approx(0.53 / (0.2 * 0.0265)).epsilon(0).margin(1e-5));
  CHECK(best.search.design.at(0) == best.motor.preload);
}

TEST_CASE("a sized motor carries its duty within the limits", "[library]") {
  const std::vector<DutyPoint> duty{duty_point("0.5 N.m", "100 rpm"),
                                    duty_point("0.6 N.m", "40 rpm")};
  const DesignAnswer best = size(question(), duty);
  REQUIRE(best.search.outcome == optim::Outcome::optimal);
  const Motor motor(best.motor);
  for (const DutyPoint& point : duty) {
    // Feasible to 1e-8 in units of the limit's change over the box, which is below 2 N.m.
    CHECK(motor.operating_point(point.speed).torque >= point.torque - 1e-7);
    const MetricRequest at{Metric::speed_at, Argument::torque, point.torque - 1e-7};
    CHECK(evaluate(motor, at).value >= point.speed);
  }
  CHECK(evaluate(motor, {Metric::no_load_speed}).value <=
        parse_quantity("180 rpm", {"rad/s", "1 rpm"}) + 1e-6);
}

TEST_CASE("the size study finds what size() finds", "[library]") {
  const StudyFile file = read_study_file(TWUM_SOURCE_DIR "/tests/package/size.yaml");
  const StudyResult result = run_study(file);
  const auto& answer = std::get<OptimizeResult>(result.answer);
  DesignProblem problem = question();
  problem.motor = file.motor.design;
  const DesignAnswer best = size(problem, duty_point("0.5 N.m", "100 rpm"));
  CHECK(result.outcome == "optimal");
  REQUIRE(answer.best.design.size() == 2);
  // Both certified to a stationarity of 1e-6.
  CHECK(answer.best.design[0].value == Approx(best.motor.preload).epsilon(1e-5));
  CHECK(answer.best.design[1].value == Approx(best.motor.stator.amplitude).epsilon(1e-5));
}

TEST_CASE("a front has one motor for each of its points", "[library]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque").maximize("no_load_speed");
  optim::ParetoOptions options;
  options.points = 5;
  const DesignFront front = solve_front(problem, options);
  REQUIRE(front.motors.size() == front.search.points.size());
  REQUIRE(front.motors.size() >= 3);
  for (std::size_t i = 0; i < front.motors.size(); ++i) {
    const double torque = evaluate(Motor(front.motors[i]), {Metric::stall_torque}).value;
    CHECK(torque == front.search.points[i].evaluation.values.at(0));
  }
}

TEST_CASE("two threads sizing at once find the same as one", "[library]") {
  const DutyPoint light = duty_point("0.4 N.m", "100 rpm");
  const DutyPoint heavy = duty_point("0.5 N.m", "100 rpm");
  const DesignAnswer alone[] = {size(question(), light), size(question(), heavy)};
  DesignAnswer together[2];
  {
    std::jthread one([&] { together[0] = size(question(), light); });
    std::jthread other([&] { together[1] = size(question(), heavy); });
  }
  for (int i = 0; i < 2; ++i) {
    CHECK(together[i].search.outcome == optim::Outcome::optimal);
    CHECK(together[i].search.design == alone[i].search.design);
    CHECK(together[i].search.evaluation.values == alone[i].search.evaluation.values);
    CHECK(together[i].search.counters.evaluations == alone[i].search.counters.evaluations);
  }
}

TEST_CASE("misuse says what was found and what would be right", "[library]") {
  const MotorDesign design;
  CHECK_THROWS_WITH(with(design, Parameter::thickness, -3e-4),
                    Contains("thickness") && Contains("at least 1e-08 m") && Contains("-0.0003"));
  MotorDesign thin = design;
  thin.layer.thickness = -3e-4;
  CHECK_THROWS_WITH(Motor(thin), Contains("thickness") && Contains("at least 1e-08 m"));
  const Motor motor(design);
  CHECK_THROWS_WITH(motor.operating_point(-1.01 * motor.wave_speed()),
                    Contains("rotor speed") && Contains("rad/s"));
  CHECK_THROWS_WITH(parse_metric("stal_torque"), Contains("unknown metric 'stal_torque'") &&
                                                     Contains("did you mean 'stall_torque'"));
  CHECK_THROWS_WITH(DesignProblem{}.limit("max_pressure <= 10 mm"), Contains("length"));
  CHECK_THROWS_WITH(duty_point("0.5 N", "100 rpm"), Contains("torque: ") && Contains("force"));
  CHECK_THROWS_WITH(duty_point("0.5 N.m", "100 mm"), Contains("speed: ") && Contains("length"));
  CHECK_THROWS_WITH(size(question(), std::span<const DutyPoint>{}),
                    Contains("at least one operating point"));
  CHECK_THROWS_WITH(solve(question()), Contains("objective"));
  CHECK_THROWS_AS(read_motor_file("no-such.yaml"), InputError);
}

TEST_CASE("the version has three numbers", "[library]") {
  int numbers[3];
  char rest = 0;
  CHECK(std::sscanf(version(), "%d.%d.%d%c", &numbers[0], &numbers[1], &numbers[2], &rest) == 3);
}
