# SPDX-License-Identifier: Apache-2.0
"""Includes follow the layers: left may never see right (CONTRIBUTING.md, Layout)."""
import re

import tree

# Layer -> layers of ours it may include. tests/core and tests/optim are held to their layer, so that
# the physics is tested without solvers and the optimization without motors.
CORE = ["core/base", "core/design", "core/contact", "core/performance"]
# Inside studies: four libraries, and the folders of each, in this order.
STUDIES = {
    "files": ["text", "units", "formula", "diagnostics", "yaml", "schema", "statistics", "store", "tables"],
    "motors": ["materials", "metrics", "motor", "tables"],
    "studies": ["problem", "study", "results", "kinds", "run"],
    "report": ["report", "datasheet", "run"],
}
FOLDERS = [f"studies/{part}/{folder}" for part, folders in STUDIES.items() for folder in folders]
ALL_STUDIES = CORE + ["core/stator", "optim"] + FOLDERS + ["studies/report"]
ALLOWED = {
    "core/base": CORE[:1],
    "core/stator": ["core/base", "core/stator"],
    "core/design": ["core/stator"] + CORE[:2],
    "core/contact": ["core/stator"] + CORE[:3],
    "core/performance": ["core/stator"] + CORE,
    "optim": ["core/base", "optim"],
    "apps": ALL_STUDIES + ["apps"],
    "bindings": ALL_STUDIES + ["bindings"],
    # Compiled for pages: core, and of studies what writes notes and curves.
    "bindings/wasm": CORE + ["core/stator", "studies/files/text", "studies/files/units", "studies/motors/motor", "bindings/wasm"],
    "tests/core": ["core/stator"] + CORE + ["tests/core", "tests/support"],
    "tests/stator": ["core/base", "core/stator", "tests/stator", "tests/support"],
    "tests/optim": ["core/base", "optim", "tests/optim", "tests/support"],
    "tests/files": ["core/base", "optim", "tests/files", "tests/support"] +
                   [folder for folder in FOLDERS if folder.startswith("studies/files/")],
    "studies/report": ALL_STUDIES,  # the umbrella header
}
for number, folder in enumerate(FOLDERS):
    below = ["core/base", "optim"] if folder.startswith("studies/files/") else CORE + ["core/stator", "optim"]
    ALLOWED[folder] = below + FOLDERS[:number + 1]

# Where a quoted include may start, besides the folder of the file itself.
PRIVATE_ROOTS = ["core/src", "core/base/src", "core/stator/src", "optim/src", "apps/cli", "apps/cli/src",
                 "bindings", "tests", ""] + [f"studies/{part}/src" for part in STUDIES]

# Third-party headers that may appear only in .cpp files, and in which layers.
ONLY_IN_SOURCES = {
    r"nlopt\.hpp?": {"optim", "bench"},
    r"(coin/)?Ip\w+\.hpp": {"optim", "bench"},
    r"gsl/.*": {"optim", "bench"},
    r"yaml-cpp/.*": {"studies/files"},
    r"udunits2\.h": {"studies/files"},
    r"sqlite3\.h": {"studies/files"},
    r"mpi\.h": {"studies/studies"},
}

# Public headers are installed, and a program that uses them has none of our third-party headers.
# A browser build has no file, thread or solver library: core uses only the standard library, and of it
# only the part that every supported toolchain has. Its .cpp files also use Boost, and those of the stator Eigen and
# Spectra for eigenvalue problems; all three are header-only.
CORE_INCLUDES = re.compile(r"(twum/|[a-z_]+$)")  # ours or standard
CORE_SOURCE_INCLUDES = re.compile(r"(twum/|[a-z_]+$|boost/(math|numeric|random)/)")
STATOR_SOURCE_INCLUDES = re.compile(r"(twum/|[a-z_]+$|boost/math/|Eigen/|Spectra/)")
CORE_LACKS = re.compile(r"<(format|source_location|stop_token|ranges|print|expected)>|std::views|"
                        r"std::(to|from)_chars")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer(path):
    """Layer of a file, from its path; None for folders with no rule (bench, examples, ...)."""
    parts = tree.name(path).split("/")
    if parts[0] == "core":
        if parts[1] == "base":
            return "core/base"
        if parts[1] == "stator":
            return "core/stator"
        for folder in ("design", "contact", "performance"):
            if folder in parts:
                return "core/" + folder
        return "core/performance"  # umbrella headers
    if parts[0] == "tests" or parts[:2] == ["bindings", "wasm"]:
        return "/".join(parts[:2])
    if parts[0] == "studies":  # studies/PART/src/FOLDER/... or studies/PART/include/twum/studies/FOLDER/...
        below = parts[3:] if parts[2] == "src" else parts[5:]
        return "/".join(["studies", parts[1]] + below[:1]) if len(below) > 1 else "studies/report"
    return parts[0]


def resolve(path, spelled):
    """File of ours that an include means; None if it is not ours."""
    candidates = [path.parent / spelled]
    candidates += [tree.ROOT / root / spelled for root in PRIVATE_ROOTS]
    candidates += [tree.ROOT / base / "include" / spelled
                   for base in ["core/base", "core/stator", "core", "optim"] + [f"studies/{part}" for part in STUDIES]]
    return next((c.resolve() for c in candidates if c.is_file()), None)


def check(path):
    here = layer(path)
    allowed = ALLOWED.get(here)
    for number, line in enumerate(tree.text(path).splitlines(), 1):
        place = f"{tree.name(path)}:{number}"
        if here.startswith("core") and CORE_LACKS.search(line):
            yield f"{place}: core must do without {CORE_LACKS.search(line).group(0)}"
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, spelled = match.groups()
        if quote == '"' and spelled.startswith("../"):
            yield f"{place}: include \"{spelled}\" by its path from the layer's root, without '..'"
        target = resolve(path, spelled) if quote == '"' or spelled.startswith("twum/") else None
        if target is not None:
            if allowed is not None and layer(target) not in allowed:
                yield f"{place}: {here} may not include {layer(target)} ({spelled})"
            continue
        if quote == '"' or spelled.startswith("twum/"):
            yield f"{place}: no file of ours is called {spelled}"
            continue
        in_source = STATOR_SOURCE_INCLUDES if here == "core/stator" else CORE_SOURCE_INCLUDES
        admitted = in_source if path.suffix == ".cpp" else CORE_INCLUDES
        if here.startswith("core") and not admitted.match(spelled):
            also = "Boost, Eigen and Spectra" if here == "core/stator" else "Boost"
            yield f"{place}: core uses only the standard library (and {also} in a .cpp), not on <{spelled}>"
        elif "include" in path.parts[:-1] and not CORE_INCLUDES.match(spelled):
            yield f"{place}: a public header uses only the standard library, not on <{spelled}>"
        for pattern, layers in ONLY_IN_SOURCES.items():
            if not re.fullmatch(pattern, spelled) or here.startswith("tests"):
                continue
            if path.suffix != ".cpp":
                yield f"{place}: <{spelled}> belongs in a .cpp file"
            if here not in layers and "/".join(here.split("/")[:2]) not in layers:
                yield f"{place}: <{spelled}> is for {', '.join(sorted(layers))}, not for {here}"


if __name__ == "__main__":
    sources = tree.files("core", "optim", "studies", "apps", "bindings", "bench", "tests", "examples",
                         suffixes=tree.CPP)
    tree.finish([c for path in sources for c in check(path)], len(sources))
