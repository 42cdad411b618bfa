# SPDX-License-Identifier: Apache-2.0
"""How often the sample of the whole range finds a better valley than the searches had, over random studies.

    valley_survey.py TWUM [--count 1000] [--seed 1] [--patience 20] [--minutes M]

The studies are those of stop_study.py by the automatic choice of solvers with the standard budget. One that lasts longer than
the patience in seconds is not waited for. Ends with one line of counts.
"""
import argparse
import collections
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

from stop_study import random_study


def survey_one(program, chance, folder, patience):
    """What a random study ended as: 'slow', or its outcome and the scan of its answer."""
    study = folder / "study.yaml"
    study.write_text(re.sub(r"  solver: .*\n", "", random_study(chance, "auto")))
    try:
        done = subprocess.run([program, "run", str(study), "-o", str(folder / "out"), "--jobs", "1"], capture_output=True, timeout=patience)
    except subprocess.TimeoutExpired:
        return "slow", None
    assert done.returncode in (0, 1), f"exit status {done.returncode}: {done.stderr.decode(errors='replace')}"
    summary = json.loads((folder / "out/summary.json").read_text())
    return summary["outcome"], summary["scan"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--patience", type=float, default=20)
    parser.add_argument("--minutes", type=float, default=math.inf)
    options = parser.parse_args()
    tally = collections.Counter()
    until = time.monotonic() + 60 * options.minutes
    for number in range(options.count):
        if time.monotonic() > until:
            break
        with tempfile.TemporaryDirectory(prefix="twum-valley-") as scratch:
            outcome, scan = survey_one(options.program, random.Random(f"{options.seed} {number}"), pathlib.Path(scratch), options.patience)
        tally["studies"] += 1
        tally[outcome] += 1
        if scan and scan["designs"]:
            tally["scanned"] += 1
            tally["better"] += scan["better"] > 0
            tally["replaced"] += scan["replaced"]
            if scan["better"]:
                print(f"seed {options.seed}, study {number}: {scan}", flush=True)
    print(f"valley_survey: {dict(tally)}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
