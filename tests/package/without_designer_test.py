# SPDX-License-Identifier: Apache-2.0
"""The program of a build with TWUM_WITH_DESIGNER=OFF: it writes pages, which say what is missing, and everything else works.

Such a build differs in one source, the parts of the pages. So that source is written and compiled without the core, as that build
would do it, and takes the place of the other in the program's link.
"""
import argparse
import pathlib
import shlex
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
RING = ROOT / "examples/motors/ring-60.yaml"
SOURCE = "studies/page_assets.cpp"
OBJECT = "studies/CMakeFiles/twum_studies.dir/page_assets.cpp.o"
ARGUMENTS = None


def output(*command, cwd=None):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=cwd, timeout=800)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


class WithoutDesigner(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.build = pathlib.Path(ARGUMENTS.build).resolve()
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.program = cls.linked(cls.compiled())

    @classmethod
    def words(cls, target):
        """The last command that makes a target of this build."""
        line = output(ARGUMENTS.ninja, "-C", cls.build, "-t", "commands", target).stdout.splitlines()[-1]
        return shlex.split(line.split("&&")[1] if "&&" in line else line)

    @classmethod
    def compiled(cls):
        """The parts of the pages without the core, compiled."""
        embed = [f"-DOUT={cls.folder}/parts.cpp" if word.startswith("-DOUT=") else "-DMODULE=" if word.startswith("-DMODULE=") else word
                 for word in cls.words(SOURCE)]
        output(*embed, cwd=cls.build)
        words = cls.words(OBJECT)
        words[words.index("-c") + 1], words[words.index("-o") + 1] = f"{cls.folder}/parts.cpp", f"{cls.folder}/parts.o"
        words[words.index("-MF") + 1] = f"{cls.folder}/parts.d"
        output(*words, cwd=cls.build)
        return f"{cls.folder}/parts.o"

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @classmethod
    def linked(cls, parts):
        """The program with these parts: an object stands before the archives."""
        words = cls.words("bin/twum")
        words.insert(words.index("studies/libtwum_studies.a"), parts)
        words[words.index("-o") + 1] = f"{cls.folder}/twum"
        output(*words, cwd=cls.build)
        return cls.folder / "twum"

    def test_such_a_build_plans_nothing_of_webassembly(self):
        plan = self.folder / "plan"
        output(ARGUMENTS.cmake, "-S", ROOT, "-B", plan, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={ARGUMENTS.ninja}", "-DTWUM_WITH_DESIGNER=OFF",
               "-DTWUM_BUILD_TESTS=OFF", "-DTWUM_BUILD_PYTHON=OFF")
        self.assertNotIn("core.wasm", output(ARGUMENTS.ninja, "-C", plan, "-t", "targets", "all").stdout)
        self.assertIn("-DMODULE=", output(ARGUMENTS.ninja, "-C", plan, "-t", "commands", SOURCE).stdout)

    def test_explore_writes_a_page_and_says_what_is_missing(self):
        page = self.folder / "page.html"
        done = output(self.program, "explore", RING, "-o", page)
        self.assertIn("this build cannot compute in a page", done.stderr)
        self.assertIn('"core":""', page.read_text())

    def test_a_report_has_no_button_that_does_nothing(self):
        result = self.folder / "result"
        study = self.folder / "study.yaml"
        study.write_text(f"twum: 1\nmotor: {RING}\nstudy: {{kind: curve, points: 5}}\n")
        output(self.program, "run", study, "-o", result)
        self.assertIn('id="core"></script>', (result / "report.html").read_text())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for name in ("cmake", "ninja", "build"):
        parser.add_argument(f"--{name}", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
