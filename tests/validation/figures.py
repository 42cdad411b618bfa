#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The figures of docs/validation.md, drawn by gnuplot from what the command twum prints.

    figures.py TWUM
"""
import csv
import io
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs/figures"
REFERENCE = ROOT / "tests/data/reference"
RING = ROOT / "tests/data/motors/ring-60.yaml"
# Reference motors with and without inertia, with mu_0 = mu and mu_0 > mu.
SHOWN = (4, 7, 10, 16)
UNITS = {"wavelengths": "", "contact_radius": "m", "contact_width": "m", "neutral_plane_distance": "m",
         "frequency": "Hz", "amplitude": "m", "thickness": "m", "youngs_modulus": "Pa", "shear_modulus": "Pa",
         "shear_viscosity": "Pa.s", "inertia": "Pa.s^2", "static_friction": "", "kinetic_friction": "",
         "preload": "N"}


def torques(twum, design, speeds):
    """Torques [N m] of a design (flat names, SI) at rotor speeds [rad/s]."""
    settings = [word for name, value in design.items() for word in ("--set", f"{name}={value!r} {UNITS[name]}".strip())]
    done = subprocess.run([twum, "curve", RING, *settings, "--speeds", ",".join(f"{s!r} rad/s" for s in speeds),
                           "--format", "csv"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"figures.py: {done.stderr}")
    rows = csv.DictReader(line for line in io.StringIO(done.stdout) if not line.startswith("#"))
    column = next(name for name in rows.fieldnames if name.startswith("torque"))
    return [float(row[column]) for row in rows]


def number(text):
    value = float(text)
    return int(value) if value.is_integer() and value < 1000 else value


def reference_motor(index):
    """A design, its crest speed V0 / r and its points (speed, torque)."""
    with open(REFERENCE / "designs.csv", encoding="utf-8") as file:
        row = [r for r in csv.DictReader(file) if int(r["design"]) == index][0]
    with open(REFERENCE / "points.csv", encoding="utf-8") as file:
        points = [(float(r["speed"]), float(r["torque"])) for r in csv.DictReader(file) if int(r["design"]) == index]
    design = {name: number(value) for name, value in row.items() if name != "design"}
    return design, sorted(points)


def crest_speed(d):
    wave_number = d["wavelengths"] / d["contact_radius"]
    omega = 2 * math.pi * d["frequency"]
    return wave_number * d["neutral_plane_distance"] * d["amplitude"] * omega / d["contact_radius"]


def elastic_motor(phi, compliance):
    """An elastic layer with half contact angle phi and friction-compliance number S at rest."""
    d = {"wavelengths": 9, "contact_radius": 0.0265, "contact_width": 4e-3, "neutral_plane_distance": 3e-3,
         "frequency": 40e3, "amplitude": 1.6e-6, "thickness": 0.3e-3, "youngs_modulus": 3e9, "shear_viscosity": 0,
         "inertia": 0, "static_friction": 0.2, "kinetic_friction": 0.2}
    wave_number = d["wavelengths"] / d["contact_radius"]
    d["shear_modulus"] = 0.2 * d["youngs_modulus"] / (compliance * wave_number * d["neutral_plane_distance"])
    stiffness = 2 * d["contact_width"] * d["youngs_modulus"] * d["amplitude"] / (d["thickness"] * wave_number)
    d["preload"] = d["wavelengths"] * stiffness * (math.sin(phi) - phi * math.cos(phi))
    return d


def draw(name, script, data, size="640,400", into=FIGURES):
    """An SVG of docs/figures; `data` is {file name: rows}, an empty row is a blank line."""
    into.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for file, rows in data.items():
            text = "\n".join(" ".join(f"{x:.6g}" for x in row) for row in rows)
            (pathlib.Path(folder) / file).write_text(text + "\n", encoding="utf-8")
        head = (f"set terminal svg size {size} font 'Arial,13' background '#ffffff'\nset output '{into / name}'\n"
                "set encoding utf8\nset grid lc rgb '#dddddd'\nset key bottom left\n")
        subprocess.run(["gnuplot", "-d"], input=head + script, text=True, cwd=folder, check=True)


def draw_curves(twum):
    data, plots = {}, []
    for colour, index in zip(("#0060ad", "#d95319", "#2a8c4a", "#7e2f8e"), SHOWN):
        design, points = reference_motor(index)
        crest = crest_speed(design)
        holding = design["static_friction"] * design["preload"] * design["contact_radius"]
        speeds = [crest * (-0.25 + 1.55 * i / 300) for i in range(301)]
        found = torques(twum, design, speeds)
        data[f"line{index}"] = [(s / crest, t / holding) for s, t in zip(speeds, found)]
        data[f"points{index}"] = [(s / crest, t / holding) for s, t in points]
        plots += [f"'line{index}' with lines lw 1.5 lc rgb '{colour}' title 'motor {index}'",
                  f"'points{index}' with points pt 7 ps 0.6 lc rgb '{colour}' notitle"]
    draw("validation-curves.svg", "set xlabel 'rotor speed over V_0 / r'\nset ylabel 'torque over μ_0 F_N r'\n"
         "plot " + ", ".join(plots), data)


def draw_brush(twum):
    law = [(i / 100, 1 - (1 - i / 100) ** 3) for i in range(101)]
    data, plots = {"law": law}, []
    for colour, phi in zip(("#d95319", "#2a8c4a", "#0060ad"), (1.0, 0.3, 0.03)):
        design = elastic_motor(phi, 1.0)
        crest = crest_speed(design)
        # S depends on the speed by W: S = S0 (1 + kappa r Omega / omega)
        coupling = design["wavelengths"] * crest / (2 * math.pi * design["frequency"])
        shares = [i / 100 for i in range(1, 101)]
        speeds = [crest * (1 - q * phi) / (1 + q * coupling * phi) for q in shares]
        full = design["kinetic_friction"] * design["preload"] * design["contact_radius"]
        data[f"phi{phi}"] = [(q, t / full) for q, t in zip(shares, torques(twum, design, speeds))]
        plots.append(f"'phi{phi}' with lines lw 1.5 lc rgb '{colour}' title 'half angle {phi:g}'")
    plots.append("'law' with lines lw 1.5 dt 2 lc rgb 'black' title 'brush-tyre law'")
    draw("validation-brush.svg", "set key bottom right\nset xlabel 'q'\nset ylabel 'torque over μ F_N r'\n"
         "plot " + ", ".join(plots), data)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve()
    draw_curves(program)
    draw_brush(program)
