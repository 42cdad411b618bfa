#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes the sources one token at a time and sees whether the tests notice.

    scripts/mutate.py --count 30                           30 changes somewhere in the core, headers included
    scripts/mutate.py --files core/src/contact --seed 2    elsewhere, other ones
    scripts/mutate.py --layer optim --count 30             the optimizers with their own tests
    scripts/mutate.py --list --files core/src/contact/lap.cpp

A change replaces an arithmetic operator, a comparison, a logical operator, a sign, true or false, or a
number. The tree is copied to --folder and built there once; each change rebuilds what depends on the file
and runs the test programs until one fails. Outcomes are kept in results.jsonl of that folder, so a second
call with the same arguments goes on where the first one stopped; the changes and their order follow from
the seed and the sources alone. --again tries the survivors anew, once there are more tests.

Outcomes: killed (a test failed or crashed), timeout (counts as killed), stillborn (does not compile;
not counted), survived.
"""
import argparse
import json
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
# Test programs with their Catch2 arguments, the quickest first: most changes die at once.
LAYERS = {
    "core": (["core/src", "core/include", "core/base"], ["core_inside_tests", "core_tests ~[slow]~[long]", "core_tests [slow]~[long]"]),
    "optim": (["optim/src", "optim/include"], ["optim_tests"]),
}
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


def blanked(source):
    """The source with comments and literals replaced by blanks of the same shape."""
    return NOISE.sub(lambda m: re.sub(r"[^\n]", "\x00", m.group()), source)


def other_number(text):
    if "x" in text:
        return f"(2 * {text})"
    if text.replace("'", "").isdigit():
        return str(int(text.replace("'", "")) + 1)
    return "1.0" if float(text) == 0 else f"(1.5 * {text})"


def changes_of(path, name):
    """Every change of one file: its place, what stands there, and what is put there."""
    source = path.read_text(encoding="utf-8")
    lines = source.split("\n")
    for number, line in enumerate(blanked(source).split("\n"), 1):
        if SKIPPED.match(line):
            continue
        found = [(m, SWAPS[m.group()]) for m in OPERATOR.finditer(line)]
        found += [(m, "") for m in SIGN.finditer(line)]
        found += [(m, "false" if m.group() == "true" else "true") for m in WORD.finditer(line)]
        found += [(m, other_number(m.group())) for m in NUMBER.finditer(line)]
        for match, new in found:
            yield {"file": name, "line": number, "column": match.start() + 1, "old": match.group(), "new": new,
                   "text": lines[number - 1].strip()}


def all_changes(folders):
    found = []
    for folder in folders:
        start = ROOT / folder
        paths = [start] if start.is_file() else sorted(p for p in start.rglob("*") if p.suffix in (".cpp", ".hpp"))
        for path in paths:
            found += changes_of(path, path.relative_to(ROOT).as_posix())
    return found


def key(change):
    return tuple(change[k] for k in ("file", "line", "column", "old", "new", "text"))


def text_of(change):
    return f"{change['file']}:{change['line']}:{change['column']}: '{change['old'].strip()}' -> '{change['new'].strip()}'"


class Copy:
    """A copy of the tree with its build."""

    def __init__(self, folder, tests):
        self.tree, self.build = folder / "tree", folder / "build"
        self.tests = [shlex.split(test) for test in tests]

    def make(self):
        self.tree.mkdir(parents=True, exist_ok=True)
        subprocess.run(["rsync", "-a", "--checksum", "--delete", "--exclude", ".git", "--exclude", "/build*",
                        f"{ROOT}/", f"{self.tree}/"], check=True)
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DTWUM_BUILD_CLI=OFF",
                        "-DTWUM_BUILD_PYTHON=OFF", "-DTWUM_PRECOMPILE=ON", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", *launcher], check=True, stdout=subprocess.DEVNULL)

    def compile(self, jobs):
        targets = sorted({test[0] for test in self.tests})
        done = subprocess.run(["ninja", "-C", self.build, f"-j{jobs}", *targets], capture_output=True, text=True)
        return done.returncode == 0, done.stdout

    def run(self, limits=None):
        """Times of the programs, and the first failure or None."""
        times = []
        for i, (program, *arguments) in enumerate(self.tests):
            start = time.monotonic()
            limit = limits[i] if limits else None
            failure = run_program(self.build / "tests/bin" / program, arguments, limit)
            times.append(time.monotonic() - start)
            if failure:
                return times, failure
        return times, None


def run_program(program, arguments, limit):
    """None if all cases pass, else the name of what failed first."""
    process = subprocess.Popen([program, *arguments, "--abort"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace", start_new_session=True,
                               env=os.environ | {"RC_PARAMS": "seed=42"})
    try:
        output, _ = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return "timeout"
    if process.returncode == 0:
        return None
    # Catch2's report of a failure: a rule, the case's name, a rule.
    heading = re.search(r"^-{79}\n(.+?)\n-{79}$", output, re.M | re.S)
    name = " ".join(heading.group(1).split()) if heading else "no report"
    return f"{name} (signal {-process.returncode})" if process.returncode < 0 else name


def try_change(copy, change, limits, jobs):
    path = copy.tree / change["file"]
    source = path.read_text(encoding="utf-8")
    lines = source.split("\n")
    line, at = lines[change["line"] - 1], change["column"] - 1
    assert line.startswith(change["old"], at), f"{text_of(change)}: the copy differs"
    lines[change["line"] - 1] = line[:at] + change["new"] + line[at + len(change["old"]):]
    path.write_text("\n".join(lines), encoding="utf-8")
    try:
        compiled, _ = copy.compile(jobs)
        if not compiled:
            return {"outcome": "stillborn"}
        _, failure = copy.run(limits)
    finally:
        path.write_text(source, encoding="utf-8")
    if failure is None:
        return {"outcome": "survived"}
    return {"outcome": "timeout" if failure == "timeout" else "killed", "by": failure}


def report(results):
    counts = {}
    for result in results:
        counts[result["outcome"]] = counts.get(result["outcome"], 0) + 1
    print(f"{len(results)} changes: " + ", ".join(f"{n} {what}" for what, n in sorted(counts.items())))
    for result in sorted(results, key=key):
        if result["outcome"] == "survived":
            print(f"{text_of(result)}\n    {result['text']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--layer", choices=LAYERS, default="core", help="whose sources and tests")
    parser.add_argument("--files", nargs="+", help="files or folders to change instead of the layer's")
    parser.add_argument("--tests", nargs="+", help="test programs with arguments, each one word of the shell")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="compile jobs")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/mutate")
    parser.add_argument("--again", action="store_true", help="try known survivors once more")
    parser.add_argument("--list", action="store_true", help="print the changes that would be tried")
    arguments = parser.parse_args()

    folders, tests = LAYERS[arguments.layer]
    absent = [name for name in arguments.files or [] if not (ROOT / name).exists()]
    if absent:
        parser.error(f"no such file or folder below {ROOT}: {', '.join(absent)}")
    chosen = all_changes(arguments.files or folders)
    random.Random(arguments.seed).shuffle(chosen)
    chosen = chosen[:arguments.count]
    if arguments.list:
        print("\n".join(text_of(change) for change in chosen))
        return

    copy = Copy(arguments.folder.resolve(), arguments.tests or tests)
    copy.make()
    compiled, log = copy.compile(arguments.jobs)
    if not compiled:
        sys.exit(f"mutate.py: the unchanged tree does not compile\n{log}")
    times, failure = copy.run()
    if failure:
        sys.exit(f"mutate.py: the unchanged tree fails: {failure}")
    limits = [10 * t + 60 for t in times]

    record = arguments.folder / "results.jsonl"
    known = {}
    if record.exists():
        known = {key(row): row for row in map(json.loads, record.read_text(encoding="utf-8").splitlines())}
    results = []
    for number, change in enumerate(chosen, 1):
        outcome = known.get(key(change), {}).get("outcome")
        if outcome is None or (outcome == "survived" and arguments.again):
            known[key(change)] = change | try_change(copy, change, limits, arguments.jobs)
            with record.open("a", encoding="utf-8") as file:
                file.write(json.dumps(known[key(change)]) + "\n")
        results.append(known[key(change)])
        print(f"{number}/{len(chosen)} {text_of(change)}: {results[-1]['outcome']} {results[-1].get('by', '')}",
              flush=True)
    report(results)


if __name__ == "__main__":
    main()
