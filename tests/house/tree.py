# SPDX-License-Identifier: Apache-2.0
"""The repository's files, and the way every house check reports."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED_FOLDERS = {".git", ".cache", "build", "node_modules", "__pycache__", "third_party"}
CPP = {".hpp", ".cpp"}


def files(*folders, suffixes=None):
    """Files below the given folders of the repository (all of it by default), in a fixed order."""
    found = []
    for folder in folders or ("",):
        start = ROOT / folder
        if start.is_file():
            found.append(start)
            continue
        for path in start.rglob("*"):
            parts = path.relative_to(ROOT).parts
            if any(part in SKIPPED_FOLDERS or part.startswith("build-") for part in parts):
                continue
            if path.is_file() or path.is_symlink():
                found.append(path)
    return sorted(p for p in set(found) if suffixes is None or p.suffix in suffixes)


def name(path):
    """Path as the reports show it."""
    return path.relative_to(ROOT).as_posix()


def text(path):
    return path.read_text(encoding="utf-8", errors="replace")


def finish(complaints, checked):
    """Prints the complaints, one a line as file:line: what; ends the program."""
    for complaint in complaints:
        print(complaint)
    if not checked:
        complaints = ["nothing was checked"]
        print(complaints[0])
    print(f"{checked} checked, {len(complaints)} wrong")
    sys.exit(1 if complaints else 0)
