# SPDX-License-Identifier: Apache-2.0
"""Sizes a motor for two duties that its drive holds by the frequency, with the least electrical power at the first."""
import sys

import twum

motor = twum.Motor(resonance_frequency="39 kHz", modal_mass="25 g", quality_factor=150, force_factor=0.55,
                   frequency="40.8 kHz", voltage="120 V")
problem = twum.DesignProblem(motor)
problem.vary("preload", "60 N", "300 N").vary("voltage", "40 V", "150 V").vary("thickness", "0.2 mm", "1 mm")
problem.limit("holding_torque >= 0.6 N.m").limit("drive_reserve_at(0.4 N.m, 60 rpm) >= 100 %")
problem.minimize("electrical_power_at(0.4 N.m, 60 rpm)")

duties = [("0.4 N.m", "60 rpm"), ("0.1 N.m", "120 rpm")]
best = problem.size(duties, drive="follows")
print("outcome", best.outcome)
print("preload {preload:.6g} N, voltage {voltage:.6g} V, thickness {thickness:.6g} m".format(**best.design))
for duty in duties:
    print(f"{best.motor.drive_frequency_at(*duty):.6g} Hz")
sys.exit(best.outcome != "optimal")
