# SPDX-License-Identifier: Apache-2.0
"""Writes the attributes and methods that follow from the tables into twum/_twum.pyi.

    PYTHONPATH=BUILD/python /usr/bin/python3 bindings/python/tools/stubs.py [--check]
"""
import pathlib
import sys

import twum

STUB = pathlib.Path(__file__).resolve().parents[1] / "twum/_twum.pyi"
BEGIN, END = "    # from the tables: begin\n", "    # from the tables: end\n"


def point_metric(row):
    name = row["name"]
    if row["takes"] == "speed or torque":
        return "".join(f"    @overload\n    def {name}({parameters}) -> {result}: ...\n" for parameters, result in (
            ("self, speed: _Quantity, *, torque: None = ...", "float"),
            ("self, speed: _Numbers, *, torque: None = ...", "NDArray[np.float64]"),
            ("self, speed: None = ..., *, torque: _Quantity", "float"),
            ("self, speed: None = ..., *, torque: _Numbers", "NDArray[np.float64]"),
            ("self, speed: _Quantity, *, torque: _Quantity", "float")))
    if row["takes"] == "torque and speed":
        return f"    def {name}(self, torque: _Quantity, speed: _Quantity) -> float: ...\n"
    return (f"    @overload\n    def {name}(self, {row['takes']}: _Quantity) -> float: ...\n"
            f"    @overload\n    def {name}(self, {row['takes']}: _Numbers) -> NDArray[np.float64]: ...\n")


def members():
    text = ""
    for row in twum.parameter_table() + [m for m in twum.metric_table() if not m["takes"]]:
        text += f"    @property\n    def {row['name']}(self) -> float: ...\n"
    return text + "".join(point_metric(row) for row in twum.metric_table() if row["takes"])


if __name__ == "__main__":
    old = STUB.read_text(encoding="utf-8")
    before, rest = old.split(BEGIN)
    new = before + BEGIN + members() + END + rest.split(END)[1]
    if "--check" not in sys.argv:
        STUB.write_text(new, encoding="utf-8")
    elif new != old:
        sys.exit(f"{STUB.name} is not what the tables say; run {pathlib.Path(__file__).name}")
