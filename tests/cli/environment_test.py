# SPDX-License-Identifier: Apache-2.0
"""The program where it was not made: locales, folders, clocks, terminals, line ends, sizes."""
import csv
import json
import os
import pathlib
import shutil
import subprocess

import program
from program import RING, twum

STUDY = """twum: 1
motor: %s
study:
  kind: sweep
  variables:
    amplitude: {min: 1.2 um, max: 1.8 um, points: 3}
    preload: [120 N, 160 N]
  sampling: grid
  metrics: [stall_torque, no_load_speed]
"""
DESIGNS = "preload [N],amplitude [um],note\n160,1.6,a\n120,1.2,\"b, c\"\n"
TIMES = {"started", "seconds"}


def calibration(data):
    return ("twum: 1\nmotor: %s\nstudy:\n  kind: calibrate\n  data: %s\n  starts: 1\n  variables:\n"
            "    kinetic_friction: {min: 0.1, max: 0.35}\n" % (RING, data))


def answer(folder):
    """What a run answered, times aside."""
    summary = json.loads((folder / "summary.json").read_text())
    return {key: value for key, value in summary.items() if key not in TIMES}, (folder / "results.csv").read_bytes()


class Environment(program.Case):
    def study(self, name="study.yaml"):
        return self.write(name, STUDY % RING)

    def run_study(self, folder, **options):
        self.ok("run", self.study(), "-o", self.folder / folder, **options)
        return answer(self.folder / folder)

    def outputs(self, **options):
        """What the commands that print numbers print, and what a study answers."""
        designs = self.write("designs.csv", DESIGNS)
        printed = [self.ok("curve", RING, "--points", 5, "--format", form, **options) for form in ("table", "csv", "json")]
        printed.append(self.ok("evaluate", RING, "--designs", designs, "--metrics", "torque_at(50 rpm)", **options))
        folder = self.folder / "out"
        shutil.rmtree(folder, ignore_errors=True)
        return printed, self.run_study("out", **options)

    def comma_locale(self):
        """A folder with a locale whose numbers have commas, made here; the C library finds it by LOCPATH."""
        if not shutil.which("localedef"):
            self.skipTest("no localedef here, so no locale with decimal commas")
        folder = self.folder / "locales"
        folder.mkdir()
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], capture_output=True)
        shown = subprocess.run(["locale", "-k", "decimal_point"], capture_output=True,
                               env={**os.environ, "LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8"})
        if b'","' not in shown.stdout:
            self.skipTest("localedef makes no de_DE.UTF-8 here (package locales): " + made.stderr.decode()[:200])
        return {"LOCPATH": str(folder)}

    def test_a_locale_with_decimal_commas_changes_nothing(self):
        plain = self.outputs()
        locale = self.comma_locale()
        self.assertEqual(self.outputs(env={**locale, "LC_ALL": "de_DE.UTF-8"}), plain)
        self.assertEqual(self.outputs(env={**locale, "LC_ALL": "", "LC_NUMERIC": "de_DE.UTF-8"}), plain)

    def test_time_zones_and_bare_environments_change_nothing(self):
        plain = self.outputs()
        for zone in ("Pacific/Kiritimati", "America/St_Johns", ":no/such/zone", "XXX-25:99"):
            self.assertEqual(self.outputs(env={"TZ": zone}), plain)
        designs = self.write("designs.csv", DESIGNS)
        command = [program.PROGRAM, "evaluate", RING, "--designs", str(designs), "--metrics", "torque_at(50 rpm)"]
        bare = subprocess.run(command, env={}, capture_output=True)
        self.assertEqual((bare.returncode, bare.stderr), (0, b""))
        self.assertEqual(bare.stdout.decode(), plain[0][3])
        out = self.folder / "bare"
        run = subprocess.run([program.PROGRAM, "run", str(self.study()), "-o", str(out)], env={}, capture_output=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(answer(out), plain[1])

    def test_homes_and_folders_for_scratch_files_are_not_needed(self):
        plain = self.run_study("plain")
        closed = self.folder / "closed"
        closed.mkdir(mode=0o500)
        for index, home in enumerate((str(closed), "/proc", "/no/such/home", "")):
            places = {"HOME": home, "TMPDIR": home, "XDG_CACHE_HOME": home, "XDG_CONFIG_HOME": home}
            self.assertEqual(self.run_study(f"home-{index}", env=places), plain)
        self.assertEqual(list(closed.iterdir()), [])

    def test_a_clock_set_back_between_two_runs_is_no_harm(self):
        plain = self.run_study("plain")
        folder = self.folder / "clock"
        self.run_study("clock")
        for path in [folder, *folder.iterdir()]:  # as if written tomorrow
            os.utime(path, (path.stat().st_atime, path.stat().st_mtime + 86400))
        self.ok("run", self.study(), "-o", folder)
        self.assertEqual(answer(folder), plain)
        self.ok("verify", folder)

    def test_wrong_clocks_change_nothing_but_the_time_that_is_noted(self):
        if not shutil.which("faketime"):
            self.skipTest("no faketime here")
        plain = self.run_study("plain")

        def run_at(clock, folder):
            done = subprocess.run(["faketime", "-f", clock, program.PROGRAM, "run", str(self.study()), "-o", str(folder)],
                                  capture_output=True, env={**os.environ, "TZ": "UTC", "DONT_FAKE_MONOTONIC": "1",
                                                            "FAKETIME_DONT_FAKE_MONOTONIC": "1",
                                                            # faketime's library comes before the sanitizer's
                                                            "ASAN_OPTIONS": "verify_asan_link_order=0"})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(answer(folder), plain)
            return json.loads((folder / "summary.json").read_text())

        for clock in ("1969-12-31 12:00:00", "2038-01-19 03:14:06", "2106-02-07 06:28:14"):
            noted = run_at("@" + clock, self.folder / clock[:4])
            self.assertEqual(noted["started"][:13], clock.replace(" ", "T")[:13])
            self.assertGreaterEqual(noted["seconds"], 0)
        # Set back by decades between two runs into one folder, and backwards all the time.
        run_at("@1999-12-31 23:59:59", self.folder / "2106")
        self.ok("verify", self.folder / "2106")
        self.assertGreaterEqual(run_at("+0 x-10", self.folder / "backwards")["seconds"], 0)

    def test_names_with_blanks_and_letters_of_other_alphabets(self):
        plain = self.run_study("plain")
        place = self.folder / "Prüfstand № 7 – 超音波"
        place.mkdir()
        motor = place / "mein Motör 'a' \"b\".yaml"
        shutil.copy(RING, motor)
        name = "Motör 超 .yaml"
        shutil.copy(RING, place / name)
        study = place / "Größe und мощность.yaml"
        study.write_text(STUDY % ("'" + name + "'"))
        out = place / "Ergebnis mit Leerzeichen µ"
        self.ok("run", study, "-o", out)
        summary, rows = answer(out)
        self.assertEqual(rows, plain[1])
        self.assertEqual(summary["study"], "Größe und мощность")
        self.ok("verify", out)
        self.ok("report", out)
        self.assertIn("Größe und мощность", (out / "report.html").read_text())
        self.assertEqual(self.ok("curve", motor), self.ok("curve", RING))
        self.ok("curve", RING, "--format", "csv", "-o", place / "Kennlinie 曲線.csv")
        self.assertTrue((place / "Kennlinie 曲線.csv").stat().st_size)
        in_c = self.ok("curve", motor, env={"LC_ALL": "C"})
        self.assertEqual(in_c, self.ok("curve", RING))
        self.assertIn("Prüfstand", self.refused("check", place / "nichts.yaml"))

    def test_a_name_that_is_no_text_is_a_name_still(self):
        path = os.fsencode(self.folder) + b"/ring-\xff.yaml"
        shutil.copy(RING, path)
        done = subprocess.run([program.PROGRAM.encode(), b"check", path], capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_line_ends_and_byte_order_marks_of_other_systems(self):
        plain = self.run_study("plain")
        curve = self.ok("curve", RING)
        table = self.ok("evaluate", RING, "--designs", self.write("designs.csv", DESIGNS), "--metrics", "stall_torque")
        data = "speed [rpm],torque [N.m]\n1,0.849\n40,0.846\n80,0.849\n"
        self.write("points.csv", data)
        self.ok("run", self.write("fit.yaml", calibration("points.csv")), "-o", self.folder / "fit")
        fit = answer(self.folder / "fit")[1]
        foreign = {"crlf": lambda t: t.replace("\n", "\r\n").encode(),
                   "mark": lambda t: b"\xef\xbb\xbf" + t.encode(),
                   "both": lambda t: b"\xef\xbb\xbf" + t.replace("\n", "\r\n").encode()}
        for name, change in foreign.items():
            with self.subTest(name):
                motor = self.write("motor.yaml", change(pathlib.Path(RING).read_text()))
                self.assertEqual(self.ok("curve", motor), curve)
                self.ok("run", self.write("study.yaml", change(STUDY % "motor.yaml")), "-o", self.folder / name)
                self.assertEqual(answer(self.folder / name), plain)
                designs = self.write("designs.csv", change(DESIGNS))
                result = twum("evaluate", RING, "--designs", designs, "--metrics", "stall_torque")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(result.stdout.decode().replace("\r", ""), table)
                self.write("points.csv", change(data))
                self.ok("run", self.write("fit.yaml", change(calibration("points.csv"))), "-o", self.folder / f"fit-{name}")
                self.assertEqual(answer(self.folder / f"fit-{name}")[1], fit)

    def test_tables_of_two_hundred_thousand_columns(self):
        count = 200000
        names = ["preload [N]", *(f"column {i}" for i in range(count - 1))]
        rows = [["160", *map(str, range(count - 1))], ["120", *["x"] * (count - 1)], ["1", "2"]]
        wide = self.write("wide.csv", "\n".join(",".join(row) for row in [names, *rows]) + "\n")
        done = twum("evaluate", RING, "--designs", wide, "--metrics", "preload", timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        lines = [line.split(",") for line in done.stdout.decode().splitlines()]
        self.assertEqual(lines[0], [*names, "preload [N]", "status"])
        self.assertEqual(lines[1], [*rows[0], "160", "ok"])
        self.assertEqual(lines[2], [*rows[1], "120", "ok"])
        self.assertEqual([len(row) for row in csv.reader(done.stdout.decode().splitlines()[3:])], [count + 2])
        again = self.write("twice.csv", ",".join(["preload"] * count) + "\n" + ",".join(["160"] * count) + "\n")
        error = self.refused("evaluate", RING, "--designs", again, "--metrics", "preload", timeout=240)
        self.assertIn("given twice", error)
        self.assertLess(len(error), 100000)

    def test_no_terminal_and_closed_channels(self):
        study, out = str(self.study()), str(self.folder / "out")
        plain = self.run_study("plain")
        alone = subprocess.run([program.PROGRAM, "run", study, "-o", out], stdin=subprocess.DEVNULL, capture_output=True,
                               start_new_session=True, env={**os.environ, "TERM": ""})
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertNotIn(b"\033", alone.stdout + alone.stderr)
        self.assertEqual(answer(self.folder / "out"), plain)
        for name, channel in (("in", "<&-"), ("errors", "2>&-"), ("in and errors", "<&- 2>&-")):
            with self.subTest(name):
                folder = self.folder / name
                done = subprocess.run(["sh", "-c", f'"$0" run "$1" -o "$2" {channel}', program.PROGRAM, study, str(folder)],
                                      capture_output=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(answer(folder), plain)
        from_nowhere = subprocess.run(["sh", "-c", '"$0" check - <&-', program.PROGRAM], capture_output=True)
        self.assertEqual(from_nowhere.returncode, 2, from_nowhere.stderr)
        nowhere = subprocess.run(["sh", "-c", '"$0" curve "$1" >&-', program.PROGRAM, RING], capture_output=True)
        self.assertEqual(nowhere.returncode, 3)

    def test_a_result_is_complete_though_nobody_reads_the_words(self):
        folder = self.folder / "unread"
        reader, writer = os.pipe()
        os.close(reader)
        run = subprocess.run([program.PROGRAM, "run", str(self.study()), "-o", str(folder)], stdout=writer, stderr=writer)
        os.close(writer)
        self.assertEqual(run.returncode, 0)
        self.assertEqual(answer(folder), self.run_study("plain"))

    def test_no_color_is_for_any_value_and_no_output_without_a_terminal_has_colour(self):
        wrong = self.write("wrong.yaml", "twum: 2\n")
        for environment in ({"NO_COLOR": "1"}, {"NO_COLOR": "0"}, {"CLICOLOR_FORCE": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\033", self.refused("check", wrong, env=environment))

    def test_very_long_arguments_get_an_answer(self):
        long = "x" * 100000  # Linux takes 128 KiB for one
        for arguments in (["check", long], ["curve", RING, "--set", long], ["curve", RING, "--speeds", long],
                          ["curve", RING, "--set", "preload=" + "1" * 100000 + " N"], [long],
                          ["evaluate", RING, "--designs", RING, "--metrics", ",".join(["preload"] * 12000)]):
            error = self.refused(*arguments, timeout=240)
            self.assertLess(len(error), 250000)
        speeds = ", ".join(["50 rpm"] * 10000)
        self.assertEqual(len(self.ok("curve", RING, "--format", "csv", "--speeds", speeds, timeout=240).splitlines()), 10001)


if __name__ == "__main__":
    program.main()
