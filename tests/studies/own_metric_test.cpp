// SPDX-License-Identifier: Apache-2.0
// Metrics that a program computes, in searches, fronts and sizes.
#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/value_error.hpp>
#include <twum/optim/check_derivatives.hpp>
#include <twum/optim/robust.hpp>
#include <twum/optim/solve.hpp>
#include <twum/studies/robust_question.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/sizing.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::studies;
using Catch::Contains;

namespace {

// The area of the track, 2 pi r b [m^2], which a price would be proportional to.
OwnMetric area() {
  constexpr double kTurn = 6.283185307179586;
  OwnMetric own{.name = "area", .unit = "m^2"};
  own.value = [](const Motor& motor) {
    const Stator& s = motor.design().stator;
    return kTurn * s.contact_radius * s.contact_width;
  };
  own.gradient = [](const Motor& motor) {
    const Stator& s = motor.design().stator;
    std::array<double, kParameterCount> gradient{};
    gradient[index_of(Parameter::contact_radius)] = kTurn * s.contact_width;
    gradient[index_of(Parameter::contact_width)] = kTurn * s.contact_radius;
    return gradient;
  };
  return own;
}

// The holding torque mu_0 F_N r (T7.8), which twum has as a metric too.
OwnMetric holding() {
  OwnMetric own{.name = "holding", .unit = "N.m"};
  own.value = [](const Motor& motor) { return motor.holding_torque(); };
  own.gradient = [](const Motor& motor) {
    return differentiate(motor, {Metric::holding_torque}).gradient;
  };
  return own;
}

DesignProblem free_track() {
  DesignProblem p{MotorDesign{}};
  p.vary(Parameter::contact_radius, 20e-3, 30e-3).vary(Parameter::contact_width, 2e-3, 6e-3);
  p.vary(Parameter::preload, 60, 300);
  return p;
}

constexpr double kNoLimit = optim::kInfinity;

}  // namespace

TEST_CASE("an own metric that twum has too leads to the same design", "[studies][own]") {
  DesignProblem own = free_track(), ours = free_track();
  own.maximize("peak_power").limit("max_pressure <= 3 MPa").limit(holding(), -kNoLimit, 0.7);
  ours.maximize("peak_power").limit("max_pressure <= 3 MPa").limit("holding_torque <= 0.7 N.m");
  const DesignAnswer a = solve(own), b = solve(ours);
  CHECK(a.search.outcome == optim::Outcome::optimal);
  CHECK(a.search.design == b.search.design);
  CHECK(a.search.certificate.limits[1].name == "holding <= 0.7 N.m");
  CHECK(a.search.certificate.limits[1].multiplier == b.search.certificate.limits[1].multiplier);
}

TEST_CASE("the gradient of an own metric is carried through derived parameters and friction",
          "[studies][own][differential]") {
  DesignProblem p{MotorDesign{}};
  p.vary(Parameter::contact_radius, 20e-3, 30e-3).vary(Parameter::kinetic_friction, 0.15, 0.19);
  p.vary(Parameter::static_friction, 0.2, 0.3);
  p.derive(Parameter::contact_width, "0.15 * contact_radius");
  p.minimize(area()).limit(holding(), 0.1, kNoLimit);
  for (const auto& one :
       optim::check_derivatives(motor_problem(p), std::vector{25e-3, 0.17, 0.25})) {
    CAPTURE(one.response, one.variable, one.given, one.difference);
    CHECK(one.agrees);
  }
}

TEST_CASE("an own metric is a goal of a front, and of a motor that reaches a duty",
          "[studies][own]") {
  DesignProblem p = free_track();
  p.minimize(area()).maximize("peak_power");
  optim::ParetoOptions few;
  few.points = 5;
  const DesignFront front = solve_front(p, few);
  REQUIRE(front.motors.size() == 5);
  for (std::size_t i = 0; i < front.motors.size(); ++i)
    CHECK(front.search.points[i].evaluation.values[0] == area().value(Motor(front.motors[i])));
  DesignProblem small = free_track();
  small.minimize(area());
  const DesignAnswer sized = size(small, duty_point("0.4 N.m", "60 rpm"));
  CHECK(sized.search.outcome == optim::Outcome::optimal);
  // The smallest track that carries the load is not the smallest one.
  CHECK(
      evaluate(Motor(sized.motor), {Metric::torque_at, Argument::speed, 6.283185307179586}).value >=
      0.4 * (1 - 1e-7));
}

TEST_CASE("an own metric without derivatives needs a solver without gradients", "[studies][own]") {
  OwnMetric off{.name = "off", .unit = "N^2.m^2"};
  off.value = [](const Motor& motor) { return std::pow(motor.holding_torque() - 0.53, 2); };
  DesignProblem p{MotorDesign{}};
  p.vary(Parameter::preload, 60, 300).minimize(off);
  CHECK_FALSE(motor_problem(p).derivatives);
  CHECK_THROWS_WITH(solve(p), Contains("needs derivatives"));
  const DesignAnswer found = solve(p, {.solver = "nlopt:sbplx"});
  CHECK(found.search.outcome == optim::Outcome::feasible);
  CHECK_THAT(found.search.certificate.reason, Contains("not measured"));
  // The preload 0.53 / (mu_0 r). A square is level to 1e-16 of its unit within 1e-8; the solver ends at 1e-4 of the range.
  CHECK(found.motor.preload ==
        Approx(0.53 / (0.2 * found.motor.stator.contact_radius)).epsilon(1e-3));
}

TEST_CASE("a function alone is a goal or a limit", "[studies][own]") {
  const auto torque = [](const Motor& motor) { return motor.holding_torque(); };
  DesignProblem p{MotorDesign{}};
  p.vary(Parameter::preload, 60, 300).maximize(torque).limit("half", torque, -kNoLimit, 0.53);
  CHECK(p.objectives[0].text() == "own");
  CHECK(p.limits[0].text == "half <= 0.53");
  const optim::Evaluation found = motor_problem(p).evaluate(std::vector{100.0}, false);
  CHECK(found.values[0] == torque(Motor(motor_of(p, std::vector{100.0}))));
  CHECK(found.values[1] == found.values[0]);
}

TEST_CASE("an own metric is a limit of motors that scatter, and a goal", "[studies][own][robust]") {
  const auto question = [](auto limit) {
    RobustQuestion asked{{MotorDesign{}}};
    asked.design.vary(Parameter::preload, 60, 300).minimize("max_pressure");
    limit(asked.design);
    asked.tolerances = {{.parameter = Parameter::kinetic_friction, .sd = Spread{0.03, true}}};
    asked.statistics = {parse_statistic_limit("yield >= 95 %")};
    return optim::solve_robust(robust_problem(asked));
  };
  const auto own = question([](DesignProblem& p) { p.limit(holding(), 0.4, kNoLimit); });
  const auto ours = question([](DesignProblem& p) { p.limit("holding_torque >= 0.4 N.m"); });
  CHECK(own.design == ours.design);
}

TEST_CASE("an own metric has a name of its own, an SI unit and a value", "[studies][own]") {
  OwnMetric own = area();
  own.name = "peak_power";
  CHECK_THROWS_WITH(expression_of(own), Contains("use another name"));
  own.name = "area of it";
  CHECK_THROWS_WITH(expression_of(own), Contains("letters, digits"));
  own = area();
  own.unit = "mm^2";
  CHECK_THROWS_WITH(expression_of(own), Contains("not an SI unit"));
  own = area();
  own.value = {};
  CHECK_THROWS_AS(expression_of(own), InputError);
  DesignProblem p{MotorDesign{}};
  CHECK_THROWS_AS(p.limit(area(), 2, 1), ValueError);
}

TEST_CASE("a motor without an own metric's value is a failed design", "[studies][own]") {
  OwnMetric own = area();
  own.value = [](const Motor& motor) {
    if (motor.design().preload > 100) throw EvaluationError("too-heavy", "not for sale");
    return 1.0;
  };
  DesignProblem p{MotorDesign{}};
  p.vary(Parameter::preload, 60, 300).minimize(own);
  const optim::Problem posed = motor_problem(p);
  CHECK(posed.evaluate(std::vector{90.0}, true).ok());
  CHECK(posed.evaluate(std::vector{110.0}, true).failure == "area: undefined");
}

TEST_CASE("no wrong sign of a metric's derivative is certified", "[studies][certificate]") {
  DesignProblem q{MotorDesign{}};
  q.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
  q.vary(Parameter::contact_radius, 20e-3, 30e-3);
  q.derive(Parameter::contact_width, "0.15 * contact_radius");
  q.maximize("peak_power").limit("max_pressure <= 3 MPa");
  const optim::Problem right = motor_problem(q);
  const optim::Result best = optim::solve(right);
  CHECK(best.certificate.passed);
  for (std::size_t entry = 0; entry < 6; ++entry) {
    optim::Problem wrong = right;
    wrong.evaluate = [&, entry](std::span<const double> x, bool gradient) {
      optim::Evaluation e = right.evaluate(x, gradient);
      if (gradient && e.ok()) e.jacobian[entry] *= -1;
      return e;
    };
    const optim::Result found = optim::solve(wrong);
    CAPTURE(entry, found.certificate.reason, found.evaluation.values);
    // The radius does not enter max_pressure where the width follows it, so a sign of nothing is no fault.
    CHECK((!found.certificate.passed ||
           found.evaluation.values[0] == Approx(best.evaluation.values[0]).epsilon(1e-6)));
  }
}
