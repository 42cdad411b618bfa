# SPDX-License-Identifier: Apache-2.0
"""Computes ten thousand designs at once with NumPy: the spread of two metrics under three tolerances."""
import numpy as np
import twum

random = np.random.default_rng(1)
designs = {
    "preload": random.normal(160, 8, 10_000),
    "amplitude": random.normal(1.6e-6, 0.05e-6, 10_000),
    "kinetic_friction": random.uniform(0.17, 0.23, 10_000),
}
answer = twum.evaluate(twum.Motor(), designs, ["stall_torque", "no_load_speed"])
good = answer["status"] == "ok"
print(f"{good.sum()} of {good.size} have an answer")
for name in ("stall_torque", "no_load_speed"):
    low, middle, high = np.quantile(answer[name][good], [0.05, 0.5, 0.95])
    print(f"{name}: {middle:.3f}, 90 % between {low:.3f} and {high:.3f}")
print(f"yield of stall_torque >= 0.8 N.m: {np.mean(answer['stall_torque'][good] >= 0.8):.3f}")
