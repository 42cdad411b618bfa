# SPDX-License-Identifier: Apache-2.0
"""Every example runs, says something, and is short."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/python"


class Examples(unittest.TestCase):
    def said(self, name, *arguments):
        done = subprocess.run([sys.executable, "-W", "error::SyntaxWarning", EXAMPLES / name, *arguments],
                              capture_output=True, text=True, timeout=300, env=os.environ)
        self.assertEqual((done.returncode, done.stderr), (0, ""), name)
        return done.stdout

    def test_all_of_them_run(self):
        names = sorted(path.name for path in EXAMPLES.glob("*.py") if path.name != "dask_workers.py")
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

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "python3-distributed is not there")
    def test_two_workers_of_dask_find_the_same(self):
        self.assertEqual(self.said("dask_workers.py"), self.said("processes.py"))

    def test_the_median_of_a_tolerance_batch(self):
        # The stall torque is mu F_N r, so its median is that of the product of a uniform and a normal
        # variable: 0.2 * 160 * 0.0265 but for their spreads, both symmetric; 10^4 draws of a relative
        # spread of 10 % place a median within 0.2 %, five of those are 1 %.
        median = float(re.search(r"stall_torque: (\S+),", self.said("batch.py"))[1])
        self.assertAlmostEqual(median, 0.848, delta=0.0085)


if __name__ == "__main__":
    unittest.main()
