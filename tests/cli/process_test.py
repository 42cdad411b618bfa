# SPDX-License-Identifier: Apache-2.0
"""The program among other processes: locales, pipes, full disks, signals, terminals."""
import collections
import contextlib
import fcntl
import os
import pty
import select
import signal
import sqlite3
import stat
import struct
import subprocess
import termios
import time

import program
from program import RING


class Surroundings(program.Case):
    def test_locales_change_nothing(self):
        plain = self.ok("curve", RING, "--points", 5)
        for locale in ("C", "C.UTF-8", "de_DE.UTF-8", "tr_TR.UTF-8", "no-such-locale"):
            self.assertEqual(self.ok("curve", RING, "--points", 5, env={"LC_ALL": locale, "LANG": locale}), plain)

    def test_no_output_can_be_lost_unnoticed(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        designs = self.write("designs.csv", "preload\n" + "160\n" * 20000)
        for arguments in (["curve", RING], ["metrics"], ["schema", "motor"], ["check", RING], ["fields", RING, "--speed", "1 rpm"],
                          ["evaluate", RING, "--designs", designs, "--metrics", "preload"]):
            with self.subTest(arguments[0]):
                with open("/dev/full", "wb") as full:
                    done = subprocess.run([program.PROGRAM, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 3)
                self.assertIn(b"No space left", done.stderr)
        self.assertIn("No space left", self.refused("curve", RING, "-o", "/dev/full", status=3))

    def test_places_that_cannot_be_written(self):
        self.assertIn("No such file", self.refused("curve", RING, "-o", self.folder / "a/b.csv", status=3))
        self.refused("curve", RING, "-o", self.folder, status=3)

    def test_closed_standard_output(self):
        done = subprocess.run(["sh", "-c", '"$0" metrics >&-', program.PROGRAM], stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 3)

    def test_a_reader_that_has_seen_enough_is_no_error(self):
        designs = self.write("designs.csv", "preload [N]\n" + "160\n" * 200000)
        process = subprocess.Popen([program.PROGRAM, "evaluate", RING, "--designs", designs, "--metrics", "preload"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertIn(b"preload", process.stdout.readline())
        process.stdout.close()
        self.assertEqual(process.stderr.read(), b"")
        self.assertEqual(process.wait(600), 0)
        process.stderr.close()


class Interrupts(program.Case):
    def start(self, **options):
        designs = self.write("designs.csv", "preload,amplitude [um]\n" + "160,1.6\n" * 400000)
        self.result = self.folder / "result.csv"
        return subprocess.Popen([program.PROGRAM, "evaluate", RING, "--designs", designs, "-o", self.result], **options)

    def test_the_first_interrupt_finishes_what_is_in_flight(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start(stderr=subprocess.PIPE)
            while not (self.result.exists() and self.result.stat().st_size > 0):
                time.sleep(0.01)
            process.send_signal(number)
            _, errors = process.communicate(timeout=600)
            self.assertEqual(process.returncode, 130)
            self.assertIn(b"interrupted after", errors)
            lines = self.result.read_text().splitlines()
            self.assertEqual(len(lines) - 1, int(errors.split(b"interrupted after ")[1].split()[0]))
            self.assertLess(len(lines), 400001)
            self.assertTrue(all(line.endswith(",ok") for line in lines[1:]))
            self.result.unlink()

    def reading(self):
        """A program that waits for a motor file without end, and checks no signals meanwhile."""
        process = subprocess.Popen([program.PROGRAM, "curve", "-"], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while not self.listens(process):
            time.sleep(0.01)
        return process

    @staticmethod
    def listens(process):
        """True once the program has a handler for SIGTERM, the last that it installs."""
        with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
            caught = next(line for line in status if line.startswith("SigCgt:"))
        return int(caught.split()[1], 16) >> (signal.SIGTERM - 1) & 1

    def test_a_signal_ends_what_nothing_else_ends(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.reading()
            process.send_signal(number)
            # Standard input stays open: without its end the program would wait as long as this does.
            self.assertEqual(process.wait(timeout=60), 130)
            self.assertIn(b"interrupted before", process.stderr.read())
            for stream in (process.stdin, process.stdout, process.stderr):
                stream.close()

    def test_two_signals_at_once_are_one_request_and_a_later_one_ends_at_once(self):
        process = self.reading()
        process.send_signal(signal.SIGTERM)  # as timeout(1) sends them: to the program and to its group
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 130)
        for stream in (process.stdin, process.stdout, process.stderr):
            stream.close()
        process = self.reading()
        process.send_signal(signal.SIGINT)
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), -signal.SIGTERM)
        for stream in (process.stdin, process.stdout, process.stderr):
            stream.close()

    def test_an_interrupted_study_says_how_far_it_came_and_waits_for_no_pipe(self):
        study = self.write("study.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: sweep\n  variables: {{preload: {{min: 60 N, max: 300 N}}}}\n"
                           "  sampling: lhs\n  samples: 5000000\n  metrics: [no_load_speed]\n")
        folder = self.folder / "out"
        folder.mkdir()
        for terminal in (False, True):
            known = self.rows(folder)
            os.mkfifo(folder / "results.csv.part")  # nobody reads it: writing into it would take for ever
            ours, theirs = pty.openpty() if terminal else os.pipe()
            process = subprocess.Popen([program.PROGRAM, "run", study, "-o", folder], stdout=theirs, stderr=theirs, env={**os.environ, "TERM": "xterm"})
            os.close(theirs)
            while process.poll() is None and self.rows(folder) == known:
                time.sleep(0.01)
            before, begin = self.rows(folder), time.monotonic()
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            took = time.monotonic() - begin
            shown = b""
            with contextlib.suppress(OSError):  # the other end is closed
                while piece := os.read(ours, 65536):
                    shown += piece
            os.close(ours)
            self.assertLess(took, 5)  # 0.8 s on an idle machine
            last = shown.decode().replace("\r\n", "\n").rstrip("\n").split("\n")[-1]
            self.assertRegex(last, r"^twum: interrupted after \d+ of 5000000 evaluations(, before all result files were written)?; the same command resumes the study$")
            self.assertTrue(stat.S_ISREG((folder / "results.csv").stat().st_mode))
            self.assertEqual(shown.count(b"twum:"), 1)
            self.assertGreaterEqual(self.rows(folder), before)
            self.assertEqual(int(last.split()[3]), self.rows(folder))

    @staticmethod
    def rows(folder):
        try:
            with contextlib.closing(sqlite3.connect(f"file:{folder / 'results.db'}?mode=ro", uri=True)) as connection:
                return connection.execute("SELECT count(*) FROM evaluations").fetchone()[0]
        except sqlite3.Error:
            return 0

    def read_terminal(self, process, terminal, last):
        """What the terminal shows until the last words come."""
        text = b""
        until = time.monotonic() + 60
        while last not in text and time.monotonic() < until and process.poll() is None:
            if select.select([terminal], [], [], 0.1)[0]:
                text += os.read(terminal, 4096)
        return text

    def test_progress_shows_on_a_terminal_only(self):
        terminal, other_end = pty.openpty()
        process = self.start(stderr=other_end, env={**os.environ, "TERM": "xterm"})
        text = self.read_terminal(process, terminal, b" left")  # once the second piece of the file is read
        process.send_signal(signal.SIGINT)
        process.wait(60)
        os.close(other_end)
        os.close(terminal)
        self.assertRegex(text, rb"\d+ evaluations, \d+/s, .*left")

    def on_terminal(self, width, *arguments):
        """Standard output on a terminal of so many columns."""
        terminal, other_end = pty.openpty()
        fcntl.ioctl(other_end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
        process = subprocess.Popen([program.PROGRAM, *map(str, arguments)], stdout=other_end, stderr=subprocess.DEVNULL)
        os.close(other_end)
        text = b""
        with contextlib.suppress(OSError):  # the other end is closed
            while piece := os.read(terminal, 65536):
                text += piece
        os.close(terminal)
        self.assertEqual(process.wait(60), 0)
        return text.decode().replace("\r\n", "\n")

    def test_tables_fit_the_terminal(self):
        for arguments in (("curve", program.DRIVE, "--points", "3"), ("parameters",), ("metrics",), ("materials",), ("solvers",),
                          ("fields", RING, "--speed", "100 rpm", "--samples", "5")):
            for width in (80, 110):
                with self.subTest(arguments[0], width=width):
                    shown = self.on_terminal(width, *arguments)
                    self.assertLessEqual(max(map(len, shown.split("\n"))), width)
                    # Nothing is lost, and without a terminal nothing is broken.
                    piped = self.ok(*arguments)
                    self.assertLessEqual(collections.Counter(piped.split()), collections.Counter(shown.split()))
                    self.assertGreaterEqual(max(map(len, piped.split("\n"))), max(map(len, shown.split("\n"))))
        written = self.folder / "curve.txt"
        self.on_terminal(80, "curve", program.DRIVE, "--points", "3", "-o", written)
        self.assertEqual(written.read_text(), self.ok("curve", program.DRIVE, "--points", "3"))

    def test_colours_only_on_a_terminal_and_without_no_color(self):
        wrong = self.write("wrong.yaml", "twum: 2\n")
        for environment, coloured in (({"NO_COLOR": ""}, True), ({"NO_COLOR": "1"}, False)):
            terminal, other_end = pty.openpty()
            subprocess.run([program.PROGRAM, "check", wrong], stderr=other_end, env={**os.environ, "TERM": "xterm", **environment})
            os.close(other_end)
            text = os.read(terminal, 4096)
            os.close(terminal)
            self.assertEqual(b"\033[" in text, coloured)
        self.assertNotIn("\033", self.refused("check", wrong))


if __name__ == "__main__":
    program.main()
