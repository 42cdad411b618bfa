# SPDX-License-Identifier: Apache-2.0
"""Puts the outcome of one step of scripts/test-long.sh into the table of docs/reliability/repeat.md.

    record_result.py STEP passed|failed SECONDS LOG
"""
import datetime
import pathlib
import re
import sys

import tree

BEGIN, END = "<!-- test-long: begin -->\n", "<!-- test-long: end -->"
HEAD = "| step | tried | outcome | time | date | repeat with |\n| --- | --- | --- | --- | --- | --- |\n"


def tried(log):
    """How much ran, from what ctest and Catch2 say about themselves."""
    parts = []
    ran = re.findall(r"tests? failed out of (\d+)", log)
    if ran:
        parts.append(f"{ran[-1]} ctests")
    catch = re.findall(r"All tests passed \((\d+) assertions? in (\d+) test cases?\)", log)
    if catch:
        parts.append(f"{sum(int(c) for _, c in catch)} cases, {sum(int(a) for a, _ in catch)} assertions")
    clean = len(re.findall(r"^valgrind .*: no errors$", log, re.M))
    if clean:
        parts.append(f"{clean} commands")
    stopped = re.search(r"^stop_study: (\d+) studies, .*; (\d+) signals", log, re.M)
    if stopped:
        parts.append(f"{stopped.group(1)} studies, {stopped.group(2)} signals")
    executions = [int(n) for n in re.findall(r"^stat::number_of_executed_units: (\d+)", log, re.M)]
    if executions:
        parts.append(f"{len(executions)} fuzzers, {sum(executions)} executions")
    return ", ".join(parts) or "-"


if __name__ == "__main__":
    step, outcome, seconds, log_name = sys.argv[1:]
    page = tree.ROOT / "docs/reliability/repeat.md"
    before, rest = tree.text(page).split(BEGIN)
    table, after = rest.split(END)
    rows = {row.split("|")[1].strip(): row for row in table.splitlines()[2:]}
    seed = re.search(r"^TWUM_SEED=\d+", (log := tree.text(pathlib.Path(log_name))), re.M)
    command = f"{seed.group(0) + ' ' if seed else ''}scripts/test-long.sh {step}"
    rows[step] = (f"| {step} | {tried(log)} | {outcome} | {int(seconds) // 60} min {int(seconds) % 60} s "
                  f"| {datetime.date.today()} | `{command}` |")
    page.write_text(before + BEGIN + HEAD + "\n".join(rows[name] for name in sorted(rows)) + "\n" + END + after,
                    encoding="utf-8")
