#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes the sources one token at a time and sees whether the tests notice.

    scripts/mutate.py --jobs 2                              every change of the core, headers included
    scripts/mutate.py --layer optim --budget 5 --jobs 2     the optimizers, at most 5 s of tests a change
    scripts/mutate.py --layer optim --budget 60 --jobs 2    goes on with those that outlived 5 s
    scripts/mutate.py --files core/src/contact --count 30 --seed 2
    scripts/mutate.py --list --files core/src/contact/lap.cpp
    scripts/mutate.py --report                              what is known, without running anything
    scripts/mutate.py --unexplained --budget 60 --jobs 2    goes on with survivors that have no reason yet
    scripts/mutate.py --one-by-one --count 20               what no run can switch: one build each

A change replaces an arithmetic operator, a comparison, a logical operator, a sign, true or false, or a
number. A copy of the tree in --folder holds all changes at once, each behind its number, and is built once;
a run of a test case switches one of them on. Each case has noted before which changes would have given it
another value at all; only these cases are run, one process each, until one fails. Outcomes are kept in
results.jsonl of the folder, so a second call goes on where the first one stopped; changes are known by
file, line, column and text. --again tries the survivors anew, once there are more tests.

In a && b || c an operator is replaced where it stands, brackets added: (a || b) || c.

Outcomes: killed (a case failed or crashed), endless (a case took 8 times as long; counts as killed), stillborn
(does not compile for any type it is used with), equivalent (no case gave it another value), unreached (no case
runs it), survived, survived so far (the budget ended first), fixed (the compiler needs it: --one-by-one).
Survivors have a class, by what tests/core/answers.cpp or tests/optim/answers.cpp writes: same answers, other
answers, not asked (never another value there). The last two get ten times the budget.
"""
import argparse
import pathlib
import queue
import random
import resource
import signal
import sys
import threading

from mutation.build import Switched
from mutation.cases import cases_of, kill_all
from mutation.changes import LAYERS, ROOT, all_changes, key, text_of
from mutation.onebyone import TESTS, Plain
from mutation.reasons import reason, rules_of
from mutation.results import LISTED, SURVIVED, Results, layer_of, report
from mutation.trial import Trial

MEMORY = 4 << 30  # of a test; a change may make it ask for any amount


def arguments_of(command_line=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--layer", choices=LAYERS, default="core", help="whose sources and tests")
    parser.add_argument("--files", nargs="+", help="files or folders to change instead of the layer's")
    parser.add_argument("--tests", nargs="+",
                        help="test programs with arguments, each one word of the shell (--one-by-one)")
    parser.add_argument("--count", type=int, help="how many of the changes, drawn by the seed; all by default")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="compile jobs and tests at a time")
    parser.add_argument("--budget", type=float, help="seconds of tests for a change; no limit by default")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/mutate")
    parser.add_argument("--again", action="store_true", help="try known survivors once more")
    parser.add_argument("--unexplained", action="store_true", help="only survivors that reasons.tsv does not explain")
    parser.add_argument("--list", action="store_true", help="print the changes that would be tried")
    parser.add_argument("--report", action="store_true", help="print what is known of the changes")
    parser.add_argument("--one-by-one", action="store_true", help="try the changes that are fixed, one build each")
    arguments = parser.parse_args(command_line)
    absent = [name for name in arguments.files or [] if not (ROOT / name).exists()]
    if absent:
        parser.error(f"no such file or folder below {ROOT}: {', '.join(absent)}")
    return arguments


def chosen_changes(arguments):
    chosen = all_changes(arguments.files or LAYERS[arguments.layer])
    random.Random(arguments.seed).shuffle(chosen)
    return chosen[:arguments.count]


def unexplained(chosen, results):
    rules = rules_of()
    found = [(change, results.of(change)) for change in chosen]
    return [change for change, row in found if row and row["outcome"] in LISTED and not reason(row, rules)[0]]


def is_open(row, arguments):
    """A change that is not known yet, or not well enough."""
    if row is None or row["outcome"] not in SURVIVED | {"killed", "endless"}:
        return True
    if row["outcome"] == "survived so far" and (arguments.budget is None or row.get("budget", 0) < arguments.budget):
        return True
    return row["outcome"] in SURVIVED and arguments.again


def tell(number, total, change, found):
    said = [found["outcome"], *(found[name] for name in ("class", "by") if name in found)]
    print(f"{number}/{total} {text_of(change)}: {', '.join(said)}", flush=True)


def work(waiting, trials, arguments, results, total):
    """One worker: takes changes until there are none."""
    while True:
        try:
            number, change = waiting.get_nowait()
        except queue.Empty:
            return
        before = None if arguments.again else results.of(change)
        if before and before["outcome"] != "survived so far":
            before = None
        found = trials[layer_of(change["file"])].outcome(number, change, before)
        results.add(change, found)
        tell(total - waiting.qsize(), total, change, found)


def try_switched(chosen, arguments, results):
    switched = Switched(arguments.folder)
    switched.make(arguments.jobs)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    layers = sorted({layer_of(change["file"]) for change in chosen} & set(LAYERS))
    trials = {layer: Trial(cases_of(layer, switched, arguments.folder), arguments.budget) for layer in layers}
    switchable = switched.switchable()
    numbers = {key(change): number for number, change in switched.numbers.items() if number in switchable}
    waiting = queue.Queue()
    for change in chosen:
        row = results.of(change)
        if key(change) not in numbers:
            if row is None or row["outcome"] not in SURVIVED | {"killed", "endless", "stillborn"}:
                results.add(change, {"outcome": "fixed"})
        elif is_open(row, arguments):
            waiting.put((numbers[key(change)], change))
    total = waiting.qsize()
    workers = [threading.Thread(target=work, args=(waiting, trials, arguments, results, total), daemon=True)
               for _ in range(arguments.jobs)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()


def try_one_by_one(chosen, arguments, results):
    wanted = [change for change in chosen if (results.of(change) or {"outcome": "fixed"})["outcome"] == "fixed" or
              (arguments.again and results.of(change)["outcome"] in SURVIVED)]
    plain = Plain(arguments.folder, arguments.tests or TESTS[arguments.layer])
    plain.make(arguments.jobs)
    for number, change in enumerate(wanted, 1):
        found = plain.outcome(change, arguments.jobs)
        results.add(change, found)
        tell(number, len(wanted), change, found)


def main():
    arguments = arguments_of()
    chosen = chosen_changes(arguments)
    arguments.folder = arguments.folder.resolve()
    results = Results(arguments.folder / "results.jsonl")
    if arguments.unexplained:
        chosen = unexplained(chosen, results)
    if arguments.list or not chosen:
        print("\n".join(text_of(change) for change in chosen) or "no changes to try")
        return
    arguments.folder.mkdir(parents=True, exist_ok=True)
    if arguments.one_by_one:
        try_one_by_one(chosen, arguments, results)
    elif not arguments.report:
        try_switched(chosen, arguments, results)
    report(chosen, results, arguments.folder / "survivors.csv")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("mutate.py: stopped; the same call goes on")
    finally:
        kill_all()
