# SPDX-License-Identifier: Apache-2.0
"""heat and life: what becomes of a motor in use."""
import csv
import io
import json

import program
from program import DRIVE, ROOT

WARM = ROOT / "examples/motors/warm-60.yaml"
WORN = ROOT / "examples/motors/worn-60.yaml"
LOAD = ("--torque", "0.5 N.m")


class Heat(program.Case):
    def test_the_steady_state_is_what_evaluate_says(self):
        heat = json.loads(self.ok("heat", WARM, *LOAD, "--format", "json"))["heat"]
        self.assertEqual(heat["steady"]["status"], "ok")
        # docs/guide/heat.md shows it as printed by evaluate
        self.assertAlmostEqual(heat["steady"]["temperatures"]["stator"], 329.67003235813155, delta=1e-9)
        self.assertEqual(heat["steady"]["on_time"], {"status": "never-too-hot", "value": None})
        self.assertEqual([state["stable"] for state in heat["steady"]["states"]], [True])
        self.assertEqual(heat["cycle"]["status"], "ok")
        self.assertEqual(len(heat["cycle"]["phases"]), 2)

    def test_each_empty_cell_of_a_table_has_its_reason(self):
        metrics = ("--metrics", "on_time_at(0.5 N.m), on_time_at(1 N.m)")
        reasons = "on_time_at(0.5 N.m): never-too-hot; on_time_at(1 N.m): no-steady-temperature"
        self.assertIn(f",,{reasons}\n", program.twum("evaluate", WARM, *metrics).stdout.decode())
        designs = self.write("designs.csv", "preload [N]\n170\n")
        self.assertIn(f"170,,,{reasons}\n", program.twum("evaluate", WARM, "--designs", designs, *metrics).stdout.decode())

    def test_the_warm_up_is_a_table(self):
        rows = list(csv.DictReader(io.StringIO(
            self.ok("heat", WARM, *LOAD, "--time", "10 min", "--points", "5", "--format", "csv"))))
        self.assertEqual([float(row["time [s]"]) for row in rows], [0, 150, 300, 450, 600])
        stators = [float(row["stator_temperature [K]"]) for row in rows]
        self.assertEqual(stators, sorted(stators))
        self.assertAlmostEqual(stators[0], 293.15, delta=1e-9)

    def test_without_a_load_the_operation_is_told(self):
        text = self.ok("heat", WARM)
        self.assertIn("Over its operation", text)
        self.assertNotIn("Steady temperatures", text)

    def test_the_warm_up_is_drawn(self):
        picture = self.folder / "warm.svg"
        self.ok("heat", WARM, *LOAD, "--plot", picture)
        for words in ("limit of the housing", "stator", "time", "°C"):
            self.assertIn(words, picture.read_text())

    def test_what_cannot_be_is_refused(self):
        self.assertIn("give 'thermal' in the motor file", self.refused("heat", DRIVE, *LOAD))
        for options, expected in ((("--time", "0 s"), "--time: '0 s'; expected more than 0"),
                                  (("--torque", "1 W"), "--torque"),
                                  (("--torque", "1 N.m", "--speed", "0 rpm"), "--speed: '0 rpm'; expected more than 0")):
            self.assertIn(expected, self.refused("heat", WARM, *options))


class Life(program.Case):
    def test_the_life_is_what_evaluate_says(self):
        life = json.loads(self.ok("life", WORN, *LOAD, "--points", "3", "--format", "json"))["life"]
        self.assertEqual(life["end"]["limit"], "depth <= 100 um")
        designs = self.write("one.csv", "preload [N]\n170\n")  # as it is
        table = csv.DictReader(io.StringIO(self.ok("evaluate", WORN, "--designs", designs, "--metrics", "life_at(0.5 N.m)")))
        told = float(next(table)["life_at(0.5 N.m) [s]"])
        self.assertAlmostEqual(life["end"]["seconds"] / told, 1, delta=1e-12)

    def test_what_ends_a_life_is_told_with_its_limit(self):
        text = self.ok("life", WORN, *LOAD, "--points", "3", "--set", "preload_spring=0 N/mm")
        self.assertIn("it violates start_voltage <= 120 V", text)

    def test_the_margins_are_drawn(self):
        picture = self.folder / "life.svg"
        self.ok("life", WORN, *LOAD, "--points", "5", "--plot", picture)
        for words in ("remaining margin of each limit", "start voltage", "end"):
            self.assertIn(words, picture.read_text())

    def test_what_cannot_be_is_refused(self):
        self.assertIn("give 'wear' in the motor file", self.refused("life", DRIVE, *LOAD))
        self.assertIn("nothing loads the motor", self.refused("life", WORN))


if __name__ == "__main__":
    program.main()
