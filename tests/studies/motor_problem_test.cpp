// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"
#include "support/motor_files.hpp"

#include <twum/optim/solve.hpp>
#include <twum/studies/motor_problem.hpp>

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::studies;
using Catch::Matchers::WithinRel;

namespace {

MotorDesign ring() { return read_motor_file(test::motor_path("ring-60")).design; }

// Richardson's central difference of one response: its error is of fourth order in the step.
double difference(const optim::Problem& problem, std::vector<double> at, std::size_t response,
                  std::size_t variable) {
  const double step = 1e-3 * at[variable];
  const double middle = at[variable];
  const auto central = [&](double h) {
    at[variable] = middle + h;
    const double right = problem.evaluate(at, false).values.at(response);
    at[variable] = middle - h;
    return (right - problem.evaluate(at, false).values.at(response)) / (2 * h);
  };
  return (4 * central(step / 2) - central(step)) / 3;
}

// The Jacobian against differences, relative to the largest change of the response in any variable.
void expect_jacobian(const DesignProblem& question, const std::vector<double>& at,
                     double tolerance) {
  const optim::Problem problem = motor_problem(question);
  const optim::Evaluation e = problem.evaluate(at, true);
  REQUIRE(e.ok());
  const std::size_t n = at.size();
  for (std::size_t i = 0; i < problem.responses(); ++i) {
    double size = 0;
    for (std::size_t j = 0; j < n; ++j)
      size = std::max(size, std::fabs(e.jacobian[i * n + j] * at[j]));
    for (std::size_t j = 0; j < n; ++j) {
      CAPTURE(i, j);
      CHECK(std::fabs(e.jacobian[i * n + j] - difference(problem, at, i, j)) * at[j] <=
            tolerance * size);
    }
  }
}

}  // namespace

TEST_CASE("a question in five lines has the answer of the study file", "[studies][problem]") {
  DesignProblem problem{ring(), {}, {}, {}};
  problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
  problem.maximize("peak_power");
  problem.limit("no_load_speed >= 100 rpm").limit("max_pressure <= 5 MPa");
  const optim::Result best = optim::solve(motor_problem(problem));
  const test::Search study(test::study_of(
      "ring-60", "",
      "{kind: optimize, variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 0.8 um, "
      "max: 2.2 um}}, maximize: peak_power, "
      "constraints: [no_load_speed >= 100 rpm, max_pressure <= 5 MPa]}"));
  CHECK(best.outcome == optim::Outcome::optimal);
  CHECK(best.design.at(0) == test::value(study.optimum().best.design, "preload"));
}

TEST_CASE("the Jacobian of a question is that of differences", "[studies][problem]") {
  DesignProblem q{ring(), {}, {}, {}};
  q.vary(Parameter::amplitude, 1e-6, 2e-6).vary(Parameter::preload, 60, 300);
  q.vary(Parameter::thickness, 1e-4, 1e-3, optim::Scale::log)
      .vary(Parameter::youngs_modulus, 5e8, 2e10, optim::Scale::log);
  q.vary(Parameter::kinetic_friction, 0.1, 0.35).vary(Parameter::frequency, 3e4, 5e4);
  q.maximize("peak_power").limit("no_load_speed >= 100 rpm").limit("max_pressure <= 10 MPa");
  q.limit("wear_intensity_at(80 rpm) <= 5 kW/m^2").limit("efficiency_at(0.3 N.m) >= 0.1");
  q.limit("speed_at(0.3 N.m) >= 50 rpm").limit("shear_modulus <= 3 GPa");
  q.limit("shear_viscosity <= 1 kPa.s")
      .limit("inertia <= 1 Pa.s^2")
      .limit("static_friction <= 0.4");
  q.limit("poisson_ratio <= 0.4");
  // Differences are good to the step's fourth power, 1e-12 of it, times large higher derivatives where
  // zones meet, and to rounding over the step, 1e-12: 1e-6 leaves room for both.
  expect_jacobian(q, {1.7e-6, 170, 2.5e-4, 4e9, 0.21, 4.1e4}, 1e-6);
}

TEST_CASE("metrics at an unreachable load have a value with a gradient", "[studies][problem]") {
  // 60 N and mu = 0.2 carry 0.318 N.m.
  DesignProblem q{ring(), {}, {}, {}};
  q.vary(Parameter::preload, 40, 300).vary(Parameter::amplitude, 1e-6, 2e-6);
  q.vary(Parameter::kinetic_friction, 0.1, 0.3);
  q.maximize("efficiency_at(0.6 N.m)").limit("speed_at(0.6 N.m) >= 50 rpm");
  q.limit("wear_intensity_at(0.6 N.m) <= 5 kW/m^2").limit("output_power_at(0.6 N.m) >= 1 W");
  q.limit("stick_fraction_at(0.6 N.m) <= 1").limit("contact_efficiency_at(0.6 N.m) <= 1");
  q.limit("stator_power_at(0.6 N.m) <= 1 W").limit("friction_power_at(0.6 N.m) <= 1 W");
  q.limit("layer_loss_at(0.6 N.m) <= 1 W");
  const std::vector<double> weak{60, 1.6e-6, 0.2};
  const optim::Problem problem = motor_problem(q);
  const optim::Evaluation e = problem.evaluate(weak, true);
  REQUIRE(e.ok());
  // The implied limit says by how much the motor is too weak: mu F_N r = 0.318 N.m on the plateau.
  CHECK(problem.constraints.back().lower ==
        Approx(0.6).epsilon(1e-6));  // a little more, so that it is carried
  CHECK_THAT(e.values.back(), WithinRel(0.2 * 60 * 0.0265, 1e-9));
  // At that share of the largest torque the curve is steep, so differences are good to fewer digits.
  expect_jacobian(q, weak, 1e-4);
}

TEST_CASE("static friction below the kinetic one is infeasible, not a failure",
          "[studies][problem]") {
  DesignProblem q{ring(), {}, {}, {}};
  q.vary(Parameter::kinetic_friction, 0.1, 0.3).vary(Parameter::static_friction, 0.1, 0.4);
  q.maximize("stall_torque");
  const optim::Problem problem = motor_problem(q);
  REQUIRE(problem.constraints.size() == 1);
  const optim::Evaluation e = problem.evaluate(std::vector{0.25, 0.2}, true);
  REQUIRE(e.ok());
  CHECK_THAT(e.values.at(1), WithinRel(-0.05, 1e-12));
  CHECK(e.jacobian == std::vector<double>{e.jacobian[0], 0, -1, 1});
}

TEST_CASE("a question that cannot be posed is refused", "[studies][problem]") {
  DesignProblem q{ring(), {}, {}, {}};
  q.maximize("peak_power");
  CHECK_THROWS_AS(motor_problem(q), InputError);  // no variable
  q.vary(Parameter::poisson_ratio, 0.2, 0.4);
  CHECK_NOTHROW(motor_problem(q));
  DesignProblem alternatives = q;
  alternatives.vary(Parameter::shear_modulus, 1e9, 2e9);
  CHECK_THROWS_AS(motor_problem(alternatives), InputError);
  DesignProblem twice = q;
  twice.vary(Parameter::poisson_ratio, 0.2, 0.3);
  CHECK_THROWS_AS(motor_problem(twice), InputError);
  DesignProblem negative = q;
  negative.vary(Parameter::preload, -1, 100);
  CHECK_THROWS_AS(motor_problem(negative), InputError);
  DesignProblem repeated = q;
  repeated.limit("stall_torque >= 1 N.m").limit("stall_torque >= 1 N.m");
  CHECK_THROWS_AS(motor_problem(repeated), InputError);
  CHECK_THROWS_AS(q.limit("stall_torque > 1 N.m"), InputError);
}

TEST_CASE("a failure names the metric and the reason", "[studies][problem]") {
  // Without friction there is no torque at any speed, and no efficiency at the peak of no power.
  DesignProblem q{ring(), {}, {}, {}};
  q.vary(Parameter::kinetic_friction, 0, 0.3).maximize("torque_at_peak_power");
  const optim::Evaluation e = motor_problem(q).evaluate(std::vector{0.0}, false);
  CHECK(e.failure == "torque_at_peak_power: undefined");
}
