# SPDX-License-Identifier: Apache-2.0
"""What a study has found: motor files, words on a fit, notes on the model."""
import json

import program
from program import RING

OPTIMIZE = f"""twum: 1
motor: {RING}
study:
  kind: optimize
  variables: {{preload: {{min: 60 N, max: 300 N}}, thickness: {{min: 0.1 mm, max: 1 mm}}}}
  maximize: peak_power
  constraints: [max_pressure <= 3 MPa]
"""
PARETO = (OPTIMIZE.replace("optimize", "pareto")
          .replace("maximize: peak_power", "objectives: [{maximize: peak_power}, {minimize: max_pressure}]\n  points: 5"))
CALIBRATE = f"""twum: 1
motor: {RING}
study: {{kind: calibrate, data: points.csv, variables: {{kinetic_friction: {{min: 0.05, max: 0.5}},
        youngs_modulus: {{min: 0.5 GPa, max: 20 GPa, scale: log}}}}}}
"""
POINTS = "speed [rpm],torque [{}]\n85,.765\n95,.765\n105,.755\n115,.720\n125,.595\n132,.410\n138,.165\n"


class Found(program.Case):
    def run_study(self, name, text, status=0, *options):
        done = program.twum("run", self.write(f"{name}.yaml", text), "-o", self.folder / name, *options)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def summary(self, name):
        return json.loads((self.folder / name / "summary.json").read_text())

    def curve(self, file):
        return json.loads(self.ok("curve", file, "--points", 2, "--format", "json"))


class MotorFiles(Found):
    def test_the_best_design_is_a_motor_file(self):
        done = self.run_study("one", OPTIMIZE)
        best = self.folder / "one/best.yaml"
        self.assertIn(f"motor file: {best}\n", done.stderr)
        self.assertIn("valid motor file", self.ok("check", best))
        found, again = self.summary("one")["best"], self.curve(best)
        for name, value in found["design"].items():
            self.assertEqual(again["motor"][name], value)  # all digits are in the file
        for name, value in found["metrics"].items():
            self.assertEqual(again["metrics"][name], value, name)

    def test_every_point_of_a_front_is_one(self):
        self.run_study("two", PARETO)
        points = self.summary("two")["front"]
        files = sorted((self.folder / "two/front").iterdir())
        self.assertEqual([file.name for file in files], [f"{i + 1:02}.yaml" for i in range(len(points))])
        for file, point in zip(files, points):
            motor = self.curve(file)["motor"]
            self.assertEqual({name: motor[name] for name in point["design"]}, point["design"])
        self.ok("verify", self.folder / "two")

    def test_a_run_anew_removes_what_it_made_and_nothing_else(self):
        self.run_study("two", PARETO)
        first, ninth, mine = (self.folder / "two/front" / name for name in ("01.yaml", "09.yaml", "mine.yaml"))
        before = first.read_bytes()
        for file in (first, ninth, mine):
            file.write_text("old")
        self.run_study("two", PARETO, 0, "--fresh")
        self.assertEqual(first.read_bytes(), before)
        self.assertFalse(ninth.exists())
        self.assertEqual(mine.read_text(), "old")

    def test_changed_files_do_not_hold(self):
        self.run_study("two", PARETO)
        for name, old, new, said in (("front/03.yaml", "preload: ", "preload: 1", "front/03.yaml: preload is not that of"),
                                     ("front/03.yaml", "motor:", "engine:", "front/03.yaml: "),
                                     ("results.csv", "ok", "OK", "results.csv: is not what results.db holds")):
            file = self.folder / "two" / name
            before = file.read_text()
            file.write_text(before.replace(old, new, 1))
            done = program.twum("verify", self.folder / "two")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(said, done.stdout.decode())
            file.write_text(before)
        (self.folder / "two/front/02.yaml").unlink()
        self.assertEqual(program.twum("verify", self.folder / "two").returncode, 1)

    def test_a_limit_at_zero_is_kept_as_closely_as_any(self):
        text = (OPTIMIZE.replace("maximize: peak_power", "minimize: no_load_speed")
                .replace("thickness: {min: 0.1 mm, max: 1 mm}", "amplitude: {min: 0.5 um, max: 2 um}")
                .replace("max_pressure <= 3 MPa", '"torque_at(120 rpm) >= 0 N.m"'))
        for solver in ("auto", "nlopt:cobyla"):
            done = self.run_study("zero", f"{text}  solver: '{solver}'\n", 0, "--fresh")
            self.assertNotIn(b"broken", done.stdout)
            self.assertTrue((self.folder / "zero/best.yaml").exists())

    def test_tolerances_of_a_front_name_a_motor_file_that_is_there(self):
        self.run_study("two", PARETO)
        study = self.write("spread.yaml", f"twum: 1\nmotor: {RING}\nstudy: {{kind: uncertainty, metrics: "
                           "[stall_torque], start: two, samples: 10,\n"
                           "  variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}}\n")
        said = self.refused("run", study, "-o", self.folder / "spread")
        self.assertIn("'motor: two/front/01.yaml'", said)
        self.assertTrue((self.folder / "two/front/01.yaml").exists())

    def test_none_where_no_limit_is_kept(self):
        text = OPTIMIZE.replace("max_pressure <= 3 MPa", "holding_torque >= 0.8 N.m").replace("300 N", "100 N")
        self.assertNotIn("motor file", self.run_study("no", text, 1).stderr)
        self.assertFalse((self.folder / "no/best.yaml").exists())


class Calibration(Found):
    def test_it_says_what_came_of_it(self):
        for unit, status, outcome in (("N.m", 0, "fitted"), ("mN.m", 1, "at-bounds"), ("kN.m", 1, "at-bounds")):
            with self.subTest(unit):
                self.write("points.csv", POINTS.format(unit))
                self.run_study("fit", CALIBRATE, status, "--fresh")
                summary = self.summary("fit")
                self.assertEqual(summary["outcome"], outcome)
                self.assertEqual((self.folder / "fit/fitted.yaml").exists(), status == 0)
                self.assertEqual(any("check the unit" in note for note in summary["notes"]), status == 1)
                self.ok("verify", self.folder / "fit")


class Notes(Found):
    def test_a_thick_layer_is_noted(self):
        text = f"twum: 1\nmotor: {RING}\nset: {{thickness: 1 mm, contact_width: 1 mm}}\nstudy: {{kind: curve, points: 3}}\n"
        said = self.run_study("thick", text).stdout.decode()
        summary = self.summary("thick")
        length = 2 * summary["curves"][0]["metrics"]["contact_half_length"]
        note, = summary["model_notes"]
        self.assertTrue(note.startswith(f"thickness 1 mm is {round(0.1 / length)} % of the contact length"), note)
        self.assertIn(f"note: {note}\n", said)

    def test_of_a_family_the_worst_is_named(self):
        text = (f"twum: 1\nmotor: {RING}\nset: {{contact_width: 1 mm}}\n"
                "study: {kind: curve, family: {thickness: [0.2 mm, 0.9 mm, 1 mm]}, points: 3}\n")
        self.run_study("family", text)
        note, = self.summary("family")["model_notes"]
        self.assertTrue(note.startswith("motor with thickness 1 mm: thickness 1 mm is "), note)
        self.assertTrue(note.endswith("; the same for 1 other, to a smaller extent"), note)

    def test_of_equals_none_is_less(self):
        # Three amplitudes with one layer that is never open: full contact has no size.
        text = (f"twum: 1\nmotor: {RING}\nset: {{preload: 20 kN}}\n"
                "study: {kind: curve, family: {amplitude: [1.0 um, 1.5 um, 2.0 um]}, points: 3}\n")
        self.run_study("closed", text)
        note, = [note for note in self.summary("closed")["model_notes"] if "all round" in note]
        self.assertTrue(note.endswith("a real wave; the same for 2 others"), note)

    def test_a_search_from_a_thick_layer_names_the_limit_to_add(self):
        # 1 mm is 27 % of the contact length; the notes on what is found are about other motors.
        thick = OPTIMIZE.replace("study:", "set: {thickness: 1 mm}\nstudy:")
        size = (thick.replace("optimize", "size").replace("  maximize: peak_power\n", "  duty: [{torque: 0.1 N.m, speed: 20 rpm}]\n")
                .replace("constraints", "limits"))
        for name, text, entry in (("optimize", thick, "constraints"), ("size", size, "limits")):
            study = self.write(f"{name}.yaml", text)
            checked = program.twum("check", study).stderr
            self.assertEqual(checked.count("of the contact length"), 1)
            self.assertIn(f"no limit keeps the search from such layers: add 'layer_aspect <= 0.1' to '{entry}'", checked)
            done = self.run_study(name, text)
            self.assertIn("add 'layer_aspect <= 0.1'", done.stderr)
            self.assertFalse(any("layer_aspect <= 0.1" in note for note in self.summary(name)["model_notes"]))
        for kept in ("layer_aspect <= 0.1", "thickness <= 0.1 * 2 * contact_half_length"):
            study = self.write("kept.yaml", thick.replace("max_pressure <= 3 MPa", kept))
            self.assertNotIn("no limit keeps", program.twum("check", study).stderr)

    def test_a_note_stands_once_on_the_terminal(self):
        text = OPTIMIZE.replace("{preload:", "{wavelengths: {min: 8, max: 9}, preload:")
        done = self.run_study("waves", text)
        terminal = done.stderr + done.stdout.decode()
        self.assertEqual(terminal.count("a real ring has one frequency"), 1)
        self.assertTrue(any("a real ring has one frequency" in note for note in self.summary("waves")["model_notes"]))

    def test_a_usual_motor_has_none(self):
        self.run_study("usual", f"twum: 1\nmotor: {RING}\nset: {{contact_width: 1 mm}}\nstudy: {{kind: curve, points: 3}}\n")
        self.assertEqual(self.summary("usual")["model_notes"], [])


if __name__ == "__main__":
    program.main()
