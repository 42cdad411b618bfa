// SPDX-License-Identifier: Apache-2.0
// Finds the motor with the most power within limits by two solvers, and certifies each answer.
#include <twum/twum.hpp>

#include <cstdio>

int main() {
  using namespace twum::studies;
  DesignProblem problem{twum::MotorDesign{}};
  problem.vary(twum::Parameter::preload, 60, 300)
      .vary(twum::Parameter::amplitude, 0.8e-6, 2.2e-6)
      .vary(twum::Parameter::thickness, 0.1e-3, 1e-3, twum::optim::Scale::log);
  problem.maximize("peak_power");
  problem.limit("max_pressure <= 3 MPa").limit("wear_intensity_at(100 rpm) <= 8 kW/m^2");

  for (const char* solver : {"nlopt:slsqp", "ipopt"}) {
    if (!twum::optim::find_solver(solver).available) continue;
    const DesignAnswer best = solve(problem, {.solver = solver});
    const twum::optim::Certificate& certificate = best.search.certificate;
    std::printf("%s: %s, peak power %s\n", solver, to_string(best.search.outcome),
                engineering(best.search.evaluation.values.at(0), "W").c_str());
    std::printf("  preload %s, amplitude %s, thickness %s\n",
                engineering(best.motor.preload, "N").c_str(),
                engineering(best.motor.stator.amplitude, "m").c_str(),
                engineering(best.motor.layer.thickness, "m").c_str());
    std::printf("  stationary to %.0e, infeasible by %.0e\n", certificate.stationarity,
                certificate.infeasibility);
    for (const twum::optim::Activity& limit : certificate.limits) {
      if (limit.active) std::printf("  held by %s\n", limit.name.c_str());
    }
  }
}
