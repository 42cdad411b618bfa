# SPDX-License-Identifier: Apache-2.0
"""Motor files through the program: check, init, schema, strange paths."""
import json
import re

import jsonschema
import yaml

import program
from program import RING, ROOT


class Check(program.Case):
    def test_all_examples_are_valid(self):
        for file in sorted((ROOT / "examples/motors").glob("*.yaml")):
            self.assertIn("valid motor file", self.ok("check", file))

    def test_every_wrong_file_is_refused_with_its_place(self):
        folder = ROOT / "tests/data/motor_errors"
        for file in sorted(folder.glob("*.yaml")):
            with self.subTest(file.name):
                expected = file.with_suffix(".txt").read_text()
                self.assertEqual(self.refused("curve", file.name, cwd=folder), expected)
                self.assertRegex(expected, rf"^{file.name}:\d+:\d+: ")
                self.refused("check", file)

    def test_files_that_cannot_be_read(self):
        self.assertIn("No such file", self.refused("check", self.folder / "absent.yaml"))
        self.assertIn("directory", self.refused("check", self.folder))
        self.assertIn("4 MiB", self.refused("check", "/dev/zero"))
        self.assertIn("empty", self.refused("check", "/dev/null"))

    def test_paths_with_blanks_and_other_letters(self):
        motor = self.write("mein Motor µ 電.yaml", (ROOT / "examples/motors/ring-60.yaml").read_bytes())
        self.ok("curve", motor, "--points", 3)
        self.ok("curve", motor.name, "--points", 3, "-o", "größe (1).txt", cwd=self.folder)
        self.assertTrue((self.folder / "größe (1).txt").read_text().startswith("ring-60"))

    def test_standard_input(self):
        with open(RING, "rb") as file:
            self.ok("check", "-", stdin=file.read())
        self.assertTrue(self.refused("check", "-", stdin=b"a: [").startswith("standard input:1:"))

    def test_files_that_a_study_names_are_read(self):
        study = self.write("c.yaml", f"twum: 1\nmotor: {RING}\nstudy: {{kind: calibrate, data: points.csv, "
                                     "variables: {kinetic_friction: {min: 0.1, max: 0.3}}}\n")
        done = program.twum("check", study)
        self.assertEqual(done.returncode, 0)
        self.assertIn("points.csv: does not exist yet", done.stderr)
        self.assertIn("expected a table of measured points", self.refused("run", study, "-o", self.folder / "fit"))
        self.write("points.csv", "speed,torqe\n1,2\n")
        self.assertIn("did you mean 'torque'?", self.refused("check", study))
        self.write("points.csv", "speed,torque\n1,0.8\n2,0.8\n")
        self.assertIn("valid study file", self.ok("check", study))

    def test_a_study_whose_points_are_missing_is_checked_all_the_same(self):
        text = f"twum: 1\nmotor: {RING}\nstudy: {{kind: calibrate, data: %s, variables: {{%s}}}}\n"
        study = self.write("c.yaml", text % ("points.csv", "wavelengths: {min: 8, max: 10}"))
        self.assertIn("c.yaml:3:56: study.variables.wavelengths: only whole numbers", self.refused("check", study))
        study = self.write("c.yaml", text % ("x" * 5000, "kinetic_friction: {min: 0.1, max: 0.3}"))
        self.assertIn("File name too long", self.refused("check", study))

    def test_unlikely_values_are_noted_and_valid(self):
        done = program.twum("check", RING, "--set", "amplitude=1.2 mm", "--set", "thickness=2 mm")
        self.assertEqual(done.returncode, 0)
        self.assertIn("note: amplitude 1.2 mm is outside 50 nm to 5 um", done.stderr)
        self.assertIn("note: thickness 2 mm is ", done.stderr)
        self.assertIn(" % of the contact length", done.stderr)
        for value, said, unsaid in (("preload=0 N", "", "contact length"),
                                    ("preload=0.1 N", "thickness 300 um is 114 % of the contact length 262.4 um", "e+02"),
                                    ("amplitude=6 um", "tested (is its unit right?)\n", "; is its")):
            note = program.twum("check", RING, "--set", value).stderr
            self.assertIn(said, note)
            self.assertNotIn(unsaid, note)
        for motor in sorted((ROOT / "examples/motors").glob("*.yaml")):
            notes = program.twum("check", motor, "--set", "contact_width=1 mm").stderr
            if motor.name == "plate-30.yaml":  # where a search begins that asks for a motor that starts
                self.assertRegex(notes, r"\Anote: .* does not start by itself.*\nnote: the surface also moves radially, by 0.49 .*\n\Z")
            elif motor.name.startswith("plate"):
                self.assertRegex(notes, r"\A(note: .* does not start by itself.*\n)?note: the surface also moves radially, by 0.4\d? .* it changes "
                                        r"peak_power by .* %, torque at half no-load speed by .* %, .*'radial_motion: true'.*\n\Z")
            elif motor.name == "elastic-layer.yaml":  # a stator without damping, which any friction feeds
                self.assertRegex(notes, r"\Anote: the motor squeals under load .* and modal_damping is not given; .*\n\Z")
            else:
                self.assertEqual(notes, "")

    def test_a_plateau_that_squeals_is_noted(self):
        # Friction feeds a heavy rotor's backward wave most; a stator of enough damping takes all of it.
        heavy = ("check", RING, "--set", "radial_slices=8", "--set", "rotor_mass=1 kg")
        note = program.twum(*heavy).stderr
        self.assertRegex(note, "note: the motor squeals under load at speeds up to [0-9.]+ rpm: friction feeds a backward wave with up to "
                               r"[0-9.]+ N.s/m, more than the modal_damping of [0-9.]+ N.s/m; a heavy rotor")
        fed = re.search(r"with up to ([0-9.]+) N.s/m", note).group(1)
        for share, squeals in ((0.99, True), (1.01, False)):
            damped = program.twum(*heavy, "--set", f"modal_damping={share * float(fed)} N.s/m").stderr
            self.assertEqual("squeals" in damped, squeals)

    def test_a_width_that_matters_is_noted(self):
        self.assertRegex(program.twum("check", RING).stderr, "note: the width of the contact .* change peak_power by -5")
        for settled in ("contact_width=1 mm", "radial_slices=8"):
            self.assertEqual(program.twum("check", RING, "--set", settled).stderr, "")

    def test_entries_of_other_kinds_and_of_motor_files_are_recognized(self):
        text = "twum: 1\nmotor: {}\nstudy: {{kind: {}, {}: [stall_torque >= 1 N.m]}}\n"
        for kind, said, meant in (("optimize", "limits", "constraints"), ("pareto", "limits", "constraints"),
                                  ("size", "constraints", "limits"), ("uncertainty", "constraints", "limits")):
            study = self.write("s.yaml", text.format(RING, kind, said))
            self.assertIn(f"did you mean '{meant}'?", self.refused("check", study))
        self.assertIn("did you mean 'amplitude'?", self.refused("check", RING, "--set", "stator.amplitude=1 um"))
        self.assertIn("did you mean 'neutral_plane_distance'?",
                      self.refused("check", RING, "--set", "neutral_plane_dist=1 mm"))


    def test_a_frequency_study_beyond_the_resonance_of_a_coil_is_refused_before_it_runs(self):
        # 1.3 mH and 8.5 nF resonate at 47.9 kHz.
        text = (ROOT / "examples/motors/drive-60.yaml").read_text()
        self.write("coil.yaml", text.replace("  contact_layer:", "  driver: {inductance: 1.3 mH}\n  contact_layer:", 1))
        text = "twum: 1\nmotor: coil.yaml\nstudy: {kind: frequency, from: 38 kHz, to: %s}\n"
        self.assertEqual(program.twum("check", self.write("f.yaml", text % "43 kHz")).returncode, 0)
        study = self.write("f.yaml", text % "52 kHz")
        message = self.refused("check", study)
        self.assertIn("f.yaml:3:", message)
        self.assertIn("must end at", message)

    def test_every_wrong_study_is_refused_with_its_place(self):
        folder = ROOT / "tests/data/study_errors"
        for file in sorted(folder.glob("*.yaml")):
            with self.subTest(file.name):
                expected = file.with_suffix(".txt").read_text()
                self.assertEqual(self.refused("check", file.name, cwd=folder), expected)
                self.assertRegex(expected, r"^\S+\.yaml:\d+:\d+: ")


KINDS = ("curve", "sweep", "sensitivity", "optimize", "pareto", "size", "uncertainty", "calibrate", "frequency")


class Init(program.Case):
    def test_every_kind_of_study_is_valid_beside_its_motor(self):
        for motor in ("ring-60.yaml", "drive-60.yaml"):
            self.write(motor, (ROOT / "examples/motors" / motor).read_bytes())
        self.write("points.csv", "speed [rpm],torque [N.m]\n10,0.8\n120,0.7\n130,0.5\n")
        schema = jsonschema.Draft202012Validator(json.loads(self.ok("schema", "study")))
        for kind in KINDS:
            with self.subTest(kind):
                path = self.folder / f"{kind}.yaml"
                self.ok("init", kind, "-o", path)
                self.assertEqual(self.ok("check", path), f"{path}: a valid study file ({kind})\n")
                schema.validate(yaml.safe_load(path.read_text()))
                with open(path, "rb") as file:
                    said = self.ok("check", "-", stdin=file.read(), cwd=self.folder)
                self.assertIn(f"valid study file ({kind})", said)
                motor = "drive-60.yaml" if kind == "frequency" else "ring-60.yaml"
                text = self.ok("init", kind, "--motor", motor)
                self.assertIn(f"\nmotor: {motor} ", text)
                self.ok("check", self.write("named.yaml", text))

    def test_a_motor_under_a_voltage_varies_it(self):
        self.write("motor.yaml", (ROOT / "examples/motors/drive-60.yaml").read_bytes())  # 120 V
        for kind, line in (("optimize", "voltage: {min: 96 V, max: 144 V}"), ("sweep", "voltage: {min: 96 V, max: 144 V, points: 8}"),
                           ("curve", "voltage: [96 V, 120 V, 144 V]")):
            with self.subTest(kind):
                path = self.folder / f"{kind}.yaml"
                self.ok("init", kind, "--motor", "motor.yaml", "-o", path)
                self.assertIn(line, path.read_text())
                self.assertNotIn("amplitude:", path.read_text())
                self.assertNotIn("amplitude", program.twum("check", path).stderr)
        study = self.write("study.yaml", self.ok("init", "size", "--motor", "not-yet.yaml").replace("not-yet", "motor"))
        self.assertIn("note: amplitude varied: it replaces the motor's voltage", program.twum("check", study).stderr)

    def test_a_motor_is_named_whatever_its_path(self):
        for name in ("it's.yaml", "- dash.yaml", "a: b.yaml", "größe #1.yaml", "{x}.yaml", "null", "true"):
            with self.subTest(name):
                self.write(name, (ROOT / "examples/motors/ring-60.yaml").read_bytes())
                self.ok("check", self.write("study.yaml", self.ok("init", "curve", "--motor", name)))
        self.assertIn("--motor is for a study", self.refused("init", "motor", "--motor", "x.yaml"))

    def test_the_file_is_valid_and_not_overwritten(self):
        path = self.folder / "new.yaml"
        self.ok("init", "motor", "-o", path)
        self.ok("check", path)
        self.assertIn("exists already", self.refused("init", "motor", "-o", path))
        self.assertEqual(self.ok("init", "motor"), path.read_text())

    def test_a_driven_motor_to_start_from_is_the_example(self):
        self.assertEqual(self.ok("init", "motor", "--driven"), (ROOT / "examples/motors/drive-60.yaml").read_text())
        path = self.folder / "driven.yaml"
        self.ok("init", "motor", "--driven", "-o", path)
        self.assertIn("a valid motor file", self.ok("check", path))
        self.assertIn("--driven is for a motor file", self.refused("init", "optimize", "--driven"))


class Schema(program.Case):
    def setUp(self):
        super().setUp()
        schema = json.loads(self.ok("schema", "motor"))
        jsonschema.Draft202012Validator.check_schema(schema)
        self.validator = jsonschema.Draft202012Validator(schema)

    def test_examples_and_init_are_valid(self):
        for file in sorted((ROOT / "examples/motors").glob("*.yaml")):
            self.validator.validate(yaml.safe_load(file.read_text()))
        self.validator.validate(yaml.safe_load(self.ok("init", "motor")))

    def test_slices_of_a_found_motor_are_valid(self):
        motor = yaml.safe_load(self.ok("init", "motor"))
        for slices, valid in (("auto", True), ("auto 10", True), (8, True), ("atuo", False), ("auto 0", False), (0, False)):
            with self.subTest(slices):
                motor["motor"]["stator"]["radial_slices"] = slices
                self.assertEqual(self.validator.is_valid(motor), valid)

    def test_it_refuses_what_a_schema_can_see(self):
        for name in ("unknown-entry", "missing", "missing-section", "missing-alternative", "wrong-version", "both-alternatives",
                     "all-alternatives", "empty-value", "list-for-value", "value-for-section", "no-unit", "too-large", "fraction",
                     "zero-wavelengths", "negative-friction", "boolean", "not-a-number", "unit-on-a-number", "study-file",
                     "motor-is-a-path"):
            with self.subTest(name):
                text = (ROOT / f"tests/data/motor_errors/{name}.yaml").read_text()
                self.assertFalse(self.validator.is_valid(yaml.safe_load(text)))


class StudySchema(program.Case):
    def test_it_refuses_what_a_schema_can_see(self):
        schema = json.loads(self.ok("schema", "study"))
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        for name in ("unknown-kind", "missing-kind", "unknown-entry", "both-objectives", "no-objective",
                     "constraint-not-a-list", "unknown-variable", "variable-without-max", "variable-is-a-value",
                     "variable-and-alternative", "unknown-scale", "solver-option", "solver-fraction", "negative-seed",
                     "motor-is-a-list", "inline-motor-wrong", "family-not-a-list", "one-objective", "objective-is-text",
                     "unknown-distribution", "sampling-unknown", "no-metrics", "study-absent"):
            with self.subTest(name):
                text = (ROOT / f"tests/data/study_errors/{name}.yaml").read_text()
                self.assertFalse(validator.is_valid(yaml.safe_load(text)))


if __name__ == "__main__":
    program.main()
