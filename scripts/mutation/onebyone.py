# SPDX-License-Identifier: Apache-2.0
"""Tries what no run can switch, such as constants that the compiler needs: one change, one build."""
import re
import shlex
import sys
import tempfile
import time

from .build import Copy
from .cases import environment, run
from .changes import text_of

# Test programs with their Catch2 arguments, the quickest first: most changes die at once.
TESTS = {"core": ["core_inside_tests", "core_tests ~[slow]~[long]", "core_tests [slow]~[long]"],
         "optim": ["optim_inside_tests", "optim_tests"]}


class Plain(Copy):
    """The copy that one change at a time is written into."""

    def __init__(self, folder, tests):
        super().__init__(folder / "plain", "-O1 -w -DNDEBUG")
        self.tests = [shlex.split(test) for test in tests]

    def make(self, jobs):
        self.copy()
        self.configure()
        built, log = self.compile(self.programs(), jobs)
        if not built:
            sys.exit(f"mutate.py: the unchanged tree does not compile\n{log[-5000:]}")
        times, failure = self.run_tests()
        if failure:
            sys.exit(f"mutate.py: the unchanged tree fails: {failure}")
        self.limits = [10 * t + 60 for t in times]

    def programs(self):
        return sorted({test[0] for test in self.tests})

    def run_tests(self, limits=None):
        """Times of the programs, and the first failure or None."""
        times = []
        for i, (program, *arguments) in enumerate(self.tests):
            start = time.monotonic()
            failure = failure_of([self.program(program), *arguments, "--abort"], limits and limits[i])
            times.append(time.monotonic() - start)
            if failure:
                return times, failure
        return times, None

    def outcome(self, change, jobs):
        path = self.tree / change["file"]
        source = path.read_text(encoding="utf-8")
        lines = source.split("\n")
        line, at = lines[change["line"] - 1], change["column"] - 1
        assert line.startswith(change["old"], at), f"{text_of(change)}: the copy differs"
        lines[change["line"] - 1] = line[:at] + change["new"] + line[at + len(change["old"]):]
        path.write_text("\n".join(lines), encoding="utf-8")
        start = time.monotonic()
        try:
            if not self.compile(self.programs(), jobs)[0]:
                return {"outcome": "stillborn"}
            _, failure = self.run_tests(self.limits)
        finally:
            path.write_text(source, encoding="utf-8")
        seconds = round(time.monotonic() - start, 3)
        if failure is None:
            return {"outcome": "survived", "seconds": seconds}
        return {"outcome": "endless" if failure == "endless" else "killed", "by": failure, "seconds": seconds}


def failure_of(command, limit):
    """None if all cases pass, else the name of what failed first."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as file:
        status = run([str(word) for word in command], environment(), limit, file)
        file.seek(0)
        output = file.read()
    if status == 0:
        return None
    if status is None:
        return "endless"
    # Catch2's report of a failure: a rule, the case's name, a rule.
    heading = re.search(r"^-{79}\n(.+?)\n-{79}$", output, re.M | re.S)
    name = " ".join(heading.group(1).split()) if heading else "no report"
    return f"{name} (signal {-status})" if status < 0 else name
