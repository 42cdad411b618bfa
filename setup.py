# SPDX-License-Identifier: Apache-2.0
"""The wheel: the Python module and the command, which CMake builds.

    CMAKE_ARGS                   more arguments of CMake, such as -DTWUM_WITH_GSL=OFF
    CMAKE_BUILD_PARALLEL_LEVEL   jobs at a time
    TWUM_BUILD_DIR               a configured build folder to take module and command from, in place of build/pip
"""
import functools
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from distutils.command.build_scripts import build_scripts  # behind setuptools, which provides it since Python 3.12

ROOT = pathlib.Path(__file__).resolve().parent
MODULE = "bindings/python/twum"


def version():
    """That of CMake, which reads it from the same header."""
    header = (ROOT / "core/base/include/twum/base/version.hpp").read_text(encoding="utf-8")
    return ".".join(re.findall(r"^#define TWUM_VERSION_(?:MAJOR|MINOR|PATCH) +(\d+)", header, re.M))


def jobs():
    """As many as there are processors. A job may need 2.3 GB: a batch of sources is compiled as one (scripts/lib.sh)."""
    memory = os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    return max(1, min(os.cpu_count() or 1, memory // 2_300_000_000))


@functools.cache
def built_folder():
    """The build folder, with module and command up to date."""
    folder = pathlib.Path(os.environ.get("TWUM_BUILD_DIR") or ROOT / "build/pip")
    if "TWUM_BUILD_DIR" not in os.environ:
        subprocess.run(["cmake", "--preset", "package", "-S", ROOT, "-B", folder, "-DTWUM_BUILD_PYTHON=ON",
                        f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
                       cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "twum", "twum_python"], check=True,
                   env={"CMAKE_BUILD_PARALLEL_LEVEL": str(jobs()), **os.environ})
    return folder


class BuildModule(build_ext):
    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built_folder() / "python/twum" / target.name, target)


class BuildCommand(build_scripts):
    """The command is a program, not a script whose first line is to be changed."""

    def run(self):
        pathlib.Path(self.build_dir).mkdir(parents=True, exist_ok=True)
        shutil.copy(built_folder() / "bin/twum", self.build_dir)


setup(
    version=version(),
    packages=["twum"],
    package_dir={"twum": MODULE},
    package_data={"twum": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("twum._twum", [])],
    scripts=["bin/twum"],
    cmdclass={"build_ext": BuildModule, "build_scripts": BuildCommand},
)
