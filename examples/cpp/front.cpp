// SPDX-License-Identifier: Apache-2.0
// Computes the front of torque and speed: no design on it is worse than another one in both.
#include <twum/twum.hpp>

#include <cstdio>

int main() {
  using namespace twum::studies;
  DesignProblem problem{twum::MotorDesign{}};
  problem.vary(twum::Parameter::preload, 60, 300).vary(twum::Parameter::amplitude, 0.8e-6, 2.2e-6);
  problem.maximize("stall_torque").maximize("no_load_speed").limit("max_pressure <= 3 MPa");

  twum::optim::ParetoOptions options;
  options.points = 8;
  const DesignFront front = solve_front(problem, options);
  for (std::size_t i = 0; i < front.motors.size(); ++i) {
    const twum::optim::FrontPoint& point = front.search.points[i];
    std::printf("%s at %s with a preload of %s%s\n",
                engineering(point.evaluation.values[0], "N.m").c_str(),
                engineering(point.evaluation.values[1], "rad/s").c_str(),
                engineering(front.motors[i].preload, "N").c_str(),
                point.certificate.passed ? "" : " (not certified)");
  }
}
