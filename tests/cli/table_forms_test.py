# SPDX-License-Identifier: Apache-2.0
"""Tables and numbers in the forms in which people have them: read as meant, or refused with the right word."""
import program
from program import RING, twum


class Headings(program.Case):
    def evaluated(self, heading, value="120", status=0):
        done = twum("evaluate", RING, "--designs", "-", "--metrics", "preload, wavelengths", stdin=f"{heading},amplitude [um]\n{value},1.4\n".encode())
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_units_in_brackets_parentheses_and_behind_a_slash(self):
        for heading in ("preload [N]", "preload (N)", "preload / N", "motor.preload [N]", "F_N (N)", "Preload [N]"):
            self.assertIn(b",120,9,ok", self.evaluated(heading).stdout, heading)

    def test_what_is_nearly_a_parameter_is_copied_with_a_warning(self):
        for heading in ("preload in N", '"preload, N"', "FN [N]"):
            done = self.evaluated(heading)
            self.assertIn(b",160,9,ok", done.stdout, heading)
            self.assertIn("is only copied; did you mean 'preload [N]'?", done.stderr, heading)

    def test_a_letter_alone_is_refused_with_the_long_name_and_one_with_a_unit_is_told(self):
        self.assertIn("write 'wavelengths'", self.evaluated("n", "3", status=2).stderr)
        done = twum("evaluate", RING, "--designs", "-", "--metrics", "thickness", stdin=b"h [mm]\n0.2\n")
        self.assertIn("sets thickness", done.stderr)
        self.assertIn(b",2e-04,ok", done.stdout)

    def test_a_letter_alone_is_refused_in_measurements(self):
        self.write("points.csv", "n,speed [rpm],torque [N.m]\n1,85,0.765\n2,105,0.74\n3,125,0.4\n")
        study = self.write("fit.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: points.csv\n"
                                       "  variables: {kinetic_friction: {min: 0.05, max: 0.5}}\n")
        self.assertIn("write 'wavelengths'", self.refused("run", study, "-o", self.folder / "out"))


class Kinds(program.Case):
    def said(self, content):
        return self.refused("evaluate", RING, "--designs", self.write("t.csv", content), "--metrics", "preload")

    def read(self, content):
        """Rows that are computed, and what is said of the file."""
        done = twum("evaluate", RING, "--designs", self.write("t.csv", content), "--metrics", "preload")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.decode().splitlines(), done.stderr

    def test_a_spreadsheet_is_called_that(self):
        self.assertIn("is a spreadsheet", self.said(b"PK\x03\x04" + bytes(100)))
        self.assertIn("save it as CSV", self.said(b"PK\x03\x04" + bytes(100)))

    def test_other_encodings_and_line_ends_are_read_and_told(self):
        table = "note,preload [N],amplitude [µm]\nµ,120,1.4\n"
        for content, kind in ((table.encode("utf-16"), "text in UTF-16"), (table.encode("utf-16-be"), "text in UTF-16"),
                              (table.replace("\n", "\r").encode(), "carriage returns alone"),
                              (table.encode("latin-1"), "text in ISO 8859-1")):
            rows, said = self.read(content)
            self.assertEqual(rows[1], "µ,120,1.4,120,ok")
            self.assertIn(f"t.csv: read as: {kind}" if "carriage" not in kind else kind, said)
        rows, said = self.read(table.encode("utf-8-sig"))
        self.assertEqual((rows[1], said), ("µ,120,1.4,120,ok", ""))

    def test_other_separators_are_read_and_told(self):
        for content, kind in (('"preload [N]";"amplitude [um]"\n120;1,4\n', "columns separated by semicolons, decimal commas"),
                              ("preload [N];amplitude [um];\n120;1.4;\n", "columns separated by semicolons"),
                              ("preload [N]\tamplitude [um]\n120\t1.4\n", "columns separated by tabs")):
            rows, said = self.read(content)
            self.assertEqual(rows, ["preload [N],amplitude [um],preload [N],status", "120,1.4,120,ok"])
            self.assertIn(f"read as: {kind}\n", said)

    def test_parts_take_the_same_forms(self):
        self.write("parts.csv", '"preload";"friction.kinetic"\nN;\n150;0,19\n170;0,21\n'.encode("utf-16"))
        study = self.write("u.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: uncertainty\n  metrics: [holding_torque]\n  samples: 200\n  parts: parts.csv\n")
        done = twum("run", study, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("parts.csv is read as: text in UTF-16, columns separated by semicolons, a row of units on line 2, decimal commas", done.stderr + done.stdout.decode())
        with open(self.folder / "out/results.csv") as rows:
            drawn = {line.split(",")[0] for line in rows} - {"preload [N]"}
        self.assertEqual({value.rstrip() for value in drawn}, {"150", "170"})

    def test_headings_separated_otherwise_than_the_rows_are_refused(self):
        self.assertIn(":2: columns separated by commas, but the headings by semicolons",
                      self.said('"preload [N]";"amplitude [um]"\n120,1.4\n'))

    def test_lines_above_the_headings_and_a_row_of_units_are_read_and_told(self):
        rows, said = self.read("Logger,7\nSerial no.,A12\n\npreload,amplitude\nN,um\n120,1.4\n")
        self.assertEqual(rows, ["preload [N],amplitude [um],preload [N],status", "120,1.4,120,ok"])
        self.assertIn("read as: headings on line 4, a row of units on line 5", said)

    def test_a_comma_that_may_separate_thousands_is_refused_with_both_readings(self):
        done = twum("evaluate", RING, "--designs", self.write("t.csv", "frequency [Hz];preload [N]\n40,000;120\n"), "--metrics", "preload")
        self.assertIn("write '40.000' or '40000'", done.stdout.decode())
        self.assertEqual(done.returncode, 1)
        # Beside a comma that leaves no doubt it is a decimal one.
        rows, _ = self.read("amplitude [um];preload [N]\n1,400;0,5\n")
        self.assertEqual(rows[1], "1.400,0.5,0.5,ok")
        # Points and commas in one file contradict each other.
        done = twum("evaluate", RING, "--designs", self.write("t.csv", "amplitude [um];preload [N]\n1,4;120.5\n"), "--metrics", "preload")
        self.assertIn("'1,4' has a decimal comma; write '1.4'", done.stdout.decode())

    def test_remarks_are_skipped_in_designs_and_measurements_alike(self):
        table = self.write("t.csv", '# made on the "bench\npreload [N]\n# between\n120\n')
        self.assertEqual(self.ok("evaluate", RING, "--designs", table, "--metrics", "preload").splitlines()[1], "120,120,ok")

    def test_the_same_table_twice_is_refused_and_a_copy_is_noted(self):
        rows = "speed [rpm],torque [N.m]\n85,0.765\n105,0.74\n125,0.465\n"
        self.write("a.csv", rows), self.write("b.csv", rows)
        text = f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: [a.csv, %s]\n  starts: 1\n  variables: {{kinetic_friction: {{min: 0.05, max: 0.5}}}}\n"
        for again in ("a.csv", "./a.csv"):
            self.assertIn("would count twice", self.refused("run", self.write("s.yaml", text % again), "-o", self.folder / "o"))
        done = twum("run", self.write("s.yaml", text % "b.csv"), "-o", self.folder / "o")
        self.assertIn("b.csv holds the same numbers as a.csv", done.stderr)

    def test_rows_that_stand_twice_are_told(self):
        self.write("a.csv", "speed [rpm],torque [N.m]\n85,0.765\n105,0.74\n85,0.765\n125,0.465\n")
        self.write("b.csv", "speed [rpm],torque [N.m]\n105,0.74\n132,0.255\n")
        text = f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: %s\n  starts: 1\n  variables: {{kinetic_friction: {{min: 0.05, max: 0.5}}}}\n"
        done = twum("check", self.write("s.yaml", text % "[a.csv, b.csv]"))
        self.assertIn("a.csv: 1 of 4 numbers stands there twice (first: lines 2 and 4)", done.stderr)
        self.assertIn("b.csv: 1 of 2 numbers stands in a.csv, too (first: lines 3 and 2)", done.stderr)

    def test_signs_that_are_reversed_are_called_that(self):
        speeds, torques = (85, 105, 115, 125, 132), (0.765, 0.74, 0.66, 0.465, 0.255)
        for turn in (1, -1):
            rows = "".join(f"{turn * s},{-t}\n" for s, t in zip(speeds, torques))
            self.write("t.csv", "speed [rpm],torque [N.m]\n" + rows)
            study = self.write("s.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: t.csv\n  starts: 1\n"
                                         "  variables: {kinetic_friction: {min: 0.05, max: 0.5}, youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}}\n")
            done = twum("run", study, "-o", self.folder / "o", "--fresh")
            self.assertIn("look reversed", done.stdout.decode())
            self.assertNotIn("check the unit of", done.stdout.decode())


class Numbers(program.Case):
    def test_a_comma_before_three_digits_is_offered_both_ways(self):
        for value, words in (("frequency=40,000 Hz", "write '40.000 Hz' or '40000 Hz'"), ("preload=1,200.5 N", "write '1200.5 N'"),
                             ("preload=1.200,5 N", "write '1200.5 N'"), ("thickness=0,3 mm", "write '0.3 mm'"),
                             ("thickness=0,300 mm", "write '0.300 mm'"), ("preload=1,200,300 N", "write '1200300 N'")):
            self.assertIn(words, self.refused("check", RING, "--set", value))

    def test_two_ends_of_a_tolerance_need_a_distribution(self):
        study = self.write("u.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: uncertainty\n  variables: {{preload: {{min: 150 N, max: 170 N}}}}\n  metrics: [stall_torque]\n")
        self.assertIn("'distribution: uniform'", self.refused("check", study))


class Endings(program.Case):
    def test_an_ending_names_the_format_in_any_case_or_is_refused(self):
        self.ok("curve", RING, "--points", "3", "-o", self.folder / "c.CSV")
        self.assertTrue((self.folder / "c.CSV").read_text().startswith("speed [rad/s],"))
        self.ok("curve", RING, "--points", "3", "-o", self.folder / "run-1.5")
        for arguments in (("curve", RING, "-o", "c.xlsx"), ("evaluate", RING, "-o", "e.json"), ("datasheet", RING, "-o", "s.pdf"),
                          ("explore", RING, "-o", "p.pdf"), ("init", "motor", "-o", "m.json"), ("schema", "study", "-o", "s.html")):
            self.assertIn("expected the ending", self.refused(*arguments[:-1], self.folder / arguments[-1]))
            self.assertFalse((self.folder / arguments[-1]).exists())


if __name__ == "__main__":
    program.main()
