# SPDX-License-Identifier: Apache-2.0
"""Motor files through the program: check, init, schema, strange paths."""
import json

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


    def test_every_wrong_study_is_refused_with_its_place(self):
        folder = ROOT / "tests/data/study_errors"
        for file in sorted(folder.glob("*.yaml")):
            with self.subTest(file.name):
                expected = file.with_suffix(".txt").read_text()
                self.assertEqual(self.refused("check", file.name, cwd=folder), expected)
                self.assertRegex(expected, r"^\S+\.yaml:\d+:\d+: ")


KINDS = ("curve", "sweep", "sensitivity", "optimize", "pareto", "size", "uncertainty", "calibrate")


class Init(program.Case):
    def test_every_kind_of_study_is_valid_beside_its_motor(self):
        self.write("ring-60.yaml", (ROOT / "examples/motors/ring-60.yaml").read_bytes())
        schema = jsonschema.Draft202012Validator(json.loads(self.ok("schema", "study")))
        for kind in KINDS:
            with self.subTest(kind):
                path = self.folder / f"{kind}.yaml"
                self.ok("init", kind, "-o", path)
                self.assertEqual(self.ok("check", path), f"{path}: a valid study file ({kind})\n")
                schema.validate(yaml.safe_load(path.read_text()))

    def test_the_file_is_valid_and_not_overwritten(self):
        path = self.folder / "new.yaml"
        self.ok("init", "motor", "-o", path)
        self.ok("check", path)
        self.assertIn("exists already", self.refused("init", "motor", "-o", path))
        self.assertEqual(self.ok("init", "motor"), path.read_text())


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

    def test_it_refuses_what_a_schema_can_see(self):
        for name in ("unknown-entry", "missing", "missing-section", "missing-twin", "wrong-version", "both-twins",
                     "all-twins", "empty-value", "list-for-value", "value-for-section", "no-unit", "too-large", "fraction",
                     "zero-wavelengths", "negative-friction", "boolean", "not-a-number", "unit-on-a-number", "study-file"):
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
                     "variable-and-twin", "unknown-scale", "solver-option", "solver-fraction", "negative-seed",
                     "motor-is-a-list", "inline-motor-wrong", "family-not-a-list", "one-objective", "objective-is-text",
                     "unknown-distribution", "distribution-missing", "sampling-unknown", "no-metrics"):
            with self.subTest(name):
                text = (ROOT / f"tests/data/study_errors/{name}.yaml").read_text()
                self.assertFalse(validator.is_valid(yaml.safe_load(text)))


if __name__ == "__main__":
    program.main()
