# SPDX-License-Identifier: Apache-2.0
"""The program of a build with TWUM_WITH_GSL=OFF: it links, says its licence, and offers no solver of GSL.

Two sources of the library of the solvers differ between the two builds, which is checked here. So these alone are compiled without
GSL, and stand before that library in the link of this build's program.
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
INCLUDES_GSL = re.compile(r"#\s*include\s*<gsl/")
LIBRARY = "optim/libtwum_optim.a"
OBJECTS = [f"optim/CMakeFiles/twum_optim.dir/src/{name}.cpp.o" for name in ("fit/no_gsl_fit", "problem/library_versions")]
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
        unity = re.search(r"^TWUM_UNITY:BOOL=(\w+)$", (cls.build / "CMakeCache.txt").read_text(), re.M)[1]
        output(ARGUMENTS.cmake, "-S", ROOT, "-B", cls.folder, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={ARGUMENTS.ninja}",
               "-DTWUM_WITH_GSL=OFF", "-DTWUM_BUILD_TESTS=OFF", "-DTWUM_BUILD_PYTHON=OFF", "-DTWUM_WITH_DESIGNER=OFF",
               f"-DTWUM_UNITY={unity}", f"-DCMAKE_CXX_COMPILER_LAUNCHER={ARGUMENTS.launcher}")
        output(ARGUMENTS.ninja, "-C", cls.folder, *OBJECTS)

    def sources(self, folder):
        """Sources of the library of the solvers, with those that are compiled in batches."""
        found = set()
        for path in map(folder.joinpath, output(ARGUMENTS.ninja, "-C", folder, "-t", "inputs", LIBRARY).splitlines()):
            if path.suffix == ".cxx":
                found |= set(re.findall(r'#include "(.*)"', path.read_text()))
            elif path.suffix == ".cpp":
                found.add(str(path.resolve()))
        return {str(pathlib.Path(path).relative_to(ROOT)) for path in found}

    def linked(self, program):
        """Links the program as this build does, without GSL."""
        link = output(ARGUMENTS.ninja, "-C", self.build, "-t", "commands", "bin/twum").splitlines()[-1]
        link = link.split("&&")[1] if "&&" in link else link
        words = [word for word in shlex.split(link) if "libgsl" not in word]
        self.assertIn(LIBRARY, words)
        words[words.index(LIBRARY):words.index(LIBRARY)] = [str(self.folder / path) for path in OBJECTS]
        words[words.index("-o") + 1] = str(program)
        output(*words, cwd=self.build)

    def test_builds_with_and_without_gsl_differ_in_one_source(self):
        ours, without = self.sources(self.build), self.sources(self.folder)
        self.assertEqual(ours - without, {"optim/src/fit/gsl_fit.cpp"})
        self.assertEqual(without - ours, {"optim/src/fit/no_gsl_fit.cpp"})
        # The versions are a definition of one source.
        settings = (ROOT / "optim/CMakeLists.txt").read_text()
        self.assertEqual(settings.count("TWUM_GSL_VERSION"), 1)
        self.assertRegex(settings, r'set_source_files_properties\(src/problem/library_versions\.cpp PROPERTIES COMPILE_DEFINITIONS\s+"TWUM_GSL_VERSION')

    def test_nothing_else_includes_gsl(self):
        sources = [path for part in ("core", "motion", "solid", "optim", "studies", "apps", "bindings") for path in (ROOT / part).rglob("*.?pp")]
        self.assertTrue(sources)
        knowing = [str(path.relative_to(ROOT)) for path in sources if INCLUDES_GSL.search(path.read_text(encoding="utf-8"))]
        self.assertEqual(knowing, ["optim/src/fit/gsl_fit.cpp"])

    def test_the_library_needs_nothing_of_gsl(self):
        said = output("nm", "--undefined-only", self.build / LIBRARY, *(self.folder / path for path in OBJECTS))
        objects = dict(re.findall(r"^(\S+\.o):\n((?:.+\n)*)", said, re.M))
        self.assertIn("no_gsl_fit.cpp.o", {pathlib.Path(name).name for name in objects})
        self.assertEqual([name for name, symbols in objects.items() if "U gsl_" in symbols], ["gsl_fit.cpp.o"])

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
