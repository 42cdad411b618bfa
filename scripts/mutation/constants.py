# SPDX-License-Identifier: Apache-2.0
"""Constants that the compiler knows become ones that are made at run time, so that their numbers can be
switched: functions where the type is plain, const variables elsewhere."""
from dataclasses import dataclass, field

PLAIN = {"double", "int", "long", "bool", "std", "::", "size_t", "uint64_t", "unsigned"}
STORAGE = {"static", "inline", "constexpr", "const"}


@dataclass
class Constant:
    name: str
    first: int   # offset of the declaration's first token
    last: int    # offset of its semicolon
    line: int
    edits: list = field(default_factory=list)  # (start, end, text)


def scope_of(tokens, i):
    """What the innermost braces round token i belong to: namespace, class or function."""
    for brace in tokens.enclosing(i):
        if tokens.list[brace].text != "{":
            return "function"
        j, words = brace - 1, []
        while j >= 0 and tokens.list[j].text not in (";", "{", "}"):
            words.append(tokens.list[j].text)
            j = tokens.list[j].match - 1 if tokens.list[j].closes else j - 1
        if "namespace" in words:
            return "namespace"
        return "class" if {"class", "struct"} & set(words) else "function"
    return "namespace"


def initializer(tokens, i):
    """Of the constexpr at i: index of the token after the name, and of the semicolon; None for a function."""
    j = i + 1
    while tokens.list[j].text not in ("=", "{", "(", ";"):
        j = tokens.list[j].match + 1 if tokens.opens(j) else j + 1
    if tokens.list[j].text in ("(", ";"):
        return None
    end = j
    while tokens.list[end].text != ";":
        end = tokens.list[end].match + 1 if tokens.opens(end) else end + 1
    return j, end


def uses_of(tokens, name, begin, end):
    return [token for token in tokens.list[begin:end] if token.text == name]


def as_function(tokens, first, i, after, end, scope):
    """static constexpr double kX = 1.5; -> static double kX() { return 1.5; }"""
    edits = [(token.start, token.end, "") for token in tokens.list[first:i + 1]]
    edits[0] = (edits[0][0], edits[0][1], "static" if scope == "class" else "static inline")
    equals, semicolon = tokens.list[after], tokens.list[end]
    edits += [(equals.start, equals.end, "() { return"), (semicolon.start, semicolon.end, "; }")]
    name = tokens.list[after - 1].text
    edits += [(t.end, t.end, "()") for t in tokens.list if t.text == name and t is not tokens.list[after - 1]]
    return edits


def as_variable(tokens, first, i, scope):
    edits = [(token.start, token.end, "") for token in tokens.list[first:i]]
    word = {"function": "static const", "class": "inline static const", "namespace": "const"}[scope]
    if any(token.text == "inline" for token in tokens.list[first:i]):
        word = "inline const" if scope == "namespace" else word
    return edits + [(tokens.list[i].start, tokens.list[i].end, word)]


def constants_of(tokens, known_elsewhere):
    """Every constexpr variable with the edits that bring its making to run time."""
    for i, token in enumerate(tokens.list):
        if token.text != "constexpr" or tokens.list[i - 1].text == "if":
            continue
        found = initializer(tokens, i)
        if not found:
            continue
        after, end = found
        first = i
        while tokens.list[first - 1].text in STORAGE:
            first -= 1
        named = after - 1
        while tokens.list[named].closes:
            named = tokens.list[named].match - 1
        name, scope = tokens.list[named].text, scope_of(tokens, i)
        constant = Constant(name, tokens.list[first].start, tokens.list[end].start,
                            tokens.text.count("\n", 0, token.start) + 1)
        kind = {t.text for t in tokens.list[i + 1:after - 1]}
        declared = sum(1 for t in tokens.list if t.text == name and t.start < constant.first)
        plain = kind <= PLAIN and tokens.list[after].text == "=" and named == after - 1 and not declared
        if plain and scope != "function" and not known_elsewhere(name):
            constant.edits = as_function(tokens, first, i, after, end, scope)
        else:
            constant.edits = as_variable(tokens, first, i, scope)
        yield constant
