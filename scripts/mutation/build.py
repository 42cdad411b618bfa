# SPDX-License-Identifier: Apache-2.0
"""Copies of the tree with their builds: one with every change behind its number, one to change by hand."""
import json
import os
import re
import shutil
import subprocess
import sys

from .changes import LAYERS, ROOT, all_changes, key, sources
from .rewrite import Source, numbered

LIBRARIES = ["twum_base", "twum_core", "twum_optim"]
PROGRAMS = ["core_inside_tests", "core_tests", "optim_inside_tests", "optim_tests", "twum_core_answers",
            "twum_optim_answers"]
PLACE = re.compile(r"^(?P<path>/[^:\n]+):(?P<line>\d+):(?:\d+:)?\s+"
                   r"(?P<what>fatal error|error|note|required from|recursively required from)?")


class Copy:
    """A copy of the tree with its build."""

    def __init__(self, folder, flags):
        self.tree, self.build, self.flags = folder / "tree", folder / "build", flags

    def copy(self, *excluded):
        self.tree.mkdir(parents=True, exist_ok=True)
        command = ["rsync", "-a", "--checksum", "--delete", "--exclude", ".git", "--exclude", "/build*"]
        command += [word for name in excluded for word in ("--exclude", f"/{name}")]
        subprocess.run([*command, f"{ROOT}/", f"{self.tree}/"], check=True)

    def configure(self):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DTWUM_BUILD_CLI=OFF",
                        "-DTWUM_BUILD_PYTHON=OFF", "-DCMAKE_BUILD_TYPE=None",
                        f"-DCMAKE_CXX_FLAGS={self.flags}", *launcher], check=True, stdout=subprocess.DEVNULL)

    def compile(self, targets, jobs):
        done = subprocess.run(["ninja", "-C", self.build, f"-j{jobs}", "-k0", *targets], capture_output=True,
                              text=True, errors="replace", env=os.environ | {"LC_ALL": "C"})
        return done.returncode == 0, done.stdout

    def program(self, name):
        return self.build / "tests/bin" / name


class Switched(Copy):
    """The copy that holds all changes at once."""

    def __init__(self, folder):
        super().__init__(folder / "switched", "-O2 -w -Wno-narrowing -DNDEBUG")
        self.memory = folder / "fixed.json"
        known = json.loads(self.memory.read_text(encoding="utf-8")) if self.memory.exists() else {}
        self.fixed = {tuple(k) for k in known.get("changes", [])}
        self.fixed_constants = {tuple(k) for k in known.get("constants", [])}  # (file, name)
        self.names = sources(sum(LAYERS.values(), []))
        self.numbers = numbered(all_changes(sum(LAYERS.values(), [])))
        self.active = {}  # file -> spots and constants now in it

    def make(self, jobs):
        self.copy(*self.names)
        self.read()
        for name in self.names:
            self.write(name)
        self.configure()
        for targets in (LIBRARIES, PROGRAMS):
            while True:
                built, log = self.compile(targets, jobs)
                if built:
                    break
                (self.build / "errors.log").write_text(log, encoding="utf-8")
                taken = self.take_back(log)
                print(f"{taken} changes or constants do not compile behind a switch", flush=True)
                if not taken:
                    sys.exit(f"mutate.py: the rewritten tree does not compile\n{log[-5000:]}")
        self.remember()

    def remember(self):
        self.memory.write_text(json.dumps({"changes": sorted(self.fixed), "constants": sorted(self.fixed_constants)}),
                               encoding="utf-8")

    def read(self):
        changes = {name: {} for name in self.names}
        for number, change in self.numbers.items():
            changes[change["file"]][number] = change
        texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in self.names}
        used = {name: set(re.findall(r"\bk[A-Z]\w*", text)) for name, text in self.every_text(texts).items()}
        declared = {name: set(re.findall(r"constexpr [^=({;]*\b(k[A-Z]\w*)", text)) for name, text in texts.items()}
        self.sources = {}
        for name, text in texts.items():
            def elsewhere(constant, name=name):
                return name.endswith(".hpp") and any(constant in words and constant not in declared.get(other, ())
                                                     for other, words in used.items() if other != name)
            self.sources[name] = Source(text, changes[name], elsewhere)

    def every_text(self, texts):
        others = sources(["tests", "bench"])
        return texts | {name: (ROOT / name).read_text(encoding="utf-8") for name in others}

    def write(self, name):
        source = self.sources[name]
        constants = {constant for file, constant in self.fixed_constants if file == name}
        header = self.tree / "scripts/mutation/mutant.hpp"
        text, spots, made = source.rewritten(self.fixed, constants, header)
        self.active[name] = spots, made
        path = self.tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")

    def switchable(self):
        """Numbers of the changes that a run can switch on."""
        return {spot.number for spots, _ in self.active.values() for spot in spots}

    def take_back(self, log):
        """Makes fixed what the errors of a build point at; how many that were. The surest causes go first, as
        other errors may follow from theirs."""
        blocks = list(error_blocks(log))
        for blame, known in ((self.named_constants, self.fixed_constants), (self.used_constants, self.fixed_constants),
                             (self.blamed_changes, self.fixed)):
            found = set().union(*map(blame, blocks)) - known
            if found:
                known |= found
                break
        for name in self.names:
            self.write(name)
        self.remember()
        return len(found)

    def places(self, block):
        """(file, line) of the copy that an error names, its own first."""
        found = [m for m in map(PLACE.match, block) if m and m["path"].startswith(f"{self.tree}/")]
        found.sort(key=lambda m: m["what"] != "error")
        return [(m["path"][len(f"{self.tree}/"):], int(m["line"])) for m in found]

    def constants(self):
        return [(file, constant) for file, (_, made) in self.active.items() for constant in made]

    def named_constants(self, block):
        """Constants that an error says to be none."""
        said = [line[PLACE.match(line).end():] for line in block if PLACE.match(line)]
        words = {word for line in said if re.search("usable|constexpr|constant|captured", line)
                 for word in re.findall(r"\w+", line)}
        return {(file, constant.name) for file, constant in self.constants() if constant.name in words}

    def used_constants(self, block):
        """Constants that are made or used on the line of an error."""
        for file, line in self.places(block)[:1]:
            words = set(re.findall(r"\w+", (ROOT / file).read_text(encoding="utf-8").split("\n")[line - 1]))
            return {(other, constant.name) for other, constant in self.constants()
                    if constant.name in words and (other == file or other.endswith(".hpp"))}
        return set()

    def blamed_changes(self, block):
        named = {int(number) for line in block for number in re.findall(r"error: .*mutant::.*\[with int id = (\d+)", line)}
        if named:
            return {key(self.numbers[number]) for number in named}
        for file, line in self.places(block):
            spots = self.active.get(file, ((), ()))[0]
            hit = ([s for s in spots if s.change["line"] == line] or
                   [s for s in spots if s.lines[0] <= line <= s.lines[1]])
            if hit:
                return {key(s.change) for s in hit}
        return set()


def error_blocks(log):
    """The lines of each error: what stands before it since the last one, and its notes."""
    block, seen = [], False
    for line in log.splitlines():
        place = PLACE.match(line)
        starts = place and place["what"] != "note" or ": In " in line or line.startswith("In file included")
        if seen and starts:
            yield block
            block, seen = [], False
        block.append(line)
        seen = seen or bool(place and place["what"] in ("error", "fatal error"))
    if seen:
        yield block
