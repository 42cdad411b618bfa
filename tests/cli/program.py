# SPDX-License-Identifier: Apache-2.0
"""Runs twum for the tests: program.main() reads its path from the command line."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# With one slice, at whose radius the closed forms hold.
RING = str(ROOT / "tests/data/motors/ring-60.yaml")
DRIVE = str(ROOT / "tests/data/motors/drive-60.yaml")
PROGRAM = None


def twum(*arguments, stdin=b"", cwd=None, env=None, timeout=600):
    """Finished process with bytes in stdout and text in stderr."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, cwd=cwd,
                          env={**os.environ, **(env or {})}, timeout=timeout)
    done.stderr = done.stderr.decode("utf-8", "surrogateescape")
    return done


class Case(unittest.TestCase):
    """A test case with a scratch folder."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="twum test µ ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def ok(self, *arguments, **options):
        """Standard output of a run that must succeed."""
        done = twum(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.decode()

    def refused(self, *arguments, status=2, **options):
        """Standard error of a run that must be refused, with nothing on standard output."""
        done = twum(*arguments, **options)
        self.assertEqual(done.returncode, status, (done.stdout, done.stderr))
        self.assertEqual(done.stdout, b"")
        self.assertTrue(done.stderr)
        return done.stderr


def main():
    global PROGRAM
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=1)
