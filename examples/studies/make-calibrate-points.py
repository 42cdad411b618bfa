#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes calibrate-points.csv: SYNTHETIC torque-speed points, the model plus seeded noise.

    make-calibrate-points.py TWUM     (the program, such as build/release/bin/twum)
"""
import json
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TRUTH = {"kinetic_friction": "0.23", "youngs_modulus": "2.2 GPa", "amplitude": "1.52 um"}
SPEEDS_RPM = [5 * i for i in range(1, 25)]
NOISE = 0.004  # standard deviation of a torque [N m]

command = [sys.argv[1], "curve", HERE.parent / "motors" / "ring-60.yaml", "--format", "json",
           "--speeds", ", ".join(f"{speed} rpm" for speed in SPEEDS_RPM)]
for name, value in TRUTH.items():
    command += ["--set", f"{name}={value}"]
curve = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

noise = random.Random(1)
remark = "# SYNTHETIC data, not measured: see make-calibrate-points.py"
lines = [remark, "speed [rpm],torque [mN.m],torque_sd [mN.m]"]
for rpm, point in zip(SPEEDS_RPM, curve["curve"], strict=True):
    torque = point["torque"] + noise.gauss(0, NOISE)
    lines.append(f"{rpm},{1000 * torque:.2f},{1000 * NOISE:g}")
(HERE / "calibrate-points.csv").write_text("\n".join(lines) + "\n")
