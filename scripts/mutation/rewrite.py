# SPDX-License-Identifier: Apache-2.0
"""All changes of a source put into it at once, each behind its number: a + b -> mutant::plus<17>(a, b)."""
from dataclasses import dataclass

from .changes import key
from .constants import constants_of
from .operands import ASSIGNED, OPENING, PRECEDENCE, SIGNED, Tokens

NAMES = {"+": "plus", "-": "minus", "*": "times", "/": "over", "<": "less", "<=": "less_equal", ">": "greater",
         ">=": "greater_equal", "==": "equal", "!=": "unequal", "+=": "add_to", "-=": "take_from",
         "*=": "multiply_by", "/=": "divide_by"}
BLOCK = 64  # numbers of a file come in blocks, so that a change of one file seldom moves those of others


@dataclass
class Spot:
    """A change with its number and the text that it needs."""
    change: dict
    number: int
    start: int   # offsets of the whole expression
    end: int
    cut: tuple   # offsets of what is replaced
    before: str
    between: str
    after: str
    lines: tuple = (0, 0)


def numbered(changes):
    """number -> change, file by file."""
    found, number, file = {}, 0, None
    for change in changes:
        if change["file"] != file:
            number, file = -(-(number + BLOCK // 2) // BLOCK) * BLOCK, change["file"]
        found[number] = change
        number += 1
    return found


class Source:
    """One source with its tokens and the places of its changes."""

    def __init__(self, source, changes, known_elsewhere=lambda name: False):
        self.source = source
        self.tokens = Tokens(source)
        self.lines = [0]
        for line in source.split("\n"):
            self.lines.append(self.lines[-1] + len(line) + 1)
        self.constants = list(constants_of(self.tokens, known_elsewhere))
        self.spots = []
        for number, change in changes.items():
            spot = self.spot(number, change)
            if spot:
                spot.lines = self.line_of(spot.start), self.line_of(spot.end)
                self.spots.append(spot)

    def line_of(self, offset):
        return self.source.count("\n", 0, offset) + 1

    def spot(self, number, change):
        """None where no rewriting is known: in template arguments and directives."""
        offset = self.lines[change["line"] - 1] + change["column"] - 1
        old = change["old"]
        start = offset + len(old) - len(old.lstrip())
        index = self.tokens.at(start)
        if index is None or self.is_template_argument(index):
            return None
        end = start + len(old.strip())
        if old in ("true", "false"):
            return Spot(change, number, start, end, (start, start), f"mutant::truth<{number}>(", "", ")")
        if old == "-":
            last = self.tokens.right(index, SIGNED)
            return last and Spot(change, number, start, last, (start, end), f"mutant::negative<{number}>(", "", ")")
        if old.strip() == old:
            after = f", {change['new']})"
            return Spot(change, number, start, end, (start, start), f"mutant::number<{number}>(", "", after)
        return self.operator_spot(number, change, index, (offset, offset + len(old)))

    def operator_spot(self, number, change, index, cut):
        operator = change["old"].strip()
        precedence = PRECEDENCE.get(operator, ASSIGNED)
        start, end = self.tokens.left(index, precedence), self.tokens.right(index, precedence)
        if start is None or end is None:
            return None
        if operator in ("&&", "||"):
            of = f"<{number}, {'true' if operator == '&&' else 'false'}>("
            return Spot(change, number, start, end, cut, f"(mutant::goes_on{of}static_cast<bool>(",
                        f")) ? mutant::second{of}static_cast<bool>(", f")) : mutant::ended{of}))")
        return Spot(change, number, start, end, cut, f"mutant::{NAMES[operator]}<{number}>(", ", ", ")")

    def is_template_argument(self, index):
        for bracket in self.tokens.enclosing(index):
            text = self.tokens.list[bracket].text
            if text == "<":
                return True
            if text in OPENING:
                return False
        return False

    def constant_round(self, spot):
        for constant in self.constants:
            if constant.first <= spot.start < constant.last:
                return constant
        return None

    def rewritten(self, fixed, fixed_constants, header):
        """The text with all changes but the fixed ones, and the changes that are in it."""
        spots, constants = [], {}
        for spot in self.spots:
            constant = self.constant_round(spot)
            if key(spot.change) in fixed or (constant and constant.name in fixed_constants):
                continue
            if constant:
                constants[constant.first] = constant
            spots.append(spot)
        text = apply(self.source, spots, [edit for c in constants.values() for edit in c.edits])
        if spots or constants:
            head, _, rest = text.partition("\n")
            assert head.startswith("// SPDX"), head
            text = f'#include "{header}"\n{rest}'
        return text, spots, list(constants.values())


def apply(source, spots, edits):
    """Insertions and replacements in the order that nests them."""
    events = []  # (offset, rank, order, text, end of what is cut)
    for spot in spots:
        size = spot.end - spot.start
        events.append((spot.start, 1, -size, spot.before, spot.start))
        if spot.cut[0] != spot.cut[1]:
            events.append((spot.cut[0], 2, 0, spot.between, spot.cut[1]))
        events.append((spot.end, 0, size, spot.after, spot.end))
    for start, end, text in edits:
        events.append((start, -1 if start == end else 2, 0, text, end))
    events.sort(key=lambda event: event[:3])
    pieces, at = [], 0
    for offset, _, _, text, end in events:
        pieces += [source[at:offset], text]
        at = max(at, end)
    return "".join(pieces) + source[at:]


def rewritten_text(source):
    """For tests: the source with all its changes, numbered from 0, constants included."""
    from .changes import changes_in
    changes = dict(enumerate(changes_in(source, "x")))
    found = Source(source, changes)
    constants = [c for c in found.constants if any(found.constant_round(s) is c for s in found.spots)]
    return apply(source, found.spots, [edit for c in constants for edit in c.edits])
