# SPDX-License-Identifier: Apache-2.0
"""Estimates friction and stiffness from measured torque-speed points by the study `calibrate`."""
import pathlib
import tempfile

import twum

MEASURED = """speed [rad/s],torque [N.m]
9,0.765
10,0.765
11,0.755
12,0.720
13,0.610
14,0.355
14.5,0.140
"""

with tempfile.TemporaryDirectory() as folder:
    points = pathlib.Path(folder) / "points.csv"
    points.write_text(MEASURED)
    result = twum.run(
        {
            "kind": "calibrate",
            "data": str(points),
            "variables": {
                "kinetic_friction": {"min": 0.05, "max": 0.5},
                "youngs_modulus": {"min": "0.5 GPa", "max": "20 GPa", "scale": "log"},
            },
        },
        motor=twum.Motor(),
    )
for name, estimate in result["estimates"].items():
    print(f"{name} {estimate['value']:.4g} ({estimate['low']:.4g} to {estimate['high']:.4g})")
print(f"residuals of {result['residual_rms']:.2g} N.m")
