# SPDX-License-Identifier: Apache-2.0
"""Random studies of every kind, on motors with an amplitude, with a voltage and with a plate, sliced and tapered, with what may
happen to them.

    attack_study.py TWUM [--other OLDER_TWUM] [--count 100] [--kills 0] [--seed 1] [--minutes M] [--keep DIR]

Each study is checked, run on one thread, verified, answered again from its directory, run on three threads, and written as
resolved and run from there: the results must be the same. It is run once more on a disk that fills up at a random size, and
goes on when there is room; with --other a run by that program that is killed is gone on with by this one, and the other way round; with
--kills it is killed that many times. Then either the same results come, or a message names the directory and the remedy.
Ends with exit status 0 and one line of counts, or names the studies at fault.
"""
import argparse
import collections
import math
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

from kill_study import ENDED, kill_often, results
from stop_study import METRICS, MOTOR, VARIABLES

PATIENCE = 60  # [s] of one run
REFUSED = (2, 3)

DRIVEN = """twum: 1
motor:
  name: driven
  stator: {{wavelengths: 9, contact_radius: 26.5 mm, contact_width: 4 mm, neutral_plane_distance: 3 mm, \
frequency_ratio: {above:.6g}, voltage: {voltage:.6g} V, resonance_frequency: {resonance:.6g} kHz, modal_mass: {mass:.6g} g, \
quality_factor: {quality:.6g}, force_factor: {factor:.6g} N/V, blocked_capacitance: 8.5 nF, loss_tangent: 0.01}}
  contact_layer: {{thickness: {thickness:.6g} mm, youngs_modulus: {modulus:.6g} GPa, poisson_ratio: 0.38, density: 1500 kg/m^3, \
loss_factor: 0.05}}
  friction: {{kinetic: {kinetic:.6g}, static: {static:.6g}}}
  preload: {preload:.6g} N
"""


def spread(chance, low, high):
    return math.exp(chance.uniform(math.log(low), math.log(high)))


def random_motor(chance):
    """Numbers of a motor near those of the examples: half have static friction above the kinetic one."""
    motor = {"wavelengths": chance.randint(6, 12), "radius": spread(chance, 20, 35), "width": spread(chance, 2, 5),
             "neutral": spread(chance, 2, 4), "frequency": spread(chance, 30, 60), "amplitude": spread(chance, 1, 2.2),
             "damping": spread(chance, 20, 80), "thickness": spread(chance, 0.15, 0.5), "modulus": spread(chance, 1, 6),
             "density": spread(chance, 1200, 2200), "loss": spread(chance, 0.02, 0.2), "kinetic": spread(chance, 0.12, 0.3),
             "preload": spread(chance, 80, 250)}
    motor["static"] = motor["kinetic"] * chance.choice([1, 1.1])
    return motor


def driven(chance):
    """A motor under a voltage with numbers near those of its example; half with static friction above the kinetic one."""
    kinetic = spread(chance, 0.15, 0.3)
    return DRIVEN.format(resonance=spread(chance, 30, 45), above=chance.uniform(1.005, 1.06), voltage=spread(chance, 50, 180),
                         mass=spread(chance, 15, 40), quality=spread(chance, 80, 300), factor=spread(chance, 0.3, 0.8),
                         thickness=spread(chance, 0.3, 0.7), modulus=spread(chance, 0.5, 2), kinetic=kinetic,
                         static=kinetic * chance.choice([1, 1.1]), preload=spread(chance, 80, 250))


def tapered(chance, text):
    """The same motor with a track of some slices, or of one beside a taper and a shape that only more slices would use."""
    slices = chance.choice(["1", "1", "4", "8", "auto"])
    shape = f"radial_slices: {slices}, radial_shape: {{exponent: {chance.uniform(-2, 3):.3g}, root: {chance.uniform(0, 5):.3g} mm}}, "
    text = text.replace("stator: {", "stator: {" + shape, 1)
    return text.replace("  preload:", f"  rotor: {{taper: {chance.uniform(-100, 100):.3g} urad, mass: 50 g}}\n  preload:", 1)


def plate(chance):
    text = (pathlib.Path(__file__).resolve().parents[2] / "examples/motors/plate-30.yaml").read_text()
    return re.sub(r"^(  preload:).*$", lambda m: f"{m[1]} {chance.uniform(5, 30):.4g} N", text, flags=re.M)


def named(metric):
    return f"{metric[0]}({metric[1]})" if metric[1] else metric[0]


def ranges(chance, motor, least=1, most=4):
    lines = []
    for name, key, unit in chance.sample(VARIABLES, chance.randint(least, most)):
        low, high = motor[key] / spread(chance, 1.05, 2), motor[key] * spread(chance, 1.05, 2)
        lines.append(f"    {name}: {{min: {low:.6g} {unit}, max: {high:.6g} {unit}, scale: {chance.choice(['linear', 'log'])}}}")
    return ["  variables:", *lines]


def limits(chance, key, most=2):
    lines = [f'"{named(m)} {chance.choice(["<=", ">="])} {m[3] * spread(chance, 0.5, 2):.4g} {m[2]}"'
             for m in chance.sample(METRICS, chance.randint(0, most))]
    return [f"  {key}: [{', '.join(lines)}]"] if lines else []


def metrics(chance):
    return [f"  metrics: [{', '.join(named(m) for m in chance.sample(METRICS, chance.randint(1, 4)))}]"]


def pareto(chance, motor):
    goals = chance.sample(METRICS, chance.choice([2, 2, 3]))
    lines = [f"    - {chance.choice(['minimize', 'maximize'])}: {named(goal)}" for goal in goals]
    solver = chance.choice(["auto", "nsga2"])
    return [*ranges(chance, motor, 1, 3), "  objectives:", *lines, *limits(chance, "constraints"), f"  points: {chance.randint(3, 8)}",
            f"  solver: {{name: {solver}, max_evaluations: {chance.choice([200, 2000])}}}"]


def size(chance, motor):
    torque = motor["kinetic"] * motor["preload"] * motor["radius"] * 1e-3
    points = [f"    - {{torque: {torque * chance.uniform(0.2, 1.1):.4g} N.m, speed: {chance.uniform(5, 80):.4g} rpm}}"
              for _ in range(chance.randint(1, 2))]
    return [*ranges(chance, motor), "  duty:", *points, *limits(chance, "limits", 1),
            f"  solver: {{max_evaluations: {chance.choice([100, 3000])}}}"]


def uncertainty(chance, motor):
    lines = []
    for name, key, unit in chance.sample(VARIABLES, chance.randint(1, 4)):
        share = chance.uniform(1, 15)
        sd = f"{motor[key] * share / 100:.6g} {unit}".strip()
        lines.append(f"    {name}: " + chance.choice([f"{share:.3g} %", f"{{distribution: lognormal, sd: {share:.3g} %}}",
                                                      f"{{distribution: triangular, below: {sd}, above: {sd}}}"]))
    return ["  variables:", *lines, *metrics(chance), *limits(chance, "limits"), f"  samples: {chance.randint(10, 3000)}",
            f"  seed: {chance.randint(0, 2**53 - 1)}"]


def sensitivity(chance, motor):
    method = chance.choice(["local", "morris", "sobol"])
    lines = [f"  method: {method}", *ranges(chance, motor), *metrics(chance)]
    return lines if method == "local" else [*lines, f"  samples: {chance.randint(4, 60)}"]


def frequency(chance):
    name, low, high, unit = chance.choice([("voltage", 40, 200, "V"), ("preload", 50, 250, "N"), ("torque", 0, 0.5, "N.m")])
    family = ", ".join(f"{chance.uniform(low, high):.4g} {unit}" for _ in range(chance.randint(1, 4)))
    load = [] if name == "torque" else chance.choice([[], [f"  torque: {chance.uniform(0, 0.5):.3g} N.m"],
                                                      [f"  speed: {chance.uniform(0, 100):.3g} rpm"]])
    return [f"  family: {{{name}: [{family}]}}", *load, f"  points: {chance.randint(10, 200)}",
            f"  direction: {chance.choice(['up', 'down', 'both'])}"]


def optimize(chance, motor):
    goal = f"  {chance.choice(['minimize', 'maximize'])}: {named(chance.choice(METRICS))}"
    return [*ranges(chance, motor), goal, *limits(chance, "constraints"), f"  solver: {{max_evaluations: {chance.choice([50, 1000])}, starts: 2}}"]


def robust(chance, motor):
    spreads = [f"    {name}: {chance.uniform(1, 8):.3g} %" for name, _, _ in chance.sample(VARIABLES, chance.randint(1, 2))]
    return [*ranges(chance, motor, 1, 2), "  tolerances:", *spreads, f"  maximize: \"quantile({named(chance.choice(METRICS))}, 5 %)\"",
            "  solver: {max_evaluations: 60, starts: 1, scan: 0}"]


def sweep(chance, motor):
    lines = [f"    {name}: {{min: {motor[key] / 1.3:.6g} {unit}, max: {motor[key] * 1.3:.6g} {unit}}}"
             for name, key, unit in chance.sample(VARIABLES, chance.randint(1, 3)) if name not in ("contact_width", "thickness")]
    derived = chance.choice([[], ["  derived: {contact_width: 0.12 * contact_radius}"], ["  derived: {static_friction: 1.05 * kinetic_friction}"]])
    lines = lines or [f"    preload: {{min: {motor['preload'] / 2:.4g} N, max: {motor['preload']:.4g} N}}"]
    return ["  variables:", *lines, *derived, f"  sampling: {chance.choice(['lhs', 'sobol'])}", f"  samples: {chance.randint(5, 60)}", *metrics(chance)]


def curve(chance, motor):
    name, key, unit = chance.choice(VARIABLES)
    family = ", ".join(f"{motor[key] * chance.uniform(0.8, 1.2):.4g} {unit}".strip() for _ in range(3))
    return [f"  family: {{{name}: [{family}]}}", f"  points: {chance.randint(5, 60)}"]


def calibrate(chance, motor):
    """Without data: it plans the first measurements."""
    return ["  variables:", "    kinetic_friction: {min: 0.05, max: 0.5}", "    youngs_modulus: {min: 0.3 GPa, max: 20 GPa, scale: log}"]


KINDS = {"pareto": pareto, "size": size, "uncertainty": uncertainty, "sensitivity": sensitivity, "optimize": optimize, "robust": robust,
         "sweep": sweep, "curve": curve, "calibrate": calibrate}
ATTACKED = [*KINDS, "frequency"]
# of a motor under a voltage or with a plate; each has these
DRIVEN_VARIABLES = {"preload", "thickness", "youngs_modulus", "density", "loss_factor"}


def random_study(chance, kind):
    if kind == "frequency":
        return "\n".join([driven(chance) + "study:", "  kind: frequency", *frequency(chance)]) + "\n"
    motor = random_motor(chance)
    text = MOTOR.format(**motor)
    other = chance.choice(["amplitude", "amplitude", "tapered", "voltage", "plate"])
    lines = KINDS[kind](chance, motor)
    if other == "tapered":
        text = tapered(chance, text)
    varied = {name for name, _, _ in VARIABLES if any(re.match(rf" *(family: {{)?{name}:", line) for line in lines)}
    if other in ("voltage", "plate") and varied <= DRIVEN_VARIABLES:
        text = driven(chance) if other == "voltage" else plate(chance)
    kind = "optimize" if kind == "robust" else kind
    return "\n".join([text.rstrip() + "\nstudy:", f"  kind: {kind}", *lines]) + "\n"


def run(program, *arguments, **options):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, timeout=PATIENCE, **options)
    return done.returncode, (done.stdout + done.stderr).decode(errors="replace")


def run_study(program, study, folder, *more):
    status, said = run(program, "run", study, "-o", folder, *more)
    assert status in ENDED, f"exit status {status}: {said}"
    return status, results(folder)


class Fault(AssertionError):
    pass


def expect(condition, words):
    if not condition:
        raise Fault(words)


def in_peace(program, study, scratch):
    """The results, with those of every other way to them."""
    status, expected = run_study(program, study, scratch / "one", "--jobs", "1")
    expect(run_study(program, study, scratch / "one") == (status, expected), "answered from its directory it is another")
    expect(run_study(program, study, scratch / "three", "--jobs", "3") == (status, expected), "three threads find another")
    expect(run_study(program, scratch / "one/study.yaml", scratch / "resolved")[1][0] == expected[0], "resolved it is another")
    code, said = run(program, "verify", scratch / "one", "--samples", "20")
    expect(code == 0, f"verify ends with {code}: {said}")
    return status, expected


def on_a_full_disk(program, study, scratch, chance, expected):
    """True if the disk was too small; a message then, and the same results once there is room."""
    folder = scratch / "full"
    most = int(spread(chance, 2_000, 2_000_000))
    code, said = run(program, "run", study, "-o", folder,
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY)))
    if code not in ENDED:
        expect(code == 3 and str(folder) in said, f"on a full disk it ends with {code}: {said}")
    expect(run_study(program, study, folder)[1] == expected, "after a full disk it is another")
    return code not in ENDED


def on_a_read_only_disk(program, study, scratch):
    """None where one may not be mounted; the message has to name the place."""
    folder = scratch / "closed"
    folder.mkdir()
    script = 'mount -t tmpfs -o ro none "$0" && exec "$1" run "$2" -o "$0/out"'
    code, said = run("unshare", "--map-root-user", "--mount", "sh", "-c", script, folder, program, study)
    if "unshare" in said or "mount:" in said:
        return None
    expect(code == 3 and str(folder) in said, f"on a read-only disk it ends with {code}: {said}")
    return True


def by_two_programs(first, second, study, folder, lasts, chance):
    """'holds', 'refused' or 'told by verify' for a run that `first` began and `second` is to go on with. Before it goes on it computes
    a few rows again; where only others differ, verify tells."""
    process = subprocess.Popen([first, "run", str(study), "-o", str(folder)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(chance.uniform(0.1, 1) * lasts)
    except subprocess.TimeoutExpired:
        process.kill()
    process.wait()
    code, said = run(second, "run", study, "-o", folder)
    if code in REFUSED:
        expect(str(folder) in said and "--fresh" in said, f"refused without the remedy: {said}")
        return "refused"
    expect(code in ENDED, f"two programs end with {code}: {said}")
    code, said = run(second, "verify", folder)
    expect(code == 0 or (code == 1 and "does NOT hold" in said), f"after two programs verify ends with {code}: {said}")
    return "holds" if code == 0 else "told by verify"


def attack(options, study, scratch, chance, tally):
    code, said = run(options.program, "check", study)
    if code == 2:  # a question that cannot be posed, such as ranges beyond what a motor may have
        expect(said.strip(), "refused without a word")
        tally["refused"] += 1
        return
    expect(code == 0, f"check ends with {code}: {said}")
    begin = time.monotonic()
    status, expected = in_peace(options.program, study, scratch)
    lasts = (time.monotonic() - begin) / 4
    tally[f"status {status}"] += 1
    tally["disks filled"] += on_a_full_disk(options.program, study, scratch, chance, expected)
    tally["read-only disks"] += bool(on_a_read_only_disk(options.program, study, scratch))
    if options.other:
        for name, pair in (("newer goes on", (options.other, options.program)), ("older goes on", (options.program, options.other))):
            verdict = by_two_programs(*pair, study, scratch / name.replace(" ", "-"), lasts, chance)
            tally[f"{name}: {verdict}"] += 1
    if options.kills:
        tally["kills"] += kill_often(options.program, study, options.kills, seed=options.seed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--other")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=math.inf)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    tally, faults = collections.Counter(), 0
    until = time.monotonic() + 60 * options.minutes
    for number in range(options.count):
        if time.monotonic() > until:
            break
        chance = random.Random(f"{options.seed} {number}")
        kind = ATTACKED[number % len(ATTACKED)]
        with tempfile.TemporaryDirectory(prefix="twum-attack-") as name:
            scratch = pathlib.Path(name)
            study = scratch / "study.yaml"
            study.write_text(random_study(chance, kind))
            tally[kind] += 1
            try:
                attack(options, study, scratch, chance, tally)
            except subprocess.TimeoutExpired:
                tally["slow"] += 1
            except AssertionError as error:
                faults += 1
                print(f"seed {options.seed}, study {number}, {kind}: {error}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(study, options.keep / f"attack_{options.seed}_{number}.yaml")
    print(f"attack_study: {faults} at fault; " + ", ".join(f"{count} {what}" for what, count in sorted(tally.items())), flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
