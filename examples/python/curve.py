# SPDX-License-Identifier: Apache-2.0
"""Computes the torque-speed curve of a motor and the contact at one speed; with a file name, draws both."""
import sys

import twum

motor = twum.Motor(name="ring", contact_radius="26.5 mm", frequency="40 kHz", preload="140 N", thickness=0.3e-3)
print(f"stall torque {twum.engineering(motor.stall_torque, 'N.m')}, "
      f"no-load speed {twum.engineering(motor.no_load_speed, 'rad/s')}")

curve = motor.curve(points=11)
for speed, torque in zip(curve.speed, curve.torque):
    print(f"{twum.engineering(speed, 'rad/s'):>10} {torque:7.4f} N.m")

fields = motor.fields("110 rpm")
for state, begin, end in fields.zones:
    print(f"{state:>6} from {begin:+.3f} to {end:+.3f} rad")

if len(sys.argv) > 1:
    curve.plot().figure.savefig(sys.argv[1])
