// SPDX-License-Identifier: Apache-2.0
// Finds the motor for 0.5 N.m at 100 rpm within three limits that has the lowest pressure on its layer.
#include <twum/twum.hpp>

#include <cstdio>

int main() {
  using namespace twum::studies;
  DesignProblem problem{twum::MotorDesign{}};
  problem.vary(twum::Parameter::preload, 60, 300)
      .vary(twum::Parameter::amplitude, 0.8e-6, 2.2e-6)
      .vary(twum::Parameter::contact_width, 2e-3, 6e-3);
  problem.limit("wear_intensity_at(100 rpm) <= 5 kW/m^2")
      .limit("contact_efficiency_at(100 rpm) >= 0.6")
      .limit("no_load_speed <= 180 rpm");

  const DesignAnswer best = size(problem, duty_point("0.5 N.m", "100 rpm"));
  std::printf("outcome %s\n", to_string(best.search.outcome));
  std::printf("preload %.6g N\n", best.motor.preload);
  std::printf("amplitude %.6g m\n", best.motor.stator.amplitude);
  std::printf("contact_width %.6g m\n", best.motor.stator.contact_width);
  const twum::Motor motor(best.motor);
  std::printf("max_pressure %.6g Pa\n", motor.contact().max_pressure);
  return best.search.outcome == twum::optim::Outcome::optimal ? 0 : 1;
}
