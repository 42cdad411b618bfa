#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes one token of the sources at a time and sees whether the tests notice.

    scripts/mutate.py core/src/contact/lap.cpp                      every change of one file
    scripts/mutate.py optim/src --count 30 --seed 2                 30 changes of a folder, drawn at random
    scripts/mutate.py studies/io --tests "studies_tests [store]" "entries_tests [store]"
    scripts/mutate.py --list core/src/contact/lap.cpp               prints the changes

A change replaces an arithmetic operator, a comparison, a logical operator, a sign, true or false, or a number. Each is
made in a copy of the tree in build/mutate, which is built and tested: one change takes seconds to minutes. Outcomes:
killed (a test failed), endless (the tests took ten times as long), stillborn (does not compile), survived. They are kept
in build/mutate/outcomes.csv, and a second call goes on where the first one stopped. A survivor is a gap in the tests, or
a change that makes no difference: read it.
"""
import argparse
import csv
import os
import pathlib
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build/mutate"
TREE, BUILD, OUTCOMES = FOLDER / "tree", FOLDER / "build", FOLDER / "outcomes.csv"
FLAGS = "-O1 -w -DNDEBUG"
# Test programs with their Catch2 arguments, the quickest first: most changes are killed at once.
TESTS = {"core": ["core_inside_tests", "core_tests ~[slow]~[long]"],
         "optim": ["optim_inside_tests ~[long]", "optim_tests ~[long]"],
         "studies": ["entries_tests ~[long]", "answers_tests ~[long]", "studies_tests ~[long]"]}

SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " -= ": " += ",
         " *= ": " /= ", " /= ": " *= ", " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ",
         " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && "}
# clang-format puts blanks round binary operators and none round template brackets or pointers.
OPERATOR = re.compile("|".join(re.escape(op) for op in sorted(SWAPS, key=len, reverse=True)))
SIGN = re.compile(r"(?<=[(=,?:{] )-(?=[\w(])|(?<=[({])-(?=[\w(])|(?<=return )-(?=[\w(])")
WORD = re.compile(r"\b(?:true|false)\b")
NUMBER = re.compile(r"(?<![\w.\"'])(?:\d+(?:'\d+)*\.?\d*(?:e[+-]?\d+)?|0x[\da-f.]+p[+-]?\d+)(?![\w.])")
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|(?<!\d)\'(?:[^\'\\\n]|\\.)+\'', re.S)
# Lines that say nothing a test could notice: the preprocessor, checks of types, our own assertions.
SKIPPED = re.compile(r"^\s*(#|template <|static_assert|TWUM_ASSERT|using )")
FIELDS = ["file", "line", "column", "old", "new", "text"]


def other_number(text):
    if "x" in text:
        return f"(2 * {text})"
    if text.replace("'", "").isdigit():
        return str(int(text.replace("'", "")) + 1)
    return "1.0" if float(text) == 0 else f"(1.5 * {text})"


def changes_in(name):
    """Every change of a source: its place, what stands there, and what is put there."""
    source = (ROOT / name).read_text(encoding="utf-8")
    lines = source.split("\n")
    code = NOISE.sub(lambda m: re.sub(r"[^\n]", "\x00", m.group()), source)  # same shape, without comments and literals
    for number, line in enumerate(code.split("\n"), 1):
        if SKIPPED.match(line):
            continue
        found = [(m, SWAPS[m.group()]) for m in OPERATOR.finditer(line)]
        found += [(m, "") for m in SIGN.finditer(line)]
        found += [(m, "false" if m.group() == "true" else "true") for m in WORD.finditer(line)]
        found += [(m, other_number(m.group())) for m in NUMBER.finditer(line)]
        for match, new in found:
            yield {"file": name, "line": str(number), "column": str(match.start() + 1), "old": match.group(), "new": new,
                   "text": lines[number - 1].strip()}


def sources(places):
    for place in places:
        start = ROOT / place
        paths = [start] if start.is_file() else sorted(p for p in start.rglob("*") if p.suffix in (".cpp", ".hpp"))
        yield from (path.relative_to(ROOT).as_posix() for path in paths)


def text_of(change):
    return f"{change['file']}:{change['line']}:{change['column']}: '{change['old'].strip()}' -> '{change['new'].strip()}'"


def copy_tree():
    """Copies what git knows or would add; what has not changed keeps its time, so that it is not built again."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            stdout=subprocess.PIPE, check=True).stdout
    for name in filter(None, listed.decode().split("\0")):
        source, copy = ROOT / name, TREE / name
        if not source.is_file() or (copy.is_file() and copy.read_bytes() == source.read_bytes()):
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, copy)


def build(programs, jobs):
    """The compiler's words if the programs cannot be built."""
    done = subprocess.run(["cmake", "--build", BUILD, "-j", str(jobs), "--target", *programs], capture_output=True, text=True)
    return done.stdout + done.stderr if done.returncode else ""


def run_tests(tests, limit=None):
    """'' if all pass, else the name of the test case that failed first, or 'endless'."""
    for test in tests:
        program, *arguments = shlex.split(test)
        process = subprocess.Popen([BUILD / "tests/bin" / program, *arguments, "--abort"], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True,
                                   env={**os.environ, "RC_PARAMS": "seed=42"})
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            return "endless"
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                process.communicate()
        if process.returncode:
            # Catch2's report of a failure: a rule, the case's name, a rule.
            heading = re.search(r"^-{79}\n(.+?)\n-{79}$", output, re.M | re.S)
            return " ".join(heading.group(1).split()) if heading else f"{program}: exit status {process.returncode}"
    return ""


def outcome(change, tests, programs, limit, jobs):
    path = TREE / change["file"]
    source = path.read_text(encoding="utf-8")
    lines = source.split("\n")
    line, at = lines[int(change["line"]) - 1], int(change["column"]) - 1
    lines[int(change["line"]) - 1] = line[:at] + change["new"] + line[at + len(change["old"]):]
    path.write_text("\n".join(lines), encoding="utf-8")
    try:
        if build(programs, jobs):
            return "stillborn", ""
        failed = run_tests(tests, limit)
    finally:
        path.write_text(source, encoding="utf-8")
    return ("survived", "") if not failed else ("endless", "") if failed == "endless" else ("killed", failed)


def prepare(tests, programs, jobs):
    """Builds and tests the unchanged tree; the time that tests of a changed one may take [s]."""
    copy_tree()
    launcher = [f"-DCMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache')}"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *launcher,
                    f"-DCMAKE_CXX_FLAGS_RELEASE={FLAGS}", "-DTWUM_BUILD_PYTHON=OFF"], check=True, stdout=subprocess.DEVNULL)
    said = build(programs, jobs)
    start = time.monotonic()
    failed = said[-5000:] or run_tests(tests)
    if failed:
        sys.exit(f"mutate.py: the unchanged tree does not build or fails: {failed}")
    return 10 * (time.monotonic() - start) + 60


def known_outcomes():
    if not OUTCOMES.exists():
        return {}
    with OUTCOMES.open(encoding="utf-8", newline="") as file:
        return {tuple(row[name] for name in FIELDS): row for row in csv.DictReader(file)}


def try_changes(chosen, tests, jobs):
    programs = sorted({shlex.split(test)[0] for test in tests})
    limit = prepare(tests, programs, jobs)
    known = known_outcomes()
    with OUTCOMES.open("a", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [*FIELDS, "outcome", "by"])
        if not known:
            writer.writeheader()
        for number, change in enumerate(chosen, 1):
            row = known.get(tuple(change.values()))
            if row is None:
                found, by = outcome(change, tests, programs, limit, jobs)
                row = {**change, "outcome": found, "by": by}
                writer.writerow(row)
                file.flush()
            print(f"{number}/{len(chosen)} {text_of(change)}: {row['outcome']} {row['by']}".rstrip(), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("places", nargs="+", help="files or folders to change, all of one layer")
    parser.add_argument("--tests", nargs="+", help="test programs with their arguments; those of the layer by default")
    parser.add_argument("--count", type=int, help="how many changes, drawn by the seed; all by default")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="compile jobs at a time")
    parser.add_argument("--list", action="store_true", help="print the changes and try none")
    options = parser.parse_args()
    for place in options.places:
        if not (ROOT / place).exists():
            parser.error(f"no such file or folder: {place}; paths start in the root of the repository")
    tests = options.tests or TESTS.get(pathlib.PurePath(options.places[0]).parts[0])
    if not tests:
        parser.error(f"no tests are known for {options.places[0]}; give some by --tests")
    chosen = [change for name in sources(options.places) for change in changes_in(name)]
    random.Random(options.seed).shuffle(chosen)
    chosen = chosen[:options.count]
    if options.list:
        print("\n".join(map(text_of, chosen)) or "no changes")
        return
    FOLDER.mkdir(parents=True, exist_ok=True)
    try_changes(chosen, tests, options.jobs)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("mutate.py: stopped; the same call goes on")
