#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/validation.md from the deviations that the core's tests record.

    validation_page.py --recorded FILE       compares the page with what the tests have recorded
    validation_page.py CORE_TESTS            with a run of the tests
    validation_page.py CORE_TESTS --update   makes the page

In page.md.in a line "@ RECORD | TEXT" is a row, "@@" the head of the table. Each record of
tests/support/deviations.hpp has exactly one row. A row holds if its tolerance is the same, the number of comparisons
agrees to 5 % and the deviation within a factor of 10 (or both are below 2e-15): rounding differs from machine to machine.
"""
import argparse
import collections
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/validation.md"
TEMPLATE = pathlib.Path(__file__).with_name("page.md.in")
HEAD = "| compared | tolerance | largest deviation | comparisons |\n| --- | --- | --- | --- |"
ROUNDING = 2e-15
Record = collections.namedtuple("Record", "largest allowed count")


def rounded_up(value):
    """One digit, upwards; the records have three."""
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(value))
    digit = math.ceil(round(value / 10.0**exponent, 6))
    if digit == 10:
        digit, exponent = 1, exponent + 1
    return f"{digit}e{exponent}" if exponent < -2 else f"{digit * 10.0**exponent:g}"


def run_of(program, path):
    """Runs the tests, which append to this file what they record."""
    done = subprocess.run([program, "~[long]"], capture_output=True, text=True,
                          env=os.environ | {"TWUM_DEVIATIONS": str(path), "RC_PARAMS": "seed=42"})
    if done.returncode:
        sys.exit(f"validation_page.py: {program} fails\n{done.stdout[-2000:]}{done.stderr}")


def records_of(path):
    """What the tests recorded, cases that run several times put together."""
    found = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        name, largest, allowed, count = line.rsplit(",", 3)
        before = found.get(name, Record(0.0, 0.0, 0))
        found[name] = Record(max(before.largest, float(largest)), float(allowed), before.count + int(count))
    return found


def row(record, text):
    if record.allowed == 0:
        return f"| {text} | all | {'all hold' if record.largest == 0 else 'NOT ALL HOLD'} | {record.count} |"
    return f"| {text} | {record.allowed:g} | {rounded_up(record.largest)} | {record.count} |"


def same(found, shown):
    """Whether two rows agree as the docstring says."""
    a, b = ([cell.strip() for cell in text.strip("|").split("|")] for text in (found, shown))
    if a[:2] != b[:2] or abs(int(a[3]) - int(b[3])) > 0.05 * int(a[3]):
        return False
    if a[2] == b[2] or "all" in a[1]:
        return a[2] == b[2]
    x, y = float(a[2]), float(b[2])
    return max(x, y) <= ROUNDING or max(x, y) <= 10 * min(x, y)


def page(records):
    """The page's lines."""
    lines, used = [], set()
    for line in TEMPLATE.read_text(encoding="utf-8").splitlines():
        entry = re.fullmatch(r"@ (.+?) \| (.+)", line)
        if line == "@@":
            lines += HEAD.split("\n")
        elif entry:
            name, text = entry.groups()
            if name not in records:
                sys.exit(f"validation_page.py: no record of '{name}'")
            used.add(name)
            lines.append(row(records[name], text))
        else:
            lines.append(line)
    if set(records) - used:
        sys.exit("validation_page.py: no row in page.md.in for: " + "; ".join(sorted(set(records) - used)))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", help="the program core_tests")
    parser.add_argument("--recorded", type=pathlib.Path, metavar="FILE", help="what its cases have recorded")
    parser.add_argument("--update", action="store_true", help="write the page")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        recorded = arguments.recorded or pathlib.Path(folder) / "deviations.csv"
        if arguments.program:
            run_of(arguments.program, recorded)
        lines = page(records_of(recorded))
    if arguments.update:
        PAGE.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return
    shown = PAGE.read_text(encoding="utf-8").splitlines()
    wrong = [f"docs/validation.md: found   {a}\n                    shown   {b}" for a, b in zip(lines, shown)
             if a != b and not (a.startswith("|") and b.startswith("|") and same(a, b))]
    if len(lines) != len(shown):
        wrong.append(f"docs/validation.md: {len(shown)} lines instead of {len(lines)}")
    print("\n".join(wrong + [f"{len(lines)} lines checked, {len(wrong)} wrong"]))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
