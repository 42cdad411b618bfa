# SPDX-License-Identifier: Apache-2.0
"""What became of the changes: the file that keeps it, and the report."""
import collections
import csv
import json
import threading

from .changes import LAYERS, key, text_of
from .reasons import reason, rules_of

OUTCOMES = ["killed", "endless", "stillborn", "equivalent", "unreached", "survived", "survived so far", "fixed",
            "untried"]
SURVIVED = {"survived", "survived so far"}
LISTED = ["survived", "survived so far", "unreached"]


class Results:
    """Rows of results.jsonl by their change; the last one of a change counts."""

    def __init__(self, path):
        self.path, self.lock, self.rows = path, threading.Lock(), {}
        if path.exists():
            for line in path.read_text(encoding="utf-8").splitlines():
                try:
                    row = json.loads(line)
                    self.rows[key(row)] = row
                except ValueError:
                    pass  # the line that a killed run was writing

    def add(self, change, found):
        row = change | found
        with self.lock:
            if self.rows.get(key(change)) != row:
                self.rows[key(change)] = row
                with self.path.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(row) + "\n")

    def of(self, change):
        return self.rows.get(key(change))


def layer_of(name):
    for layer, folders in LAYERS.items():
        if any(name.startswith(f"{folder}/") for folder in folders):
            return layer
    return "other"


def table(rows):
    """Counts by layer, file and outcome."""
    used = [outcome for outcome in OUTCOMES if any(row["outcome"] == outcome for row in rows)]
    counts = {}
    for row in rows:
        for place in ("all", layer_of(row["file"]), row["file"]):
            counts.setdefault(place, dict.fromkeys(used, 0))[row["outcome"]] += 1
    order = sorted(counts, key=lambda place: (place != "all", "/" in place, place))
    width = max(map(len, order))
    yield " ".join([" " * width, f"{'changes':>8}", *(f"{outcome:>{max(8, len(outcome))}}" for outcome in used)])
    for place in order:
        numbers = (f"{counts[place][outcome]:{max(8, len(outcome))}}" for outcome in used)
        yield " ".join([f"{place:{width}}", f"{sum(counts[place].values()):8}", *numbers])


def group_of(row):
    return f"{row['outcome']}, {row['class']}" if "class" in row else row["outcome"]


def counted(names):
    counts = collections.Counter(names)
    width = max(map(len, counts), default=0)
    return [f"{name:{width}} {count:5}" for name, count in sorted(counts.items(), key=lambda item: -item[1])]


def report(chosen, results, survivors):
    """Prints counts and the survivors without a reason; writes all survivors as CSV."""
    rows = [results.of(change) or change | {"outcome": "untried"} for change in chosen]
    print("\n".join(table(rows)))
    listed = sorted((row for row in rows if row["outcome"] in LISTED), key=key)
    rules = rules_of()
    reasons = [reason(row, rules) for row in listed]
    for title, names in [("survivors", map(group_of, listed)), ("reasons", (kind or "none" for kind, _ in reasons))]:
        print(f"\n{title}:", *counted(f"{layer_of(row['file'])}: {name}" for row, name in zip(listed, names)), sep="\n")
    print("\nwithout a reason:")
    for row, (kind, _) in zip(listed, reasons):
        if not kind:
            print(f"{text_of(row)} ({group_of(row)})\n    {row['text']}")
    with survivors.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["file", "line", "column", "old", "new", "class", "kind", "why"])
        for row, why in zip(listed, reasons):
            place = row["file"], row["line"], row["column"]
            writer.writerow([*place, row["old"].strip(), row["new"].strip(), group_of(row), *why])
    seconds = sum(row.get("seconds", 0) for row in rows)
    print(f"\n{len(rows)} changes, {seconds:.0f} s of tests; survivors: {survivors}")
