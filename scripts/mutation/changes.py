# SPDX-License-Identifier: Apache-2.0
"""The changes of a source: which tokens are replaced, and by what."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAYERS = {"core": ["core/src", "core/include", "core/base"], "optim": ["optim/src", "optim/include"]}
SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " -= ": " += ",
         " *= ": " /= ", " /= ": " *= ", " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ",
         " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && "}
# clang-format puts blanks round binary operators and none round template brackets or pointers.
OPERATOR = re.compile("|".join(re.escape(op) for op in sorted(SWAPS, key=len, reverse=True)))
SIGN = re.compile(r"(?<=[(=,?:{] )-(?=[\w(])|(?<=[({])-(?=[\w(])|(?<=return )-(?=[\w(])")
WORD = re.compile(r"\b(?:true|false)\b")
NUMBER = re.compile(r"(?<![\w.\"'])(?:\d+(?:'\d+)*\.?\d*(?:e[+-]?\d+)?|0x[\da-f.]+p[+-]?\d+)(?![\w.])")
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|(?<!\d)\'(?:[^\'\\\n]|\\.)+\'', re.S)
# Lines that say nothing a test could notice: the preprocessor, checks of types, our own assertions.
SKIPPED = re.compile(r"^\s*(#|template <|static_assert|TWUM_ASSERT|using )")


def blanked(source):
    """The source with comments and literals replaced by blanks of the same shape."""
    return NOISE.sub(lambda m: re.sub(r"[^\n]", "\x00", m.group()), source)


def other_number(text):
    if "x" in text:
        return f"(2 * {text})"
    if text.replace("'", "").isdigit():
        return str(int(text.replace("'", "")) + 1)
    return "1.0" if float(text) == 0 else f"(1.5 * {text})"


def changes_in(source, name):
    """Every change of one source: its place, what stands there, and what is put there."""
    lines = source.split("\n")
    for number, line in enumerate(blanked(source).split("\n"), 1):
        if SKIPPED.match(line):
            continue
        found = [(m, SWAPS[m.group()]) for m in OPERATOR.finditer(line)]
        found += [(m, "") for m in SIGN.finditer(line)]
        found += [(m, "false" if m.group() == "true" else "true") for m in WORD.finditer(line)]
        found += [(m, other_number(m.group())) for m in NUMBER.finditer(line)]
        for match, new in found:
            yield {"file": name, "line": number, "column": match.start() + 1, "old": match.group(), "new": new,
                   "text": lines[number - 1].strip()}


def sources(folders, root=ROOT):
    """Names of the sources below some folders, in a fixed order."""
    names = []
    for folder in folders:
        start = root / folder
        paths = [start] if start.is_file() else sorted(p for p in start.rglob("*") if p.suffix in (".cpp", ".hpp"))
        names += [path.relative_to(root).as_posix() for path in paths]
    return names


def all_changes(folders, root=ROOT):
    return [change for name in sources(folders, root)
            for change in changes_in((root / name).read_text(encoding="utf-8"), name)]


def key(change):
    return tuple(change[k] for k in ("file", "line", "column", "old", "new", "text"))


def text_of(change):
    return f"{change['file']}:{change['line']}:{change['column']}: '{change['old'].strip()}' -> '{change['new'].strip()}'"
