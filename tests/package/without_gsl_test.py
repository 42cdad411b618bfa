# SPDX-License-Identifier: Apache-2.0
"""The program of a build with TWUM_WITH_GSL=OFF: it links, says its licence, and offers no solver of GSL.

Nothing but the library of the solvers knows whether GSL is there, which is checked here. So that library is built without GSL
and takes the place of the other in the program's link.
"""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
KNOWS_GSL = re.compile(r"TWUM_WITH_GSL|TWUM_GSL_VERSION|gsl/gsl_")
ARGUMENTS = None


def output(*command, cwd=None):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=cwd, timeout=800)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


class WithoutGsl(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.build = pathlib.Path(ARGUMENTS.build).resolve()
        cls.folder = cls.build / "tests/package/without_gsl"
        output(ARGUMENTS.cmake, "-S", ROOT, "-B", cls.folder, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={ARGUMENTS.ninja}",
               "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DTWUM_WITH_GSL=OFF", "-DTWUM_BUILD_TESTS=OFF",
               "-DTWUM_BUILD_PYTHON=OFF", "-DTWUM_PRECOMPILE=OFF", "-DTWUM_UNITY=ON",
               f"-DCMAKE_CXX_COMPILER_LAUNCHER={ARGUMENTS.launcher}")
        output(ARGUMENTS.ninja, "-C", cls.folder, "twum_optim")

    def linked(self, program):
        """Links the program as this build does, without GSL."""
        link = output(ARGUMENTS.ninja, "-C", self.build, "-t", "commands", "bin/twum").splitlines()[-1]
        link = link.split("&&")[1] if "&&" in link else link
        words = [word for word in shlex.split(link) if "libgsl" not in word]
        self.assertIn("optim/libtwum_optim.a", words)
        words[words.index("optim/libtwum_optim.a")] = str(self.folder / "optim/libtwum_optim.a")
        words[words.index("-o") + 1] = str(program)
        output(*words, cwd=self.build)

    def test_only_the_solvers_know_of_gsl(self):
        sources = [path for part in ("core", "optim", "studies", "apps", "bindings") for path in (ROOT / part).rglob("*.?pp")]
        self.assertTrue(sources)
        for path in sources:
            if KNOWS_GSL.search(path.read_text(encoding="utf-8")):
                self.assertEqual(path.relative_to(ROOT).parts[0], "optim", path)

    def test_the_library_needs_nothing_of_gsl(self):
        self.assertNotIn("U gsl_", output("nm", "--undefined-only", self.folder / "optim/libtwum_optim.a"))

    def test_the_program_may_be_passed_on(self):
        with tempfile.TemporaryDirectory() as scratch:
            program = pathlib.Path(scratch) / "twum"
            self.linked(program)
            version = output(program, "--version")
            self.assertNotIn("GSL", version)
            self.assertRegex(version, r"licence of this program: Apache-2\.0(; Ipopt is under the EPL)?\n")
            solvers = {row["name"]: row for row in json.loads(output(program, "solvers", "--format", "json"))}
            self.assertEqual(solvers["gsl:lm"]["available"], "no")
            self.assertIn("stall_torque", output(program, "evaluate", ROOT / "examples/motors/ring-60.yaml"))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for name in ("cmake", "ninja", "build", "launcher"):
        parser.add_argument(f"--{name}", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
