# SPDX-License-Identifier: Apache-2.0
"""The core in a page gives the numbers of the core of the library, for random motors: agreement_test.py TWUM [MOTORS]

With the Python module of the build on PYTHONPATH.
"""
import json
import math
import pathlib
import random
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import ROOT, Page, main, twum as program  # noqa: E402

import twum  # noqa: E402

COUNT = int(sys.argv.pop(2)) if len(sys.argv) > 2 and sys.argv[2].isdigit() else 1000
POINTS = 21
AGREE = 1e-9
METRICS = ("stall_torque", "max_torque", "holding_torque", "no_load_speed", "plateau_speed", "peak_power", "max_pressure", "contact_half_length")
CONTACT = ("speed", "torque", "output_power", "stator_power", "friction_power", "layer_loss", "contact_efficiency", "wear_intensity", "stick_fraction")
DRIVEN = CONTACT + ("amplitude", "phase_lag", "phase_current", "power_factor", "electrical_power", "overall_efficiency")


def between(chance, low, high):
    return low * (high / low) ** chance.random()


def contact(chance):
    """A motor of the box in which the solver is tested (theory, section 10); one in ten undamped, one in four with mu_0 > mu."""
    mu = chance.uniform(0.02, 1)
    return {"wavelengths": chance.randint(1, 30), "contact_radius": between(chance, 2e-3, 0.1), "neutral_plane_distance": between(chance, 0.2e-3, 10e-3),
            "thickness": between(chance, 10e-6, 5e-3), "youngs_modulus": between(chance, 1e6, 500e9), "poisson_ratio": chance.uniform(0, 0.49),
            "density": between(chance, 500, 8000), "loss_factor": 0 if chance.random() < 0.1 else chance.uniform(0, 2), "kinetic_friction": mu,
            "static_friction": mu * (chance.uniform(1, 2) if chance.random() < 0.25 else 1), "preload": between(chance, 1, 1000)}


def prescribed(chance):
    motor = contact(chance) | {"frequency": between(chance, 20e3, 150e3), "amplitude": between(chance, 0.05e-6, 5e-6), "modal_damping": chance.uniform(0, 200)}
    return motor | {"contact_width": motor["contact_radius"] * chance.uniform(0.02, 0.4)}


def driven(chance):
    """The motor drive-60, every number within a fifth of its own, the frequency above the resonance."""
    base = {name: value for name, value in twum.Motor(ROOT / "examples/motors/drive-60.yaml").parameters.items()}
    names = ("contact_radius", "contact_width", "neutral_plane_distance", "voltage", "quality_factor", "resonance_frequency", "modal_mass", "force_factor",
             "blocked_capacitance", "loss_tangent", "thickness", "youngs_modulus", "poisson_ratio", "density", "loss_factor", "kinetic_friction", "preload")
    motor = {name: base[name] * chance.uniform(0.8, 1.2) for name in names}
    ratio = chance.uniform(1, 1.5) if chance.random() < 0.25 else 1
    return motor | {"wavelengths": 9, "frequency": motor["resonance_frequency"] * chance.uniform(1.01, 1.08), "static_friction": ratio * motor["kinetic_friction"]}


ASK = """(() => { const { core } = document.getElementById('page').panel; const list = %s; const metrics = %s.map((metric) => ({ metric }));
    const clean = (values) => Array.from(values, (v) => (Number.isFinite(v) ? v : null));
    return list.map((values) => { const found = core.motor({ values, branch: 'running', inner_edge: null, table: [] });
      const curve = core.curve(%d, found.last_speed);
      return { curve: Object.fromEntries(Object.entries(curve).map(([n, v]) => [n, clean(v)])), statuses: Array.from(curve.status, (s) => core.pointStatuses[s]),
        metrics: core.metrics(metrics).map((m) => [Number.isFinite(m.value) ? m.value : null, m.status]) }; }); })()"""


def deviation(a, b):
    """The largest, in parts of the largest of `a`."""
    scale = np.nanmax(np.abs(a)) if np.isfinite(a).any() else 0
    return np.nanmax(np.abs(a - b)) / scale if scale > 0 else 0


def rounding_of(motor, speed, name):
    """How far the library's own column moves if one number of the motor changes by its last digit: in nearly rigid layers a power is a
    small difference, and no two programs can agree better than that."""
    own, most = np.array(getattr(twum.Motor(**motor).curve(speed), name), float), 0
    for key in motor.keys() & {"thickness", "youngs_modulus", "preload", "amplitude", "frequency"}:
        for way in (-math.inf, math.inf):
            other = twum.Motor(**(motor | {key: math.nextafter(motor[key], way)})).curve(speed)
            most = max(most, deviation(own, np.array(getattr(other, name), float)))
    return most


class Agreement(Page):
    def setUp(self):
        page = self.folder / "ring-60.html"
        program("explore", ROOT / "examples/motors/ring-60.yaml", "-o", page)
        self.browser.open(page)
        self.browser.value("document.getElementById('page').panel.playing = false")

    def told(self, motors):
        """What the page computes of each motor."""
        answers = []
        for i in range(0, len(motors), 50):
            answers += self.browser.value(ASK % (json.dumps(motors[i:i + 50]), json.dumps(METRICS), POINTS))
        return answers

    def compare(self, motors, columns):
        """Largest deviation of the curves, of the metrics, and the motors whose statuses differ."""
        worst_curve = worst_metric = 0.0
        differ, delicate = [], 0
        for motor, page in zip(motors, self.told(motors)):
            own = twum.Motor(**motor)
            curve = own.curve(page["curve"]["speed"])
            statuses = own.status(*METRICS)
            if list(curve.status) != page["statuses"] or [statuses[name] for name in METRICS] != [status for _, status in page["metrics"]]:
                differ.append(motor)
                continue
            for name in columns:
                a, b = np.array(getattr(curve, name), float), np.array([math.nan if v is None else v for v in page["curve"][name]])
                self.assertEqual(np.isfinite(a).tolist(), np.isfinite(b).tolist(), (name, motor))
                off = deviation(a, b)
                if off > AGREE and off <= rounding_of(motor, page["curve"]["speed"], name):
                    delicate += 1
                else:
                    worst_curve = max(worst_curve, off)
            worst_metric = max([worst_metric, *self.metric_deviations(own, page["metrics"])])
        return worst_curve, worst_metric, differ, delicate

    def metric_deviations(self, own, found):
        values = own.metrics(*METRICS)
        torque = values["holding_torque"]
        for name, (value, status) in zip(METRICS, found):
            if status == "ok":
                # A torque is a small part of the motor's largest where the layer sticks; its rounding is of the largest.
                yield abs(value - values[name]) / max(abs(values[name]), torque if "torque" in name else 0, 1e-300)

    def test_random_motors(self):
        chance = random.Random(29)
        for name, motors, columns in (("prescribed", [prescribed(chance) for _ in range(COUNT * 4 // 5)], CONTACT), ("driven", [driven(chance) for _ in range(COUNT // 5)], DRIVEN)):
            with self.subTest(name):
                curve, metric, differ, delicate = self.compare(motors, columns)
                print(f"{name}: {len(motors)} motors, curves within {curve:.1e} of the largest of their column but for {delicate} columns that a last digit "
                      f"of the motor moves as far, metrics within {metric:.1e}, {len(differ)} with other statuses")
                # Another libm rounds sines, roots and logarithms otherwise; a root is found to some 1e-12 of its scale, and the
                # motors of the box magnify that by up to a thousand.
                self.assertLess(curve, AGREE)
                self.assertLess(metric, AGREE)
                self.assertLessEqual(delicate, len(motors) // 100)
                for motor in differ:
                    print("other status:", json.dumps(motor))
                    # Free vibration of an undamped layer never decays: there may be no period, or several (theory, section 10),
                    # and a last digit decides whether one is found. These are some per cent of the undamped motors.
                    self.assertEqual(motor["loss_factor"], 0)
                self.assertLessEqual(len(differ), len(motors) // 100)


if __name__ == "__main__":
    main()
