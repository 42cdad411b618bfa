# SPDX-License-Identifier: Apache-2.0
"""Everything of twum is in the inline namespace with its version, in the sources and, given a program, in its symbols."""
import re
import subprocess
import sys

import tree

PRODUCT = ("core", "motion", "optim", "solid", "studies", "apps", "bindings")


def versioned():
    """Name of the inline namespace."""
    header = tree.text(tree.ROOT / "core/base/include/twum/base/version.hpp")
    return "v" + "_".join(re.findall(r"#define TWUM_VERSION_(?:MAJOR|MINOR) (\d+)", header))


def complaints_about(path, name):
    """Namespaces of one file that are outside."""
    for number, line in enumerate(tree.text(path).splitlines(), 1):
        if line.startswith("namespace twum") and not re.match(rf"namespace twum::inline {name}(::| \{{)", line):
            yield f"{tree.name(path)}:{number}: expected 'namespace twum::inline {name}', the version of version.hpp"


def complaints_about_symbols(program, name):
    """Symbols that the program defines in twum, but outside."""
    listed = subprocess.run(["nm", "--defined-only", program], capture_output=True, text=True, check=True).stdout
    for symbol in sorted({line.split()[-1] for line in listed.splitlines()}):
        if re.match(rf"_ZN[KVrRO]*4twum(?!{len(name)}{name})", symbol):
            yield f"{program}: {symbol} is outside {name}"


if __name__ == "__main__":
    name = versioned()
    paths = tree.files(*PRODUCT, suffixes=tree.CPP)
    complaints = [one for path in paths for one in complaints_about(path, name)]
    for program in sys.argv[1:]:
        complaints += complaints_about_symbols(program, name)
    tree.finish(complaints, len(paths))
