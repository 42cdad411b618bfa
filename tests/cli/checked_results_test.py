# SPDX-License-Identifier: Apache-2.0
"""What a directory of results says is checked before it is believed: types, tables, links, pipes, files that have changed since."""
import json
import os
import re
import signal
import sqlite3
import subprocess
import time

import program
from program import DRIVE, RING, twum

SWEEP = """twum: 1
motor: %s
study:
  kind: sweep
  variables: {preload: {min: 100 N, max: 200 N}}
  sampling: lhs
  samples: 20
  metrics: [stall_torque]
"""
TAPERED = """twum: 1
motor:
  name: tapered
  stator: {wavelengths: 9, contact_radius: 26.5 mm, contact_width: 4 mm, radial_slices: 1, radial_shape: {exponent: 2, root: 1 mm},
    neutral_plane_distance: 3 mm, frequency: 40 kHz, amplitude: 1.6 um, modal_damping: 12 N.s/m, blocked_capacitance: 3 nF,
    loss_tangent: 0.01}
  contact_layer: {thickness: 0.3 mm, youngs_modulus: 3 GPa, poisson_ratio: 0.35, density: 1800 kg/m^3, loss_factor: 0.05}
  friction: {kinetic: 0.2}
  rotor: {taper: 1 mrad, mass: 30 g}
  preload: 160 N
"""


class Results(program.Case):
    def swept(self, name="out"):
        study = self.write("sweep.yaml", SWEEP % RING)
        self.ok("run", study, "-o", self.folder / name, "--fresh")
        return study, self.folder / name

    def changed_database(self, *statements):
        study, folder = self.swept()
        connection = sqlite3.connect(folder / "results.db")
        for statement in statements:
            connection.execute(statement)
        connection.commit()
        connection.close()
        return study, folder

    def damaged(self, study, folder):
        for arguments in (("run", study, "-o", folder), ("verify", folder), ("report", folder)):
            said = self.refused(*arguments, status=3, timeout=30)
            self.assertIn("damaged", said)


class Databases(Results):
    def test_a_value_of_another_type_is_damage(self):
        for column, value in (("stage", "x''"), ('"index"', "x'3139'"), ("status", "x'6f6b'"), ("checksum", "'1'")):
            with self.subTest(column):
                self.damaged(*self.changed_database(f'UPDATE OR REPLACE evaluations SET {column} = {value} WHERE "index" = 19'))

    def test_views_triggers_and_other_tables_are_damage(self):
        endless = ("ALTER TABLE evaluations RENAME TO e2",
                   "CREATE VIEW evaluations AS WITH RECURSIVE r(n) AS (SELECT 1 UNION ALL SELECT n+1 FROM r) "
                   "SELECT n AS stage, n AS \"index\", 1., 1., 'ok', 'ok', 'ok' FROM r")
        for statements in (endless, ("CREATE TABLE more (a)",),
                           ("CREATE TRIGGER t AFTER INSERT ON evaluations BEGIN SELECT 1; END",)):
            with self.subTest(statements[-1]):
                self.damaged(*self.changed_database(*statements))


class Summaries(Results):
    def test_wrong_types_and_depth_are_damage_in_our_own_words(self):
        _, folder = self.swept()
        summary = folder / "summary.json"
        good = json.loads(summary.read_text())
        texts = ['{"a":' * 50000 + "1" + "}" * 50000, '{"study":[1],"kind":{},"metrics":"x"}', "[]", "{", "",
                 *[json.dumps({**good, name: value}) for name in good for value in (7, "x", [1], {"a": 1}, None)]]
        for text in texts:
            summary.write_text(text)
            done = twum("verify", folder, timeout=30)
            said = done.stdout.decode() + done.stderr
            self.assertIn(done.returncode, (0, 1, 2, 3), said)
            self.assertNotIn("json.exception", said)
            self.assertNotIn("terminate called", said)

    def test_special_files_are_refused_at_once(self):
        _, folder = self.swept()
        summary = folder / "summary.json"
        summary.unlink()
        os.mkfifo(summary)
        self.assertIn("not an ordinary file", self.refused("verify", folder, status=3, timeout=10))
        summary.unlink()
        summary.symlink_to("/dev/zero")
        self.assertIn("not an ordinary file", self.refused("verify", folder, status=3, timeout=10))

    def test_a_pipe_without_a_writer_ends_and_one_with_a_writer_is_read(self):
        pipe = self.folder / "motor.yaml"
        os.mkfifo(pipe)
        self.assertIn("no program writes", self.refused("check", pipe, timeout=20))
        with subprocess.Popen(["sh", "-c", f'sleep 0.5; cat "{RING}" > "{pipe}"']):
            self.ok("check", pipe, timeout=20)


class Links(Results):
    def test_a_link_in_the_place_of_an_unfinished_file_is_not_followed(self):
        precious = self.write("precious", "precious\n")
        folder = self.folder / "out"
        folder.mkdir()
        (folder / "summary.json.part").symlink_to(precious)
        self.ok("run", self.write("sweep.yaml", SWEEP % RING), "-o", folder)
        self.assertEqual(precious.read_text(), "precious\n")
        self.assertFalse((folder / "summary.json").is_symlink())


class Motors(Results):
    def test_a_motor_file_keeps_what_one_slice_does_not_use(self):
        """Taper and shape come into use with more slices, as the note on one slice advises."""
        motor = self.write("motor.yaml", TAPERED)
        study = self.write("study.yaml", "twum: 1\nmotor: motor.yaml\nstudy:\n  kind: optimize\n"
                                         "  variables: {preload: {min: 100 N, max: 200 N}}\n  maximize: peak_power\n")
        self.ok("run", study, "-o", self.folder / "out")
        for name in ("best.yaml", "study.yaml"):
            text = (self.folder / "out" / name).read_text()
            for entry in ("taper: 0.001 rad", "exponent: 2", "root: 0.001 m", "blocked_capacitance", "loss_tangent"):
                self.assertIn(entry, text)
        self.ok("verify", self.folder / "out")
        best = self.folder / "out/best.yaml"
        preload = re.search(r"^  preload: (.*)$", best.read_text(), re.M).group(1)
        powers = [self.ok("evaluate", *file, "--set", "radial_slices=auto", "--metrics", "peak_power")
                  for file in ((best,), (motor, "--set", f"preload={preload}"))]
        self.assertEqual(*powers)

    def test_designs_of_a_sweep_hold_what_follows_from_the_variables(self):
        for variables, derived, name in (("kinetic_friction: [0.18, 0.22]", "static_friction: 1.05 * kinetic_friction", "static_friction"),
                                         ("contact_radius: [25 mm, 27 mm]", "contact_width: 0.1 * contact_radius", "contact_width")):
            study = self.write("sweep.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: sweep\n  variables: {{{variables}}}\n"
                                             f"  derived: {{{derived}}}\n  sampling: list\n  metrics: [stall_torque, holding_torque]\n")
            folder = self.folder / name
            self.ok("run", study, "-o", folder)
            lowest = json.loads((folder / "summary.json").read_text())["metrics"]["stall_torque"]["lowest"]
            self.assertIn(name, lowest["design"])
            self.ok("verify", folder)

    def test_the_motor_of_a_study_that_starts_from_another_is_that_ones_design(self):
        best = self.write("best.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: optimize\n  maximize: peak_power\n"
                                       "  variables: {amplitude: {min: 1 um, max: 2 um}, preload: {min: 60 N, max: 300 N}}\n"
                                       "  constraints: [max_pressure <= 3 MPa]\n")
        self.ok("run", best, "-o", self.folder / "best")
        found = json.loads((self.folder / "best/summary.json").read_text())["best"]["design"]
        spread = self.write("spread.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: uncertainty\n  start: best\n"
                                           "  variables: {preload: 3 %}\n  metrics: [stall_torque]\n  samples: 100\n")
        said = self.ok("run", spread, "-o", self.folder / "spread")
        self.assertIn("Varied: the design of 'best'", said)
        nominal = json.loads((self.folder / "spread/summary.json").read_text())["nominal"]["design"]
        self.assertEqual(nominal, {name: found[name] for name in nominal})
        self.assertEqual(set(nominal), set(found))
        page = (self.folder / "spread/report.html").read_text()
        self.assertIn(json.dumps(found["preload"]), page)
        again = self.write("again.yaml", best.read_text().replace("  kind: optimize", "  kind: optimize\n  start: best").replace("3 MPa", "2.5 MPa"))
        self.ok("run", again, "-o", self.folder / "again")
        before = json.loads((self.folder / "again/summary.json").read_text())["before"]["design"]
        self.assertEqual(before, {name: found[name] for name in before})


class Interruptions(Results):
    def test_an_interrupted_verification_leaves_nothing_behind(self):
        study = self.write("big.yaml", (SWEEP % RING).replace("samples: 20", "samples: 60000").replace("stall_torque", "max_pressure"))
        self.ok("run", study, "-o", self.folder / "big")
        scratch = self.folder / "tmp"
        scratch.mkdir()
        for pause in (0.05, 0.2, 0.5):
            process = subprocess.Popen([program.PROGRAM, "verify", self.folder / "big", "--samples", "1000000000"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env={**os.environ, "TMPDIR": str(scratch)})
            time.sleep(pause)
            asked = time.monotonic()
            process.send_signal(signal.SIGTERM)
            _, said = process.communicate(timeout=60)
            self.assertIn(process.returncode, (0, 130, -signal.SIGTERM), said)
            self.assertLess(time.monotonic() - asked, 10)
            self.assertEqual(list(scratch.iterdir()), [])


class Terminals(Results):
    def test_control_characters_in_names_do_not_reach_the_terminal(self):
        study, _ = self.swept()
        for arguments in (("check", "\x1b[31mnope"), ("run", study, "-o", self.folder / "\x1b[31md"),
                          ("report", self.folder / "\x1b[31mno"), ("curve", "\x1b]0;x\x07")):
            done = twum(*arguments)
            self.assertNotIn("\x1b", done.stderr)
            self.assertIn("\\x1b", done.stderr)


class ExitStatus(Results):
    def test_it_says_whether_all_limits_are_kept(self):
        search = f"twum: 1\nmotor: {RING}\nstudy:\n  kind: optimize\n  variables: {{preload: {{min: 60 N, max: 300 N}}}}\n  maximize: peak_power\n"
        cases = (("  solver: {name: ipopt, max_evaluations: 3, starts: 1, scan: 0}\n", 0, "budget"),
                 ("  constraints: [no_load_speed >= 1000 rpm]\n", 1, "infeasible"),
                 ("  constraints: [no_load_speed >= 1000 rpm]\n  solver: {max_evaluations: 3}\n", 1, None))
        for more, status, outcome in cases:
            done = twum("run", self.write("s.yaml", search + more), "-o", self.folder / "s", "--fresh")
            self.assertEqual(done.returncode, status, done.stdout.decode() + done.stderr)
            if outcome:
                self.assertEqual(json.loads((self.folder / "s/summary.json").read_text())["outcome"], outcome)
        done = twum("run", self.write("s.yaml", search + cases[0][0]), "-o", self.folder / "t", "--fresh")
        self.assertIn("max_evaluations", done.stdout.decode())
        self.assertNotIn("Restoration_Failed", done.stdout.decode())


class NeverDefined(Results):
    def checked(self, motor, study):
        return self.write("study.yaml", f"twum: 1\nmotor: {motor}\nstudy:\n{study}")

    def test_metrics_and_variables_that_no_motor_of_the_study_has(self):
        search = "  kind: optimize\n  variables: {preload: {min: 60 N, max: 300 N}}\n  maximize: peak_power\n"
        cases = ((RING, search + "  constraints: [start_voltage <= 100 V]\n", ":7:", "modal data"),
                 (RING, search.replace("preload: {min: 60 N, max: 300 N}", "voltage: {min: 50 V, max: 100 V}"), "variables.voltage", "needs"),
                 (RING, "  kind: sensitivity\n  method: sobol\n  variables: {preload: {min: 140 N, max: 180 N}}\n  metrics: [peak_power, hold_voltage]\n",
                  "metrics[1]", "modal data"),
                 (RING, search + "  constraints: [\"1.2 * mode_separation >= 1 kHz\"]\n", "mode_separation", "geometry"),
                 (DRIVE, search + "  constraints: [sensor_voltage_at(0 rpm) >= 1 V]\n", "sensor_voltage_at", "sensor"))
        for motor, text, place, need in cases:
            said = self.refused("check", self.checked(motor, text))
            self.assertIn(place, said)
            self.assertIn(need, said)
        self.ok("check", self.checked(DRIVE, search + "  constraints: [start_voltage <= 200 V]\n"))

    def test_an_end_of_a_range_with_an_unlikely_unit_is_noted_with_its_line(self):
        study = self.checked(RING, "  kind: optimize\n  variables:\n    amplitude: {min: 0.8 um, max: 2.2 mm}\n  maximize: peak_power\n")
        done = twum("check", study)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"study\.yaml:6: amplitude 2\.2 mm is outside .*did you mean '2\.2 um'\?")


if __name__ == "__main__":
    program.main()
