# SPDX-License-Identifier: Apache-2.0
"""Shell scripts parse, can be run, and leave installing to scripts/install-deps.sh."""
import os
import re
import subprocess

import tree


def check(path):
    content = tree.text(path)
    shell = "sh" if content.startswith("#!/bin/sh") else "bash"
    parsed = subprocess.run([shell, "-n", str(path)], capture_output=True, text=True)
    if parsed.returncode:
        yield f"{tree.name(path)}: {parsed.stderr.strip()}"
    if content.startswith("#!") and not os.access(path, os.X_OK):
        yield f"{tree.name(path)}: has a #! line but is not executable"
    if path.name != "install-deps.sh" and re.search(r"\bapt(-get)? .*install|pip3? install|npm (ci|install)", content):
        yield f"{tree.name(path)}: only scripts/install-deps.sh installs packages"


if __name__ == "__main__":
    scripts = tree.files(suffixes={".sh"}) + [tree.ROOT / ".ci/run"]
    complaints = [c for path in scripts for c in check(path)]
    commands = [l for l in tree.text(tree.ROOT / ".ci/run").splitlines() if l.strip() and not l.startswith("#")]
    if commands != ['exec "$(dirname "$0")/../scripts/test.sh"']:
        complaints.append(".ci/run: calls scripts/test.sh and nothing else")
    tree.finish(complaints, len(scripts))
