# SPDX-License-Identifier: Apache-2.0
"""A user's program that mypy --strict accepts; see types_test.py."""
import threading

import numpy as np
import twum

motor = twum.Motor(preload=140.0, thickness="0.3 mm")
torque: float = motor.torque_at("100 rpm")
points = motor.curve(points=11)
power: float = float(points.output_power.max())
answer = twum.evaluate(motor, {"preload": np.linspace(60, 300, 3)}, "stall_torque", jobs=1)
largest: float = float(answer["stall_torque"].max())


def tell(done: int, total: int, best: str) -> None:
    print(done, total, best)


def solve() -> twum.Optimum:
    problem = twum.DesignProblem(motor).vary("preload", "60 N", 300.0, scale="log").minimize("preload")
    problem.limit("holding_torque >= 0.53 N.m")
    return problem.solve(solver="auto", starts=2, stop=threading.Event(), progress=tell)


def cost(of: twum.Motor) -> float:
    return 2e3 * of.contact_radius * of.contact_width


def cost_slopes(of: twum.Motor) -> dict[str, float]:
    return {"contact_radius": 2e3 * of.contact_width, "contact_width": 2e3 * of.contact_radius}


cheap = twum.DesignProblem(motor).vary("contact_radius", "20 mm", "30 mm").minimize(cost, gradient=cost_slopes)
cheap.limit("cost_again", cost, upper=0.25, gradient=cost_slopes)
smallest: float = cheap.solve(starts=1).objective["cost"]
units: dict[str, str] = {row["name"]: row["unit"] for row in twum.metric_table()}
lowest: float = twum.parameter_table()[0]["min"]
local: bool = not twum.solver_table()[0]["global"]

best = solve()
price: float = sum(one["multiplier"] for one in best.limits)
passed: bool = best.certificate["passed"]
findings: list[str] = best.certificate["findings"]
price_unit: str = best.limits[0]["price_unit"]
preload: float = best.design["preload"]
same: bool = best.motor == motor
result = twum.run({"kind": "curve", "points": 11}, motor=motor, progress=tell)
speeds = result.rows["speed"]
text: twum.Json = result["curves"]
cheapest = twum.run(
    {"kind": "optimize", "minimize": "price", "variables": {"contact_width": {"min": 2e-3, "max": 6e-3}}},
    motor=motor,
    metrics={"price": twum.OwnMetric(cost, gradient=cost_slopes)},
)
found = cheapest["best"]
assert found is not None
width: float = found["design"]["contact_width"]
settled: bool = found["certificate"]["passed"]
seed: int = cheapest["seed"]
print(torque, power, largest, preload, same, result.outcome, len(speeds))


def picture() -> None:
    axes = points.plot()
    axes.set_title("curve")
