# SPDX-License-Identifier: Apache-2.0
"""Which function, or else which class, a line of a source belongs to."""
import re

from .changes import blanked

DIRECTIVE = re.compile(r"^[ \t]*#[^\n]*", re.M)
DEFAULT = re.compile(r"=\s*\{[^{};]*\}(?=\s*[,)])")  # of an argument
TEMPLATE = re.compile(r"\btemplate\s*<[^{;]*?>\s*(?=[\w\[])")
CALLED = re.compile(r"(operator\s*\S+?|[~\w:]+)\s*\(")
CLASS = re.compile(r"\b(?:class|struct|union|enum(?:\s+class)?)\s+(\w+)")


def name_of(head, inside):
    """What the text before an opening brace begins: ("function" | "class" | "other", name)."""
    if re.search(r"\bnamespace\b", head):
        return "other", inside
    head = TEMPLATE.sub("", head)
    of_class, call = CLASS.search(head), CALLED.search(head)
    if of_class and not (call and call.start() < of_class.start()):
        return "class", of_class.group(1)
    if call and not re.search(r"=\s*$", head):
        name = call.group(1)
        return "function", name if "::" in name or not inside else f"{inside}::{name}"
    return "other", inside


def places(source):
    """The name of the function round each line; of the class outside functions, or "" outside both."""
    text = blanked(source).replace("\x00", " ")
    for pattern in (DIRECTIVE, DEFAULT):
        text = pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)
    found = [""] * (text.count("\n") + 1)
    stack = []  # (kind, name, first line)
    head = 0
    for match in re.finditer(r"[{};]", text):
        sign, at = match.group(), match.start()
        if sign == "{":
            kind, name, _ = stack[-1] if stack else ("other", "", 0)
            if kind != "function":
                before = text[head:at]
                kind, name = name_of(before, name)
                first = text.count("\n", 0, head + len(before) - len(before.lstrip()))
                stack.append((kind, name, first))
            else:
                stack.append((kind, name, None))
        elif sign == "}" and stack:
            kind, name, first = stack.pop()
            last = text.count("\n", 0, at)
            if kind in ("function", "class") and first is not None:
                for line in range(first, last + 1):
                    found[line] = found[line] or name
        head = at + 1
    return found
