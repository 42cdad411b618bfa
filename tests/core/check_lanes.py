#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Objects that are compiled for some processors only define one function each.

A second one, inline in a header, could be taken by the linker for the whole program, which would then stop on older
processors.

    check_lanes.py OBJECT...
"""
import subprocess
import sys


def main():
    objects = [name for name in sys.argv[1:] if "lanes_avx" in name]
    if not objects:
        sys.exit("none of the objects is compiled for wider vectors: " + " ".join(sys.argv[1:4]))
    for name in objects:
        listed = subprocess.run(["nm", "--defined-only", "--extern-only", "--demangle", name],
                                check=True, capture_output=True, text=True).stdout.splitlines()
        functions = [line.split(" ", 2)[2] for line in listed if line.split(" ", 2)[1] in "TWVuiw"]
        if len(functions) != 1 or "run_lanes_" not in functions[0]:
            sys.exit(f"{name} defines, beside what it is for: {functions}")
        print(f"{name}: {functions[0]}")


if __name__ == "__main__":
    main()
