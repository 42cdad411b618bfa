# SPDX-License-Identifier: Apache-2.0
"""Every example runs, says something, and is short."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest
from unittest import mock

import numpy as np
import twum

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/python"
# Examples for packages that may be absent; Debian has none of the last two.
PACKAGES = {"dask_workers.py": "distributed", "openmdao_component.py": "openmdao", "pymoo_problem.py": "pymoo"}


def unless_absent(package):
    return unittest.skipUnless(importlib.util.find_spec(package), f"the Python package {package} is not there")


def module_of(example, **stand_ins):
    """An example as a module, with modules in place of those of a package."""
    named = {name.replace("__", "."): types.SimpleNamespace(**content) for name, content in stand_ins.items()}
    with mock.patch.dict(sys.modules, named):
        spec = importlib.util.spec_from_file_location(example, EXAMPLES / f"{example}.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module


class Examples(unittest.TestCase):
    def said(self, name, *arguments, **how):
        done = subprocess.run([sys.executable, "-W", "error::SyntaxWarning", EXAMPLES / name, *arguments],
                              capture_output=True, text=True, timeout=300, **how)
        self.assertEqual((done.returncode, done.stderr), (0, ""), name)
        return done.stdout

    def test_all_of_them_run(self):
        names = sorted(path.name for path in EXAMPLES.glob("*.py") if path.name not in PACKAGES)
        self.assertGreater(len(names), 6)
        for name in names:
            with self.subTest(name):
                self.assertTrue(self.said(name).strip())
                self.assertLess(len((EXAMPLES / name).read_text().splitlines()), 80)

    def test_a_picture_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            self.said("curve.py", f"{folder}/curve.png")
            self.assertTrue(pathlib.Path(folder, "curve.png").read_bytes().startswith(b"\x89PNG"))

    def test_the_fit_finds_what_the_points_were_made_with(self):
        # The points are those of mu = 0.18, E = 2.5 GPa, rounded to 5 mN.m: the intervals hold both.
        text = self.said("fit.py")
        for name, truth in (("kinetic_friction", 0.18), ("youngs_modulus", 2.5e9)):
            low, high = re.search(rf"{name} \S+ \((\S+) to (\S+)\)", text).groups()
            self.assertLess(float(low), truth)
            self.assertLess(truth, float(high))

    def test_two_processes_find_what_one_finds(self):
        # The largest power under a limit cannot fall as the limit rises.
        found = re.findall(r"^(\S+) MPa: optimal, (\S+) W$", self.said("processes.py"), re.MULTILINE)
        self.assertEqual([pressure for pressure, _ in found], ["1.5", "2", "2.5", "3"])
        powers = [float(power) for _, power in found]
        self.assertEqual(powers, sorted(powers))

    @unless_absent("distributed")
    def test_two_workers_of_dask_find_the_same(self):
        self.assertEqual(self.said("dask_workers.py"), self.said("processes.py"))

    @unless_absent("openmdao")
    def test_openmdao_finds_the_optimum_of_twum(self):
        with tempfile.TemporaryDirectory() as folder:
            text = self.said("openmdao_component.py", cwd=folder, env={**os.environ, "OPENMDAO_REPORTS": "0"})
        problem = twum.DesignProblem(twum.Motor()).vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
        best = problem.maximize("peak_power").limit("max_pressure <= 3 MPa").solve()
        # SLSQP stops at a relative change of 1e-6, and the limit, which it keeps to as much, moves the power by less.
        self.assertAlmostEqual(float(text.split()[1]) / best.objective["peak_power"], 1, delta=1e-5)

    @unless_absent("pymoo")
    def test_pymoo_finds_no_better_front(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertGreater(len(self.said("pymoo_problem.py", cwd=folder).splitlines()), 20)

    def component(self):
        class AnalysisError(Exception):
            pass

        api = {"ExplicitComponent": object, "AnalysisError": AnalysisError}
        example = module_of("openmdao_component", openmdao={"api": types.SimpleNamespace(**api)}, openmdao__api=api)
        return example.MotorComponent(), AnalysisError

    def test_partial_derivatives_for_openmdao_are_those_of_the_values(self):
        component, _ = self.component()
        at = {"preload": np.array([160.0]), "amplitude": np.array([1.6e-6])}
        partials = {}
        component.compute_partials(at, partials)

        def value(metric, **changed):
            outputs = {"peak_power": None, "max_pressure": None}
            component.compute({**at, **changed}, outputs)
            return outputs[metric]

        self.assertEqual(len(partials), 4)
        for (metric, parameter), slope in partials.items():
            # A central difference over 1e-4 of the value leaves out about 1e-8 of it; the metrics are exact to 1e-11, which
            # makes 1e-7 over this step.
            step = 1e-4 * at[parameter]
            ends = [value(metric, **{parameter: at[parameter] + side * step}) for side in (1, -1)]
            difference = (ends[0] - ends[1]) / (2 * step)
            self.assertAlmostEqual((slope / difference).item(), 1, delta=1e-6, msg=(metric, parameter))

    def test_openmdao_is_told_that_a_motor_has_no_value(self):
        component, error = self.component()
        with self.assertRaisesRegex(error, "preload must be at least 0 N, but is -1 N"):
            component.compute({"preload": np.array([-1.0]), "amplitude": np.array([1.6e-6])}, {"peak_power": None})

    def test_pymoo_is_told_which_motors_keep_the_limit(self):
        example = module_of("pymoo_problem", pymoo__algorithms__moo__nsga2={"NSGA2": None},
                            pymoo__core__problem={"Problem": object}, pymoo__optimize={"minimize": None})
        designs, out = np.array([[40.2e3, 80.0], [40.2e3, 240.0], [41.6e3, 80.0]]), {}
        example.MotorProblem._evaluate(None, designs, out)
        for (frequency, preload), objectives, limit in zip(designs, out["F"], out["G"]):
            motor = example.MOTOR.replace(frequency=frequency, preload=preload)
            found = list(motor.metrics(example.OBJECTIVES).values())
            with self.subTest(frequency=frequency, preload=preload):
                if np.isnan(found).any():
                    self.assertEqual([*objectives, limit], [np.inf] * 3)
                else:
                    self.assertEqual((-objectives).tolist(), found)
                    self.assertEqual(limit <= 0, motor.start_voltage <= motor.voltage)

    def test_the_median_of_a_tolerance_batch(self):
        # The stall torque is mu F_N r, so its median is that of the product of a uniform and a normal
        # variable: 0.2 * 160 * 0.0265 but for their spreads, both symmetric; 10^4 draws of a relative
        # spread of 10 % place a median within 0.2 %, five of those are 1 %.
        median = float(re.search(r"stall_torque: (\S+),", self.said("batch.py"))[1])
        self.assertAlmostEqual(median, 0.848, delta=0.0085)


if __name__ == "__main__":
    unittest.main()
