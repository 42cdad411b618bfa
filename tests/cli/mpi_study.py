# SPDX-License-Identifier: Apache-2.0
"""Runs studies with one process and with several that mpirun starts: the results must be the same bytes.

    mpi_study.py TWUM STUDY.yaml [STUDY.yaml ...] [--processes 3] [--jobs 1]

Ends with exit status 0 and one line for each study, or says which files differ.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from kill_study import TIMES

AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
TIMES_OF_PAGE = re.compile(rb'"(seconds|started)": ?("[^"]*"|[-0-9.e]+)')


def mpirun(processes, *command, options=(), **more):
    """A finished mpirun; it may be started by root, and there may be fewer processors than processes."""
    return subprocess.run(["mpirun", "-n", str(processes), "--oversubscribe", *options, *map(str, command)], capture_output=True,
                          text=True, env={**os.environ, **AS_ROOT}, timeout=3600, **more)


def results(folder):
    """What must not depend on the number of processes."""
    files = {name: (folder / name).read_bytes() for name in ("study.yaml", "results.csv", "summary.json", "report.html")}
    files["summary.json"] = TIMES.sub(b"", files["summary.json"])
    files["report.html"] = TIMES_OF_PAGE.sub(b"", files["report.html"])
    return files


def compare(program, study, folder, processes=3, jobs=1):
    """Seconds alone and together, of the whole commands; raises AssertionError if the results differ."""
    alone, together = folder / "alone" / study.stem, folder / "together" / study.stem
    begin = time.monotonic()
    first = subprocess.run([program, "run", study, "-o", alone, "--jobs", "1"], capture_output=True, text=True, check=False)
    between = time.monotonic()
    second = mpirun(processes, program, "run", study, "-o", together, "--jobs", jobs)
    end = time.monotonic()
    assert first.returncode == second.returncode, second.stderr
    ours, theirs = results(alone), results(together)
    for name, bytes_alone in ours.items():
        assert bytes_alone == theirs[name], f"{study.name}: {name} differs with {processes} processes"
    return between - begin, end - between


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("studies", nargs="+", type=pathlib.Path)
    parser.add_argument("--processes", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="twum-mpi-") as scratch:
        for study in options.studies:
            alone, together = compare(options.program, study, pathlib.Path(scratch), options.processes, options.jobs)
            print(f"{study.name}: same results, {alone:.1f} s alone, {together:.1f} s with {options.processes} processes",
                  flush=True)


if __name__ == "__main__":
    sys.exit(main())
