# SPDX-License-Identifier: Apache-2.0
"""verify and compare: results that hold, that do not, and that are none."""
import contextlib
import csv
import io
import json
import shutil
import sqlite3

import program
from program import RING

SWEEP = f"""twum: 1
motor: {RING}
study:
  kind: sweep
  variables: {{preload: [100 N, 160 N], amplitude: {{min: 1 um, max: 2 um, points: 3}}}}
  sampling: grid
  metrics: [stall_torque, no_load_speed]
"""
CURVE = f"twum: 1\nmotor: {RING}\nstudy: {{kind: curve, family: {{F_N: [100 N, 160 N]}}, points: 3}}\n"


class Results(program.Case):
    def run_study(self, name, text):
        self.write(f"{name}.yaml", text)
        self.ok("run", f"{name}.yaml", "-o", name, cwd=self.folder)
        return self.folder / name

    def test_results_hold(self):
        for name, text, rows in (("sweep", SWEEP, 6), ("curve", CURVE, 6)):
            folder = self.run_study(name, text)
            before = {path.name: path.read_bytes() for path in folder.iterdir()}
            said = self.ok("verify", folder)
            self.assertIn(f"{name} ({name}): holds", said)
            self.assertIn(f"{rows} of {rows} stored rows evaluated again", said)
            self.assertIn("bitwise equal", said)
            self.assertEqual(before, {path.name: path.read_bytes() for path in folder.iterdir()})

    def test_an_answer_as_markdown(self):
        folder = self.run_study("sweep", SWEEP)
        before = {path.name: path.read_bytes() for path in folder.iterdir()}
        said = self.ok("report", folder, "--format", "md")
        highest = json.loads((folder / "summary.json").read_text())["metrics"]["stall_torque"]["max"]
        self.assertTrue(said.startswith("# sweep\n\nsweep of designs of "), said[:60])
        self.assertRegex(said, rf"\n\| stall torque \| \S+ mN·m \| \S+ mN·m \| {1e3 * highest:.4g} mN·m \| 6 \|\n")
        self.ok("report", folder, "--format", "md", "-o", self.folder / "answer.md")
        self.assertEqual((self.folder / "answer.md").read_text(), said)
        self.assertEqual({path.name: path.read_bytes() for path in folder.iterdir()}, before)
        self.assertIn("-o belongs to --format md", self.refused("report", folder, "-o", self.folder / "page.html"))

    def test_samples_are_that_many(self):
        said = self.ok("verify", self.run_study("sweep", SWEEP), "--samples", "2", "--seed", "9")
        self.assertIn("2 of 6 stored rows evaluated again", said)

    def test_changed_summary_does_not_hold(self):
        folder = self.run_study("sweep", SWEEP)
        path = folder / "summary.json"
        summary = json.loads(path.read_text())
        summary["metrics"]["stall_torque"]["highest"]["metrics"]["no_load_speed"] *= 1 + 1e-9
        path.write_text(json.dumps(summary))
        done = program.twum("verify", folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(b"does NOT hold", done.stdout)
        self.assertIn(b"metrics.stall_torque.highest.metrics.no_load_speed is", done.stdout)

    def test_rows_of_another_motor_do_not_hold(self):
        folder = self.run_study("sweep", SWEEP)
        path = folder / "study.yaml"
        path.write_text(path.read_text().replace("kinetic: 0.2", "kinetic: 0.200000001")
                        .replace("static: 0.2", "static: 0.200000001"))
        done = program.twum("verify", folder)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr.encode())
        for row in range(6):
            self.assertIn(f"row {row}: stall_torque is".encode(), done.stdout)

    def test_a_record_that_was_changed_does_not_hold(self):
        # Full contact at 20 kN, which is noted.
        folder = self.run_study("sweep", SWEEP.replace("160 N", "20 kN"))
        path = folder / "summary.json"
        summary = json.loads(path.read_text())
        self.ok("verify", folder)
        for name, value, said in (("evaluations", 7, "evaluations is 7 there, but follows from the rows as 6"),
                                  ("model_notes", ["all is well"], "model_notes is"),
                                  ("failures", {"resonance": 1}, "failures.resonance is 1 there"),
                                  ("seed", 3, "seed is 3 there"),
                                  ("motor", "another", "motor is"),
                                  ("hash", "0123456789abcdef", "study.yaml: is not the study that was run")):
            with self.subTest(name):
                self.assertNotEqual(summary[name], value)
                path.write_text(json.dumps({**summary, name: value}))
                done = program.twum("verify", folder)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(said.encode(), done.stdout)

    def test_a_study_file_that_was_changed_does_not_hold(self):
        folder = self.run_study("sweep", SWEEP)
        path = folder / "study.yaml"
        path.write_text(path.read_text().replace("ring-60", "ring-61"))  # which changes no row
        done = program.twum("verify", folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(b"study.yaml: is not the study that was run", done.stdout)

    def test_rows_that_an_interrupted_study_lost_do_not_hold(self):
        folder = self.run_study("sweep", SWEEP)
        path = folder / "summary.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), "outcome": "interrupted", "evaluations": 7}))
        done = program.twum("verify", folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(b"results.db: holds 6 rows, but summary.json says 7 evaluations", done.stdout)

    def test_altered_row_is_damage(self):
        folder = self.run_study("sweep", SWEEP)
        with contextlib.closing(sqlite3.connect(folder / "results.db")) as database:
            database.execute('update evaluations set "no_load_speed [rad/s]" = 1 where "index" = 3')
            database.commit()
        self.assertIn("results.db", self.refused("verify", folder, status=3))

    def test_what_is_no_result(self):
        folder = self.run_study("sweep", SWEEP)
        self.assertIn("no such directory", self.refused("verify", self.folder / "none"))
        self.assertIn("no such directory", self.refused("compare", folder, self.folder / "none"))
        (self.folder / "empty").mkdir()
        self.assertIn("not a result directory", self.refused("verify", self.folder / "empty"))
        self.assertIn("no summary.json", self.refused("compare", folder, self.folder / "empty"))
        self.assertIn("two or more", self.refused("compare", folder))
        self.assertIn("--samples", self.refused("verify", folder, "--samples", "-1"))
        broken = self.folder / "broken"
        shutil.copytree(folder, broken)
        (broken / "summary.json").write_text("{")
        self.assertIn("damaged", self.refused("verify", broken, status=3))
        self.assertIn("damaged", self.refused("compare", folder, broken, status=3))
        shutil.copy(folder / "summary.json", broken)
        (broken / "results.db").write_bytes(b"no database at all, but long enough to be one" * 100)
        self.refused("verify", broken, status=3)
        shutil.copy(folder / "results.db", broken)
        (broken / "study.yaml").write_text("twum: 1\n")
        self.assertIn("stored study is damaged", self.refused("verify", broken, status=3))

    def test_compare(self):
        one = self.run_study("one", SWEEP)
        two = self.run_study("two", SWEEP.replace("160 N", "200 N"))
        curve = self.run_study("curve", CURVE)
        rows = json.loads(self.ok("compare", one, two, curve, "--format", "json"))["rows"]
        found = {(row["group"], row["name"]): row["values"] for row in rows}
        self.assertEqual(found["study", "kind"], ["sweep", "sweep", "curve"])
        summaries = [json.loads((folder / "summary.json").read_text()) for folder in (one, two)]
        self.assertEqual(found["max", "stall_torque"],
                         [summary["metrics"]["stall_torque"]["max"] for summary in summaries] + [None])
        table = list(csv.DictReader(io.StringIO(self.ok("compare", one, two, "--format", "csv"))))
        row = next(row for row in table if row["group"] == "max" and row["name"] == "stall_torque")
        self.assertEqual([float(row[str(one)]), float(row[str(two)])], found["max", "stall_torque"][:2])
        # 200 N for 160 N is a quarter more torque while the whole contact drives.
        line = next(line for line in self.ok("compare", one, two).splitlines()
                    if line.lstrip().startswith("max ") and "stall_torque" in line)
        self.assertRegex(line, r"\+2[0-9.]+ %$")
        rows = self.ok("compare", one, two, "--format", "markdown").splitlines()
        self.assertRegex(next(row for row in rows if row.startswith("| max | stall\\_torque |")), r"\| \+2[0-9.]+ % \|$")
        self.assertEqual({row.count("|") - row.count("\\|") for row in rows}, {len(rows[0].split(" | ")) + 1})


if __name__ == "__main__":
    program.main()
