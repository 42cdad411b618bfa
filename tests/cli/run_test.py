# SPDX-License-Identifier: Apache-2.0
"""twum run: the result directory, resuming, refusing, and what goes wrong with disks and processes."""
import json
import fcntl
import os
import pty
import re
import resource
import select
import shutil
import signal
import sqlite3
import struct
import subprocess
import termios
import time

import program
from kill_study import kill_often, results
from program import RING, twum

SWEEP = """twum: 1
motor: %s
study:
  kind: sweep
  variables:
    amplitude: {min: 0.8 um, max: 2.2 um}
    preload: {min: 60 N, max: 300 N}
  sampling: sobol
  samples: %d
  metrics: [stall_torque, no_load_speed, peak_power]
"""
SMALL, LARGE = 500, 40000


class Run(program.Case):
    def study(self, samples=SMALL, name="sweep.yaml", extra=""):
        return self.write(name, SWEEP % (RING, samples) + extra)

    def run_into(self, folder, *options, samples=SMALL):
        self.ok("run", self.study(samples), "-o", self.folder / folder, *options)
        return self.folder / folder

    def begin(self, folder, samples=LARGE):
        """A run that is held (SIGSTOP) with some of its rows stored; one that was too quick to be held is begun again."""
        command = [program.PROGRAM, "run", self.study(samples), "-o", self.folder / folder, "--jobs", "2"]
        for _ in range(50):
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            while process.poll() is None and self.rows(self.folder / folder / "results.db") == 0:
                time.sleep(0.01)
            process.send_signal(signal.SIGSTOP)
            if 0 < self.rows(self.folder / folder / "results.db") < samples:
                return process
            process.kill()
            _, errors = process.communicate()
            self.assertIn(process.returncode, (0, -signal.SIGKILL), errors)
            shutil.rmtree(self.folder / folder)
        self.fail("no run could be held before its end")

    def interrupted(self, name, number):
        """A run that the signal has ended after it wrote its results: its folder, and what it said on both streams. It ends within
        a second, and on a busy machine before it has written them; then another one is interrupted."""
        for attempt in range(20):
            folder = f"{name}-{attempt}"
            process = self.begin(folder)
            process.send_signal(number)
            process.send_signal(signal.SIGCONT)
            out, errors = process.communicate(timeout=600)
            self.assertEqual(process.returncode, 130, errors)
            if b", before all result files were written; the same command resumes the study\n" not in errors:
                return folder, out, errors
        self.fail("no interrupted run wrote its results")

    @staticmethod
    def rows(database):
        try:
            connection = sqlite3.connect(f"file:{database}?mode=ro", uri=True)
            with connection:
                return connection.execute("SELECT count(*) FROM evaluations").fetchone()[0]
        except sqlite3.Error:
            return 0

    def summary(self, folder):
        return json.loads((self.folder / folder / "summary.json").read_text())


class Directory(Run):
    def test_what_a_run_leaves(self):
        folder = self.run_into("out")
        self.assertEqual(sorted(p.name for p in folder.iterdir()),
                         ["report.html", "results.csv", "results.db", "study.yaml", "summary.json"])
        lines = (folder / "results.csv").read_text().splitlines()
        self.assertEqual(lines[0], "amplitude [m],preload [N],stall_torque [N.m],no_load_speed [rad/s],"
                                   "peak_power [W],status")
        self.assertEqual(len(lines), 1 + SMALL)
        summary = self.summary("out")
        self.assertEqual({k: summary[k] for k in ("study", "kind", "motor", "outcome", "evaluations", "failures")},
                         {"study": "sweep", "kind": "sweep", "motor": "ring-60", "outcome": "done",
                          "evaluations": SMALL, "failures": {}})
        self.assertIn(summary["version"], self.ok("--version"))
        self.assertGreater(summary["seconds"], 0)

    def test_the_table_holds_what_the_database_holds(self):
        folder = self.run_into("out")
        cells = [line.split(",") for line in (folder / "results.csv").read_text().splitlines()[1:]]
        rows = sqlite3.connect(folder / "results.db").execute(
            'SELECT "amplitude [m]", "preload [N]", "peak_power [W]", status FROM evaluations '
            'ORDER BY stage, "index"').fetchall()
        self.assertEqual([(float(c[0]), float(c[1]), float(c[4]), c[5]) for c in cells], rows)

    def test_the_default_directory_is_named_like_the_study(self):
        done = twum("run", self.study(8), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "results/sweep/summary.json").exists())
        self.assertIn("results/sweep", done.stderr)

    def test_a_search_whose_budget_lasts_long_says_so_before_it_starts(self):
        # Of 1e9 evaluations each would have to take less than 60 ns for the budget to last less than the minute.
        search = ("twum: 1\nmotor: %s\nstudy: {kind: optimize, variables: {preload: {min: 60 N, max: 300 N}}, maximize: stall_torque, "
                  "solver: {max_evaluations: %d}}\n")
        done = twum("run", self.write("long.yaml", search % (RING, 10**9)), "-o", self.folder / "long")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"note: an evaluation of this motor takes about \S+ [mun]s, so that the budget of 1000000000 evaluations "
                                      r"\(solver: max_evaluations\) lasts about \S+ (s|min|h) on one processor, or several times as long where other designs take longer\n")
        self.assertIn("local optimum\n", done.stdout.decode())
        # One evaluation would have to last a second.
        done = twum("run", self.write("short.yaml", search % (RING, 60)), "-o", self.folder / "short")
        self.assertNotIn("an evaluation of this motor", done.stderr)

    def test_a_better_valley_is_looked_for_before_a_design_is_called_optimal(self):
        study = program.ROOT / "tests/data/local_but_beaten.yaml"
        without = study.read_text().rstrip() + "\n  solver: {scan: 0}\n"
        self.ok("run", self.write("without.yaml", without), "-o", self.folder / "without")
        text = self.ok("run", study, "-o", self.folder / "with")
        before, found = self.summary("without"), self.summary("with")
        speed = before["best"]["metrics"]["plateau_speed"]
        self.assertGreater(speed, 40)  # [rad/s]
        self.assertEqual((before["outcome"], before["scan"]["designs"]), ("optimal", 0))
        self.assertEqual({"designs": 512, "replaced": True, "before": speed}, {k: found["scan"][k] for k in ("designs", "replaced", "before")})
        # A plateau ends at rest or later.
        self.assertEqual(found["best"]["metrics"]["plateau_speed"], 0)
        self.assertIn("of 512 designs sampled over the whole range", text)
        # At no speed at all nothing changes the goal, so its curvature decides nothing.
        self.assertTrue(text.startswith("local_but_beaten (optimize) of m: optimum to first order only\n"))
        self.assertEqual(found["evaluations"], len((self.folder / "with/results.csv").read_text().splitlines()) - 1)
        self.ok("verify", self.folder / "with")

    def test_a_study_of_dots_keeps_to_its_directory(self):
        for name in ("...yaml", "..yaml"):
            study = self.study(8).rename(self.folder / name)
            done = twum("run", study, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue((self.folder / "results" / name / "summary.json").exists())
            study.unlink()
        self.assertEqual([path.name for path in self.folder.iterdir()], ["results"])

    def test_seeds_are_those_that_were_typed(self):
        for seed in (9007199254740991, 9007199254740990):
            self.ok("run", self.study(8, extra=f"  seed: {seed}\n"), "-o", self.folder / str(seed))
            self.assertEqual(self.summary(str(seed))["seed"], seed)
        for seed in (9007199254740992, 9007199254740993):
            self.assertIn(f"'{seed}' is too large; must be at most 9007199254740991",
                          self.refused("check", self.study(8, extra=f"  seed: {seed}\n")))

    def test_the_number_of_threads_changes_no_byte(self):
        first = results(self.run_into("one", "--jobs", 1))
        for jobs in (2, 8):
            self.assertEqual(results(self.run_into(f"jobs{jobs}", "--jobs", jobs)), first)

    def test_the_resolved_study_gives_the_same_rows(self):
        folder = self.run_into("out")
        text = (folder / "study.yaml").read_text()
        self.assertIn("seed: 1", text)  # a default, written out
        self.assertIn("min: 0.8 um", text)  # as typed
        self.ok("check", folder / "study.yaml")
        self.ok("run", folder / "study.yaml", "-o", self.folder / "again")
        self.assertEqual((self.folder / "again/results.csv").read_bytes(), (folder / "results.csv").read_bytes())

    def test_overrides_are_part_of_the_study(self):
        self.run_into("out", "--set", "thickness=0.2 mm")
        self.assertIn("thickness: 2e-04 m", (self.folder / "out/study.yaml").read_text())
        self.assertIn("thickness", self.refused("run", self.study(), "-o", self.folder / "out"))

    def test_a_complete_result_is_answered_from_the_directory(self):
        folder = self.run_into("out")
        before = {p.name: p.read_bytes() for p in folder.iterdir()}
        done = twum("run", self.study(), "-o", folder)
        self.assertEqual(done.returncode, 0)
        self.assertIn("holds this result already", done.stderr)
        for name in ("results.csv", "summary.json", "study.yaml"):
            self.assertEqual((folder / name).read_bytes(), before[name])

    def test_failed_designs_are_rows_and_are_counted(self):
        study = self.write("failing.yaml", """twum: 1
motor: %s
study:
  kind: sweep
  variables: {preload: [100 N, 160 N, 220 N]}
  sampling: grid
  metrics: ["speed_at(1000 N.m)", stall_torque]
""" % RING)
        done = twum("run", study, "-o", self.folder / "out")
        summary = self.summary("out")
        self.assertEqual(sum(summary["failures"].values()), 3)
        region = summary["failure_regions"][0]
        self.assertEqual(region["where"]["preload"], {"low": 100.0, "high": 220.0})
        self.assertIn(b"3 failed or incomplete", done.stdout)
        self.assertIn(b"100 N to 220 N", done.stdout)


class Refusals(Run):
    def test_another_study_in_the_directory(self):
        folder = self.run_into("out")
        before = (folder / "results.csv").read_bytes()
        other = self.study(SMALL + 1)
        text = self.refused("run", other, "-o", folder)
        for words in ("another study", "study.samples: '500' there, '501' here", "-o", "--fresh"):
            self.assertIn(words, text)
        self.assertEqual((folder / "results.csv").read_bytes(), before)
        self.ok("run", other, "-o", folder, "--fresh")
        self.assertEqual(self.summary("out")["evaluations"], SMALL + 1)

    def test_fresh_leaves_what_is_not_ours(self):
        folder = self.run_into("out")
        (folder / "notes.txt").write_text("mine")
        self.run_into("out", "--fresh")
        self.assertEqual((folder / "notes.txt").read_text(), "mine")

    def test_other_peoples_files_are_not_written_over(self):
        folder = self.folder / "mine"
        folder.mkdir()
        for name in ("study.yaml", "results.csv", "summary.json", "results.db"):
            (folder / name).write_text("mine")
            for option in ([], ["--fresh"]):
                self.assertIn(name, self.refused("run", self.study(), "-o", folder, *option))
            self.assertEqual((folder / name).read_text(), "mine")
            (folder / name).unlink()

    def test_other_peoples_points_of_a_front_are_not_written_over(self):
        (self.folder / "mine/front").mkdir(parents=True)
        point = self.folder / "mine/front/1.yaml"
        point.write_text("mine")
        for option in ([], ["--fresh"]):
            self.assertIn("front/1.yaml: exists already", self.refused(
                "run", self.study(), "-o", self.folder / "mine", *option))
        self.assertEqual(point.read_text(), "mine")
        point.rename(self.folder / "mine/front/notes.yaml")  # which no point of a front is called
        self.ok("run", self.study(8), "-o", self.folder / "mine")

    def test_a_file_in_the_place_of_a_front_is_found_before_the_run(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/front").write_text("mine")
        self.assertIn("front: exists already", self.refused("run", self.study(), "-o", self.folder / "out"))
        self.assertFalse((self.folder / "out/results.db").exists())

    def test_what_check_lets_pass_begins(self):
        text = ("twum: 1\nmotor: %s\nstudy: {kind: optimize, variables: {preload: {min: 60 N, max: 300 N}},\n"
                "  maximize: stall_torque, solver: {name: '%s', max_evaluations: 50, options: {%s}}}\n")
        for solver, option, said in (("nlopt:isres", "population: 1.5", "'1.5' is not a whole number"),
                                     ("ipopt", "max_iter: 1e99", "'1e99' is too large; must be at most 1000000"),
                                     ("ipopt", "tol: 1", "'1' is too large; must be at most 0.1")):
            with self.subTest(option):
                study = self.write("s.yaml", text % (RING, solver, option))
                for command in (["check", study], ["run", study, "-o", self.folder / "out"]):
                    self.assertIn(said, self.refused(*command))
                self.assertFalse((self.folder / "out").exists())
        for option in ("population: +20", "xtol_rel: 1 %"):
            study = self.write("s.yaml", text % (RING, "nlopt:isres", option))
            done = twum("run", study, "-o", self.folder / "out", "--fresh")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_study_itself_is_not_written_over(self):
        study = self.study(name="study.yaml")
        before = study.read_bytes()
        for option in ([], ["--fresh"]):
            self.assertIn("-o", self.refused("run", study, "-o", self.folder, *option))
        self.assertEqual(study.read_bytes(), before)

    def test_wrong_arguments(self):
        self.assertIn("--jobs", self.refused("run", self.study(), "--jobs", "0"))
        self.assertIn("cannot be read", self.refused("run", self.folder / "absent.yaml"))
        self.refused("run", RING)
        self.refused("run")
        self.assertIn("preload", self.refused("run", self.study(), "--set", "preload=3 mm"))


class Disks(Run):
    def test_places_that_cannot_be_written(self):
        blocker = self.write("file", "")
        self.assertIn(str(blocker), self.refused("run", self.study(), "-o", blocker, status=3))
        self.refused("run", self.study(), "-o", blocker / "below", status=3)
        if os.path.isdir("/proc"):
            self.assertIn("/proc/", self.refused("run", self.study(), "-o", "/proc/twum", status=3))

    def test_a_folder_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        folder = self.folder / "closed"
        folder.mkdir(mode=0o500)
        self.assertIn("ermission", self.refused("run", self.study(), "-o", folder, status=3))

    def test_a_full_disk_loses_nothing_that_was_written(self):
        expected = results(self.run_into("peace", samples=LARGE))

        def limit():  # bytes of a file: the run needs about 4 MB
            resource.setrlimit(resource.RLIMIT_FSIZE, (1_500_000, resource.RLIM_INFINITY))

        done = subprocess.run([program.PROGRAM, "run", self.study(LARGE), "-o", self.folder / "out"],
                              capture_output=True, preexec_fn=limit)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn(b"results.db", done.stderr)
        self.assertNotIn(b"terminate", done.stderr)
        self.assertFalse((self.folder / "out/summary.json").exists())
        self.assertEqual(results(self.run_into("out", samples=LARGE)), expected)

    def test_a_full_disk_in_earnest(self):
        """A disk of 2 MB, where one may be mounted without being root."""
        folder = self.folder / "disk"
        folder.mkdir()
        script = 'mount -t tmpfs -o size=2m none "$0" && "$1" run "$2" -o "$0/out"'
        done = subprocess.run(["unshare", "--map-root-user", "--mount", "sh", "-c", script, folder, program.PROGRAM,
                               self.study(LARGE)], capture_output=True)
        if b"unshare" in done.stderr or b"mount:" in done.stderr:
            self.skipTest("no mounts of one's own here")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn(b"the disk is full", done.stderr)

    def test_a_damaged_database_is_named(self):
        for name, damage in {"cut": lambda data: data[:len(data) // 2],
                             "overwritten": lambda data: data[:8000] + b"\xff" * 4000 + data[12000:]}.items():
            with self.subTest(name):
                folder = self.run_into(name)
                database = folder / "results.db"
                database.write_bytes(damage(database.read_bytes()))
                text = self.refused("run", self.study(), "-o", folder, status=3)
                self.assertIn(str(database), text)
                self.assertIn("damaged", text)
                self.run_into(name, "--fresh")

    def test_a_flipped_bit_in_a_row_is_noticed(self):
        folder = self.run_into("out")
        database = folder / "results.db"
        connection = sqlite3.connect(database)
        connection.execute('UPDATE evaluations SET "peak_power [W]" = "peak_power [W]" * 1.000001 WHERE "index" = 77')
        connection.commit()
        connection.close()
        self.assertIn("row 77", self.refused("run", self.study(), "-o", folder, status=3))


class Processes(Run):
    def test_the_second_of_two_is_refused(self):
        first = self.begin("out")
        text = self.refused("run", self.study(LARGE), "-o", self.folder / "out", status=3)
        first.send_signal(signal.SIGCONT)
        first.communicate()
        self.assertEqual(first.returncode, 0)
        self.assertIn("another twum", text)

    def test_an_interrupted_run_is_written_and_goes_on(self):
        expected = results(self.run_into("peace", samples=LARGE))
        for name in ("SIGINT", "SIGTERM"):
            with self.subTest(name):
                folder, out, errors = self.interrupted(name, getattr(signal, name))
                self.assertIn(b"interrupted", out.splitlines()[0])
                summary = self.summary(folder)
                self.assertTrue(errors.endswith(b"\ntwum: interrupted after %d of %d evaluations; the same command resumes the study\n" %
                                                (summary["evaluations"], LARGE)), errors)
                self.assertEqual(summary["outcome"], "interrupted")
                self.assertLess(summary["evaluations"], LARGE)
                self.assertEqual((self.folder / folder / "results.csv").read_text().count("\n"),
                                 1 + summary["evaluations"])
                self.assertEqual(results(self.run_into(folder, samples=LARGE)), expected)

    def test_a_killed_run_ends_with_the_same_bytes(self):
        self.assertGreater(kill_often(program.PROGRAM, self.study(LARGE), count=6), 0)

    def on_terminal(self, width, *arguments):
        """What a command shows on a terminal of so many columns."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
        process = subprocess.Popen([program.PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=theirs,
                                   env={**os.environ, "TERM": "xterm"})
        os.close(theirs)
        shown = b""
        while select.select([ours], [], [], 60)[0]:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            shown += piece
        os.close(ours)
        self.assertEqual(process.wait(60), 0)
        return shown.decode()

    def test_the_terminal_shows_progress(self):
        shown = self.on_terminal(0, "run", self.study(LARGE), "-o", self.folder / "out")
        self.assertRegex(shown, r"\[#*-*\] \d+ %, \d+ evaluations, \d+/s, \d+ s left")

    def test_a_search_shows_its_budget_and_its_best_on_one_line(self):
        study = program.ROOT / "examples/studies/size-driven.yaml"
        for width, expected in ((130, r"\[#*-*\] \d+ % of the budget, \d+ evaluations, \d+/s, at most .* left, run \d+, best max_pressure [\d.]+ [kM]Pa"),
                                (80, r"% of the budget, at most .* left, best max_pressure"), (60, r"% of the budget, best max_pressure"), (20, r"\[-+\] \d %")):
            with self.subTest(width):
                shown = self.on_terminal(width, "run", study, "--set", "radial_slices=1", "-o", self.folder / "out", "--fresh", "--jobs", "1")
                lines = [line for line in shown.split("\n")[0].split("\r\033[K") if line.strip()]
                self.assertTrue(any(re.search(expected, line) for line in lines), lines)
                self.assertLess(max(len(line) for line in lines if line.startswith("[")), width)


if __name__ == "__main__":
    program.main()
