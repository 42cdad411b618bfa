# SPDX-License-Identifier: Apache-2.0
"""Damages the database of a study at random and runs the study again: it has to be refused with a message, or to answer
exactly as without the damage.

    damage_survey.py TWUM STUDY.yaml [STUDY.yaml ...] [--count 300] [--seed 1]

Half of the databases are finished, half are those of a killed run, with what is still in their log. Ends with exit
status 0 and one line for each study, or says which damage went unnoticed.
"""
import argparse
import collections
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

from kill_study import ENDED, finish, results, start

PAGE = 4096  # bytes, the default of SQLite
REFUSED = (2, 3)
HANGS = 120  # s; the studies take a second


def flip(data, chance):
    place = chance.randrange(len(data))
    data[place] ^= 1 << chance.randrange(8)
    return f"bit of byte {place} flipped"


def cut(data, chance):
    size = chance.randrange(len(data))
    del data[size:]
    return f"cut to {size} bytes"


def page(data, chance):
    at = PAGE * chance.randrange(len(data) // PAGE)
    return slice(at, at + PAGE)


def duplicate(data, chance):
    one, other = page(data, chance), page(data, chance)
    data[other] = data[one]
    return f"page at {one.start} copied to {other.start}"


def swap(data, chance):
    one, other = page(data, chance), page(data, chance)
    data[one], data[other] = data[other], data[one]
    return f"pages at {one.start} and {other.start} swapped"


def zero(data, chance):
    one = page(data, chance)
    data[one] = bytes(PAGE)
    return f"page at {one.start} zeroed"


KINDS = (flip, cut, duplicate, swap, zero)


def killed_run(program, study, folder, lasts, chance):
    """A run that is killed on its way, with rows in its log if it lasts long enough to have any.

    How long a run lasts is learned on the way, since the machine may have been busier before.
    """
    for _ in range(50):
        begin = time.monotonic()
        process = start(program, study, folder, jobs=1)
        try:
            process.wait(chance.uniform(0.5, 0.9) * lasts)
            lasts = time.monotonic() - begin
        except subprocess.TimeoutExpired:
            process.kill()
            lasts *= 1.05  # counts if it was too early
        process.communicate()
        if (folder / "results.db-wal").exists():
            return
        shutil.rmtree(folder, ignore_errors=True)
    raise AssertionError(f"{study.name}: no run was caught at work")


def verdict(program, study, folder, expected):
    """'refused' or 'same' for a damaged directory; an AssertionError if it is neither."""
    process = start(program, study, folder, jobs=1)
    try:
        _, errors = process.communicate(timeout=HANGS)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise AssertionError(f"no end within {HANGS} s") from None
    said = errors.decode(errors="replace")
    if process.returncode in REFUSED:
        words = [line for line in said.splitlines() if not line.startswith("note: ")]
        refused = words and words[0].startswith("twum: ") and str(folder) in words[0]
        assert refused, f"refused with the words {said!r}"
        return "refused"
    assert process.returncode in ENDED, f"exit status {process.returncode}: {said}"
    assert results(folder) == expected, "another answer"
    check = subprocess.run([program, "verify", str(folder), "--samples", "20"], capture_output=True)
    assert check.returncode == 0, f"verify: {check.stdout.decode()}{check.stderr.decode()}"
    return "same"


def survey(program, study, count, seed=1):
    """Counts of (kind of damage, verdict); raises AssertionError with the damage that went unnoticed."""
    chance = random.Random(f"{seed} {study.name}")
    counts = collections.Counter()
    with tempfile.TemporaryDirectory(prefix="twum-damage-") as scratch:
        finished, killed, damaged = (pathlib.Path(scratch, name) for name in ("finished", "killed", "damaged"))
        begin = time.monotonic()
        finish(start(program, study, finished, jobs=1))
        killed_run(program, study, killed, time.monotonic() - begin, chance)
        expected = results(finished)
        for index in range(count):
            kind = KINDS[index % len(KINDS)]
            source = (finished, killed)[index // len(KINDS) % 2]
            shutil.copytree(source, damaged)
            file = chance.choice([path for path in sorted(damaged.glob("results.db*"))
                                  if not path.name.endswith("-shm") and path.stat().st_size >= PAGE])
            data = bytearray(file.read_bytes())
            what = f"{study.name}, {source.name}, {file.name} of {len(data)} bytes: {kind(data, chance)}"
            file.write_bytes(data)
            try:
                counts[kind.__name__, verdict(program, study, damaged, expected)] += 1
            except AssertionError as error:
                raise AssertionError(f"{what} (seed {seed}, number {index}): {error}") from error
            shutil.rmtree(damaged)
    return counts


def summary_survey(program, study, count, seed=1):
    """How many of so many flipped bits of summary.json were found, and how many change nothing that is compared; none ends verify in any
    other way than by a verdict or a message."""
    chance = random.Random(f"{seed} summary of {study.name}")
    counts = collections.Counter()
    with tempfile.TemporaryDirectory(prefix="twum-damage-") as scratch:
        folder = pathlib.Path(scratch, "finished")
        finish(start(program, study, folder, jobs=1))
        good = (folder / "summary.json").read_bytes()
        for number in range(count):
            data = bytearray(good)
            what = f"{study.name}, summary.json: {flip(data, chance)} (seed {seed}, number {number})"
            (folder / "summary.json").write_bytes(data)
            done = subprocess.run([program, "verify", str(folder), "--samples", "5"], capture_output=True, timeout=HANGS)
            said = (done.stdout + done.stderr).decode(errors="replace")
            if done.returncode not in (0, 1, *REFUSED) or "json.exception" in said:
                raise AssertionError(f"{what}: exit status {done.returncode}: {said}")
            counts["not compared" if done.returncode == 0 else "found"] += 1
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("studies", nargs="+", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    for study in options.studies:
        counts = survey(options.program, study, options.count, options.seed)
        text = ", ".join(f"{kind.__name__} {counts[kind.__name__, 'refused']} refused {counts[kind.__name__, 'same']} same"
                         for kind in KINDS)
        print(f"{study.name}: {options.count} damages, none unnoticed: {text}", flush=True)
        seen = summary_survey(options.program, study, options.count, options.seed)
        print(f"{study.name}: {options.count} bits of its summary flipped: {seen['found']} found, {seen['not compared']} not compared", flush=True)


if __name__ == "__main__":
    sys.exit(main())
