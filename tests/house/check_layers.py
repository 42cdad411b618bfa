# SPDX-License-Identifier: Apache-2.0
"""Includes follow the layers: left may never see right (CONTRIBUTING.md, Layout)."""
import re

import tree

# The libraries, each with those of ours that it may include, and the folders of its src in their order. A file may include its own
# folder and those before it. tests/core and tests/optim are held to their libraries, so that the physics is tested
# without solvers and the optimization without motors.
LIBRARIES = {
    "core/base": [],
    "core/stator": ["core/base"],
    "core": ["core/base", "core/stator"],
    "motion": ["core/base", "core/stator", "core"],
    "solid": ["core/base", "core/stator"],
    "optim": ["core/base"],
    "studies/io": ["core/base"],
    "studies/motors": ["core/base", "core/stator", "core", "studies/io"],
    "studies": ["core/base", "core/stator", "core", "motion", "optim", "studies/io", "studies/motors"],
}
FOLDERS = {
    "core": ["design", "contact", "model", "point", "curve", "drive", "held", "heat", "wear", "metrics"],
    "optim": ["sampling", "problem", "solvers", "certificate", "search", "fronts", "fit", "robust"],
    "studies/io": ["text", "units", "formula", "diagnostics", "yaml", "schema", "store", "tables"],
    "studies/motors": ["materials", "metrics", "file", "tables"],
    "studies": ["statistics", "problem", "entries", "results", "kinds/rows", "kinds/sample", "kinds/sensitivity",
                "kinds/calibrate", "kinds/robust", "kinds/search", "telling", "stored", "report", "run"],
}
# Public headers whose functions and classes a source of another name defines, and those of types alone, in the lowest folder that
# needs them.
FOLDER_OF_HEADER = {
    "twum/core/life.hpp": "metrics",
    "twum/core/load.hpp": "design",
    "twum/core/metric_request.hpp": "design",
    "twum/core/motion_metrics.hpp": "metrics",
    "twum/optim/options.hpp": "problem",
    "twum/studies/telling.hpp": "telling",
    "twum/optim/estimate.hpp": "sampling",
    "twum/optim/robust.hpp": "robust",
    "twum/optim/robust_problem.hpp": "robust",
    "twum/io/column.hpp": "store",
    "twum/io/erased.hpp": "schema",
    "twum/io/library_versions.hpp": "store",
    "twum/io/publish.hpp": "schema",
    "twum/io/schema.hpp": "schema",
    "twum/io/shape.hpp": "schema",
    "twum/io/shared_list.hpp": "schema",
    "twum/io/value_error.hpp": "text",
    "twum/io/value_shape.hpp": "schema",
    "twum/io/yaml_loader.hpp": "yaml",
    "twum/io/yaml_node.hpp": "yaml",
    "twum/motors/column_choice.hpp": "tables",
    "twum/studies/estimate.hpp": "statistics",
    "twum/studies/extent.hpp": "statistics",
    "twum/studies/study.hpp": "entries",
    "twum/studies/fit_curves.hpp": "results",
    "twum/studies/run_options.hpp": "stored",
    "twum/studies/stored_result.hpp": "stored",
} | {f"twum/studies/{name}.hpp": "results" for name in (
    "calibrate_result", "curve_result", "frequency_result", "heat_result", "life_result", "map_result", "motion_result", "move", "optimize_result", "pareto_result", "robust_result",
    "run_progress", "sample_results", "search_results", "sensitivity_result", "study_result", "sweep_result",
    "uncertainty_result")}
OTHERS = {
    "apps": list(LIBRARIES),
    "bindings": list(LIBRARIES),
    # Compiled for pages: core, of motion the plant, and of studies what writes notes and curves.
    "bindings/wasm": ["core/base", "core/stator", "core", "motion", "studies/io", "studies/motors"],
    "tests/core": ["core/base", "core/stator", "core", "tests/support"],
    "tests/stator": ["core/base", "core/stator", "tests/support"],
    "tests/solid": ["core/base", "core/stator", "solid", "tests/support"],
    "tests/motion": ["core/base", "core/stator", "core", "motion", "tests/support"],
    "tests/optim": ["core/base", "optim", "tests/support"],
    "tests/io": ["core/base", "studies/io", "tests/support"],
}

# Where a quoted include may start, besides the folder of the file itself.
PRIVATE_ROOTS = [f"{library}/src" for library in LIBRARIES] + ["apps/cli", "apps/cli/src", "bindings", "tests", ""]

# Third-party headers that may appear only in .cpp files, and in which layers.
ONLY_IN_SOURCES = {
    r"nlopt\.hpp?": {"optim", "bench"},
    r"(coin/)?Ip\w+\.hpp": {"optim", "bench"},
    r"gsl/.*": {"optim", "bench"},
    r"(cvodes|nvector|sundials|sunlinsol|sunmatrix)/.*": {"motion"},
    r"yaml-cpp/.*": {"studies/io"},
    r"udunits2\.h": {"studies/io"},
    r"sqlite3\.h": {"studies/io"},
    r"zip\.h": {"apps"},
    r"mpi\.h": {"studies"},
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


def library(path):
    """Library of a file, or what else has rules of its own; None for bench, examples, ..."""
    name = tree.name(path)
    owners = [known for known in list(LIBRARIES) + list(OTHERS) if name.startswith(known + "/")]
    return max(owners, key=len, default=None)


def folder(path, owner):
    """Number of its folder in the order of its library. A public header belongs to the folder of the source of its name."""
    order = FOLDERS.get(owner)
    if order is None:
        return 0
    parts = tree.name(path)[len(owner) + 1:].split("/")
    if parts[0] == "src":
        place = "/".join(parts[1:3] if parts[1] == "kinds" else parts[1:2])
        return order.index(place) if place in order else len(order)
    if len(parts) == 3:  # the header of all: include/twum/core.hpp
        return len(order)
    known = FOLDER_OF_HEADER.get("/".join(parts[1:]))
    if known is not None:
        return order.index(known)
    sources = sorted((tree.ROOT / owner / "src").rglob(path.stem + ".cpp"))
    return folder(sources[0], owner) if sources else -1


def resolve(path, spelled):
    """File of ours that an include means; None if it is not ours."""
    candidates = [path.parent / spelled]
    candidates += [tree.ROOT / root / spelled for root in PRIVATE_ROOTS]
    candidates += [tree.ROOT / owner / "include" / spelled for owner in LIBRARIES]
    return next((c.resolve() for c in candidates if c.is_file()), None)


def against_order(path, target):
    """What is wrong with the include of a file of ours; empty if nothing is."""
    here, there = library(path), library(target)
    if here is None or (here, there) == (None, None):
        return ""
    if here != there:
        allowed = OTHERS.get(here) or LIBRARIES.get(here, [])
        return "" if there in allowed or there is None and here in OTHERS else f"{here} may not include {there}"
    if here not in FOLDERS:
        return ""
    order, ours, theirs = FOLDERS[here], folder(path, here), folder(target, here)
    if theirs == -1:
        return f"{tree.name(target)} belongs to no folder: no source has its name, and FOLDER_OF_HEADER does not name it"
    if ours < theirs < len(order):
        return f"{here}/{order[ours]} may not include what belongs to {order[theirs]}"
    return ""


def check(path):
    here = library(path) or tree.name(path).split("/")[0]
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
            wrong = against_order(path, target)
            if wrong:
                yield f"{place}: {wrong} ({spelled})"
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
            if here not in layers:
                yield f"{place}: <{spelled}> is for {', '.join(sorted(layers))}, not for {here}"


if __name__ == "__main__":
    sources = tree.files("core", "motion", "solid", "optim", "studies", "apps", "bindings", "bench", "tests", "examples",
                         suffixes=tree.CPP)
    tree.finish([c for path in sources for c in check(path)], len(sources))
