# SPDX-License-Identifier: Apache-2.0
"""Finds the motor for 0.5 N.m at 100 rpm within three limits that has the lowest pressure on its layer."""
import sys

import twum

problem = twum.DesignProblem(twum.Motor())
problem.vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um").vary("contact_width", "2 mm", "6 mm")
problem.limit("wear_intensity_at(100 rpm) <= 5 kW/m^2").limit("contact_efficiency_at(100 rpm) >= 0.6")
problem.limit("no_load_speed <= 180 rpm")

best = problem.size(("0.5 N.m", "100 rpm"))
print("outcome", best.outcome)
for name, value in best.design.items():
    print(f"{name} {value:.6g}", "N" if name == "preload" else "m")
print(f"max_pressure {best.motor.max_pressure:.6g} Pa")
sys.exit(best.outcome != "optimal")
