# SPDX-License-Identifier: Apache-2.0
"""Computes the front of torque and speed: no design on it is worse than another one in both."""
import twum

problem = twum.DesignProblem(twum.Motor()).vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
problem.maximize("stall_torque").maximize("no_load_speed").limit("max_pressure <= 3 MPa")
for point in problem.front(points=8):
    print(f"{point.objective['stall_torque']:.4f} N.m, {twum.engineering(point.objective['no_load_speed'], 'rad/s')}, "
          f"preload {point.motor.preload:.1f} N ({point.outcome})")
