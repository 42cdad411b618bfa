#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The ten figures of docs/theory/how-twum-computes.md, drawn by gnuplot from what the command twum prints.

    torque_figures.py TWUM            draws them into docs/figures
    torque_figures.py TWUM --check    draws them elsewhere and compares
"""
import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import figures

RING = figures.RING
WORKING_SPEED = 133  # [rpm], where the contact of the ring motor slips, sticks and slips again
BLUE, RED, GREEN, PURPLE, GREY = "#0060ad", "#d95319", "#2a8c4a", "#7e2f8e", "#777777"
ZONES = {"slip+": "#ffe3b3", "stick": "#d3ebfb", "slip-": "#f3d3e4"}
BORDERS = "set border 3\nset tics nomirror out scale 0.5\nset key off\n"
KEY_ABOVE = "set key outside top center horizontal Left reverse\n"


class Ring:
    """The 60 mm ring motor, asked through the command."""

    def __init__(self, twum):
        self.twum = twum
        names = ("amplitude", "frequency", "contact_radius", "wavelengths", "neutral_plane_distance",
                 "kinetic_friction")
        row = self.table("evaluate", RING, "--metrics", ", ".join(names))[0]
        self.amplitude, frequency, self.radius, waves, distance, self.friction = (float(row[n]) for n in names)
        self.wave_number, self.omega = waves / self.radius, 2 * math.pi * frequency
        self.crest_velocity = self.wave_number * distance * self.amplitude * self.omega

    def ask(self, *words):
        done = subprocess.run([self.twum, *words], capture_output=True, text=True, cwd=figures.ROOT)
        if done.returncode:
            sys.exit(f"torque_figures.py: {done.stderr}")
        return done.stdout

    def table(self, *words):
        """Rows of a CSV output, keyed by the columns' names without their units."""
        rows = list(csv.reader(io.StringIO(self.ask(*words))))
        names = [name.split(" [")[0] for name in rows[0]]
        return [dict(zip(names, row)) for row in rows[1:]]

    def evaluate(self, designs, metrics):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write(designs)
            file.flush()
            return self.table("evaluate", RING, "--designs", file.name, "--metrics", metrics)

    def fields(self, speed=WORKING_SPEED, samples=2881, **settings):
        """Fields along the wave at a speed [rpm], numbers in SI units."""
        words = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
        rows = self.table("fields", RING, "--speed", f"{speed} rpm", "--samples", str(samples), "--format", "csv",
                          *words)
        return [{name: value if name == "state" else float(value) for name, value in row.items()} for row in rows]


def zones(fields):
    """(state, first phase, last phase) of each zone of the contact."""
    found = []
    for row in fields:
        if found and found[-1][0] == row["state"]:
            found[-1][2] = row["phase"]
        else:
            if found:
                found[-1][2] = row["phase"]
            found.append([row["state"], row["phase"], row["phase"]])
    return [zone for zone in found if zone[0] != "free"]


def shaded(fields, scale=1.0):
    """gnuplot's words for the zones as coloured ground with their names."""
    words = ""
    for number, (state, first, last) in enumerate(zones(fields), 1):
        words += (f"set object {number} rectangle from {first * scale:.4f}, graph 0 to {last * scale:.4f}, graph 1 "
                  f"behind fillcolor rgb '{ZONES[state]}' fillstyle solid noborder\n"
                  f"set label {number} '{state}' at {(first + last) / 2 * scale:.4f}, graph 0.95 center\n")
    return words


def column(fields, *names):
    return [tuple(row[name] for name in names) for row in fields]


def draw_wave(ring, draw):
    half_angle = max(row["phase"] for row in ring.fields() if row["state"] != "free")
    depth = ring.amplitude * math.cos(half_angle) * 1e6
    length = 2 * math.pi / ring.wave_number * 1e3  # [mm]
    surface = [(3 * length * i / 300, ring.amplitude * 1e6 * math.cos(ring.wave_number * 3e-3 * length * i / 300))
               for i in range(301)]
    later = [(x, ring.amplitude * 1e6 * math.cos(ring.wave_number * x * 1e-3 - math.pi / 3)) for x, _ in surface]
    draw("torque-01-wave.svg", BORDERS + f"""set xlabel 'place along the ring [mm]'
set ylabel 'height of the surface [μm]'
set xrange [0:{3 * length:.4f}]
set yrange [-2.2:3.2]
set object 1 rectangle from graph 0, first {depth:.4f} to graph 1, first 2.6 behind fillcolor rgb '#e4e4e4' \
    fillstyle solid noborder
set label 1 'rotor with its contact layer' at graph 0.5, first 2.25 center
set arrow 1 from 1.2, -1.95 to 7, -1.95 lc rgb '{BLUE}' lw 1.5
set label 2 'the wave runs this way' at 7.6, -1.95 tc rgb '{BLUE}'
set arrow 2 from {3 * length - 1.2:.4f}, 2.9 to {3 * length - 7:.4f}, 2.9 lc rgb '{RED}' lw 1.5
set label 3 'the crests drive the rotor this way' at {3 * length - 7.6:.4f}, 2.9 right tc rgb '{RED}'
plot 'surface' using 1:($2 > {depth:.4f} ? $2 : {depth:.4f}):({depth:.4f}) with filledcurves lc rgb '#f3b79a', \\
     'later' with lines dt 2 lw 1 lc rgb '{BLUE}', 'surface' with lines lw 2 lc rgb '{BLUE}'
""", {"surface": surface, "later": later})


def draw_ellipse(ring, draw):
    across = ring.crest_velocity / ring.omega * 1e6
    phases = [2 * math.pi * i / 200 for i in range(201)]
    turn = [(across * math.sin(t), ring.amplitude * 1e6 * math.cos(t)) for t in phases]
    speeds = [(row["phase"], row["stator_velocity"]) for row in ring.fields()]
    draw("torque-02-ellipse.svg", BORDERS + f"""set multiplot layout 1,2
set size square
set xrange [-2.2:2.2]
set yrange [-2.2:2.2]
set xlabel 'along the ring [μm]'
set ylabel 'height [μm]'
set label 1 'crest' at 0, {ring.amplitude * 1e6 + 0.3:.3f} center
set arrow 1 from 0, {ring.amplitude * 1e6:.3f} to 0.9, {ring.amplitude * 1e6:.3f} lc rgb '{RED}' lw 2
set arrow 2 from 0, {-ring.amplitude * 1e6:.3f} to -0.9, {-ring.amplitude * 1e6:.3f} lc rgb '{RED}' lw 2
set label 2 'trough' at 0, {-ring.amplitude * 1e6 - 0.3:.3f} center
plot 'turn' with lines lw 2 lc rgb '{BLUE}'
unset label
unset arrow
set size nosquare
set xrange [-pi:pi]
set yrange [-0.55:0.55]
set xtics ('-π' -pi, '0' 0, 'π' pi)
set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'velocity in drive direction [m/s]'
set label 1 'V_0 = {ring.crest_velocity:.3f} m/s' at 0, 0.46 center
plot 'speeds' with lines lw 2 lc rgb '{BLUE}'
unset multiplot
""", {"turn": turn, "speeds": speeds}, size="720,360")


def draw_pressure(ring, draw):
    loads = ((80, GREEN), (160, BLUE), (240, RED))
    data = {f"load{load}": [(row["phase"], row["pressure"] / 1e6) for row in ring.fields(preload=f"{load} N")]
            for load, _ in loads}
    top = {load: max(p for _, p in data[f"load{load}"]) for load, _ in loads}
    labels = "".join(f"set label '{load} N' at 0, {top[load] + 0.12:.4f} center tc rgb '{colour}'\n"
                     for load, colour in loads)
    draw("torque-03-pressure.svg", BORDERS + labels + f"""set xrange [-1:1]
set yrange [0:{max(top.values()) + 0.5:.3f}]
set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'pressure [MPa]'
plot """ + ", ".join(f"'load{load}' with lines lw 2 lc rgb '{colour}'" for load, colour in loads), data)


def draw_velocities(ring, draw):
    fields = ring.fields()
    rotor = WORKING_SPEED * 2 * math.pi / 60 * ring.radius
    draw("torque-04-velocities.svg", BORDERS + shaded(fields) + f"""set xrange [-0.75:0.75]
set yrange [0.28:0.44]
set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'velocity in drive direction [m/s]'
{KEY_ABOVE}plot 'stator' with lines lw 2 lc rgb '{BLUE}' title 'surface of the stator', \\
     'layer' with lines lw 2 lc rgb '{RED}' title 'surface of the layer', \\
     {rotor:.6f} with lines dt 2 lw 1.5 lc rgb '{GREY}' title 'rotor at {WORKING_SPEED} rpm'
""", {"stator": column(fields, "phase", "stator_velocity"), "layer": column(fields, "phase", "layer_velocity")})


def draw_traction(ring, draw):
    fields = [row for row in ring.fields() if row["state"] != "free"]
    data = [(row["phase"], row["traction"] / 1e3, ring.friction * row["pressure"] / 1e3) for row in fields]
    draw("torque-05-traction.svg", BORDERS + shaded(fields) + f"""set xrange [-0.6:0.6]
set yrange [-520:560]
set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'traction on the layer [kPa]'
{KEY_ABOVE}plot 'data' using 1:2 with lines lw 2 lc rgb '{RED}' title 'traction', \\
     'data' using 1:3 with lines dt 2 lw 1.2 lc rgb '{GREY}' title 'friction times pressure', \\
     'data' using 1:(-$3) with lines dt 2 lw 1.2 lc rgb '{GREY}' notitle
""", {"data": data})


def march(zone, steps):
    """Steps of (E3.1) through f [m/s] over phase: (phase, f, f', reach) each, and the bound on |f''|."""
    phases, f = [p for p, _ in zone], [v for _, v in zone]
    width = phases[1] - phases[0]
    slope = [(b - a) / (2 * width) for a, b in zip(f, f[2:])]
    bound = max(abs((b - a) / (2 * width)) for a, b in zip(slope, slope[2:]))
    taken, place = [], phases[2]
    while len(taken) < steps and place < phases[-3]:
        i = min(range(1, len(f) - 1), key=lambda k: abs(phases[k] - place))
        reach = (slope[i - 1] + math.sqrt(slope[i - 1] ** 2 + 2 * bound * f[i])) / bound
        taken.append((phases[i], f[i], slope[i - 1], reach))
        place = phases[i] + reach
    return taken, bound


def draw_march(ring, draw):
    fields = ring.fields(speed=100, samples=20001)
    state, first, last = zones(fields)[0]
    zone = [(row["phase"], row["stator_velocity"] - row["layer_velocity"]) for row in fields
            if first <= row["phase"] < last]
    taken, bound = march(zone, 6)
    data, plots = {"f": zone[::10] + zone[-1:]}, []
    for number, (x, f, slope, reach) in enumerate(taken):
        ahead = [reach * k / 60 for k in range(61)]
        data[f"step{number}"] = [(x + t, f + slope * t - bound * t * t / 2) for t in ahead]
        plots.append(f"'step{number}' with lines lw 1.2 lc rgb '{RED}' notitle")
    data["starts"] = [(x, f) for x, f, _, _ in taken]
    draw("torque-06-first-zero.svg", BORDERS + f"""set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'slip velocity [m/s]'
set xrange [{first - 0.01:.4f}:{last + 0.06:.4f}]
set yrange [0:*]
set key top right
set label 'the zone ends here' at {last:.4f}, graph 0.06 left offset 1,0
plot 'f' with lines lw 2 lc rgb '{BLUE}' title 'slip velocity', """ + ", ".join(plots) +
         f", 'starts' with points pt 7 ps 0.5 lc rgb '{RED}' notitle"
         f", NaN lw 1.2 lc rgb '{RED}' title 'lower bounds, step by step'",
         data)


def draw_period(ring, draw):
    fields = {loss: ring.fields(samples=2001, loss_factor=loss) for loss in ("0.05", "0.005")}
    data = {f"loss{loss}": [(row["phase"], row["displacement"] * 1e9) for row in rows] for loss, rows in fields.items()}
    contact = zones(fields["0.05"])
    draw("torque-07-period.svg", BORDERS + f"""set object 1 rectangle from {contact[0][1]:.4f}, graph 0 \
    to {contact[-1][2]:.4f}, graph 1 behind fillcolor rgb '#e8eef4' fillstyle solid noborder
set label 1 'contact' at 0, graph 0.95 center
set label 2 'free' at 1.8, graph 0.95 center
set label 3 'free' at -1.8, graph 0.95 center
set xrange [-pi:pi]
set xtics ('-π' -pi, '-π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'displacement of the layer [nm]'
set key at graph 0.02, graph 0.88 left top Left reverse
plot 'loss0.005' with lines lw 1.2 lc rgb '{RED}' title 'loss factor 0.005', \\
     'loss0.05' with lines lw 2 lc rgb '{BLUE}' title 'loss factor 0.05'
""", data)


def draw_map(ring, draw):
    step, data = 2, {state: [] for state in ZONES}
    for speed in range(0, 201, step):
        for state, first, last in zones(ring.fields(speed=speed, samples=1441)):
            data[state].append((first, speed, first, last, speed - step / 2, speed + step / 2))
    plots = [f"'{state}' using (($3+$4)/2):2:3:4:5:6 with boxxyerror fillstyle solid noborder lc rgb '{colour}' "
             f"title '{state}'" for state, colour in ZONES.items()]
    plots.append(f"{WORKING_SPEED} with lines dt 2 lc rgb '{GREY}' title 'figures 4, 5, 7'")
    draw("torque-08-zones.svg", BORDERS + f"""set xlabel 'phase of the wave, crest at 0 [rad]'
set ylabel 'rotor speed [rpm]'
set xrange [-0.75:0.75]
set yrange [0:200]
{KEY_ABOVE}plot """ + ", ".join(plots), data)


def draw_torque(ring, draw):
    rows = ring.table("curve", RING, "--points", "141", "--format", "csv")
    data = [(float(row["speed"]) * 30 / math.pi, *(float(row[name]) for name in
             ("torque", "output_power", "friction_power", "layer_loss", "stator_power"))) for row in rows]
    data = [row for row in data if row[1] >= 0]
    draw("torque-09-curve.svg", BORDERS + f"""set multiplot layout 2,1
set lmargin at screen 0.12
set rmargin at screen 0.68
set xrange [0:142]
set ylabel 'torque [N m]'
set yrange [0:1]
set arrow 1 from {WORKING_SPEED}, graph 0 to {WORKING_SPEED}, graph 1 nohead dt 2 lc rgb '{GREY}'
plot 'data' using 1:2 with lines lw 2 lc rgb '{BLUE}'
set xlabel 'rotor speed [rpm]'
set ylabel 'power [W]'
set yrange [0:14]
set key at screen 0.99, graph 1 right top Left reverse invert
plot 'data' using 1:3 with filledcurves y1=0 lc rgb '#9cc3e5' title 'output', \\
     'data' using 1:3:($3+$4) with filledcurves lc rgb '#f3b79a' title 'friction', \\
     'data' using 1:($3+$4):($3+$4+$5) with filledcurves lc rgb '{GREEN}' title 'layer', \\
     'data' using 1:6 with lines lw 2 lc rgb 'black' title 'from the stator'
unset multiplot
""", {"data": data}, size="640,520")


GOAL, PRESSURE, WEAR = "peak_power", "max_pressure", "wear_intensity_at(100 rpm)"
OPTIMUM_STUDY = f"""twum: 1
motor: {RING}
study:
  kind: optimize
  variables:
    preload:   {{min: 60 N, max: 300 N}}
    amplitude: {{min: 0.8 um, max: 2.2 um}}
  maximize: {GOAL}
  constraints:
    - {PRESSURE} <= 3 MPa
    - {WEAR} <= 8 kW/m^2
"""


def optimum(ring):
    """Preload [N] and amplitude [um] of the study's answer."""
    with tempfile.TemporaryDirectory() as folder:
        study = pathlib.Path(folder) / "power.yaml"
        study.write_text(OPTIMUM_STUDY, encoding="utf-8")
        ring.ask("run", study, "-o", pathlib.Path(folder) / "power", "--jobs", "1")
        best = json.loads((pathlib.Path(folder) / "power/summary.json").read_text(encoding="utf-8"))["best"]["design"]
    return best["preload"], best["amplitude"] * 1e6


def designs(points):
    return "preload [N],amplitude [um]\n" + "".join(f"{p!r},{a!r}\n" for p, a in points)


def slopes(ring, place, span):
    """Unit vectors along the gradients of the goal and the limits, in shares of the figure's axes."""
    steps = [(0.01, 0), (-0.01, 0), (0, 0.01), (0, -0.01)]
    rows = ring.evaluate(designs([(place[0] + du * span[0], place[1] + dv * span[1]) for du, dv in steps]),
                         ", ".join((GOAL, PRESSURE, WEAR)))
    for name in (GOAL, PRESSURE, WEAR):
        right, left, up, down = (float(row[name]) for row in rows)
        size = math.hypot(right - left, up - down)
        yield (right - left) / size, (up - down) / size


def draw_optimum(ring, draw):
    low, high = (60.0, 0.8), (300.0, 2.2)
    span = (high[0] - low[0], high[1] - low[1])
    grid = [(low[0] + span[0] * i / 60, low[1] + span[1] * j / 60) for i in range(61) for j in range(61)]
    rows = ring.evaluate(designs(grid), ", ".join((GOAL, PRESSURE, WEAR)))
    data = []
    for number, ((preload, amplitude), row) in enumerate(zip(grid, rows)):
        if number and number % 61 == 0:
            data.append(())
        data.append((preload, amplitude, float(row[GOAL]), float(row[PRESSURE]) / 3e6, float(row[WEAR]) / 8e3))
    best = optimum(ring)
    arrows = ""
    for number, ((x, y), colour) in enumerate(zip(slopes(ring, best, span), ("black", GREEN, RED)), 1):
        arrows += (f"set arrow {number} from {best[0]:.4f}, {best[1]:.5f} to {best[0] + 0.16 * x * span[0]:.4f}, "
                   f"{best[1] + 0.16 * y * span[1]:.5f} front lw 2 lc rgb '{colour}'\n")
    levels = (("goal", 3, "incremental 2, 2, 20"), ("pressure", 4, "discrete 1"), ("wear", 5, "discrete 1"))
    contours = "".join(f"set table '{name}'\nset cntrparam levels {level}\nsplot 'grid' using 1:2:{number}\n"
                       "unset table\n" for name, number, level in levels)
    draw("torque-10-optimum.svg", f"set contour base\nunset surface\n{contours}unset contour\n" + BORDERS + arrows +
         f"""set size square
set xrange [{low[0]}:{high[0]}]
set yrange [{low[1]}:{high[1]}]
set xlabel 'preload [N]'
set ylabel 'amplitude [μm]'
set key outside right top Left reverse
set label 1 'both limits hold here' at graph 0.06, graph 0.06
plot 'goal' using 1:2 with lines lc rgb '#aaaaaa' title 'peak power, every 2 W', \\
     'pressure' using 1:2 with lines lw 2 lc rgb '{GREEN}' title 'limit of pressure', \\
     'wear' using 1:2 with lines lw 2 lc rgb '{RED}' title 'limit of wear', \\
     '-' with points pt 7 ps 0.8 lc rgb 'black' title 'optimum'
{best[0]:.4f} {best[1]:.5f}
e
""", {"grid": data}, size="720,460")


FIGURES = (draw_wave, draw_ellipse, draw_pressure, draw_velocities, draw_traction, draw_march, draw_period, draw_map,
           draw_torque, draw_optimum)


def draw_all(twum, folder):
    ring = Ring(twum)
    for figure in FIGURES:
        figure(ring, lambda *words, **settings: figures.draw(*words, into=folder, **settings))


def differing(drawn):
    """Names of drawn figures that docs/figures does not have like this."""
    kept = {path.name: path.read_bytes() for path in figures.FIGURES.glob("torque-*.svg")}
    found = {path.name: path.read_bytes() for path in drawn.glob("*.svg")}
    return sorted(name for name in kept.keys() | found.keys() if kept.get(name) != found.get(name))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve()
    if not sys.argv[2:]:
        draw_all(program, figures.FIGURES)
        sys.exit()
    with tempfile.TemporaryDirectory() as scratch:
        draw_all(program, pathlib.Path(scratch))
        wrong = differing(pathlib.Path(scratch))
    if wrong:
        sys.exit(f"not as drawn today: {', '.join(wrong)}; draw them by tests/validation/torque_figures.py TWUM")
