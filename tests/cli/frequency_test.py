# SPDX-License-Identifier: Apache-2.0
"""frequency: sweeps, branches, jumps and the margin to the pull-out."""
import csv
import io
import json
import math

import program
from program import DRIVE, RING


class Frequency(program.Case):
    def answer(self, *arguments):
        return json.loads(self.ok("frequency", DRIVE, *arguments, "--format", "json"))

    def metric(self, name, *arguments):
        designs = self.write("one.csv", "preload [N]\n170\n")
        rows = list(csv.DictReader(io.StringIO(
            self.ok("evaluate", DRIVE, *arguments, "--designs", designs, "--metrics", name))))
        return float(next(value for column, value in rows[0].items() if column.startswith(name)))

    def test_without_preload_the_free_stator_is_swept(self):
        answer = json.loads(self.ok("frequency", DRIVE, "--set", "preload=0 N", "--points", "9", "--format", "json"))
        motor = answer["motor"]
        resonance = 2 * math.pi * motor["resonance_frequency"]
        for way in ("up", "down"):
            points = answer["sweeps"][way]["points"]
            self.assertEqual(len(points), 9)
            for point in points:
                omega = 2 * math.pi * point["frequency"]
                damping = resonance * motor["modal_mass"] / motor["quality_factor"]
                stiffness = complex(motor["modal_mass"] * (resonance ** 2 - omega ** 2), omega * damping)
                expected = motor["force_factor"] * math.sqrt(2) * motor["voltage"] / abs(stiffness)
                # A tolerance of the solver of 1e-11, of which 1e-9 is left at a sharp resonance.
                self.assertAlmostEqual(point["amplitude"] / expected, 1, delta=1e-8)
        self.assertIn("stator without rotor", self.ok("frequency", DRIVE, "--set", "preload=0 N", "--points", "3"))
        self.assertIn("cannot be carried with a preload of 0 N",
                      self.refused("frequency", DRIVE, "--set", "preload=0 N", "--torque", "0.1 N.m"))

    def test_at_rest_it_jumps_where_the_metrics_say(self):
        low = ("--set", "voltage=65 V")
        answer = self.answer(*low, "--speed", "0 rpm", "--points", 11)
        up, down = (answer["sweeps"][way]["jumps"] for way in ("up", "down"))
        self.assertEqual((len(up), len(down)), (1, 1))
        # Two searches for the same fold, each to 1e-12 of the frequency.
        self.assertAlmostEqual(up[0]["from"]["frequency"] / self.metric("start_frequency", *low), 1, delta=1e-10)
        pull_out = self.metric("pull_out_frequency", *low)
        self.assertAlmostEqual(down[0]["from"]["frequency"] / pull_out, 1, delta=1e-10)
        self.assertAlmostEqual(answer["pull_out_below"] / pull_out, 1, delta=1e-10)
        self.assertLess(up[0]["from"]["amplitude"], up[0]["to"]["amplitude"])
        self.assertGreater(down[0]["from"]["amplitude"], down[0]["to"]["amplitude"])

    def test_points_are_motors_of_their_frequency(self):
        answer = self.answer("--torque", "0.5 N.m", "--from", "40 kHz", "--to", "42 kHz", "--points", 5,
                             "--direction", "down")
        self.assertEqual(list(answer["sweeps"]), ["down"])
        points = answer["sweeps"]["down"]["points"]
        self.assertEqual([p["frequency"] for p in points], [42e3, 41.5e3, 41e3, 40.5e3, 40e3])
        for point in points:
            self.assertTrue(point["steady"])
            self.assertAlmostEqual(point["output_power"], point["torque"] * point["speed"], delta=1e-12)
            setting = f"frequency={point['frequency']} Hz"
            # The same wave by the motor's own curve, whose searches end at 1e-12.
            speed = self.metric("speed_at(0.5 N.m)", "--set", setting)
            self.assertAlmostEqual(point["speed"] / speed, 1, delta=1e-8)

    def test_points_have_the_backward_wave_of_the_metrics(self):
        elastic = ("--set", "shear_viscosity=0 Pa.s", "--set", "inertia=0 Pa.s^2", "--set", "rotor_mass=100 g",
                   "--set", "voltage_ratio=1.05", "--set", "phase_error=0.03 rad")
        arguments = ("--speed", "8 rad/s", "--from", "40.4 kHz", "--to", "41 kHz", "--points", 3, "--direction", "down")
        points = self.answer(*elastic, *arguments)["sweeps"]["down"]["points"]
        for point in points:
            there = (*elastic, "--set", f"frequency={point['frequency']} Hz")
            for column, metric in (("squeal_rate", "squeal_rate_at(8 rad/s)"),
                                   ("backward_ratio", "backward_ratio_at(8 rad/s)")):
                # Two searches for the same wave, to 1e-10 of its amplitude.
                self.assertAlmostEqual(point[column] / self.metric(metric, *there), 1, delta=1e-7)
            ratio = point["backward_ratio"]
            self.assertAlmostEqual(point["standing_wave_ratio"], (1 + ratio) / (1 - ratio), delta=1e-12)
            self.assertAlmostEqual(max(point["first_current"], point["second_current"]), point["phase_current"], delta=1e-12)
        self.assertIn("standing_wave_ratio", self.ok("frequency", DRIVE, *elastic, *arguments))
        equal = self.ok("frequency", DRIVE, *arguments)
        self.assertNotIn("standing_wave_ratio", equal)
        self.assertIn("not known", equal)  # where the layer, which has damping and inertia, sticks

    def test_formats_say_the_same(self):
        arguments = ("--points", 7, "--set", "voltage=80 V")
        answer = self.answer(*arguments)
        rows = list(csv.DictReader(io.StringIO(self.ok("frequency", DRIVE, *arguments, "--format", "csv"))))
        self.assertEqual(len(rows), 14)
        points = answer["sweeps"]["up"]["points"] + answer["sweeps"]["down"]["points"]
        for row, point in zip(rows, points):
            self.assertEqual(row["status"], "ok" if point["steady"] else "no-steady-wave")
            for column, cell in row.items():
                name = column.split(" [")[0]
                if name in point and cell:
                    self.assertEqual(float(cell), point[name])
        table = self.ok("frequency", DRIVE, *arguments)
        for words in ("pulls out below", "margin", "jump of the sweep up", "jump of the sweep down"):
            self.assertIn(words, table)
        for branch in answer["branches"]:
            rising = [a["frequency"] < b["frequency"] for a, b in zip(branch["points"], branch["points"][1:])]
            self.assertIn(len(set(rising)), (0, 1))

    def test_the_picture_is_the_same_every_time(self):
        for name in ("a.svg", "b.svg"):
            self.ok("frequency", DRIVE, "--plot", self.folder / name)
        picture = (self.folder / "a.svg").read_bytes()
        self.assertEqual(picture, (self.folder / "b.svg").read_bytes())
        for words in (b"frequency [kHz]", b"amplitude", b"pull-out below", b"current of a phase"):
            self.assertIn(words, picture)

    def test_what_cannot_be_swept_is_refused(self):
        self.assertIn("voltage", self.refused("frequency", RING))
        self.assertIn("below --to", self.refused("frequency", DRIVE, "--from", "42 kHz", "--to", "40 kHz"))
        self.assertIn("40 kHz", self.refused("frequency", DRIVE, "--from", "42 mm"))
        self.assertIn("whole number", self.refused("frequency", DRIVE, "--points", "1"))
        self.refused("frequency", DRIVE, "--direction", "sideways")
        self.refused("frequency", DRIVE, "--speed", "1 rpm", "--torque", "1 N.m")

    def test_a_load_that_is_too_large_has_no_answer(self):
        done = program.twum("frequency", DRIVE, "--torque", "5 N.m")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no steady wave", done.stderr)
        self.assertTrue(math.isclose(json.loads(program.twum(
            "frequency", DRIVE, "--torque", "5 N.m", "--format", "json").stdout)["load"]["torque"], 5))


if __name__ == "__main__":
    program.main()
