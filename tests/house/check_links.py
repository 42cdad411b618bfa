# SPDX-License-Identifier: Apache-2.0
"""Relative links in Markdown lead to files, and to headings, that exist. Code named in backticks with
a path of the tree exists too. No blank line cuts a table in two: what is below it would not be one."""
import re

import tree

LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)|!\[[^\]]*\]\(([^)\s]+)\)")
PATH_IN_CODE = re.compile(r"`((?:core|optim|studies|apps|bench|tests|docs|scripts|cmake|examples|bindings)/"
                          r"[\w./-]*\.\w+)`")


def anchors(path):
    """Heading anchors as GitHub makes them."""
    found = set()
    for heading in re.findall(r"^#+\s+(.*?)\s*$", prose(tree.text(path)), re.M):
        plain = re.sub(r"[`*]", "", heading).lower()
        found.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return found


def prose(markdown):
    """Markdown with its fenced blocks blanked, line numbers kept."""
    return re.sub(r"^```.*?^```", lambda m: re.sub(r"[^\n]", "", m.group(0)), markdown, flags=re.M | re.S)


def torn_tables(lines):
    """Numbers of the rows below a blank line that belong to the table above it."""
    for i in range(2, len(lines)):
        heading = i + 1 < len(lines) and re.match(r"\|[\s|:-]+$", lines[i + 1])
        if lines[i].startswith("|") and not lines[i - 1] and lines[i - 2].startswith("|") and not heading:
            yield i + 1


def check(path):
    for number in torn_tables(prose(tree.text(path)).splitlines()):
        yield f"{tree.name(path)}:{number}: a table cut in two by the blank line above"
    for number, line in enumerate(prose(tree.text(path)).splitlines(), 1):
        place = f"{tree.name(path)}:{number}"
        for spelled in (a or b for a, b in LINK.findall(line)):
            if re.match(r"[a-z]+:", spelled):
                continue
            target, _, anchor = spelled.partition("#")
            file = (path.parent / target).resolve() if target else path
            if not file.exists():
                yield f"{place}: link to {spelled}, which does not exist"
            elif not file.is_relative_to(tree.ROOT):
                yield f"{place}: link to {spelled}, outside the repository"
            elif anchor and file.suffix == ".md" and anchor not in anchors(file):
                yield f"{place}: {target or path.name} has no heading #{anchor}"
        for spelled in PATH_IN_CODE.findall(line):
            if not (tree.ROOT / spelled).exists():
                yield f"{place}: `{spelled}` does not exist"


if __name__ == "__main__":
    pages = tree.files(suffixes={".md"})
    tree.finish([c for page in pages for c in check(page)], len(pages))
