# SPDX-License-Identifier: Apache-2.0
"""Results that vanish or change under a running study, or between two runs: nothing is lost without exit status 3."""
import os
import shutil
import signal

import program
from damage_survey import survey
from kill_study import results
from program import RING
from run_test import LARGE, Run

SEARCH = """twum: 1
motor: %s
study:
  kind: optimize
  variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 0.8 um, max: 2.2 um}}
  maximize: peak_power
  constraints: [no_load_speed >= 100 rpm]
  solver: {starts: 2}
"""


class UnderARunningStudy(Run):
    def harmed(self, harm):
        """Standard error of a run whose directory `out` is changed by harm(folder) while it is at work."""
        process = self.begin("out")
        harm(self.folder / "out")
        process.send_signal(signal.SIGCONT)
        _, errors = process.communicate(timeout=600)
        said = errors.decode()
        self.assertEqual(process.returncode, 3, said)
        self.assertEqual(said.count("twum: "), 1, said)
        self.assertIn(str(self.folder / "out"), said)
        return said

    def test_a_directory_that_is_removed(self):
        said = self.harmed(shutil.rmtree)
        self.assertIn("removed", said)
        self.assertFalse((self.folder / "out").exists())

    def test_a_directory_that_is_moved_keeps_what_it_had(self):
        expected = results(self.run_into("peace", samples=LARGE))
        said = self.harmed(lambda folder: folder.rename(self.folder / "moved"))
        self.assertIn("moved", said)
        self.assertFalse((self.folder / "out").exists())
        self.assertGreater(self.rows(self.folder / "moved/results.db"), 0)
        self.assertEqual(results(self.run_into("moved", samples=LARGE)), expected)

    def test_a_directory_in_whose_place_there_is_another(self):
        def replace(folder):
            folder.rename(self.folder / "moved")
            shutil.copytree(self.folder / "moved", folder)

        self.assertIn("replaced", self.harmed(replace))
        self.assertFalse((self.folder / "out/summary.json").exists())

    def test_a_database_that_is_removed_or_replaced(self):
        def replace(folder):
            shutil.copy(folder / "results.db", folder / "copy.db")
            (folder / "copy.db").rename(folder / "results.db")

        for harm in (lambda folder: (folder / "results.db").unlink(), replace):
            self.assertIn("results.db", self.harmed(harm))
            shutil.rmtree(self.folder / "out")

    def test_a_database_that_is_emptied(self):
        self.assertIn("results.db", self.harmed(lambda folder: os.truncate(folder / "results.db", 0)))

    def test_a_log_that_is_emptied(self):
        self.assertIn("results.db", self.harmed(lambda folder: os.truncate(folder / "results.db-wal", 0)))

    def test_results_that_cannot_be_put_in_their_place(self):
        for name in ("results.csv", "summary.json", "report.html"):
            with self.subTest(name):
                self.assertIn(f"{name}: cannot be written", self.harmed(lambda folder: (folder / name).mkdir()))
                shutil.rmtree(self.folder / "out")


class BetweenTwoRuns(Run):
    def test_a_database_that_is_emptied_is_not_begun_anew_unasked(self):
        folder = self.run_into("out")
        (folder / "results.db").write_bytes(b"")
        said = self.refused("run", self.study(), "-o", folder, status=3)
        self.assertIn("results.db: is empty", said)
        self.assertIn("--fresh", said)
        self.run_into("out", "--fresh")

    def test_a_study_file_that_is_damaged_is_written_again(self):
        folder = self.run_into("out")
        before = (folder / "study.yaml").read_bytes()
        (folder / "study.yaml").write_bytes(before[:100])
        self.run_into("out")
        self.assertEqual((folder / "study.yaml").read_bytes(), before)

    def test_random_damage_is_refused_or_does_no_harm(self):
        """Two of each kind; scripts/test-long.sh does 300."""
        for study in (self.study(2000), self.write("search.yaml", SEARCH % RING)):
            counts = survey(program.PROGRAM, study, count=10)
            self.assertEqual(sum(counts.values()), 10)


if __name__ == "__main__":
    program.main()
