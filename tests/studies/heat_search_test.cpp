// SPDX-License-Identifier: Apache-2.0
// Searches with temperatures as limits and metrics of the warm motor as goals.
#include <twum/core/steady_heat.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/optim/solve.hpp>
#include <twum/studies/motor_problem.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::studies;

TEST_CASE("a search keeps the motor cool, with a certificate (H6.1)", "[studies][heat]") {
  const MotorDesign motor = read_motor_file(TWUM_SOURCE_DIR "/examples/motors/warm-60.yaml").design;
  DesignProblem problem{motor, {}, {}, {}};
  problem.vary(Parameter::voltage, 110, 140).vary(Parameter::preload, 140, 200);
  problem.maximize("warm(speed_at(0.5 N.m))");
  problem.limit("stator_temperature_at(0.5 N.m) <= 57 degC");
  const optim::Result found = optim::solve(motor_problem(problem));
  CHECK(found.outcome == optim::Outcome::optimal);
  MotorDesign answer = motor;
  answer.stator.voltage = found.design.at(0);
  answer.preload = found.design.at(1);
  // The limit holds the answer, since more voltage is faster and hotter; kept to the tolerance of a limit, 1e-6 of 330 K.
  const double T = steady_heat(answer, {Argument::torque, 0.5}).temperatures.stator;
  CHECK(std::fabs(T - (57 + 273.15)) <= 1e-3);
}
