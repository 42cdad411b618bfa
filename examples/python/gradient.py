# SPDX-License-Identifier: Apache-2.0
"""Prints the change of two metrics for 1 % more of each parameter, from exact derivatives."""
import twum

motor = twum.Motor()
gradients = motor.gradients("peak_power", "torque_at(120 rpm)")
print(f"{'+1 % of':24}" + "".join(f"{name:>20}" for name in gradients))
for name, value in motor.parameters.items():
    changes = [value * g[name] / g.value for g in gradients.values()]
    if any(changes):
        print(f"{name:24}" + "".join(f"{change:+19.3f}%" for change in changes))
