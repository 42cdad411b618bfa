# SPDX-License-Identifier: Apache-2.0
"""The C++ reference is built from the public headers without a warning, and every public name is in it."""
import re
import subprocess
import tempfile

import tree

TYPE = re.compile(r"(struct|class|enum class) (\w+)[^;]*\{")


def bare_types(path):
    """Types without documentation: doxygen passes over one in silence if no member has any either."""
    before = ""
    for number, line in enumerate(tree.text(path).splitlines(), 1):
        found = TYPE.match(line)
        if found and not before.startswith("///"):
            yield f"{tree.name(path)}:{number}: {found[2]} is not documented"
        if not line.startswith("template"):
            before = line

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        settings = tree.text(tree.ROOT / "docs/Doxyfile") + f"\nOUTPUT_DIRECTORY = {folder}\n"
        done = subprocess.run(["doxygen", "-"], input=settings, cwd=tree.ROOT, capture_output=True, text=True)
        pages = len(list(tree.pathlib.Path(folder).rglob("*.html")))
    warnings = sorted(set(done.stderr.replace(f"{tree.ROOT}/", "").splitlines()))
    headers = [path for path in tree.files("core", "motion", "solid", "optim", "studies", suffixes={".hpp"}) if "include" in path.parts]
    warnings += [complaint for path in headers for complaint in bare_types(path)]
    tree.finish(warnings + ([f"doxygen exits with {done.returncode}"] if done.returncode else []), pages)
