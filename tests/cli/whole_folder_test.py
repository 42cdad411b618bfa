# SPDX-License-Identifier: Apache-2.0
"""A directory of results holds what it needs: the files that the study named may change or vanish, and it can be moved."""
import shutil

import program
from program import RING, twum

POINTS = "speed [rpm],torque [N.m]\n85,0.765\n95,0.760\n105,0.740\n115,0.660\n125,0.465\n132,0.255\n138,0.055\n"
FIT = "  kind: calibrate\n  data: points.csv\n  starts: 2\n  variables: {kinetic_friction: {min: 0.05, max: 0.5}, youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}}\n"
SEARCH = "  kind: optimize\n  maximize: stall_torque\n  constraints: [max_pressure <= 3 MPa]\n  variables: {preload: {min: 60 N, max: 300 N}}\n  solver: {starts: 1}\n"
CHOICE = SEARCH + "  choose: {lining: [soft.yaml, hard.yaml]}\n"
PARTS = "  kind: uncertainty\n  metrics: [stall_torque]\n  samples: 20\n  parts: parts.csv\n"
FROM_FIRST = "  kind: uncertainty\n  metrics: [stall_torque]\n  samples: 20\n  start: first\n  variables: {preload: 3 %}\n"


class Whole(program.Case):
    def study(self, name, content):
        return self.write(f"work/{name}.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n{content}")

    def setUp(self):
        super().setUp()
        self.work = self.folder / "work"
        self.write_files()

    def write_files(self):
        self.work.mkdir(exist_ok=True)
        for name, text in (("points.csv", POINTS), ("soft.yaml", "contact_layer: {youngs_modulus: 1 GPa}\n"),
                           ("hard.yaml", "contact_layer: {youngs_modulus: 4 GPa}\n"), ("parts.csv", "preload [N]\n150\n160\n171\n")):
            self.write(f"work/{name}", text)

    def run_in(self, name, content):
        out = self.work / name
        self.run_study(self.study(name, content), out)
        return out

    def run_study(self, *arguments):
        done = twum("run", arguments[0], "-o", *arguments[1:])
        self.assertIn(done.returncode, (0, 1), done.stderr)  # whether a fit is good is no question here

    def moved(self, out):
        """The results, away from all that they were made of."""
        shutil.move(out, self.folder / "elsewhere")
        shutil.rmtree(self.work)
        return self.folder / "elsewhere"

    def test_results_are_read_where_nothing_else_of_the_study_is(self):
        for name, content, copies in (("fit", FIT, {"points.csv"}), ("choice", CHOICE, {"soft.yaml", "hard.yaml"}),
                                      ("parts", PARTS, {"parts.csv"}), ("first", SEARCH, set())):
            out = self.run_in(name, content)
            self.assertEqual({path.name for path in (out / "inputs").glob("*")}, copies)
            before = (out / "report.html").read_bytes()
            there = self.moved(out)
            self.assertIn("holds", self.ok("verify", there))
            self.ok("report", there)
            self.assertEqual((there / "report.html").read_bytes(), before, name)
            self.ok("plot", there, "-o", self.folder / "pictures")
            self.ok("compare", there, there)
            shutil.rmtree(there)
            self.write_files()

    def test_a_result_to_start_from_is_copied_too(self):
        self.run_in("first", SEARCH)
        there = self.moved(self.run_in("spread", FROM_FIRST))
        self.assertTrue((there / "inputs/first/summary.json").is_file())
        self.assertIn("holds", self.ok("verify", there))

    def test_a_changed_original_changes_nothing_and_a_changed_copy_is_refused_by_name(self):
        for name, content, file in (("fit", FIT, "points.csv"), ("choice", CHOICE, "hard.yaml"), ("parts", PARTS, "parts.csv")):
            out = self.run_in(name, content)
            before = (out / "report.html").read_bytes()
            text = (self.work / file).read_text()
            self.write(f"work/{file}", text.replace("150", "140").replace("4 GPa", "9 GPa").replace("0.740", "0.640"))
            self.ok("report", out)
            self.assertEqual((out / "report.html").read_bytes(), before)
            self.assertIn(f"the content of a file that the study names: {self.work / file}",
                          self.refused("run", self.work / f"{name}.yaml", "-o", out))
            self.write(f"work/{name}/inputs/{file}", (self.work / file).read_bytes())
            for command in ("report", "plot", "verify"):
                said = self.refused(command, out)
                self.assertIn(f"inputs/{file}: has changed since", said)
            self.write(f"work/{file}", text)

    def test_the_same_study_resumes_and_restores_its_copies(self):
        out = self.run_in("fit", FIT)
        (out / "inputs/points.csv").unlink()
        self.assertIn("points.csv", self.refused("report", out, status=3))
        self.run_study(self.work / "fit.yaml", out)
        self.assertEqual((out / "inputs/points.csv").read_text(), POINTS)
        self.assertIn("holds", self.ok("verify", out))

    def test_fresh_removes_the_copies_and_no_other_file(self):
        out = self.run_in("fit", FIT)
        self.write("work/fit/inputs/mine.txt", "mine")
        self.run_study(self.study("other", SEARCH), out, "--fresh")
        self.assertEqual([path.name for path in (out / "inputs").iterdir()], ["mine.txt"])

    def test_a_file_in_the_place_of_a_copy_is_not_overwritten(self):
        (self.work / "out/inputs").mkdir(parents=True)
        self.write("work/out/inputs/points.csv", "mine")
        self.assertIn("is no copy that twum made", self.refused("run", self.study("fit", FIT), "-o", self.work / "out"))
        self.assertEqual((self.work / "out/inputs/points.csv").read_text(), "mine")

    def test_a_study_may_name_files_of_its_own_directory_of_results(self):
        (self.work / "inputs").mkdir()
        shutil.move(self.work / "points.csv", self.work / "inputs/points.csv")
        study = self.study("fit", FIT.replace("points.csv", "inputs/points.csv"))
        self.run_study(study, self.work)
        self.assertIn("holds", self.ok("verify", self.work))
        self.run_study(study, self.work, "--fresh")
        self.assertEqual((self.work / "inputs/points.csv").read_text(), POINTS)


if __name__ == "__main__":
    program.main()
