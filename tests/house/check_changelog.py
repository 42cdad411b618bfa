# SPDX-License-Identifier: Apache-2.0
"""CHANGELOG.md has an entry for the version of the headers, one line per change."""
import re

import tree

KINDS = ("Added", "Changed", "Fixed")

if __name__ == "__main__":
    numbers = re.findall(r"#define TWUM_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                         tree.text(tree.ROOT / "core/base/include/twum/base/version.hpp"))
    version = ".".join(numbers)
    lines = tree.text(tree.ROOT / "CHANGELOG.md").splitlines()
    complaints, releases, kind, entries = [], [], None, {}
    for number, line in enumerate(lines, 1):
        place = f"CHANGELOG.md:{number}"
        if line.startswith("## "):
            releases.append(line[3:].split(" ")[0].strip("[]"))
            kind = None
        elif line.startswith("### "):
            kind = line[4:]
            if kind not in KINDS:
                complaints.append(f"{place}: '{kind}' is not one of {', '.join(KINDS)}")
        elif line.startswith("- "):
            if not releases or kind is None:
                complaints.append(f"{place}: an entry stands below a version and one of {', '.join(KINDS)}")
            else:
                entries[releases[-1]] = entries.get(releases[-1], 0) + 1
            if not line[2:3].isupper():
                complaints.append(f"{place}: an entry begins with a capital letter")
        elif line.startswith("#") and number > 1:
            complaints.append(f"{place}: unexpected heading")
    if version not in releases[:2]:
        complaints.append(f"CHANGELOG.md: the top entry is not version {version} of CMakeLists.txt")
    if releases and not entries.get(releases[0]):
        complaints.append(f"CHANGELOG.md: no entry below {releases[0]}")
    tree.finish(complaints, len(lines))
