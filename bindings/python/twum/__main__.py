# SPDX-License-Identifier: Apache-2.0
"""`python -m twum` is the command twum that belongs to this module."""
import os
import pathlib
import sys


def command() -> pathlib.Path:
    """The nearest bin/twum above the module: of an environment, a prefix or a build folder."""
    here = pathlib.Path(__file__).resolve().parent
    for folder in here.parents:
        if (folder / "bin/twum").is_file():
            return folder / "bin/twum"
    sys.exit(f"twum: no bin/twum in a folder above {here}; install the command, too")


program = command()
os.execv(program, [str(program), *sys.argv[1:]])
