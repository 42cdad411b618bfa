# SPDX-License-Identifier: Apache-2.0
"""Random searches over random motors, by every solver: each must end by itself, and within a second after a signal.

    stop_study.py TWUM [--count 100] [--seed 1] [--minutes M] [--keep DIR] [--solver NAME ...]

The motors have light damping, static friction above kinetic, or neither; the limits may be met, kept by no design, or
lie where a design has no answer. Each study runs twice: without a signal, where a search that stores no new evaluation for 60 s
counts as endless (one evaluation of these motors takes up to some seconds); and with one SIGINT or SIGTERM at a random
moment. A study that still finds its way after a minute is not waited for. Ends with exit status 0 and one line of counts, or names the studies at fault.
"""
import argparse
import collections
import json
import math
import pathlib
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

ENDED = (0, 1, 130)  # with an answer, without one, asked to stop
STILL = 60  # [s] without a new evaluation: endless
LONG = 60  # [s] of a study that goes on storing evaluations
SOON = 1.0  # [s] from the signal to the end of the program

MOTOR = """twum: 1
motor:
  name: random
  stator: {{wavelengths: {wavelengths}, contact_radius: {radius:.6g} mm, contact_width: {width:.6g} mm, \
neutral_plane_distance: {neutral:.6g} mm, frequency: {frequency:.6g} kHz, amplitude: {amplitude:.6g} um, \
modal_damping: {damping:.6g} N.s/m}}
  contact_layer: {{thickness: {thickness:.6g} mm, youngs_modulus: {modulus:.6g} GPa, poisson_ratio: 0.35, \
density: {density:.6g} kg/m^3, loss_factor: {loss:.6g}}}
  friction: {{kinetic: {kinetic:.6g}, static: {static:.6g}}}
  preload: {preload:.6g} N
"""
VARIABLES = [("contact_radius", "radius", "mm"), ("contact_width", "width", "mm"), ("neutral_plane_distance", "neutral", "mm"),
             ("frequency", "frequency", "kHz"), ("amplitude", "amplitude", "um"), ("thickness", "thickness", "mm"),
             ("youngs_modulus", "modulus", "GPa"), ("density", "density", "kg/m^3"), ("loss_factor", "loss", ""),
             ("preload", "preload", "N")]
# name, argument, unit, and a size that is usual for it
METRICS = [("stall_torque", "", "N.m", 1), ("max_torque", "", "N.m", 1), ("no_load_speed", "", "rpm", 120),
           ("plateau_speed", "", "rpm", 80), ("peak_power", "", "W", 8), ("torque_at_peak_power", "", "N.m", 0.8),
           ("max_efficiency", "", "", 0.45), ("max_pressure", "", "MPa", 3), ("efficiency_at", "0.4 N.m", "", 0.4),
           ("stator_power_at", "60 rpm", "W", 15), ("wear_intensity_at", "60 rpm", "kW/m^2", 8), ("contact_ratio", "", "", 0.08),
           ("stick_fraction_at", "100 rpm", "", 0.3), ("speed_at", "0.3 N.m", "rpm", 80)]


def random_study(chance, solver):
    def spread(low, high):
        return math.exp(chance.uniform(math.log(low), math.log(high)))

    motor = {"wavelengths": chance.randint(5, 13), "radius": spread(18, 40), "width": spread(2, 6), "neutral": spread(2, 5),
             "frequency": spread(25, 70), "amplitude": spread(0.8, 2.5), "damping": chance.choice([0, spread(20, 80)]),
             "thickness": spread(0.15, 0.6), "modulus": spread(1, 6), "density": spread(1200, 2200),
             "loss": chance.choice([spread(1e-3, 1e-2), spread(1e-2, 0.2)]), "kinetic": spread(0.12, 0.35), "preload": spread(60, 300)}
    motor["static"] = motor["kinetic"] * chance.choice([1, 1, 1.01, chance.uniform(1, 1.6)])
    metrics = [m for m in METRICS if motor["damping"] or m[0] != "max_efficiency"]

    def named(metric):
        return f"{metric[0]}({metric[1]})" if metric[1] else metric[0]

    lines = [MOTOR.format(**motor) + "study:", "  kind: optimize", "  variables:"]
    for name, key, unit in chance.sample(VARIABLES, chance.randint(1, 4)):
        low, high = motor[key] / spread(1.02, 3), motor[key] * spread(1.02, 3)
        lines.append(f"    {name}: {{min: {low:.6g} {unit}, max: {high:.6g} {unit}, scale: {chance.choice(['linear', 'log'])}}}")
    lines.append(f"  {chance.choice(['minimize', 'maximize'])}: {named(chance.choice(metrics))}")
    limits = [f'"{named(m)} {chance.choice(["<=", ">="])} {m[3] * spread(0.3, 3):.4g} {m[2]}"'
              for m in chance.sample(metrics, chance.randint(0, 3))]
    if limits:
        lines.append(f"  constraints: [{', '.join(limits)}]")
    starts = chance.choice([1, 2, 8])
    lines.append(f'  solver: {{name: "{solver}", max_evaluations: {chance.choice([40, 150, 500])}, starts: {starts}}}')
    return "\n".join(lines) + "\n"


def start(program, study, folder, fresh=()):
    return subprocess.Popen([program, "run", str(study), "-o", str(folder), *fresh], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def rows(folder):
    try:
        connection = sqlite3.connect(f"file:{folder / 'results.db'}?mode=ro", uri=True)
        with connection:
            return connection.execute("SELECT count(*) FROM evaluations").fetchone()[0]
    except sqlite3.Error:
        return 0


def in_peace(program, study, folder):
    """Seconds, and True if it ended; False if it is slow, None if no evaluation came for a long time."""
    begin = time.monotonic()
    process = start(program, study, folder)
    known, since = -1, begin
    while True:
        try:
            _, errors = process.communicate(timeout=2)
            assert process.returncode in ENDED, f"exit status {process.returncode}: {errors.decode(errors='replace')}"
            return time.monotonic() - begin, True
        except subprocess.TimeoutExpired:
            now = rows(folder)
            if now != known:
                known, since = now, time.monotonic()
            slow, endless = since - begin > LONG, time.monotonic() - since > STILL
            if slow or endless:
                process.kill()
                process.communicate()
                return LONG, None if endless else False


def after_signal(program, study, folder, chance, lasts):
    """How the run ended and how long after the signal; nothing where it ended before."""
    process = start(program, study, folder, ["--fresh"])
    try:
        process.wait(chance.uniform(0, lasts))
        process.communicate()
        return None
    except subprocess.TimeoutExpired:
        pass
    number = chance.choice([signal.SIGINT, signal.SIGTERM])
    asked = time.monotonic()
    process.send_signal(number)
    try:
        _, errors = process.communicate(timeout=10)
    except subprocess.TimeoutExpired:
        process.kill()
        _, errors = process.communicate()
    took = time.monotonic() - asked
    early = process.returncode == -number and not errors  # before the program listens
    assert early or process.returncode in ENDED or took > SOON, f"exit status {process.returncode}: {errors.decode(errors='replace')}"
    return took, b"before all result files were written" in errors


def solver_names(program):
    listed = json.loads(subprocess.run([program, "solvers", "--format", "json"], capture_output=True, check=True).stdout)
    fits = ("twum:lm", "gsl:lm")  # of measurements
    return ["auto"] + [s["name"] for s in listed if s["available"] == "yes" and s["name"] not in fits]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--solver", action="append")
    options = parser.parse_args()
    names = options.solver or solver_names(options.program)
    tally = collections.Counter()
    longest = 0.0
    faults = []
    until = time.monotonic() + 60 * options.minutes
    for number in range(options.count):
        if time.monotonic() > until:
            break
        name = names[number % len(names)]
        chance = random.Random(f"{options.seed} {number}")
        with tempfile.TemporaryDirectory(prefix="twum-stop-") as scratch:
            study, folder = pathlib.Path(scratch, "study.yaml"), pathlib.Path(scratch, "out")
            study.write_text(random_study(chance, name))
            tally["studies"] += 1
            said = ""
            try:
                lasts, ended = in_peace(options.program, study, folder)
                tally["ended"] += ended is True
                if ended is None:
                    said = "endless"
                stopped = after_signal(options.program, study, folder, chance, min(lasts, 5))
                if stopped:
                    tally["signals"] += 1
                    tally["cut"] += stopped[1]
                    longest = max(longest, stopped[0])
                    if stopped[0] > SOON:
                        said += f" ended {stopped[0]:.2f} s after the signal"
            except AssertionError as error:
                said += f" {error}"
            if said:
                faults.append(number)
                print(f"seed {options.seed}, study {number}, {name}: {said}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / f"stop_{options.seed}_{number}.yaml").write_text(study.read_text())
    print(f"stop_study: {tally['studies']} studies, {tally['ended']} ended within a minute, {len(faults)} at fault; "
          f"{tally['signals']} signals, the slowest answered in {longest:.2f} s, {tally['cut']} runs cut within an evaluation "
          "or a report", flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
