# SPDX-License-Identifier: Apache-2.0
"""scripts/mutate.py rewrites what it means to: operands reach as far as the language says, and no further.
Its reasons are about lines that exist, and each survivor that docs/survivors.csv names has one."""
import csv
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

from mutation.changes import LAYERS, all_changes, key  # noqa: E402
from mutation.places import places  # noqa: E402
from mutation.reasons import KINDS, places_of, rules_of  # noqa: E402
from mutation.rewrite import Source, numbered, rewritten_text  # noqa: E402

# A line, and what becomes of it; m. stands for mutant:: and numbers of changes are left out.
CASES = [
    ("x = a + b * c;", "x = m.plus(a, m.times(b, c));"),
    ("x = a - b + c;", "x = m.plus(m.minus(a, b), c);"),
    ("x = a * (b + c) / d;", "x = m.over(m.times(a, (m.plus(b, c))), d);"),
    ("return a.b[i]->c(d, e) + std::f<T>(x);", "return m.plus(a.b[i]->c(d, e), std::f<T>(x));"),
    ("const T& y = *p + &q - !r;", "const T& y = m.minus(m.plus(*p, &q), !r);"),
    ("if (x < y) z += w;", "if (m.less(x, y)) m.add_to(z, w);"),
    ("for (int i = k; i < n; ++i) r[i] *= s;", "for (int i = k; m.less(i, n); ++i) m.multiply_by(r[i], s);"),
    ("else x -= y;", "else m.take_from(x, y);"),
    ("case A: x -= y;", "case A: m.take_from(x, y);"),
    ("{\n}\nx /= y ? a : b;", "{\n}\nm.divide_by(x, y ? a : b);"),
    ("x += y, z += w;", "m.add_to(x, y), m.add_to(z, w);"),
    ("f(a - b, {c + d, e});", "f(m.minus(a, b), {m.plus(c, d), e});"),
    ("x = T{a} + U{b}(c);", "x = m.plus(T{a}, U{b}(c));"),
    ("x = y ? a - b : c + d;", "x = y ? m.minus(a, b) : m.plus(c, d);"),
    ("x = (y) ? a : -b.c(d) * e;", "x = (y) ? a : m.times(m.negative(b.c(d)), e);"),
    ("return -x;", "return m.negative(x);"),
    ("f(-2.0, 0);", "f(m.negative(m.number(2.0, (1.5 * 2.0))), m.number(0, 1));"),
    ("x = true;", "x = m.truth(true);"),
    ("x = a < b == c > d;", "x = m.equal(m.less(a, b), m.greater(c, d));"),
    ("x = a << b + c;", "x = a << m.plus(b, c);"),
    ("x = a && b;", "x = (m.goes_on(static_cast<bool>(a)) ? m.second(static_cast<bool>(b)) : m.ended());"),
    ("x = a < b || c;",
     "x = (m.goes_on(static_cast<bool>(m.less(a, b))) ? m.second(static_cast<bool>(c)) : m.ended());"),
    ("T&& f(std::vector<T*> x, A<B<C>>& y);", "T&& f(std::vector<T*> x, A<B<C>>& y);"),
    ("A<N + 2> x = y;  // a + b", "A<N + 2> x = y;  // a + b"),
    ('x = "a + b" + c;', 'x = m.plus("a + b", c);'),
    ("#define X a + b\nx = y + z;", "#define X a + b\nx = m.plus(y, z);"),
    ("x = a +\n    b * c;", "x = a +\n    m.times(b, c);"),
    ("constexpr double kA = 2.5;\nx = kA + y;",
     "static inline double kA () { return m.number(2.5, (1.5 * 2.5)); }\nx = m.plus(kA(), y);"),
    ("constexpr int kA[] = {7};\nx = kA[i];", "const int kA[] = {m.number(7, 8)};\nx = kA[i];"),
    ("void f() {\n  constexpr int kA = 7;\n}", "void f() {\n  static const int kA = m.number(7, 8);\n}"),
    ("struct A {\n  static constexpr long kA = 7;\n};",
     "struct A {\n  static  long kA () { return m.number(7, 8); }\n};"),
]


def shortened(text):
    text = re.sub(r"mutant::(\w+)<\d+(?:, \w+)?>", r"m.\1", text)
    return text


def unplaced():
    """Changes of the tree that are rewritten although their brackets do not pair."""
    changes = all_changes(sum(LAYERS.values(), []))
    numbers = numbered(changes)
    for name in sorted({change["file"] for change in changes}):
        source = Source((ROOT / name).read_text(encoding="utf-8"),
                        {n: c for n, c in numbers.items() if c["file"] == name})
        text, spots, _ = source.rewritten(set(), set(), "x")
        opened = {c: text.count(c) for c in "()[]{}"}
        was = {c: source.source.count(c) for c in "()[]{}"}
        for a, b in ("()", "[]", "{}"):
            if opened[a] - opened[b] != was[a] - was[b]:
                yield f"{name}: {a} and {b} do not pair after rewriting"
        if len({key(spot.change) for spot in spots}) != len(spots):
            yield f"{name}: a change stands twice"


# Lines with the function or class that each belongs to.
PLACES = [
    ("#define F(x) {", ""),
    ("namespace a {", ""),
    ("constexpr int kA[] = {1, 2};", ""),
    ("template <typename T, int = 3>", "f"),
    ("T f(T x, B b = {}) {", "f"),
    ("  if (x) { g(); }", "f"),
    ("  auto h = [](int y) { return y; };", "f"),
    ("}", "f"),
    ("class C : public D {", "C"),
    ("  int a_{3};", "C"),
    ("  bool g() const { return a_; }", "C::g"),
    ("};", "C"),
    ("C::C(int a)", "C::C"),
    ("    : a_{a} {}", "C::C"),
    ("}  // namespace a {", "")]


def misplaced():
    found = places("\n".join(line for line, _ in PLACES))
    return [f"{line!r} belongs to {name!r}, not {was!r}" for (line, name), was in zip(PLACES, found) if was != name]


def stale_rules():
    """Rules of reasons.tsv that no line of the tree fits."""
    for rule in rules_of():
        row = rule.row
        path = ROOT / row["file"]
        lines = path.read_text(encoding="utf-8").split("\n") if path.exists() else []
        if not any(row["text"] in line and row["place"] in ("*", place)
                   for line, place in zip(lines, places_of(row["file"]) if lines else [])):
            yield f"reasons.tsv: no line of {row['file']}, {row['place']}, has {row['text']!r}"


def unexplained():
    with (ROOT / "docs/survivors.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["kind"] not in KINDS or not row["why"]:
                yield f"docs/survivors.csv: {row['file']}:{row['line']}: {row['old']} -> {row['new']} has no reason"


if __name__ == "__main__":
    failures = [*misplaced(), *stale_rules(), *unexplained()]
    failures += [f"{line!r}\n  gave     {shortened(rewritten_text(line))!r}\n  expected {expected!r}"
                 for line, expected in CASES if shortened(rewritten_text(line)) != expected]
    failures += unplaced()
    print("\n".join(failures))
    print(f"{len(CASES)} rewritings, {len(PLACES)} places, {len(rules_of())} reasons: {len(failures)} wrong")
    sys.exit(1 if failures else 0)
