// SPDX-License-Identifier: Apache-2.0
// The most powerful motor whose lining costs at most 8, by a price of your own.
#include <twum/twum.hpp>

#include <cstdio>
#include <limits>
#include <numbers>

int main() {
  using namespace twum::studies;
  const auto cost = [](const twum::Motor& motor) {  // pure, and safe from several threads at once
    const auto of = [&](twum::Parameter each) { return get(motor.design(), each); };
    const double width = of(twum::Parameter::contact_width);
    return 2 + 1e4 * 2 * std::numbers::pi * of(twum::Parameter::contact_radius) * width;
  };
  DesignProblem problem{twum::MotorDesign{}};
  problem.vary("preload", "60 N", "300 N").vary("contact_width", "2 mm", "6 mm");
  problem.maximize("peak_power").limit("max_pressure <= 3 MPa");
  problem.limit("cost", cost, -std::numeric_limits<double>::infinity(), 8);
  // 'auto' needs derivatives, which this function does not have.
  const DesignAnswer best = solve(problem, {.solver = "nlopt:sbplx"});
  std::printf("%s: %.3f W at %.1f N, cost %.2f\n", to_string(best.search.outcome),
              best.search.evaluation.values.at(0), best.motor.preload,
              cost(twum::Motor(best.motor)));
  return best.search.outcome == twum::optim::Outcome::feasible ? 0 : 1;
}
