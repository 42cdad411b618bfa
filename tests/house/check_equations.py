# SPDX-License-Identifier: Apache-2.0
"""Numbered equations of docs/theory and their citations (CONTRIBUTING.md, Equations).

An equation is numbered where its tag, such as (T3.2), ends an indented line or is the first cell of
a table row. It is cited by the bare tag in code and tests.

    check_equations.py            every tag used exists, every equation is cited
    check_equations.py --report   the same, but only unknown tags are an error
"""
import re
import sys

import tree

DEFINITION = re.compile(r"^(?:    .*\((?P<line>[A-Z]\d+\.\d+)\)\s*$|\|\s*\((?P<row>[A-Z]\d+\.\d+)\)\s*\|)")
TAG = re.compile(r"(?<![\w.])([A-Z]\d+\.\d+)(?![\w]|\.\d)")
CODE = ("core", "motion", "solid", "optim", "studies", "apps")
ALSO_CITING = ("bench", "bindings", "examples")
CHECKS = "C"  # equations that only tests use: closed forms, bounds, scalings


def definitions():
    found, complaints = {}, []
    for page in tree.files("docs/theory", suffixes={".md"}):
        for number, line in enumerate(tree.text(page).splitlines(), 1):
            match = DEFINITION.match(line)
            if not match:
                continue
            tag, place = match["line"] or match["row"], f"{tree.name(page)}:{number}"
            if tag in found:
                complaints.append(f"{place}: {tag} is already the number of {found[tag]}")
            found[tag] = place
    return found, complaints


def citations(paths):
    """Tag -> places, for the given files."""
    found = {}
    for path in paths:
        for number, line in enumerate(tree.text(path).splitlines(), 1):
            for tag in TAG.findall(line):
                found.setdefault(tag, []).append(f"{tree.name(path)}:{number}")
    return found


def order(tag):
    return tag[0], *map(int, tag[1:].split("."))


if __name__ == "__main__":
    report_only = "--report" in sys.argv
    defined, complaints = definitions()
    letters = {tag[0] for tag in defined}
    in_code = citations(tree.files(*CODE, suffixes=tree.CPP))
    in_tests = citations(p for p in tree.files("tests", suffixes=tree.CPP | {".py", ".yaml"})
                         if p.parent.name != "house")
    in_docs = citations(tree.files("docs", "README.md", suffixes={".md"}))
    elsewhere = citations(tree.files(*ALSO_CITING, suffixes=tree.CPP | {".py"}))

    for cited in (in_code, in_tests, in_docs, elsewhere):
        for tag, places in cited.items():
            if tag[0] in letters and tag not in defined:
                complaints += [f"{place}: cites {tag}, which no page of docs/theory numbers" for place in places]

    uncited = []
    for tag in sorted(defined, key=order):
        missing = [] if tag[0] == CHECKS or tag in in_code else ["code"]
        missing += [] if tag in in_tests else ["a test"]
        if missing:
            uncited.append(f"{defined[tag]}: {tag} is not cited by {' nor by '.join(missing)}")
    if report_only:
        print("\n".join(uncited))
        print(f"{len(defined) - len(uncited)} of {len(defined)} equations are cited as they should be")
    else:
        complaints += uncited
    tree.finish(complaints, len(defined))
