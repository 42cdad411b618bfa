# SPDX-License-Identifier: Apache-2.0
"""Computes exact derivatives of two thousand designs at once: the effect of a parameter all over its range."""
import numpy as np
import twum

random = np.random.default_rng(1)
designs = {
    "preload": random.uniform(60, 300, 2000),
    "amplitude": random.uniform(0.8e-6, 2.2e-6, 2000),
    "youngs_modulus": np.exp(random.uniform(np.log(0.5e9), np.log(20e9), 2000)),
}
speed = twum.gradients(twum.Motor(), designs, "no_load_speed")["no_load_speed"]
good = (speed.status == "ok") & (speed.smoothness != "undefined")
print(f"{good.sum()} of {good.size} have derivatives")
print("1 % more of a parameter changes the no-load speed by")
for name, values in designs.items():
    elasticity = (speed[name] * values / speed.value)[good]
    low, middle, high = np.quantile(elasticity, [0.05, 0.5, 0.95])
    print(f"  {name}: {middle:+.2f} %, in 9 of 10 designs between {low:+.2f} and {high:+.2f}")
