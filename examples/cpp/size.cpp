// SPDX-License-Identifier: Apache-2.0
// Sizes a motor for two duties that its drive holds by the frequency, with the least electrical power at the first.
#include <twum/twum.hpp>

#include <cstdio>

int main() {
  using namespace twum::studies;
  using twum::Parameter;
  const twum::ParameterValue drive[] = {
      {Parameter::resonance_frequency, 39e3}, {Parameter::modal_mass, 0.025},
      {Parameter::quality_factor, 150},       {Parameter::force_factor, 0.55},
      {Parameter::frequency, 40.8e3},         {Parameter::voltage, 120}};
  DesignProblem problem{with(twum::MotorDesign{}, drive)};
  problem.vary("preload", "60 N", "300 N")
      .vary("voltage", "40 V", "150 V")
      .vary("thickness", "0.2 mm", "1 mm");
  problem.limit("holding_torque >= 0.6 N.m")
      .limit("drive_reserve_at(0.4 N.m, 60 rpm) >= 100 %")
      .minimize("electrical_power_at(0.4 N.m, 60 rpm)");

  const DutyPoint duties[] = {duty_point("0.4 N.m", "60 rpm"), duty_point("0.1 N.m", "120 rpm")};
  const DesignAnswer best = size(problem, duties, {}, DutyDrive::follows);
  std::printf("outcome %s\n", to_string(best.search.outcome));
  std::printf("preload %.6g N, voltage %.6g V, thickness %.6g m\n", best.motor.preload,
              *best.motor.stator.voltage, best.motor.layer.thickness);
  for (const DutyPoint& duty : duties)
    std::printf("%.6g Hz\n", held_point(best.motor, duty.torque, duty.speed).frequency);
  return best.search.outcome == twum::optim::Outcome::optimal ? 0 : 1;
}
