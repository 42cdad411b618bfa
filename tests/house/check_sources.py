# SPDX-License-Identifier: Apache-2.0
"""Every source carries its licence line, is listed in a CMakeLists.txt, and points nowhere outside."""
import re

import tree

SPDX = "SPDX-License-Identifier: Apache-2.0"
NEEDS_SPDX = {".hpp", ".cpp", ".h", ".c", ".py", ".sh", ".cmake", ".js", ".dict"}

# Places on the author's machine, and addresses of a package host of one's own.
OUTSIDE = re.compile(r"(?<![\w.$}~/-])/(work|root|home|opt|mnt|tmp|Users)/\w|(?<![\w/])\.\./shared\b|localhost:\d")
OUTSIDE_ALLOWED = "house: outside path is meant"  # on the same line, for a test that needs one

BINARY = {".png", ".svg", ".gz", ".db"}


def licence(path):
    if path.suffix in NEEDS_SPDX or path.name == "CMakeLists.txt":
        head = "\n".join(tree.text(path).splitlines()[:3])
        if SPDX not in head:
            yield f"{tree.name(path)}:1: no '{SPDX}' in the first three lines"


def outside(path):
    if path.is_symlink() and not path.resolve().is_relative_to(tree.ROOT):
        yield f"{tree.name(path)}: links to a place outside the repository"
        return
    if path.suffix in BINARY or path == tree.ROOT / "LICENSE" or path.name == "check_sources.py":
        return
    for number, line in enumerate(tree.text(path).splitlines(), 1):
        match = OUTSIDE.search(line)
        if match and OUTSIDE_ALLOWED not in line:
            yield f"{tree.name(path)}:{number}: points outside the repository: {match.group(0)}"


def unlisted():
    """Sources and public headers that no CMakeLists.txt of their layer names."""
    for layer in ("core", "motion", "solid", "optim", "studies", "apps", "bindings", "bench", "tests"):
        lists = tree.files(layer, suffixes={".txt"})
        named = set()
        for cmake in (c for c in lists if c.name == "CMakeLists.txt"):
            for word in re.findall(r"[\w./+-]+\.[hc]pp", tree.text(cmake)):
                named.add((cmake.parent / word).resolve())
        for path in tree.files(layer, suffixes=tree.CPP):
            public = "include" in path.relative_to(tree.ROOT).parts and path.suffix == ".hpp"
            if (public or path.suffix == ".cpp") and path.resolve() not in named:
                what = "public header (HEADERS of twum_library)" if public else "source"
                yield f"{tree.name(path)}: {what} is named in no CMakeLists.txt of {layer}"


def once(path):
    if path.suffix == ".hpp" and "#pragma once" not in tree.text(path):
        yield f"{tree.name(path)}: no #pragma once"


def case_names(path):
    """Catch2's discovery splits a name at ';' and does not match '\\': such a test would not run."""
    if path.suffix == ".cpp" and "tests" in path.relative_to(tree.ROOT).parts:
        for match in re.finditer(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', tree.text(path)):
            if ";" in match[1] or "\\" in match[1]:
                line = tree.text(path).count("\n", 0, match.start()) + 1
                yield f"{tree.name(path)}:{line}: a test case's name must do without ; and \\"


if __name__ == "__main__":
    everything = tree.files()
    found = [c for path in everything for rule in (outside, licence, once, case_names) if not path.is_dir() for c in rule(path)]
    tree.finish(found + list(unlisted()), len(everything))
