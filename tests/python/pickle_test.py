# SPDX-License-Identifier: Apache-2.0
"""Every class pickles by every protocol, and an object without a value is refused; both in programs of their own where an
error could end the interpreter."""
import concurrent.futures
import copy
import math
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import twum

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOTOR = twum.Motor(ROOT / "examples/motors/drive-60.yaml", thickness=0.3e-3 * math.pi / 3)
CLASSES = (twum.Motor, twum.DesignProblem, twum.OperatingPoint, twum.Derivative)


def problem():
    asked = twum.DesignProblem(twum.Motor()).vary("preload", "60 N", "300 N", scale="log", start=0.1 * 1000)
    asked.vary("amplitude", 0.8e-6, 2.2e-6).derive("contact_width", "0.15 * contact_radius")
    asked.choose("lining", {"soft": {"youngs_modulus": "2 GPa"}, "hard": {"youngs_modulus": 9e9}})
    return asked.maximize("peak_power").limit("no_load_speed >= 100 rpm").limit("max_pressure <= 10 MPa")


def same(one, other):
    """True if two values, or the public values of two objects, are the same to the last bit."""
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and all(map(same, one.tolist(), other.tolist()))
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, float):
        return one == other or (math.isnan(one) and math.isnan(other))
    if isinstance(one, twum.Motor):
        return (one.name, one.file_text()) == (other.name, other.file_text())
    if isinstance(one, twum.DesignProblem):
        return same(one.__getstate__(), other.__getstate__())
    if isinstance(one, (twum.OperatingPoint, twum.Derivative)):
        return same(*({name: getattr(x, name) for name in dir(x) if not name.startswith("_")} for x in (one, other)))
    return same(vars(one), vars(other)) if hasattr(one, "__dict__") else one == other


def solved(asked):
    return asked.solve(starts=2, max_evaluations=2000)


class Named(twum.Motor):
    """A class of a user's own with an attribute."""

    def __init__(self, shelf, **parameters):
        super().__init__(**parameters)
        self.shelf = shelf


class Pickling(unittest.TestCase):
    def test_every_class_by_every_protocol(self):
        motor = MOTOR.replace(preload=150)
        objects = [motor, twum.Motor(ROOT / "examples/motors/plate-60.yaml"), problem(), motor.point("100 rpm"),
                   motor.point("5000 rpm"), motor.gradients("peak_power")["peak_power"], motor.curve(points=5),
                   twum.Motor().curve(points=5), motor.fields("100 rpm", samples=20),
                   twum.gradients(motor, {"preload": [100.0, -1.0]}, "stall_torque")["stall_torque"],
                   problem().solve(starts=1, max_evaluations=300)]
        for one in objects:
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.subTest(type(one).__name__, protocol=protocol):
                    again = pickle.loads(pickle.dumps(one, protocol))
                    self.assertIs(type(again), type(one))
                    self.assertTrue(same(again, one))
            self.assertTrue(same(copy.deepcopy(one), one) and same(copy.copy(one), one))

    def test_the_comparison_tells_objects_apart(self):
        motor = MOTOR.replace(preload=150)
        for name in ("point", "fields"):
            self.assertFalse(same(getattr(motor, name)(10.0), getattr(motor, name)(10.1)))
        self.assertFalse(same(problem(), problem().limit("stall_torque >= 0.1 N.m")))

    def test_a_pickled_question_has_the_same_answer(self):
        again = pickle.loads(pickle.dumps(problem()))
        self.assertEqual(solved(again).design, solved(problem()).design)

    def test_errors_pickle_with_their_reason(self):
        for error in (twum.InputError("a"), twum.FileError("b"), twum.StoreError("c")):
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(again), str(again)), (type(error), str(error)))
        with self.assertRaises(twum.EvaluationError) as caught:
            twum.Motor(modal_damping=0).max_efficiency
        self.assertEqual(pickle.loads(pickle.dumps(caught.exception)).reason, "undefined")

    def test_a_class_derived_from_a_motor_keeps_its_attributes(self):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(Named("top", preload=140), protocol))
            self.assertEqual((type(again), again.shelf, again.preload), (Named, "top", 140))

    def test_a_state_of_something_else_is_refused(self):
        for kind in CLASSES:
            for state in ((), (1, {}), ("no motor", {}), ({}, {}), None):
                with self.subTest(kind.__name__, state=state), self.assertRaises((TypeError, ValueError, KeyError)):
                    kind.__new__(kind).__setstate__(state)

    def test_other_processes_answer(self):
        with concurrent.futures.ProcessPoolExecutor(2) as workers:
            for one, other in zip(workers.map(solved, [problem(), problem()]), [solved(problem())] * 2):
                self.assertTrue(same(one, other))


class WithoutValue(unittest.TestCase):
    def test_new_alone_is_refused_at_every_use(self):
        for kind in CLASSES:
            empty = kind.__new__(kind)
            for name in dir(kind):
                if name.startswith("__") and name not in ("__repr__", "__getstate__", "__reduce__", "__getitem__"):
                    continue
                with self.subTest(kind.__name__, name=name), self.assertRaisesRegex(TypeError, "__init__"):
                    taken = getattr(empty, name)
                    if name == "__repr__" and kind is not twum.Motor:
                        raise TypeError("__init__ is not asked by Python's own representation")
                    for arguments in ((), ("preload",), ("preload", 1, 2), ("preload", "1")):
                        try:
                            taken(*arguments)
                        except TypeError as error:
                            if "__init__" in str(error):
                                raise

    def test_no_use_of_them_ends_the_interpreter(self):
        script = ("import copyreg, pickle, twum\n"
                  "for kind in (twum.Motor, twum.DesignProblem, twum.OperatingPoint, twum.Derivative):\n"
                  "    for use in (lambda: kind.__new__(kind), lambda: object.__new__(kind), lambda: repr(kind.__new__(kind)),\n"
                  "                lambda: kind.__new__(kind).__reduce__(), lambda: copyreg._reconstructor(kind, object, None),\n"
                  "                lambda: twum.DesignProblem(kind.__new__(kind)), lambda: pickle.dumps(kind.__new__(kind), 0)):\n"
                  "        try: use()\n"
                  "        except TypeError: pass\n"
                  "twum.Motor().__reduce__()\n"
                  "print('alive')")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "alive\n", ""))


class Importing(unittest.TestCase):
    def test_without_the_compiled_part_the_import_says_what_to_build(self):
        sources = sorted((ROOT / "bindings/python/twum").glob("*.py"))
        with tempfile.TemporaryDirectory() as build:
            folder = pathlib.Path(build, "python/twum")
            folder.mkdir(parents=True)
            for source in sources:
                (folder / source.name).write_bytes(source.read_bytes())
            for there, words in ((False, "cmake --preset release"), (True, f"cmake --build {pathlib.Path(build).resolve()} --target twum_python")):
                if there:
                    pathlib.Path(build, "CMakeCache.txt").touch()
                done = subprocess.run([sys.executable, "-c", "import twum"], capture_output=True, text=True, timeout=60,
                                      env={"PYTHONPATH": str(folder.parent)})
                self.assertEqual(done.returncode, 1)
                self.assertIn("ImportError", done.stderr)
                self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
