# SPDX-License-Identifier: Apache-2.0
"""map: points, envelope and duty of a drive that follows."""
import csv
import io
import json
import math

import program
from program import DRIVE

ONE = ("--set", "radial_slices=1")


class Map(program.Case):
    def test_each_point_is_what_evaluate_says(self):
        answer = json.loads(self.ok("map", DRIVE, *ONE, "--points", "6x5", "--format", "json"))["map"]
        points = [p for p in answer["points"] if p["status"] == "ok" and p["torque"] > 0]
        self.assertGreater(len(points), 3)
        asked = ", ".join(f"electrical_power_at({p['torque']!r} N.m, {p['speed']!r} rad/s)" for p in points)
        designs = self.write("one.csv", "preload [N]\n170\n")  # as it is
        table = csv.DictReader(io.StringIO(self.ok("evaluate", DRIVE, *ONE, "--designs", designs, "--metrics", asked)))
        told = [float(value) for name, value in next(table).items() if name.startswith("electrical_power_at")]
        for point, value in zip(points, told, strict=True):
            # Either search ends at 1e-12 of the amplitude, with which the power goes in less than the fifth power.
            self.assertAlmostEqual(point["electrical_power"] / value, 1, delta=1e-11)

    def test_the_table_of_rows_has_all_points(self):
        rows = list(csv.DictReader(io.StringIO(
            self.ok("map", DRIVE, *ONE, "--points", "5x4", "--torque", "0.5 N.m", "--speed", "100 rpm", "--format", "csv"))))
        self.assertEqual(len(rows), 20)
        self.assertAlmostEqual(float(rows[-1]["torque [N.m]"]), 0.5)
        self.assertAlmostEqual(float(rows[-1]["speed [rad/s]"]), 100 * math.pi / 30)
        self.assertEqual({row["status"] for row in rows}, {"ok"})

    def test_duties_are_told_and_drawn(self):
        picture = self.folder / "map.svg"
        text = self.ok("map", DRIVE, *ONE, "--points", "12x10", "--duty", "0.5 N.m, 100 rpm", "--duty", "2 N.m, 10 rpm",
                       "--plot", picture)
        self.assertIn("It holds 1 of 2 duty points.", text)
        self.assertIn("not held: friction carries 1.036 N.m", text)
        drawn = picture.read_text()
        for words in ("500 mN·m at 100 rpm", "overall efficiency", "largest torque", "output power"):
            self.assertIn(words, drawn)

    def test_wrong_options_are_refused(self):
        for options, expected in (
                (("--points", "60"), "--points: '60'; expected the number of speeds and that of torques"),
                (("--torque", "0 N.m"), "--torque: '0 N.m'; expected more than 0"),
                (("--speed", "1 N.m"), "--speed"),
                (("--duty", "1 N.m"), "--duty: '1 N.m'; expected a torque and a speed"),
                (("--duty", "1 N.m, 0 rpm"), "--duty"),
                (("--quantity", "stall_torque"), "--quantity"),
                (("--quantity", "stator_temperature_at"), "--quantity: stator_temperature_at has no value for this motor"),
                (("--set", "voltage=0 V"), "--speed: the drive holds no speed without load")):
            self.assertIn(expected, self.refused("map", DRIVE, *options))


if __name__ == "__main__":
    program.main()
