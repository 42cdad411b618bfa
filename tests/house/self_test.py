# SPDX-License-Identifier: Apache-2.0
"""The house checks see what they are meant to see: each fault planted in a small tree is reported,
and the same tree without it is clean."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HOUSE = pathlib.Path(__file__).resolve().parent
SPDX = "// SPDX-License-Identifier: Apache-2.0\n"

CLEAN = {
    "CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\nproject(twum)\n",
    "CHANGELOG.md": "# Change log\n\n## 1.2.3\n\n### Added\n\n- Everything.\n",
    "README.md": "# twum\n\nSee [theory](docs/theory/a.md#one).\n\n```sh run\ncat examples/x\n```\n\n```text output\n5\n```\n",
    "docs/theory/a.md": "# One\n\n    a = b        (T1.1)\n\n    c < d        (C1.1)\n",
    "docs/page.md": "# Page\n",
    "docs/guide/b.md": "# B\n\n```sh run\ntouch b.txt\n```\n",
    "docs/pages.css": "/* SPDX-License-Identifier: Apache-2.0 */\n",
    "docs/Doxyfile": re.sub(r"(INPUT|IMAGE_PATH)  (.*\\\n)*.*", "",
                            (HOUSE.parents[1] / "docs/Doxyfile").read_text(encoding="utf-8"))
                     + "INPUT = core/include optim/include\n",
    "examples/x": "5\n",
    ".ci/run": '#!/bin/sh\nexec "$(dirname "$0")/../scripts/test.sh"\n',
    "scripts/install-deps.sh": "#!/bin/sh\n# SPDX-License-Identifier: Apache-2.0\napt-get install g++\n",
    "core/CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\nsrc/contact/a.cpp src/design/d.cpp include/twum/core/a.hpp include/twum/core/e.hpp "
                           "include/twum/core/d.hpp\n",
    "core/base/CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\ninclude/twum/base/version.hpp\n",
    "core/base/include/twum/base/version.hpp": SPDX + "#pragma once\n#define TWUM_VERSION_MAJOR 1\n"
                                               "#define TWUM_VERSION_MINOR 2\n#define TWUM_VERSION_PATCH 3\n",
    "core/include/twum/core/a.hpp": SPDX + "#pragma once\n",
    "core/include/twum/core/d.hpp": SPDX + "#pragma once\n#include <vector>\n",
    "core/include/twum/core/e.hpp": SPDX + "#pragma once\n",
    "core/src/design/d.cpp": SPDX + "#include <twum/core/d.hpp>\n",
    "core/src/contact/a.cpp": SPDX + "#include <twum/core/a.hpp>\n#include <cmath>\n// T1.1\n",
    "studies/page/a.js": "// SPDX-License-Identifier: Apache-2.0\nexport const a = 'the largest of all';\n",
    "optim/CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\nsrc/problem/o.cpp include/twum/optim/o.hpp\n",
    "optim/include/twum/optim/o.hpp": SPDX + "#pragma once\n",
    "optim/src/problem/o.cpp": SPDX + "#include <twum/optim/o.hpp>\n#include <nlopt.hpp>\n",
    "materials/brass.yaml": "# Brass\ntwum_material: 1\nname: brass\nkind: metal\nvalues:\n"
                            "  youngs_modulus: {value: 100 GPa, source: typical}\n"
                            "  poisson_ratio: {value: 0.33, source: typical}\n"
                            "  density: {value: 8500 kg/m^3, source: book}\n"
                            "  loss_factor: {value: 0.001, source: typical}\n"
                            "  conductivity: {value: 120 W/(m.K), source: typical}\n"
                            "  specific_heat: {value: 380 J/(kg.K), source: typical}\nsources:\n  book: \"A book\"\n",
    "tests/core/CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\na_test.cpp\n",
    "tests/core/a_test.cpp": SPDX + "#include <twum/core/a.hpp>\n// T1.1 C1.1\n",
}

# check, file, text added to it (or None: the file is left out), part of the report
FAULTS = [
    ("layers", "core/include/twum/core/d.hpp", "#include <twum/core/a.hpp>\n", "core/design may not include what belongs to contact"),
    ("layers", "core/src/contact/a.cpp", "#include <twum/core/e.hpp>\n", "belongs to no folder"),
    ("layers", "optim/src/problem/o.cpp", "#include <twum/core/a.hpp>\n", "optim may not include core"),
    ("layers", "core/src/contact/a.cpp", "#include <twum/optim/o.hpp>\n", "core may not include optim"),
    ("layers", "core/src/contact/a.cpp", "#include <gsl/gsl_math.h>\n", "uses only the standard library"),
    ("layers", "core/src/contact/a.cpp", "#include <Eigen/Core>\n", "uses only the standard library"),
    ("layers", "core/include/twum/core/d.hpp", "#include <boost/math/x.hpp>\n", "uses only the standard library"),
    ("layers", "core/src/contact/a.cpp", "#include <format>\n", "core must do without"),
    ("layers", "core/src/contact/a.cpp", "#include \"contact/gone.hpp\"\n", "no file of ours"),
    ("layers", "optim/include/twum/optim/o.hpp", "#include <nlopt.hpp>\n", "belongs in a .cpp file"),
    ("layers", "optim/include/twum/optim/o.hpp", "#include <Eigen/Core>\n", "a public header uses only"),
    ("layers", "optim/src/problem/o.cpp", "#include <sqlite3.h>\n", "is for studies"),
    ("layers", "tests/core/a_test.cpp", "#include <twum/optim/o.hpp>\n", "tests/core may not include optim"),
    ("sources", "core/src/contact/b.cpp", SPDX, "named in no CMakeLists.txt"),
    ("sources", "core/include/twum/core/b.hpp", SPDX + "#pragma once\n", "public header"),
    ("sources", "scripts/x.py", "print()\n", "first three lines"),
    ("sources", "README.md", "see /home/" + "me/x\n", "points outside"),
    ("sources", "tests/core/a_test.cpp", 'TEST_CASE("one; two") {}\n', "must do without"),
    ("namespaces", "core/src/contact/a.cpp", "namespace twum::core {\nint a;\n}\n", "expected 'namespace twum::inline v1_2'"),
    ("namespaces", "core/src/contact/a.cpp", "namespace twum::inline v1_1 {\nint a;\n}\n", "the version of version.hpp"),
    ("links", "README.md", "[gone](docs/gone.md)\n", "does not exist"),
    ("links", "README.md", "[gone](docs/theory/a.md#two)\n", "no heading #two"),
    ("links", "README.md", "`core/src/gone.cpp`\n", "does not exist"),
    ("links", "README.md", "\n| a |\n| --- |\n| 1 |\n\n| 2 |\n", "cut in two"),
    ("equations", "core/src/contact/a.cpp", "// (T9.9)\n", "cites T9.9"),
    ("equations", "docs/theory/a.md", "\n    e = f   (T1.2)\n", "T1.2 is not cited by code nor by a test"),
    ("equations", "docs/theory/a.md", "\n    e = f   (C1.2)\n", "C1.2 is not cited by a test"),
    ("equations", "docs/theory/a.md", "\n    e = f   (T1.1)\n", "already the number"),
    ("changelog", "CHANGELOG.md", "\n### Broken\n", "not one of"),
    ("changelog", "CHANGELOG.md", "\n- lower case\n", "capital letter"),
    ("scripts", "scripts/install-deps.sh", "if\n", "yntax error"),
    ("scripts", ".ci/run", "echo more\n", "nothing else"),
    ("phrases", "core/src/contact/a.cpp", 'const char* a = "the largest " "of all motors";\n', "'the largest of all' is said by core/src/contact/a.cpp:5 as well"),
    ("materials", "materials/brass.yaml", "  paper: \"A paper\"\n", "no value uses the source paper"),
    ("materials", "materials/brass.yaml", "colour: yellow\n", "not a line of a material"),
    ("materials", "materials/steel.yaml", "twum_material: 1\nname: iron\nkind: metal\n", "name is iron"),
    ("materials", "materials/steel.yaml", "twum_material: 1\nname: steel\nkind: metal\nvalues:\n"
     "  density: {value: 7800 g/cm^3, source: typical}\n", "has the unit 'g/cm^3'"),
    ("materials", "materials/steel.yaml", "twum_material: 1\nname: steel\nkind: metal\nvalues:\n"
     "  density: {value: 7800 kg/m^3, source: hearsay}\n", "no source is called hearsay"),
    ("materials", "materials/steel.yaml", "twum_material: 1\nname: steel\nkind: metal\nvalues:\n"
     "  density: {value: 78 kg/m^3, source: typical}\n", "is plausible"),
    ("materials", "materials/steel.yaml", "twum_material: 1\nname: steel\nkind: metal\n", "loss_factor is missing"),
    ("doxygen", "core/include/twum/core/a.hpp", "/// Words.\nnamespace a {\nvoid f();\n}\n", "f() (function) of namespace a is not documented"),
    ("doxygen", "core/include/twum/core/a.hpp", "/// Words.\nstruct A {\n  int b;\n};\n", "Member b"),
    ("doxygen", "core/include/twum/core/a.hpp", "struct A {};\n", "A is not documented"),
    ("commands", "docs/page.md", "by hand\n", "is not what"),
    ("commands", "docs/guide/c.md", "# C\n\n```sh run\ntouch b.txt\n```\n", "b.txt is also written by docs/guide/b.md"),
    ("commands", "examples/x", "6\n", "something else"),
    ("commands", "README.md", "\n```sh run\nfalse\n```\n", "exit 1, expected 0"),
    ("commands", "README.md", "\n```cpp file=core/src/contact/a.cpp\nint a;\n```\n", "is not core/src/contact/a.cpp"),
]


def plant(root, extra=None):
    for name, content in CLEAN.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
    if extra:
        path = root / extra[0]
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a") as file:
            file.write(extra[1])
    for script in ("scripts/install-deps.sh", ".ci/run"):
        (root / script).chmod(0o755)
    shutil.copytree(HOUSE, root / "tests/house", ignore=shutil.ignore_patterns("__pycache__", "self_test.py"))
    (root / "tests/house/generated_pages.txt").write_text("docs/page.md: echo '# Page'\n")


def report(check, extra=None):
    """Exit status and text of a check on the small tree."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        plant(root, extra)
        arguments = [root / "bin/twum"] if check == "commands" else []
        done = subprocess.run([sys.executable, root / f"tests/house/check_{check}.py", *arguments],
                              capture_output=True, text=True, env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"})
        return done.returncode, done.stdout + done.stderr


if __name__ == "__main__":
    if not shutil.which("doxygen"):
        FAULTS = [fault for fault in FAULTS if fault[0] != "doxygen"]
    failures = []
    for check in sorted({fault[0] for fault in FAULTS}):
        status, text = report(check)
        if status:
            failures.append(f"check_{check}.py complains about a clean tree:\n{text}")
    for check, file, added, expected in FAULTS:
        status, text = report(check, (file, added))
        if status != 1 or expected not in text:
            failures.append(f"check_{check}.py misses {added!r} in {file}:\n{text}")
    print("\n".join(failures))
    print(f"{len(FAULTS)} faults planted, {len(failures)} missed")
    sys.exit(1 if failures else 0)
