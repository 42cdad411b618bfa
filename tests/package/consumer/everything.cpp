// SPDX-License-Identifier: Apache-2.0
// Uses something behind each library that twum links: units, YAML, solvers. Prints the holding torque
// of the file named, and the preload that makes it as large as the second argument says.
#include <twum/twum.hpp>

#include <cstdio>

int main(int, char** argv) {
  const twum::MotorDesign motor = twum::studies::read_motor_file(argv[1]).design;
  const double wanted = twum::studies::parse_quantity(argv[2], {"N.m", "1 N.m"});

  twum::optim::Problem problem;
  problem.variables = {{.name = "preload", .lower = 10, .upper = 500}};
  problem.objectives = {{.name = "preload"}};
  problem.constraints = {{.name = "holding_torque", .lower = wanted}};
  problem.evaluate = [&](std::span<const double> x, bool) {
    const twum::Motor changed(with(motor, twum::Parameter::preload, x[0]));
    const double slope = changed.holding_torque() / x[0];
    return twum::optim::Evaluation{{x[0], changed.holding_torque()}, {1, slope}, {}, {}};
  };
  for (const char* solver : {"nlopt:slsqp", "ipopt"}) {
    if (!twum::optim::find_solver(solver).available) continue;
    const twum::optim::Result best = twum::optim::solve(problem, {.solver = solver});
    std::printf("%s %s %.9g\n", solver, to_string(best.outcome), best.design.at(0));
  }
  std::printf("twum %s %.9g\n", twum::version(), twum::Motor(motor).holding_torque());
}
