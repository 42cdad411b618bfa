# SPDX-License-Identifier: Apache-2.0
"""Tries a change that is switched on at run time: the cases that could notice it, the most promising first."""
import array
import pathlib
import tempfile
import threading
import time

from .cases import ANSWERS, DIFFERED, FORMLESS, REACHED, environment, run

LEAST_LIMIT, TIMES_LIMIT, TIMES_ANSWERS = 1.0, 8.0, 10.0  # [s], of the case's own time
TIMES_FURTHER = 10  # budgets for changes that may alter an answer


class Odds:
    """How often each case noticed changes of a file, and of any: kills a second decide the order."""

    def __init__(self):
        self.lock = threading.Lock()
        self.counts = {}  # (file or None, title) -> [noticed, tried]

    def note(self, file, case, noticed):
        with self.lock:
            for place in (file, None):
                count = self.counts.setdefault((place, case.title), [0, 0])
                count[0] += noticed
                count[1] += 1

    def ordered(self, file, cases):
        def promise(case):
            here, all_in_all = (self.counts.get((place, case.title), (0, 0)) for place in (file, None))
            odds = (3 * here[0] + all_in_all[0] + 0.5) / (3 * here[1] + all_in_all[1] + 1)
            return odds / (case.seconds + 0.005)
        with self.lock:
            return sorted(cases, key=promise, reverse=True)


class Trial:
    """The cases of a layer, and what they say about one change after the other."""

    def __init__(self, cases, budget):
        self.cases = [case for case in cases if case.name != ANSWERS]
        self.answers = next((case for case in cases if case.name == ANSWERS), None)
        self.budget = budget if budget is not None else float("inf")
        self.odds = Odds()
        self.expected = self.ask(None)[1] if self.answers else None

    def seen(self, number):
        bits = 0
        for case in self.cases:
            bits |= case.record[number]
        return bits

    def without_running(self, number):
        """The outcome that the records alone tell, or None."""
        bits = self.seen(number)
        if bits & DIFFERED:
            return None
        if bits & REACHED:
            return "equivalent"
        return "stillborn" if bits & FORMLESS else "unreached"

    def outcome(self, number, change, before):
        """before: the row of an earlier trial that ran out of its budget, or None."""
        said = self.without_running(number)
        if said:
            return {"outcome": said}
        before = before or {}
        row = self.after_cases(number, change, before, self.budget)
        if not row["outcome"].startswith("survived") or not self.answers:
            return row
        row["class"] = before.get("class") or self.answers_with(number)
        if row["class"] == "same answers" or row["outcome"] == "survived":
            return row
        further = self.after_cases(number, change, row, TIMES_FURTHER * self.budget)
        return {"class": row["class"]} | further if further["outcome"].startswith("survived") else further

    def after_cases(self, number, change, before, budget):
        """What the cases say that fit into the budget and were not run before."""
        waiting = [case for case in self.cases if case.differs(number)]
        if "left" in before:
            waiting = [case for case in waiting if case.title in before["left"]]
        spent, ran = before.get("seconds", 0), before.get("cases", 0)
        while True:
            fitting = [case for case in waiting if spent + case.seconds <= budget]
            if not fitting:
                break
            case = self.odds.ordered(change["file"], fitting)[0]
            waiting.remove(case)
            start = time.monotonic()
            status = run(case.command(), environment(number), max(LEAST_LIMIT, TIMES_LIMIT * case.seconds))
            spent, ran = spent + time.monotonic() - start, ran + 1
            self.odds.note(change["file"], case, status != 0)
            if status != 0:
                by = case.title + (f" (signal {-status})" if status is not None and status < 0 else "")
                return {"outcome": "endless" if status is None else "killed", "by": by, "seconds": round(spent, 3),
                        "cases": ran}
        row = {"outcome": "survived so far" if waiting else "survived", "seconds": round(spent, 3), "cases": ran}
        if waiting:
            row |= {"left": [case.title for case in waiting], "budget": self.budget}
        return row

    def ask(self, number):
        """Status and numbers of the program of answers."""
        limit = None if number is None else max(LEAST_LIMIT, TIMES_ANSWERS * self.answers.seconds)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "answers"
            with path.open("wb") as file:
                status = run(self.answers.command(), environment(number), limit, file)
            numbers = array.array("d")
            data = path.read_bytes()
            numbers.frombytes(data[:len(data) // 16 * 16])
        return status, numbers

    def answers_with(self, number):
        if not self.answers.differs(number):
            return "not asked"  # the designs of the answers never make it differ
        status, found = self.ask(number)
        return "same answers" if status == 0 and same(found, self.expected) else "other answers"


def same(found, expected):
    """Pairs of value and allowed difference; numbers that are none agree with each other."""
    if len(found) != len(expected):
        return False
    for i in range(0, len(expected), 2):
        a, b = found[i], expected[i]
        if a != b and not abs(a - b) <= expected[i + 1] and not (a != a and b != b):
            return False
    return True
