# SPDX-License-Identifier: Apache-2.0
"""Finds the motor with the most power within limits by two solvers, and certifies each answer."""
import twum

problem = twum.DesignProblem(twum.Motor())
problem.vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
problem.vary("thickness", "0.1 mm", "1 mm", scale="log")
problem.maximize("peak_power")
problem.limit("max_pressure <= 3 MPa").limit("wear_intensity_at(100 rpm) <= 8 kW/m^2")

available = {row["name"] for row in twum.solver_table() if row["available"]}
for solver in ("nlopt:slsqp", "ipopt"):
    if solver not in available:
        continue
    best = problem.solve(solver=solver)
    print(f"{solver}: {best.outcome}, peak power {best.motor.peak_power:.4f} W at {best.design}")
    print(f"  stationary to {best.certificate['stationarity']:.0e}, held by",
          [limit["text"] for limit in best.limits if limit["active"]])
