# SPDX-License-Identifier: Apache-2.0
"""A motor as a problem of pymoo: the front of overall efficiency and torque at 100 rpm, of motors that start."""
import pathlib

import numpy as np
import twum
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.core.problem import Problem
from pymoo.optimize import minimize

MOTOR = twum.Motor(pathlib.Path(__file__).parents[1] / "motors/drive-60.yaml", radial_slices=1)
OBJECTIVES, LIMIT = ["overall_efficiency_at(100 rpm)", "torque_at(100 rpm)"], "start_voltage - voltage"


class MotorProblem(Problem):
    def __init__(self):
        super().__init__(n_var=2, n_obj=2, n_ieq_constr=1, xl=[40.2e3, 80], xu=[41.6e3, 250])

    def _evaluate(self, x, out, *args, **kwargs):
        designs = {"frequency": x[:, 0], "preload": x[:, 1]}  # [Hz], [N]
        found = twum.evaluate(MOTOR, designs, [*OBJECTIVES, LIMIT])
        answered = found["status"] == "ok"  # a design without a value keeps no limit
        out["F"] = np.transpose([np.where(answered, -found[metric], np.inf) for metric in OBJECTIVES])
        out["G"] = np.where(answered, found[LIMIT], np.inf)


if __name__ == "__main__":
    front = minimize(MotorProblem(), NSGA2(pop_size=40), ("n_gen", 50), seed=1)
    for design, objective in sorted(zip(front.X.tolist(), front.F.tolist())):
        print(f"{design[0]:.0f} Hz, {design[1]:.1f} N: efficiency {-objective[0]:.4f}, torque {-objective[1]:.4f} N.m")
