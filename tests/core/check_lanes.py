#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Objects that are compiled for some processors only define one function each, and templates of their own width of lanes.

Another one, inline in a header, could be taken by the linker for the whole program, which would then stop on older
processors.

    check_lanes.py OBJECT...
"""
import re
import subprocess
import sys


def main():
    objects = [name for name in sys.argv[1:] if "lanes_avx" in name]
    if not objects:
        sys.exit("none of the objects is compiled for wider vectors: " + " ".join(sys.argv[1:4]))
    seen = set()
    for name in objects:
        listed = subprocess.run(["nm", "--defined-only", "--extern-only", "--demangle", name],
                                check=True, capture_output=True, text=True).stdout.splitlines()
        functions = [line.split(" ", 2)[2] for line in listed if line.split(" ", 2)[1] in "TWVuiw"]
        entries = [text for text in functions if "::run_lanes_" in text]
        others = [text for text in functions if text not in entries]
        widths = {width for text in others for width in re.findall(r"LaneWidth\)(\d+)", text)}
        shared = [text for text in others if "LaneWidth)" not in text]
        if len(entries) != 1 or shared or len(widths) > 1 or widths & seen:
            sys.exit(f"{name} defines, beside what it is for: {shared or others}")
        seen |= widths
        print(f"{name}: {entries[0]}")


if __name__ == "__main__":
    main()
