# SPDX-License-Identifier: Apache-2.0
"""Whether certified answers of random studies hold: `twum evaluate` shows each limit kept within its stated tolerance, and
neither random designs in the valley of the answer nor a search by another program (SLSQP of scipy, on differences) find one that keeps
the limits and is better by more than 1e-7.

    certificate_survey.py TWUM [--count 300] [--first 0] [--seed 1] [--patience 20] [--minutes M]

The studies are those of stop_study.py, by a solver drawn for each, in turn as `optimize`, `size`, `pareto` and `optimize` under
tolerances. Of a front each certified point has to keep the limits, and one of them is looked beside: no design may be better in
all goals. Under tolerances, where a metric of one motor says nothing of the goal, only the limits of the nominal motor are looked at.
Ends with one line of counts; exit status 1 if an answer does not hold. Needs numpy and scipy.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import numpy
import scipy.optimize

from stop_study import METRICS, random_study

SOLVERS = ["auto", "auto", "nlopt:slsqp", "ipopt", "nlopt:mma", "nlopt:cobyla", "nlopt:ccsaq"]
BETTER = 1e-7


def ranges_of(study):
    found = re.findall(r"    (\w+): \{min: (\S+) (\S*), max: (\S+) \S*, scale: \w+\}", study)
    return {name: (float(low), float(high), unit) for name, low, unit, high in found}


def beside(chance, centre, ranges):
    """A design at a random distance of the answer, in the units of the study, within the ranges."""
    size = 10 ** chance.uniform(-5, -1.3)
    direction = {name: chance.gauss(0, 1) for name in ranges}
    moved = {}
    for name, (low, high, _) in ranges.items():
        value = centre[name] * (1 + size * direction[name] * chance.choice([0, 1, 1]))
        moved[name] = min(max(value, low), high)
    return moved


def evaluate(program, folder, motor, ranges, designs, metrics):
    table = folder / "designs.csv"
    with table.open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow([f"{name} [{unit}]" if unit else name for name, (_, _, unit) in ranges.items()])
        rows.writerows([[repr(design[name]) for name in ranges] for design in designs])
    out = folder / "values.csv"
    done = subprocess.run([program, "evaluate", str(motor), "--designs", str(table), "--metrics", ", ".join(metrics), "-o", str(out)],
                          capture_output=True)
    assert done.returncode == 0, done.stderr.decode(errors="replace")
    with out.open() as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    first = len(ranges)
    return [[float(cell) if cell else math.nan for cell in row[first:first + len(metrics)]] for row in rows[1:]]


KINDS = ["optimize", "size", "pareto", "robust"]


def study_of(kind, text, chance):
    """The random study `text`, which is an `optimize`, as one of another kind."""
    goal = re.search(r"  (minimize|maximize): (.*)\n", text)
    text = re.sub(r"max_evaluations: \d+", f"max_evaluations: {chance.choice([300, 1000, 3000])}", text)
    if kind == "size":
        duty = f"  duty:\n    - {{torque: {chance.uniform(0.05, 0.6):.3g} N.m, speed: {chance.uniform(20, 120):.3g} rpm}}\n"
        text = text.replace(goal[0], duty + f"  prefer: {goal[2]}\n").replace("kind: optimize", "kind: size")
        return text.replace("  constraints:", "  limits:")
    if kind == "pareto":
        other = chance.choice([m for m in METRICS if not m[1] and m[0] not in goal[2] and m[0] != "max_efficiency"])[0]
        goals = f"  objectives:\n    - {goal[1]}: {goal[2]}\n    - {chance.choice(['minimize', 'maximize'])}: {other}\n  points: 5\n"
        text = re.sub(r'name: "[^"]*"', "name: auto", text)  # the one that finds fronts with certificates
        return text.replace(goal[0], goals).replace("kind: optimize", "kind: pareto")
    if kind == "robust":
        tolerances = "  tolerances: {kinetic_friction: 5 %, preload: 2 %}\n"
        if "constraints: [" not in text:
            return text.replace(goal[0], f"  {goal[1]}: mean({goal[2]})\n" + tolerances)
        return text.replace(goal[0], goal[0] + tolerances).replace("constraints: [", 'constraints: ["yield >= 95 %", ')
    return text


def goals_of(study):
    """Signs that make goals to be minimized, and their metrics."""
    found = re.findall(r"  (?:- )?(minimize|maximize|prefer): (.*)\n", study)
    return [(-1 if sense == "maximize" else 1, metric) for sense, metric in found]


def excess(limits, values, allowed):
    """By how much the limits are broken at most, beyond so much of each one's tolerance."""
    worst = -math.inf
    for limit, value in zip(limits, values):
        if math.isnan(value):
            return math.inf
        low, high = limit["lower"], limit["upper"]
        over = max(-math.inf if low is None else low - value, -math.inf if high is None else value - high)
        tolerance = limit["tolerance"] if limit["tolerance"] is not None else 0
        worst = max(worst, over - allowed * tolerance)
    return worst


class Answer:
    """A certified design of a study, with what other programs say of it."""

    def __init__(self, program, folder, text, answer, robust):
        self.program, self.folder, self.ranges = program, folder, ranges_of(text)
        factors = {"um": 1e-6, "mm": 1e-3, "GPa": 1e9, "kHz": 1e3}
        self.centre = {name: answer["design"][name] / factors.get(unit, 1) for name, (_, _, unit) in self.ranges.items()}
        self.limits, self.goals = answer["constraints"], [] if robust else goals_of(text)
        self.motor = folder / "motor.yaml"
        self.motor.write_text(text[:text.index("study:\n")])
        self.best = self.values([self.centre])[0] if self.goals or self.limits else []

    def values(self, designs):
        """Goals to be minimized, then the limits' metrics."""
        metrics = [metric for _, metric in self.goals] + [limit["metric"] for limit in self.limits]
        once = list(dict.fromkeys(metrics))  # no metric may be asked for twice
        table = evaluate(self.program, self.folder, self.motor, self.ranges, designs, once)
        rows = [[row[once.index(metric)] for metric in metrics] for row in table]
        return [[sign * value for (sign, _), value in zip(self.goals, row)] + row[len(self.goals):] for row in rows]

    def broken(self):
        """By how much a limit is broken beyond its tolerance; what the table rounds is worth the last digits of a metric."""
        size = max([abs(limit["limit"]) for limit in self.limits] or [0])
        over = excess(self.limits, self.best[len(self.goals):], 1)
        return over if over > 1e-11 * size else 0

    def better(self, row):
        """Whether values keep the limits and all goals are better by more than 1e-7."""
        number = len(self.goals)
        if not excess(self.limits, row[number:], 0) <= 0:
            return False
        return all(value < best - BETTER * abs(best) for value, best in zip(row, self.best[:number]))

    def in_its_valley(self, design):
        """Whether no goal rises on the straight way to a better design: else that is another local optimum."""
        way = [{name: c + part * (design[name] - c) for name, c in self.centre.items()} for part in numpy.linspace(0, 1, 41)]
        return all(value <= best + 1e-9 * abs(best) for row in self.values(way) for value, best in zip(row, self.best[:len(self.goals)]))

    def random_search(self, chance):
        designs = [beside(chance, self.centre, self.ranges) for _ in range(300)]
        better = [design for design, row in zip(designs, self.values(designs)) if self.better(row)]
        return next((design for design in better if self.in_its_valley(design)), None)

    def descent(self):
        """SLSQP within 3 % of the answer on central differences. Several goals have to fall alike, by t each."""
        names, number = list(self.ranges), len(self.goals)
        centre = numpy.array([self.centre[name] for name in names])
        size = numpy.maximum(numpy.abs(centre), 1e-12)
        scale = numpy.array([max(abs(best), 1e-12) for best in self.best[:number]])
        box = [(max(low, c - 0.03 * s) / s, min(high, c + 0.03 * s) / s)
               for (low, high, _), c, s in zip(self.ranges.values(), centre, size)]
        known, found = {}, []

        def look(x):
            key = tuple(x)
            if key not in known:
                steps = [numpy.zeros(len(x))] + [sign * 1e-6 * row for row in numpy.eye(len(x)) for sign in (1, -1)]
                designs = [{name: min(max(value, self.ranges[name][0]), self.ranges[name][1])
                            for name, value in zip(names, (x + step) * size)} for step in steps]
                rows = numpy.array(self.values(designs))
                if self.better(list(rows[0])):
                    found.append(designs[0])
                moved = numpy.array([[design[name] for name in names] for design in designs]) / size
                width = numpy.array([moved[1 + 2 * k][k] - moved[2 + 2 * k][k] for k in range(len(x))])
                slopes = (rows[1::2] - rows[2::2]).T / width
                if not (numpy.isfinite(rows).all() and numpy.isfinite(slopes).all()):
                    raise ArithmeticError
                known[key] = rows[0], slopes
            return known[key]

        def sides(x):
            """Values >= 0 and their slopes by x and t."""
            row, slopes = look(x[:-1])
            lines = [((b - v) / s - x[-1], numpy.append(-d / s, -1)) for v, d, s, b in
                     zip(row, slopes, scale, self.best[:number])]
            for limit, value, slope in zip(self.limits, row[number:], slopes[number:]):
                unit = max(abs(limit["limit"]), 1e-12)
                for bound, sign in ((limit["lower"], 1), (limit["upper"], -1)):
                    if bound is not None:
                        lines.append((sign * (value - bound) / unit, numpy.append(sign * slope / unit, 0)))
            return lines

        start = numpy.append(numpy.clip(centre / size, [low for low, _ in box], [high for _, high in box]), 0.0)
        try:
            scipy.optimize.minimize(
                lambda x: -x[-1], start, jac=lambda x: numpy.append(numpy.zeros(len(x) - 1), -1), method="SLSQP",
                bounds=box + [(-1, 1)], options={"maxiter": 15, "ftol": 1e-12},
                constraints={"type": "ineq", "fun": lambda x: numpy.array([v for v, _ in sides(x)]),
                             "jac": lambda x: numpy.array([d for _, d in sides(x)])})
        except ArithmeticError:  # a design beside it has no value
            pass
        return found[-1] if found else None


def survey_one(program, chance, folder, patience, number):
    """Kind, outcome, and what does not hold."""
    kind = KINDS[number % len(KINDS)]
    text = study_of(kind, random_study(chance, chance.choice(SOLVERS)), chance)
    study = folder / "study.yaml"
    study.write_text(text)
    try:
        done = subprocess.run([program, "run", str(study), "-o", str(folder / "out"), "--jobs", "1"], capture_output=True, timeout=patience)
    except subprocess.TimeoutExpired:
        return kind, "slow", []
    if done.returncode == 2:
        return kind, "refused", []
    assert done.returncode in (0, 1), f"exit status {done.returncode}: {done.stderr.decode(errors='replace')}"
    summary = json.loads((folder / "out/summary.json").read_text())
    points = summary["front"] if kind == "pareto" else [summary["best"]] if summary.get("best") else []
    answers = [Answer(program, folder, text, point, kind == "robust") for point in points if point["certificate"]["passed"]]
    if not answers:
        return kind, summary["outcome"], []
    wrong = [f"a limit is broken by {answer.broken():.3g} more than its tolerance" for answer in answers if answer.broken()]
    if kind != "robust":
        answer = chance.choice(answers)
        for name, design in (("random", answer.random_search(chance)), ("descent", answer.descent())):
            if design:
                wrong.append(f"{name}: {answer.goals} {answer.values([design])[0]} instead of {answer.best} at {design}")
    return kind, "certified", wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--patience", type=float, default=20)
    parser.add_argument("--minutes", type=float, default=math.inf)
    options = parser.parse_args()
    tally = collections.Counter()
    until = time.monotonic() + 60 * options.minutes
    for number in range(options.first, options.first + options.count):
        if time.monotonic() > until:
            break
        with tempfile.TemporaryDirectory(prefix="twum-certificate-") as scratch:
            chance = random.Random(f"{options.seed} {number}")
            kind, outcome, wrong = survey_one(options.program, chance, pathlib.Path(scratch), options.patience, number)
        tally["studies"] += 1
        tally[f"{kind} {outcome}"] += 1
        tally["wrong"] += len(wrong) > 0
        for word in wrong:
            print(f"seed {options.seed}, study {number}: {word}", flush=True)
        if sys.stderr.isatty():
            print(f"\r{number} {dict(tally)}", end="", file=sys.stderr)
    print(f"certificate_survey: {dict(tally)}", flush=True)
    return 1 if tally["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
