# SPDX-License-Identifier: Apache-2.0
"""The C++ reference is built from the public headers without a warning."""
import subprocess
import tempfile

import tree

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        settings = tree.text(tree.ROOT / "docs/Doxyfile") + f"\nOUTPUT_DIRECTORY = {folder}\n"
        done = subprocess.run(["doxygen", "-"], input=settings, cwd=tree.ROOT, capture_output=True, text=True)
        pages = len(list(tree.pathlib.Path(folder).rglob("*.html")))
    warnings = sorted(set(done.stderr.replace(f"{tree.ROOT}/", "").splitlines()))
    tree.finish(warnings + ([f"doxygen exits with {done.returncode}"] if done.returncode else []), pages)
