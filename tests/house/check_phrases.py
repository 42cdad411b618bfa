# SPDX-License-Identifier: Apache-2.0
"""What is said is said in one place: no phrase stands both in a script of a page and in C++ (CONTRIBUTING.md, How to add)."""
import re

import tree

WORDS, LETTERS = 2, 14  # of a phrase; what is shorter is a name or a word of the trade
# Where names and meanings of metrics and parameters stand.
TABLES = {"core/src/metrics/metric_table.cpp", "core/src/design/motor_rows.hpp", "studies/motors/src/metrics/plain_name.cpp"}

COMMENT = r"//[^\n]*|/\*.*?\*/"
CPP = re.compile(COMMENT + r'|R"(?P<tag>\w*)\((?P<raw>.*?)\)(?P=tag)"|"(?P<text>(?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\])\'|[^\s]', re.S)
SCRIPT = re.compile(COMMENT + r"""|'(?P<single>(?:\\.|[^'\\\n])*)'|"(?P<double>(?:\\.|[^"\\\n])*)"|`(?P<ticks>(?:\\.|[^`\\])*)`|[^\s]""", re.S)


def literals(text, pattern, joint):
    """(line, text) of each string; neighbours, with a joint between them if there is one, are one string."""
    whole, begin, joined = None, 0, False
    for match in pattern.finditer(text):
        token = match.group(0)
        if token.startswith(("//", "/*")):
            continue
        groups = {k: v for k, v in match.groupdict().items() if k != "tag"}
        part = next((v for v in groups.values() if v is not None), None)
        if part is not None and whole is not None and (joined or not joint):
            whole, joined = whole + part, False
        elif part is None and token == joint and whole is not None and not joined:
            joined = True
        else:
            if whole is not None:
                yield text.count("\n", 0, begin) + 1, whole
            whole, begin, joined = part, match.start(), False
    if whole is not None:
        yield text.count("\n", 0, begin) + 1, whole


def phrases(text, pattern, joint):
    for line, literal in literals(text, pattern, joint):
        for part in re.split(r"\$\{[^}]*\}|\\n", literal.replace("\\'", "'").replace('\\"', '"')):
            part = " ".join(part.split())
            if len(part.split()) >= WORDS and sum(c.isalpha() for c in part) >= LETTERS:
                yield line, part


def names():
    """What metrics and parameters are called."""
    found = set()
    for path in TABLES:
        if (tree.ROOT / path).exists():
            for literal in re.findall(r'"([^"\n]+)"', tree.text(tree.ROOT / path)):
                found |= {literal.lower().replace("_", " "), literal.lower().replace("_", " ").removesuffix(" at")}
    return found


if __name__ == "__main__":
    scripts = [p for p in tree.files("studies/page", suffixes={".js"})]
    sources = [p for p in tree.files("core", "motion", "solid", "optim", "studies", "apps", suffixes=tree.CPP) if tree.name(p) not in TABLES]
    told = {}
    for path in sources:
        for line, phrase in phrases(tree.text(path), CPP, None):
            told.setdefault(phrase, f"{tree.name(path)}:{line}")
    everything = "\n".join(told)
    known = names()
    complaints = []
    for path in scripts:
        for line, phrase in phrases(tree.text(path), SCRIPT, "+"):
            if phrase.lower() in known:
                continue
            twice = next((q for q in told if phrase in q), None) if phrase in everything else next((q for q in told if q in phrase and q.lower() not in known), None)
            if twice:
                complaints.append(f"{tree.name(path)}:{line}: '{phrase}' is said by {told[twice]} as well; say it there alone")
    tree.finish(complaints, len(scripts) + len(sources))
