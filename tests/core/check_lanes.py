#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Objects that are compiled for some processors only define one function each, and templates of their own width of lanes.

Another one, inline in a header, could be taken by the linker for the whole program, which would then stop on older
processors.

    check_lanes.py OBJECT...
"""
import subprocess
import sys


WIDTHS = {"lanes_avx2": "LaneWidth)2", "lanes_avx512": "LaneWidth)3"}  # of contact/lane_batch.hpp


def main():
    checked = 0
    for name in sys.argv[1:]:
        own = [width for source, width in WIDTHS.items() if source + ".cpp" in name]
        if not own:
            continue
        listed = subprocess.run(["nm", "--defined-only", "--extern-only", "--demangle", name],
                                check=True, capture_output=True, text=True).stdout.splitlines()
        functions = [line.split(" ", 2)[2] for line in listed if line.split(" ", 2)[1] in "TWVuiw"]
        entries = [text for text in functions if "::run_lanes_" in text]
        foreign = [text for text in functions if text not in entries and own[0] not in text]
        if len(entries) != 1 or foreign:
            sys.exit(f"{name} defines {entries}, and what others might use: {foreign}")
        print(f"{name}: {entries[0]}")
        checked += 1
    if checked != len(WIDTHS):
        sys.exit(f"{checked} objects are compiled for wider vectors: " + " ".join(sys.argv[1:4]))


if __name__ == "__main__":
    main()
