# SPDX-License-Identifier: Apache-2.0
"""The test cases of the programs: how long each takes, and which changes it would notice at all."""
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass, field

# What is listed of each program; [long] cases are left out.
PROGRAMS = {"core": {"core_inside_tests": ["~[long]"], "core_tests": ["~[long]", "[slow]~[long]"]},
            "optim": {"optim_inside_tests": ["~[long]"], "optim_tests": ["~[long]", "[slow]~[long]"]}}
REACHED, DIFFERED, FORMLESS = 1, 2, 4  # bits of a record, as in mutant.hpp
ANSWERS = "answers"
RUNNING = set()  # processes
STOPPING = threading.Event()


def kill(process):
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def kill_all():
    """Ends the program's tests; what they would have said is not kept."""
    STOPPING.set()
    for process in list(RUNNING):
        kill(process)


@dataclass
class Case:
    program: pathlib.Path
    name: str
    seconds: float = 0
    record: bytes = field(default=b"", repr=False)

    @property
    def title(self):
        return f"{self.program.name}: {self.name}"

    def command(self):
        if self.name == ANSWERS:
            return [str(self.program)]
        return [str(self.program), re.sub(r"([\\,\[\]\"*])", r"\\\1", self.name), "-w", "NoTests", "--abort"]

    def differs(self, number):
        return bool(self.record[number] & DIFFERED)


def environment(number=None, record=None):
    variables = {k: v for k, v in os.environ.items() if not k.startswith("TWUM_MUTANT")} | {"RC_PARAMS": "seed=42"}
    if number is not None:
        variables["TWUM_MUTANT"] = str(number)
    if record is not None:
        variables["TWUM_MUTANT_RECORD"] = str(record)
    return variables


def processor_seconds(pid):
    try:
        words = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError):
        return float("inf")


def run(command, variables, limit=None, output=subprocess.DEVNULL):
    """Exit status, or None if the limit [s] passed; negative for a signal. A process that was kept from
    the processor gets more time."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.DEVNULL,
                               start_new_session=True, env=variables)
    RUNNING.add(process)
    try:
        for wait in (limit, 4 * limit if limit else None):
            try:
                return process.wait(wait)
            except subprocess.TimeoutExpired:
                if processor_seconds(process.pid) > 0.5 * limit:
                    return None
        return None
    finally:
        kill(process)
        RUNNING.discard(process)
        if STOPPING.is_set():
            raise SystemExit


def named(program, filters):
    names = []
    for each in filters:
        done = subprocess.run([program, "--list-test-names-only", each], capture_output=True, text=True)
        names += [line for line in done.stdout.splitlines() if line and line not in names]
    return names


def fingerprint(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def measured(case, folder, index):
    """Runs a case by itself and once more noting what it reaches."""
    start = time.monotonic()
    status = run(case.command(), environment())
    case.seconds = time.monotonic() - start
    if status:
        sys.exit(f"mutate.py: the unchanged tree fails: {case.title} ({status})")
    record = folder / f"{index}.record"
    run(case.command(), environment(record=record))
    case.record = record.read_bytes()


def cases_in(program, filters, folder):
    """The cases of a program, measured once for each build."""
    place = folder / "records" / f"{program.name}-{fingerprint(program)}"
    listed = [Case(program, name) for name in (named(program, filters) if filters else [ANSWERS])]
    index = place / "cases.json"
    if index.exists():
        for i, (case, seconds) in enumerate(zip(listed, json.loads(index.read_text(encoding="utf-8")))):
            case.seconds, case.record = seconds, (place / f"{i}.record").read_bytes()
        return listed
    place.mkdir(parents=True, exist_ok=True)
    print(f"measuring the {len(listed)} cases of {program.name}", flush=True)
    for i, case in enumerate(listed):
        measured(case, place, i)
    index.write_text(json.dumps([case.seconds for case in listed]), encoding="utf-8")
    return listed


def cases_of(layer, copy, folder):
    """The cases of a layer's programs, and that of the answers."""
    programs = PROGRAMS[layer] | {f"twum_{layer}_answers": []}
    return [case for name, filters in programs.items() for case in cases_in(copy.program(name), filters, folder)]
