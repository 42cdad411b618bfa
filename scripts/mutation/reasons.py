# SPDX-License-Identifier: Apache-2.0
"""Why a change survives: the rules of reasons.tsv, by file, function and text of the line."""
import csv
import functools
import pathlib

from .changes import ROOT
from .places import places

TABLE = pathlib.Path(__file__).with_name("reasons.tsv")
COLUMNS = ["file", "place", "text", "change", "kind", "why"]
KINDS = {"cost": "the way to the answer is longer or shorter, the answer is polished or checked afterwards",
         "choice": "a constant without one right value: limits of work, shares of a budget, steps, weights of a merit",
         "rounding": "last bits, or a threshold among values that only rounding tells apart",
         "tie": "differs only where two numbers are equal, and both sides are right there",
         "guard": "against what no input reaches, or reaches by rounding alone",
         "twice": "another line does the same again, or makes it not matter",
         "words": "names and words of messages",
         "memory": "a reserve of memory, or a read beyond an end that has no visible effect",
         "slow": "only tests that are left out of the run, or need longer than its budget, see it",
         "library": "what a library does with it is its own affair and not promised",
         "unused": "a default, or a branch, that this library's callers never take"}
# What is not known to keep the answers is explained line by line; the others may be by their function.
BY_LINE = {"other answers", "not asked"}


class Rule:
    def __init__(self, row):
        self.row, self.used = row, False

    def fits(self, change, place, found_class):
        if self.row["file"] != change["file"] or self.row["place"] not in ("*", place):
            return False
        if found_class in BY_LINE and not self.row["text"]:
            return False
        return self.row["text"] in change["text"] and self.row["change"] in ("", changed(change))


def changed(change):
    return f"{change['old'].strip()} -> {change['new'].strip()}"


def rules_of(path=TABLE):
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    for row in rows:
        assert None not in row and None not in row.values(), f"{path}: six columns, not {row}"
        assert row["kind"] in KINDS, f"{path}: unknown kind {row['kind']}"
    # what names a change or a line goes before what names a function, the longer text first
    return sorted(map(Rule, rows), key=lambda r: (r.row["change"] == "", -len(r.row["text"]), r.row["place"] == "*"))


@functools.lru_cache(None)
def places_of(name):
    return places((ROOT / name).read_text(encoding="utf-8"))


def place_of(change):
    return places_of(change["file"])[change["line"] - 1]


def reason(change, rules):
    """(kind, why), or two empty texts."""
    for rule in rules:
        if rule.fits(change, place_of(change), change.get("class", "")):
            rule.used = True
            return rule.row["kind"], rule.row["why"]
    return "", ""
