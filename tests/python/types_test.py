# SPDX-License-Identifier: Apache-2.0
"""The type stubs are what the module is, and the examples keep to them."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command, **environment):
    done = subprocess.run([sys.executable, *map(str, command)], capture_output=True, text=True, timeout=500,
                          env={**os.environ, **environment}, cwd=environment.get("MYPY_CACHE_DIR"))
    return done.returncode, done.stdout + done.stderr


class Types(unittest.TestCase):
    def test_stubs_follow_the_tables(self):
        self.assertEqual(run(ROOT / "bindings/python/tools/stubs.py", "--check"), (0, ""))

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not there")
    def test_stubs_are_what_the_module_is(self):
        with tempfile.TemporaryDirectory() as folder:
            status, text = run("-m", "mypy.stubtest", "twum._twum", "--ignore-missing-stub",
                               "--allowlist", ROOT / "tests/python/stubtest_allowed.txt", MYPY_CACHE_DIR=folder,
                               MYPYPATH=os.environ["PYTHONPATH"])
        self.assertEqual(status, 0, text)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not there")
    def test_examples_keep_to_the_types(self):
        with tempfile.TemporaryDirectory() as folder:
            examples = sorted((ROOT / "examples/python").glob("*.py"))
            status, text = run("-m", "mypy", "--ignore-missing-imports", "--check-untyped-defs", "--cache-dir",
                               folder, *examples, MYPYPATH=os.environ["PYTHONPATH"])
        self.assertEqual(status, 0, text)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not there")
    def test_a_strict_program_keeps_to_the_types(self):
        program = pathlib.Path(__file__).with_name("strict_program.py")
        with tempfile.TemporaryDirectory() as folder:
            status, text = run("-m", "mypy", "--strict", "--cache-dir", folder, program,
                               MYPYPATH=os.environ["PYTHONPATH"])
        self.assertEqual(status, 0, text)
        status, text = run(program)
        self.assertEqual(status, 0, text)


if __name__ == "__main__":
    unittest.main()
