# SPDX-License-Identifier: Apache-2.0
"""Tokens of a formatted C++ source, and how far the operands of its operators reach.

Not a parser: it stands on clang-format's blanks, which binary operators have on both sides and template
brackets, pointers and signs have not."""
import bisect
import re
from dataclasses import dataclass

from .changes import NOISE

TOKEN = re.compile(r"""
    \d(?:[eEpP][+-]|'\w|[\w.])*
  | operator\s?(?:\(\)|\[\]|""\w+|[-+*/%&|^!=<>~,]+)
  | [A-Za-z_\x00]\w*\x00*
  | (?<=\s)>>=?(?=\s)
  | <<=|<=>|->|::|\.\.\.|\+\+|--|&&|\|\||[-+*/%&|^!=<>]=|<<
  | [^\s\w]""", re.X)
PRECEDENCE = {"*": 13, "/": 13, "%": 13, "+": 12, "-": 12, "<<": 11, ">>": 11, "<=>": 10, "<": 9, "<=": 9, ">": 9,
              ">=": 9, "==": 8, "!=": 8, "&": 7, "^": 6, "|": 5, "&&": 4, "||": 3}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
SIGNED, ASSIGNED = 14, 1  # precedences of a sign and of an assignment
STOPS = {",", ";", "?", ":"} | ASSIGNMENTS
WORDS = {"return", "throw", "case", "else", "do", "co_return", "co_yield"}
HEADS = {"if", "for", "while", "switch", "catch", "constexpr"}
OPENING, CLOSING = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)


def cleaned(source):
    """Comments and directives become blanks; strings become words, so that they are operands."""
    def noise(match):
        filler = " " if match.group().startswith("/") else "\x00"
        return re.sub(r"[^\n]", filler, match.group())
    return DIRECTIVE.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), NOISE.sub(noise, source))


@dataclass
class Token:
    text: str
    start: int
    end: int
    binary: bool    # blanks on both sides
    match: int = -1  # of a bracket: its counterpart
    closes: bool = False


class Tokens:
    def __init__(self, source):
        self.text = cleaned(source)
        self.list = []
        for match in TOKEN.finditer(self.text):
            start, end = match.span()
            binary = self.text[start - 1:start].isspace() and self.text[end:end + 1].isspace()
            self.list.append(Token(match.group(), start, end, binary))
        self.starts = [token.start for token in self.list]
        self.pair()

    def at(self, offset):
        """Index of the token that starts at an offset, or None."""
        index = bisect.bisect_left(self.starts, offset)
        return index if index < len(self.starts) and self.starts[index] == offset else None

    def pair(self):
        """Brackets find their counterparts; < and > count where they are no operators."""
        opened = []
        for i, token in enumerate(self.list):
            if token.text in OPENING:
                opened.append(i)
            elif token.text == "<" and (not token.binary or self.list[i - 1].text == "template"):
                opened.append(i)
            elif token.text in CLOSING:
                while opened and OPENING.get(self.list[opened[-1]].text) != token.text:
                    opened.pop()  # a < that was none
                if opened:
                    self.join(opened.pop(), i)
            elif token.text == ">" and opened and self.list[opened[-1]].text == "<":
                self.join(opened.pop(), i)

    def join(self, first, last):
        self.list[first].match, self.list[last].match = last, first
        self.list[last].closes = True

    def opens(self, i):
        return self.list[i].match >= 0 and not self.list[i].closes

    def is_head(self, closing):
        """A closing parenthesis that ends what an if or a loop begins with."""
        before = self.list[closing].match - 1
        return self.list[closing].text == ")" and before >= 0 and self.list[before].text in HEADS

    def ends_line(self, i):
        following = self.list[i + 1].start if i + 1 < len(self.list) else len(self.text)
        return "\n" in self.text[self.list[i].end:following]

    def left(self, i, precedence):
        """Offset where the left operand of the operator at i begins."""
        start, j = None, i - 1
        while j >= 0:
            token = self.list[j]
            if token.closes:
                if self.is_head(j) or (token.text == "}" and self.ends_line(j)):
                    break
                start, j = self.list[token.match].start, token.match - 1
                continue
            if token.match >= 0 or token.text in STOPS | WORDS | CLOSING | OPENING.keys():
                break
            if token.binary and PRECEDENCE.get(token.text, 99) < precedence:
                break
            if not (token.binary and token.text in PRECEDENCE):
                start = token.start
            j -= 1
        return start

    def right(self, i, precedence):
        """Offset where the right operand of the operator at i ends."""
        end, j = None, i + 1
        while j < len(self.list):
            token = self.list[j]
            if self.opens(j):
                end, j = self.list[token.match].end, token.match + 1
                continue
            if token.closes or token.text in CLOSING or token.text in (",", ";"):
                break
            if token.text in STOPS and precedence != ASSIGNED:
                break
            if token.binary and PRECEDENCE.get(token.text, 99) <= precedence:
                break
            if not (token.binary and token.text in PRECEDENCE):
                end = token.end
            j += 1
        return end

    def enclosing(self, i):
        """Indices of the brackets open at i, the innermost first."""
        depth_first, j = [], i - 1
        while j >= 0:
            token = self.list[j]
            if token.closes:
                j = token.match - 1
                continue
            if token.match >= 0:
                depth_first.append(j)
            j -= 1
        return depth_first
