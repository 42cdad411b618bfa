# SPDX-License-Identifier: Apache-2.0
"""Whether certified answers of random studies hold: `twum evaluate` shows each limit kept within its stated tolerance, and
no random design beside the answer that keeps the limits is better by more than 1e-7.

    certificate_survey.py TWUM [--count 300] [--seed 1] [--patience 20] [--minutes M]

The studies are those of stop_study.py, by a solver drawn for each. Ends with one line of counts; exit status 1 if an answer
does not hold.
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

from stop_study import random_study

SOLVERS = ["auto", "auto", "nlopt:slsqp", "ipopt", "nlopt:mma", "nlopt:cobyla", "nlopt:ccsaq"]
BETTER = 1e-7


def ranges_of(study):
    found = re.findall(r"    (\w+): \{min: (\S+) (\S+), max: (\S+) \S+, scale: \w+\}", study)
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
        rows.writerow([f"{name} [{unit}]" for name, (_, _, unit) in ranges.items()])
        rows.writerows([[repr(design[name]) for name in ranges] for design in designs])
    out = folder / "values.csv"
    subprocess.run([program, "evaluate", str(motor), "--designs", str(table), "--metrics", ", ".join(metrics), "-o", str(out)],
                   capture_output=True, check=True)
    with out.open() as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    first = len(ranges)
    return [[float(cell) if cell else math.nan for cell in row[first:first + len(metrics)]] for row in rows[1:]]


def survey_one(program, chance, folder, patience):
    """Outcome, and what does not hold."""
    solver = chance.choice(SOLVERS)
    text = random_study(chance, solver)
    study = folder / "study.yaml"
    study.write_text(text)
    motor = folder / "motor.yaml"
    motor.write_text(text[:text.index("study:\n")])
    try:
        done = subprocess.run([program, "run", str(study), "-o", str(folder / "out"), "--jobs", "1"], capture_output=True, timeout=patience)
    except subprocess.TimeoutExpired:
        return "slow", []
    assert done.returncode in (0, 1), f"exit status {done.returncode}: {done.stderr.decode(errors='replace')}"
    summary = json.loads((folder / "out/summary.json").read_text())
    if summary["outcome"] != "optimal":
        return summary["outcome"], []
    ranges = ranges_of(text)
    # SI to the unit of the study, by the ends of the ranges in both.
    si = {name: summary["best"]["design"][name] for name in ranges}
    factors = {"um": 1e-6, "mm": 1e-3, "GPa": 1e9, "kHz": 1e3}
    centre = {name: si[name] / factors.get(unit, 1) for name, (_, _, unit) in ranges.items()}
    limits = summary["best"]["constraints"]
    goal = re.search(r"  (minimize|maximize): (.*)\n", text)
    metrics = [goal[2]] + [limit["metric"] for limit in limits]
    designs = [centre] + [beside(chance, centre, ranges) for _ in range(300)]
    values = evaluate(program, folder, motor, ranges, designs, metrics)
    wrong = []

    def excess(row, allowed):
        """By how much the limits are broken at most, beyond so much of each one's tolerance."""
        worst = -math.inf
        for limit, value in zip(limits, row[1:]):
            if math.isnan(value):
                return math.inf
            low, high = limit["lower"], limit["upper"]
            over = max(-math.inf if low is None else low - value, -math.inf if high is None else value - high)
            worst = max(worst, over - allowed * limit["tolerance"])
        return worst

    # What the table rounds of the design is worth a few of the last digits of a metric.
    size = max([abs(limit["limit"]) for limit in limits] or [0])
    broken = excess(values[0], 1)
    if broken > 1e-11 * size:
        wrong.append(f"a limit is broken by {broken:.3g} more than its tolerance")
    sign = 1 if goal[1] == "minimize" else -1
    best = sign * values[0][0]
    for design, row in zip(designs[1:], values[1:]):
        if excess(row, 0) <= 0 and sign * row[0] < best - BETTER * abs(best):
            wrong.append(f"{goal[2]} {row[0]!r} instead of {values[0][0]!r} at {design}")
            break
    return "optimal", wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--patience", type=float, default=20)
    parser.add_argument("--minutes", type=float, default=math.inf)
    options = parser.parse_args()
    tally = collections.Counter()
    until = time.monotonic() + 60 * options.minutes
    for number in range(options.count):
        if time.monotonic() > until:
            break
        with tempfile.TemporaryDirectory(prefix="twum-certificate-") as scratch:
            chance = random.Random(f"{options.seed} {number}")
            outcome, wrong = survey_one(options.program, chance, pathlib.Path(scratch), options.patience)
        tally["studies"] += 1
        tally[outcome] += 1
        tally["wrong"] += len(wrong) > 0
        for word in wrong:
            print(f"seed {options.seed}, study {number}: {word}", flush=True)
    print(f"certificate_survey: {dict(tally)}", flush=True)
    return 1 if tally["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
