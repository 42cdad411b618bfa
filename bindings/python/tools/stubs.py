# SPDX-License-Identifier: Apache-2.0
"""Writes the attributes and methods that follow from the tables into twum/_twum.pyi.

    PYTHONPATH=BUILD/python /usr/bin/python3 bindings/python/tools/stubs.py [--check]
"""
import keyword
import pathlib
import sys

import twum

STUB = pathlib.Path(__file__).resolve().parents[1] / "twum/_twum.pyi"
BEGIN, END = "    # from the tables: begin\n", "    # from the tables: end\n"


def point_metric(row):
    name = row["name"]
    follows = row["takes"] == "speed or torque"
    if follows or row["takes"] == "speed or torque, not both":
        return "".join(f"    @overload\n    def {name}({parameters}) -> {result}: ...\n" for parameters, result in (
            ("self, speed: _Quantity, *, torque: None = ...", "float"),
            ("self, speed: _Numbers, *, torque: None = ...", "NDArray[np.float64]"),
            ("self, speed: None = ..., *, torque: _Quantity", "float"),
            ("self, speed: None = ..., *, torque: _Numbers", "NDArray[np.float64]"),
            *([("self, speed: _Quantity, *, torque: _Quantity", "float")] if follows else [])))
    if row["takes"] == "torque and speed":
        return f"    def {name}(self, torque: _Quantity, speed: _Quantity) -> float: ...\n"
    return (f"    @overload\n    def {name}(self, {row['takes']}: _Quantity) -> float: ...\n"
            f"    @overload\n    def {name}(self, {row['takes']}: _Numbers) -> NDArray[np.float64]: ...\n")


def members():
    text = ""
    for row in twum.parameter_table() + [m for m in twum.metric_table() if not m["takes"]]:
        text += f"    @property\n    def {row['name']}(self) -> float: ...\n"
    return text + "".join(point_metric(row) for row in twum.metric_table() if row["takes"])


def making():
    """The functions that take parameters by their names or symbols."""
    names = [row[key] for row in twum.parameter_table() for key in ("name", "symbol") if row[key].isidentifier()]
    taken = "".join(f"        {name}: _Quantity = ...,\n" for name in names if not keyword.iskeyword(name))
    return (f"    def __init__(\n        self,\n        path: _Path | None = None,\n        /,\n        *,\n"
            f"        name: str | None = None,\n{taken}    ) -> None: ...\n"
            f"    def replace(\n        self,\n        *,\n{taken}    ) -> Motor: ...\n")


def written(stub, *parts):
    """The stub with each part in place of what stands between one pair of the marks."""
    pieces = stub.split(BEGIN)
    return pieces[0] + "".join(BEGIN + part + END + piece.split(END)[1] for part, piece in zip(parts, pieces[1:], strict=True))


if __name__ == "__main__":
    old = STUB.read_text(encoding="utf-8")
    new = written(old, making(), members())
    if "--check" not in sys.argv:
        STUB.write_text(new, encoding="utf-8")
    elif new != old:
        sys.exit(f"{STUB.name} is not what the tables say; run {pathlib.Path(__file__).name}")
