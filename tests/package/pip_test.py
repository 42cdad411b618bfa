# SPDX-License-Identifier: Apache-2.0
"""The wheel, as `pip wheel --no-build-isolation` makes it, in a fresh environment without a package index.

    pip_test.py            builds from nothing, which takes minutes
    pip_test.py BUILD      takes module and command from a build folder
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = None


def output(*command, expected=0, **how):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=3600, **how)
    assert done.returncode == expected, f"exit {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout if expected == 0 else done.stderr


def copied_sources(folder):
    """The tree without what was built in it: setuptools writes beside its sources."""
    skipped = shutil.ignore_patterns("build*", ".git", "*.egg-info", "__pycache__")
    return shutil.copytree(ROOT, folder, ignore=skipped)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        folder = pathlib.Path(cls.scratch.name)
        cls.environment = folder / "environment"
        cls.clean = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "TWUM_BUILD_DIR")}
        output(sys.executable, "-m", "venv", "--system-site-packages", cls.environment)
        pip = [cls.environment / "bin/pip", "--disable-pip-version-check"]
        build = {"TWUM_BUILD_DIR": str(pathlib.Path(BUILD).resolve())} if BUILD else {}
        output(*pip, "wheel", "--no-build-isolation", "--no-index", "--wheel-dir", folder,
               copied_sources(folder / "sources"), env={**cls.clean, **build}, cwd=folder)
        (cls.wheel,) = folder.glob("*.whl")
        output(*pip, "install", "--no-index", cls.wheel, env=cls.clean, cwd=folder)
        cls.folder = folder

    def python(self, *arguments, **how):
        return output(self.environment / "bin/python", *arguments, env={**self.clean, "MPLBACKEND": "Agg"},
                      cwd=self.folder, **how)

    def test_it_holds_module_types_and_command(self):
        names = zipfile.ZipFile(self.wheel).namelist()
        for end in ("twum/__init__.py", "twum/py.typed", "twum/_twum.pyi", ".data/scripts/twum"):
            self.assertTrue(any(name.endswith(end) for name in names), end)
        self.assertEqual(len([name for name in names if re.fullmatch(r"twum/_twum\.cpython-.*\.so", name)]), 1)
        ours = {f"twum/{path.name}" for path in (ROOT / "bindings/python/twum").iterdir() if path.is_file()}
        self.assertEqual(ours - set(names), set())

    def test_the_version_is_that_of_the_library(self):
        header = (ROOT / "core/base/include/twum/base/version.hpp").read_text()
        version = ".".join(re.findall(r"#define TWUM_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
        self.assertIn(f"twum-{version}-", self.wheel.name)
        said = self.python("-c", "import importlib.metadata, twum; print(twum.__version__, importlib.metadata.version('twum'))")
        self.assertEqual(said.split(), [version, version])

    def test_an_example_runs_with_the_module_of_the_environment(self):
        place = self.python("-c", "import twum; print(twum.__file__)").strip()
        self.assertTrue(pathlib.Path(place).is_relative_to(self.environment), place)
        shutil.copytree(ROOT / "examples", self.folder / "examples")
        self.assertTrue(self.python("examples/python/curve.py"))

    def test_the_command_and_python_m_are_the_same_program(self):
        motor = ROOT / "examples/motors/ring-60.yaml"
        called = ("curve", motor, "--points", "5", "--format", "csv")
        direct = output(self.environment / "bin/twum", *called, env=self.clean, cwd=self.folder)
        self.assertEqual(len(direct.splitlines()), 1 + 5)
        self.assertEqual(self.python("-m", "twum", *called), direct)

    def test_python_m_ends_with_the_exit_status_of_the_command(self):
        self.assertIn("no-such-file", self.python("-m", "twum", "check", "no-such-file.yaml", expected=2))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        BUILD = sys.argv.pop()
    unittest.main()
