# SPDX-License-Identifier: Apache-2.0
"""Kills `twum run` at random moments and runs it again: the results must be those of an uninterrupted run.

    kill_study.py TWUM STUDY.yaml [STUDY.yaml ...] [--count 50] [--jobs 2] [--seed 1] [--processes 3]

With several processes mpirun starts them, one of them is killed, and the uninterrupted run is that of one process. Ends with exit status 0 and one line for each study, or says which bytes differ.
"""
import argparse
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TIMES = re.compile(rb'^  "(seconds|started)": .*\n', re.MULTILINE)
ENDED = (0, 1)  # with an answer, or without one
KILLED = (-9, 137, 130)  # by us; mpirun on behalf of the process killed; the first process, told to stop by mpirun


def results(folder):
    """What must not depend on interruptions: the table, and the summary without times."""
    summary = (folder / "summary.json").read_bytes()
    assert len(TIMES.findall(summary)) == 2, "summary.json has its times elsewhere"
    return (folder / "results.csv").read_bytes(), TIMES.sub(b"", summary)


def start(program, study, folder, jobs, processes=1):
    command = [program, "run", str(study), "-o", str(folder), "--jobs", str(jobs)]
    if processes > 1:
        command = ["mpirun", "-n", str(processes), "--oversubscribe", *command]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                            env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})


def kill(process, processes, chance):
    """Kills the program, or one of those that mpirun has started, if they are running already."""
    if processes == 1:
        return process.kill()
    children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    if children:
        os.kill(int(chance.choice(children)), signal.SIGKILL)
    else:
        process.kill()


def living_children(process):
    """Processes started by mpirun that still run; one that has ended but was not asked for its status does not."""
    children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    states = [pathlib.Path(f"/proc/{child}/stat").read_text().rsplit(")", 1)[1].split()[0] for child in children]
    return [child for child, state in zip(children, states) if state != "Z"]


def ended(process, processes):
    """What the killed program said. Open MPI 4.1 sometimes waits for ever for a lock of its own (in PMIx_server_finalize) when
    all its processes have ended; such an mpirun is killed, and any other that does not end is a failure."""
    try:
        return process.communicate(timeout=60)[1]
    except subprocess.TimeoutExpired:
        if processes == 1 or living_children(process):
            raise AssertionError("does not end after a process was killed") from None
        process.kill()
        print("mpirun did not end although its processes had ended", flush=True)
        return process.communicate()[1]


def finish(process):
    _, errors = process.communicate(timeout=600)
    if process.returncode not in ENDED:
        raise AssertionError(f"exit status {process.returncode}: {errors.decode(errors='replace')}")
    return process.returncode


def kill_often(program, study, count, jobs=2, seed=1, processes=1):
    """Number of runs that were killed before their end; raises AssertionError if results differ."""
    chance = random.Random(f"{seed} {study.name}")
    with tempfile.TemporaryDirectory(prefix="twum-kill-") as scratch:
        peace, war = pathlib.Path(scratch, "peace"), pathlib.Path(scratch, "war")
        status = finish(start(program, study, peace, jobs))
        begin = time.monotonic()
        finish(start(program, study, war, jobs, processes))
        lasts = time.monotonic() - begin
        shutil.rmtree(war)
        expected = results(peace)
        killed = 0

        def compare():
            assert finish(start(program, study, war, jobs, processes)) == status, f"{study}: another exit status"
            for name, ours, theirs in zip(("results.csv", "summary.json"), results(war), expected):
                assert ours == theirs, f"{study}: {name} differs after {killed} kills (seed {seed})"

        for _ in range(count):
            process = start(program, study, war, jobs, processes)
            try:
                process.wait(chance.uniform(0, lasts))
            except subprocess.TimeoutExpired:
                kill(process, processes, chance)
                killed += 1
            errors = ended(process, processes)
            assert process.returncode in (*ENDED, *KILLED), errors.decode(errors="replace")
            if process.returncode in ENDED:
                compare()
                shutil.rmtree(war)
        compare()
        return killed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("studies", nargs="+", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args()
    for study in options.studies:
        killed = kill_often(options.program, study, options.count, options.jobs, options.seed,
                            options.processes)
        print(f"{study.name}: {killed} of {options.count} runs killed, same results", flush=True)


if __name__ == "__main__":
    sys.exit(main())
