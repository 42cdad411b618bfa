# SPDX-License-Identifier: Apache-2.0
"""Studies from Python: run, kept, read again, refused."""
import os
import pathlib
import tempfile
import unittest
import unittest.mock

import numpy as np
import twum

RING = pathlib.Path(__file__).resolve().parents[2] / "tests/data/motors/ring-60.yaml"
SWEEP = {"kind": "sweep", "sampling": "grid", "metrics": ["holding_torque", "max_pressure"],
         "variables": {"preload": ["100 N", "160 N", "220 N"]}}
OPTIMIZE = {"kind": "optimize", "minimize": "preload", "variables": {"preload": {"min": "10 N", "max": "500 N"}},
            "constraints": ["holding_torque >= 0.53 N.m"]}


class Study(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="twum test ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_a_sweep_is_arrays(self):
        result = twum.run(SWEEP, motor=RING)
        self.assertEqual((result.outcome, result["kind"]), ("done", "sweep"))
        preload = result.rows["preload"]
        self.assertEqual(preload.tolist(), [100, 160, 220])
        # mu_0 F_N r: a product of three.
        np.testing.assert_allclose(result.rows["holding_torque"], 0.2 * 0.0265 * preload, rtol=4e-16)
        self.assertEqual(set(result.rows["status"]), {"ok"})

    def test_a_motor_object_and_set(self):
        motor = twum.Motor(RING, kinetic_friction=0.1)
        result = twum.run(SWEEP, motor=motor, set={"contact_radius": 0.053, "thickness": "0.2 mm"})
        np.testing.assert_allclose(result.rows["holding_torque"], 0.1 * 0.053 * result.rows["preload"], rtol=4e-16)

    def test_an_optimum_and_its_certificate(self):
        result = twum.run(OPTIMIZE, motor=RING)
        self.assertEqual(result.outcome, "optimal")
        self.assertAlmostEqual(result["best"]["design"]["preload"], 0.53 / (0.2 * 0.0265), delta=1e-5)
        self.assertTrue(result["best"]["certificate"]["passed"])

    def test_a_metric_of_the_program(self):
        def grip(motor):
            return 0.2 * motor.preload * motor.contact_radius

        def slopes(motor):
            return {"preload": 0.2 * motor.contact_radius, "contact_radius": 0.2 * motor.preload}

        own = {**OPTIMIZE, "constraints": ["grip >= 530 N.mm"]}
        study = twum.Study(own, motor=RING, metrics={"grip": twum.OwnMetric(grip, slopes, "N.m")})
        study.check()
        result = study.run()
        self.assertEqual(result.outcome, "optimal")
        self.assertAlmostEqual(result["best"]["design"]["preload"], 0.53 / (0.2 * 0.0265), delta=1e-5)
        self.assertEqual(result["units"]["grip"], "N.m")
        self.assertIn("grip", result.rows)
        self.assertIn("grip", str(result))
        with self.assertRaisesRegex(twum.InputError, "which a study file cannot have"):
            study.run(self.folder / "out")
        with self.assertRaisesRegex(twum.FileError, "unknown metric 'grip'"):
            twum.run(own, motor=RING)

    def test_a_metric_without_unit_and_slopes(self):
        def cost(motor):
            return 2 + motor.preload / 100

        sweep = {**SWEEP, "metrics": ["cost", "holding_torque / cost"]}
        rows = twum.run(sweep, motor=RING, metrics={"cost": cost}).rows
        self.assertEqual(rows["cost"].tolist(), [3.0, 3.6, 4.2])

    def test_what_a_metric_raises_reaches_the_caller(self):
        def broken(motor):
            raise KeyError("price list")

        with self.assertRaises(KeyError):
            twum.run({**OPTIMIZE, "minimize": "broken", "solver": "nlopt:sbplx"}, motor=RING, metrics={"broken": broken})

        misspelt = twum.OwnMetric(lambda motor: motor.preload / 100, lambda motor: {"prelod": 0.01})
        with self.assertRaisesRegex(ValueError, "unknown parameter 'prelod'; did you mean 'preload'"):
            twum.run({**OPTIMIZE, "minimize": "cost"}, motor=RING, metrics={"cost": misspelt})

        def none(motor):
            raise twum.EvaluationError("not for sale")

        result = twum.run({**SWEEP, "metrics": ["none"]}, motor=RING, metrics={"none": none})
        self.assertEqual(set(result.rows["status"]), {"none: undefined"})

    def test_numbers_are_in_si_units(self):
        # The same study in texts and in numbers; a list, a range, an argument and a count among them.
        texts = {"kind": "sweep", "sampling": "grid", "metrics": ["holding_torque"],
                 "variables": {"preload": {"min": "100 N", "max": "300 N", "points": 3}, "contact_radius": ["20 mm", "30 mm"]}}
        si = {**texts, "variables": {"preload": {"min": 100, "max": np.float64(300.0), "points": 3},
                                     "contact_radius": np.array([0.02, 0.03])}}
        expected, found = (twum.run(study, motor=RING).rows for study in (texts, si))
        for name, values in expected.items():
            self.assertEqual(found[name].tolist(), values.tolist())
        duty = {"kind": "size", "variables": {"preload": {"min": 60.0, "max": 300.0}}, "duty": [{"torque": 0.3, "speed": 1.0}]}
        best = twum.run(duty, motor=RING)
        self.assertEqual(best.outcome, "optimal")

    def test_a_run_without_a_directory_writes_no_file(self):
        with unittest.mock.patch.dict(os.environ, {"TMPDIR": str(self.folder)}):
            tempfile.tempdir = None
            self.addCleanup(setattr, tempfile, "tempdir", None)
            twum.run(SWEEP, motor=RING)
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_errors_speak_of_functions_instead_of_commands(self):
        twum.run(SWEEP, self.folder / "result", motor=RING)
        with self.assertRaises(twum.InputError) as other:
            twum.run(dict(SWEEP, metrics=["preload"]), self.folder / "result", motor=RING)
        with self.assertRaises(twum.InputError) as metric:
            twum.Motor().metrics("foo")
        self.assertIn("fresh=True", str(other.exception))
        self.assertIn("twum.metric_table()", str(metric.exception))
        for text in (str(other.exception), str(metric.exception)):
            for word in ("-o", "--fresh", "'twum "):
                self.assertNotIn(word, text)

    def test_what_is_kept_can_be_read_again(self):
        first = twum.run(SWEEP, self.folder / "result", motor=RING)
        again = twum.read_result(self.folder / "result")
        self.assertEqual(again.summary, first.summary)
        for name, values in first.rows.items():
            self.assertEqual(again.rows[name].tolist(), values.tolist())
        self.assertEqual(again.directory, str(self.folder / "result"))

    def test_a_file_is_run_as_it_stands(self):
        path = self.folder / "study.yaml"
        path.write_text(f"twum: 1\nmotor: {RING}\nstudy: {{kind: curve, points: 11}}\n")
        self.assertEqual(twum.run(path).outcome, "done")

    def test_progress_is_told(self):
        told = []
        study = dict(SWEEP, variables={"preload": {"min": "100 N", "max": "200 N", "points": 20000}})
        twum.run(study, motor=RING, progress=lambda done, total, best: told.append((done, total)))
        self.assertTrue(told)
        self.assertTrue(all(0 <= done <= total == 20000 for done, total in told), told[:3])

    def test_an_error_in_progress_ends_the_run(self):
        def progress(done, total, best):
            raise RuntimeError("enough")

        study = dict(SWEEP, variables={"preload": {"min": "100 N", "max": "200 N", "points": 200000}})
        with self.assertRaisesRegex(RuntimeError, "enough"):
            twum.run(study, motor=RING, progress=progress)

    def test_wrong_studies_say_all_that_is_wrong(self):
        with self.assertRaises(twum.FileError) as caught:
            twum.run({"kind": "sweep", "sampling": "grod", "metrics": ["peek"], "variables": {"preload": ["1 mm"]}}, motor=RING)
        for word in ("grod", "peek", "length"):
            self.assertIn(word, str(caught.exception))
        with self.assertRaisesRegex(twum.InputError, "no-such.yaml"):
            twum.run(self.folder / "no-such.yaml")
        with self.assertRaisesRegex(twum.InputError, "no result of a study"):
            twum.read_result(self.folder)


if __name__ == "__main__":
    unittest.main()
