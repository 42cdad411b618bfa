# SPDX-License-Identifier: Apache-2.0
"""Files of materials/: kind, values with units and ranges, a source for each value (materials/README.md)."""
import re

import tree

# Value -> unit and the range of what is plausible in it.
ALL = {"youngs_modulus": ("GPa", 0.01, 1000), "poisson_ratio": ("", 0, 0.5), "density": ("kg/m^3", 500, 20000)}
VALUES = {
    "metal": ALL | {"loss_factor": ("", 1e-6, 0.1), "conductivity": ("W/(m.K)", 1, 500),
                    "specific_heat": ("J/(kg.K)", 100, 2000)},
    "piezoceramic": ALL | {"d31": ("pm/V", -500, -10), "permittivity": ("nF/m", 1, 100),
                           "loss_tangent": ("", 1e-4, 0.1), "quality_factor": ("", 10, 10000),
                           "specific_heat": ("J/(kg.K)", 100, 2000)},
    "lining": ALL | {"loss_factor": ("", 1e-6, 1), "kinetic_friction": ("", 0.01, 1), "static_friction": ("", 0.01, 1),
                     "specific_wear": ("mm^3/(N.m)", 1e-10, 1e-2), "conductivity": ("W/(m.K)", 0.02, 10)},
}
HEAD = re.compile(r"(?P<key>twum_material|name|kind): (?P<value>\S+)$")
VALUE = re.compile(r"  (?P<key>\w+): \{value: (?P<number>\S+?)(?: (?P<unit>\S+))?, source: (?P<source>\w+)\}$")
SOURCE = re.compile(r'  (?P<key>\w+): "(?P<text>.+)"$')


def check(path):
    head, values, sources, section = {}, {}, {}, None
    for number, line in enumerate(tree.text(path).splitlines(), 1):
        place = f"{tree.name(path)}:{number}"
        if line.startswith("#"):
            continue
        if line in ("values:", "sources:", "sources: {}"):
            section = line.split(":")[0]
            continue
        match = {None: HEAD, "values": VALUE, "sources": SOURCE}[section].match(line)
        if not match:
            yield f"{place}: not a line of a material: {line}"
            continue
        into = {None: head, "values": values, "sources": sources}[section]
        if match["key"] in into:
            yield f"{place}: {match['key']} is given twice"
        into[match["key"]] = (place, match)
    yield from check_head(path, head)
    kind = head["kind"][1]["value"] if "kind" in head else None
    if kind in VALUES:
        yield from check_values(path, VALUES[kind], values, sources)


def check_head(path, head):
    wanted = {"twum_material": {"1"}, "name": {path.stem}, "kind": set(VALUES)}
    for key, allowed in wanted.items():
        found = head[key][1]["value"] if key in head else None
        if found not in allowed:
            yield f"{tree.name(path)}: {key} is {found}; it must be {' or '.join(sorted(allowed))}"


def check_values(path, wanted, values, sources):
    for key in wanted.keys() - values.keys():
        yield f"{tree.name(path)}: {key} is missing"
    for key, (place, match) in values.items():
        if key not in wanted:
            yield f"{place}: {key} is no value of this kind; there are {', '.join(wanted)}"
            continue
        unit, low, high = wanted[key]
        if (match["unit"] or "") != unit:
            yield f"{place}: {key} has the unit '{match['unit'] or ''}'; it must be '{unit}'"
        try:
            inside = low <= float(match["number"]) <= high
        except ValueError:
            inside = False
        if not inside:
            yield f"{place}: {key} is {match['number']}; a number from {low} to {high} is plausible"
        if match["source"] != "typical" and match["source"] not in sources:
            yield f"{place}: no source is called {match['source']}; give it under sources, or write typical"
    used = {match["source"] for _, match in values.values()}
    for key, (place, _) in sources.items():
        if key not in used:
            yield f"{place}: no value uses the source {key}"


if __name__ == "__main__":
    paths = [p for p in tree.files("materials") if p.suffix == ".yaml"]
    complaints = [c for path in paths for c in check(path)]
    tree.finish(complaints if paths else ["materials: no files"], len(paths))
