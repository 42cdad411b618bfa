# SPDX-License-Identifier: Apache-2.0
"""curve and fields: formats and what they hold."""
import csv
import io
import json
import math
import re

import program
from program import DRIVE, RING, ROOT

PLATE = ROOT / "examples/motors/plate-60.yaml"

POINT = ["speed", "torque", "output_power", "stator_power", "friction_power", "layer_loss", "contact_efficiency",
         "wear_intensity", "stick_fraction", "zones", "squeals"]
METRICS = ["stall_torque", "max_torque", "holding_torque", "no_load_speed", "plateau_speed", "peak_power",
           "speed_at_peak_power", "torque_at_peak_power", "contact_efficiency_at_peak_power", "max_efficiency",
           "speed_at_max_efficiency", "contact_half_length", "contact_ratio", "max_pressure", "layer_aspect",
           "pressure_nonuniformity"]

TERMINALS = ["amplitude", "phase_lag", "voltage", "phase_current", "power_factor", "electrical_power",
             "overall_efficiency", "dielectric_loss", "stator_loss"]
OF_MODES = ["max_overall_efficiency", "speed_at_max_overall_efficiency", "pull_out_torque", "start_voltage", "hold_voltage",
            "start_frequency", "pull_out_frequency", "loaded_resonance", "coupling_factor", "capacitance_ratio", "free_amplitude"]


class Driven(program.Case):
    def curve(self, *arguments):
        return json.loads(self.ok("curve", DRIVE, *arguments, "--format", "json"))

    def test_columns_and_metrics_of_the_terminals_come_last(self):
        result = self.curve("--points", 5)
        self.assertEqual(list(result["metrics"]), METRICS + OF_MODES)
        self.assertEqual(list(result["curve"][0]), POINT[:-2] + TERMINALS + POINT[-2:])
        self.assertEqual(result["units"]["phase_current"], "A")

    def test_output_and_losses_make_up_the_electrical_power(self):
        for setting in ("voltage=120 V", "voltage=50 V", "amplitude=1.7 um", "frequency=41.5 kHz"):
            points = [p for p in self.curve("--set", setting)["curve"] if "status" not in p]
            self.assertGreater(len(points), 20)
            for p in points:
                parts = sum(p[name] for name in ("output_power", "friction_power", "layer_loss", "stator_loss",
                                                 "dielectric_loss"))
                # The contact's powers balance to 1e-12 of some ten watts.
                self.assertAlmostEqual(p["electrical_power"], parts, delta=1e-10 * max(10, abs(parts)))
                apparent = 2 * p["voltage"] * p["phase_current"]
                self.assertAlmostEqual(p["electrical_power"], apparent * p["power_factor"], delta=1e-10 * apparent)

    def test_the_voltage_is_that_of_the_file_or_the_one_that_an_amplitude_takes(self):
        driven = self.curve("--points", 21)["curve"]
        for point in driven:
            self.assertAlmostEqual(point["voltage"], 120, delta=1e-9)
        rest = driven[0]
        given = self.curve("--points", 3, "--set", f"amplitude={rest['amplitude']!r} m")
        self.assertAlmostEqual(given["curve"][0]["voltage"], 120, delta=1e-9)
        # At constant amplitude the voltage follows the load.
        self.assertNotAlmostEqual(given["curve"][1]["voltage"], 120, delta=1)
        for name in ("pull_out_torque", "start_frequency", "pull_out_frequency"):
            self.assertNotIn(name, given["metrics"])

    def test_below_pull_out_there_is_no_point(self):
        result = self.curve("--set", "voltage=50 V")
        lost = [p for p in result["curve"] if p.get("status") == "pulled-out"]
        self.assertEqual(result["curve"][:len(lost)], lost)
        self.assertIsNone(result["metrics"]["stall_torque"])
        pull_out = result["metrics"]["pull_out_torque"]
        found = [p["torque"] for p in result["curve"][len(lost):]]
        # The torque leaves the fold like a root, upwards by some per cent here, and falls from then on.
        self.assertAlmostEqual(max(found) / pull_out, 1, delta=0.1)
        self.assertTrue(all(p["torque"] is None for p in lost))

    def test_table_has_the_terminals_below_the_contact(self):
        done = program.twum("curve", DRIVE, "--points", 5)
        blocks = done.stdout.decode().split("\n\n")
        self.assertEqual(len(blocks), 4)
        self.assertTrue(blocks[3].split()[:3] == ["speed", "torque", "amplitude"])
        self.assertIn("pull_out_torque                   - (does-not-pull-out)", blocks[1])
        self.assertNotIn("does-not-pull-out", done.stderr)

    def test_evaluate_asks_what_a_healthy_motor_has(self):
        table = list(csv.DictReader(io.StringIO(self.ok("evaluate", DRIVE))))
        self.assertEqual(table[0]["status"], "ok")
        self.assertIn("start_voltage [V]", table[0])


class Branches(program.Case):
    """What a voltage holds: the running wave, the dead one, or what it would take."""

    def notes(self, *arguments):
        return program.twum("curve", DRIVE, "--points", 3, *arguments).stderr

    def threshold(self, note, name):
        return re.search(rf"([\d.]+ k?(?:V|Hz)) \({name}\)", note)[1]

    def test_a_voltage_that_holds_and_does_not_start_says_what_starts(self):
        note = self.notes("--set", "voltage=100 V")
        self.assertIn("at 100 V and 40.8 kHz the motor runs but does not start by itself if the voltage rises slowly; to start it takes more than", note)
        volts, hertz = self.threshold(note, "start_voltage"), self.threshold(note, "start_frequency")
        # Four digits are printed, so a thousandth more starts it and a thousandth less does not.
        for setting, starts in ((f"voltage={float(volts.split()[0]) * 1.001} V", True),
                                (f"voltage={float(volts.split()[0]) * 0.999} V", False),
                                (f"frequency={float(hertz.split()[0]) * 1.001} kHz", True),
                                (f"frequency={float(hertz.split()[0]) * 0.999} kHz", False)):
            first = () if "voltage" in setting else ("--set", "voltage=100 V")
            self.assertEqual("does not start" in self.notes(*first, "--set", setting), not starts, setting)

    def test_a_voltage_that_does_not_hold_says_what_would(self):
        note = self.notes("--set", "voltage=50 V")
        self.assertIn("at 50 V and 40.8 kHz only the dead wave exists at rest, which the rotor clamps; a running wave takes", note)
        volts, hertz = self.threshold(note, "hold_voltage"), self.threshold(note, "pull_out_frequency")
        for setting, holds in ((f"voltage={float(volts.split()[0]) * 1.001} V", True),
                               (f"voltage={float(volts.split()[0]) * 0.999} V", False),
                               (f"frequency={float(hertz.split()[0]) * 1.001} kHz", True),
                               (f"frequency={float(hertz.split()[0]) * 0.999} kHz", False)):
            first = () if "voltage" in setting else ("--set", "voltage=50 V")
            self.assertEqual("only the dead wave" in self.notes(*first, "--set", setting), not holds, setting)

    def test_a_frequency_below_the_resonance_says_so(self):
        done = program.twum("curve", DRIVE, "--points", 3, "--set", "frequency=38.5 kHz")
        self.assertEqual(done.returncode, 0)
        self.assertIn("there is one small wave, which the rotor clamps; drive it above the resonance of its stator, 39 kHz", done.stderr)

    def test_the_dead_wave_is_asked_for(self):
        held = ("--set", "voltage=100 V", "--branch", "dead")
        rest = json.loads(self.ok("curve", DRIVE, *held, "--format", "json"))["curve"][0]
        running = json.loads(self.ok("curve", DRIVE, *held[:2], "--format", "json"))["curve"][0]
        # The rotor clamps it: a small wave nearly in phase with the voltage; the running one lags by more than a quarter turn.
        self.assertLess(rest["amplitude"], 0.2 * running["amplitude"])
        self.assertLess(rest["phase_lag"], math.pi / 4)
        self.assertGreater(running["phase_lag"], math.pi / 2)
        table = list(csv.DictReader(io.StringIO(self.ok("evaluate", DRIVE, *held, "--metrics", "amplitude_at(0 rpm)"))))
        self.assertEqual(float(table[0]["amplitude_at(0 rpm) [m]"]), rest["amplitude"])
        fields = json.loads(self.ok("fields", DRIVE, *held, "--speed", "0 rpm", "--format", "json"))
        self.assertEqual(fields["torque"], rest["torque"])

    def test_no_dead_wave_says_what_has_one(self):
        done = program.twum("curve", DRIVE, "--points", 3, "--branch", "dead")
        self.assertEqual(done.returncode, 1)
        self.assertIn("starts by itself and has no dead wave; a dead wave takes less than", done.stderr)
        volts = float(self.threshold(done.stderr, "start_voltage").split()[0])
        self.ok("curve", DRIVE, "--points", 3, "--branch", "dead", "--set", f"voltage={0.999 * volts} V")

    def test_a_branch_of_a_given_amplitude_is_refused(self):
        self.assertIn("--branch: the amplitude of this motor is given", self.refused("curve", RING, "--branch", "dead"))
        self.assertIn("--branch", self.refused("curve", DRIVE, "--branch", "sleeping"))


class Curve(program.Case):
    def test_json_has_the_agreed_shape(self):
        result = json.loads(self.ok("curve", RING, "--points", 9, "--format", "json"))
        self.assertRegex(result["twum"], r"^\d+\.\d+\.\d+$")
        self.assertEqual(result["motor"]["thickness"], 0.3e-3)
        self.assertEqual(result["motor"]["amplitude"], 1.6e-6)
        self.assertEqual(list(result["metrics"]), METRICS)
        self.assertEqual(len(result["curve"]), 9)
        for point in result["curve"]:
            self.assertEqual(list(point), POINT)
            for zone in point["zones"]:
                self.assertIn(zone["state"], ("slip+", "stick", "slip-"))
                self.assertLess(zone["from"], zone["to"])
        for name in [*result["motor"], *METRICS, *POINT[:-2], "from", "to"]:
            self.assertIn(name, result["units"])

    def test_the_curve_goes_from_rest_to_beyond_no_load(self):
        result = json.loads(self.ok("curve", RING, "--format", "json"))
        speeds = [p["speed"] for p in result["curve"]]
        self.assertEqual(speeds[0], 0)
        self.assertEqual(speeds, sorted(speeds))
        self.assertGreater(speeds[-1], result["metrics"]["no_load_speed"])
        self.assertLess(result["curve"][-1]["torque"], 0)
        self.assertAlmostEqual(result["curve"][0]["torque"], result["metrics"]["stall_torque"], delta=1e-9)

    def test_given_speeds_in_mixed_units(self):
        result = json.loads(self.ok("curve", RING, "--speeds", "60 rpm, -2 rad/s, 0 rpm", "--format", "json"))
        self.assertEqual([p["speed"] for p in result["curve"]], [60 * (2 * math.pi / 60), -2, 0])

    def test_csv_is_si_with_units_in_the_header(self):
        rows = list(csv.reader(io.StringIO(self.ok("curve", RING, "--points", 5, "--format", "csv"))))
        self.assertEqual(rows[0][:2], ["speed [rad/s]", "torque [N.m]"])
        self.assertEqual(len(rows), 6)
        exact = json.loads(self.ok("curve", RING, "--points", 5, "--format", "json"))["curve"]
        self.assertEqual([float(r[1]) for r in rows[1:]], [p["torque"] for p in exact])

    def test_points_at_which_a_motor_squeals_say_so(self):
        # The sign of the metric, which is computed another way, at 9 speeds of a motor that squeals under load only.
        elastic = (DRIVE, "--set", "shear_viscosity=0 Pa.s", "--set", "inertia=0 Pa.s^2", "--set", "rotor_mass=100 g")
        points = json.loads(self.ok("curve", *elastic, "--points", 9, "--format", "json"))["curve"]
        metrics = ", ".join(f"squeal_rate_at({p['speed']!r} rad/s)" for p in points)
        values = list(next(csv.reader(io.StringIO(self.ok("evaluate", *elastic, "--metrics", metrics).split("\n", 1)[1]))))
        self.assertEqual({p["squeals"] for p in points}, {True, False})
        self.assertEqual([p["squeals"] for p in points], [float(v) > 0 for v in values[:9]])
        rows = list(csv.DictReader(io.StringIO(self.ok("curve", *elastic, "--points", 9, "--format", "csv"))))
        self.assertEqual([r["squeals"] for r in rows], ["yes" if p["squeals"] else "no" for p in points])
        self.assertEqual(self.ok("curve", *elastic, "--points", 9).count(", squeals"), sum(p["squeals"] for p in points))
        # A layer with damping that sticks somewhere: not known.
        sticks = json.loads(self.ok("curve", DRIVE, "--points", 9, "--format", "json"))["curve"]
        self.assertIn(None, [p["squeals"] for p in sticks])
        for motor, squeals in ((elastic, True), ((DRIVE, "--set", "quality_factor=5"), False)):
            self.ok("curve", *motor, "--plot", self.folder / "squeal.svg")
            self.assertEqual("squeals" in (self.folder / "squeal.svg").read_text(), squeals)

    def test_the_note_on_squeal_says_where_it_ends(self):
        # With damping in the layer it is known only where all of the contact slips. This motor squeals there, so to the plateau's end.
        result = program.twum("curve", DRIVE, "--points", 2, "--format", "json")
        fastest = float(re.search(r"squeals under load at speeds up to ([0-9.]+) rpm", result.stderr).group(1))
        plateau = json.loads(result.stdout)["metrics"]["plateau_speed"] * 30 / math.pi
        # The note is good to 1 / 16384 of the no-load speed, 0.009 rpm, and rounded to 0.005 rpm.
        self.assertAlmostEqual(fastest, plateau, delta=0.014)

    def test_a_file_gets_the_format_of_its_name(self):
        for name, begin in (("c.csv", "speed ["), ("c.json", "{"), ("c.txt", "ring-60"), ("c", "ring-60")):
            self.assertEqual(self.ok("curve", RING, "--points", 3, "-o", self.folder / name), "")
            self.assertTrue((self.folder / name).read_text().startswith(begin), name)
        self.ok("curve", RING, "--points", 3, "-o", self.folder / "t.csv", "--format", "table")
        self.assertTrue((self.folder / "t.csv").read_text().startswith("ring-60"))

    def test_table_shows_engineering_units(self):
        text = self.ok("curve", RING, "--points", 5)
        self.assertTrue(text.startswith("ring-60\n"))
        self.assertRegex(text, r"no_load_speed +[\d.]+ rpm\n")
        self.assertRegex(text, r"max_pressure +[\d.]+ MPa\n")

    def test_undefined_metrics_are_null(self):
        result = json.loads(self.ok("curve", RING, "--set", "modal_damping=0 N.s/m", "--format", "json"))
        self.assertIsNone(result["metrics"]["max_efficiency"])
        done = program.twum("curve", RING, "--set", "modal_damping=0 N.s/m")
        self.assertIn("max_efficiency                    - (undefined)", done.stdout.decode())
        self.assertIn("note: undefined: the metric has no meaning for this motor", done.stderr)
        self.assertEqual(program.twum("curve", RING, "--set", "contact_width=1 mm").stderr, "")

    def test_slices_are_compared_when_asked(self):
        asked = json.loads(self.ok("curve", RING, "--compare-slices", "--format", "json", "--points", 3))["slices"]
        for setting, block in (("radial_slices=1", "one_slice"), ("radial_slices=auto", "track")):
            alone = json.loads(self.ok("curve", RING, "--set", setting, "--format", "json", "--points", 3))["metrics"]
            self.assertEqual(asked[block], alone)
        text = self.ok("curve", RING, "--compare-slices", "--points", 3)
        change = 100 * (asked["track"]["peak_power"] / asked["one_slice"]["peak_power"] - 1)
        # Two digits are printed.
        shown = float(re.search(r"peak_power .* ([-\d.]+) %", text)[1])
        self.assertAlmostEqual(shown / change, 1, delta=0.05)
        self.assertIn("--compare-slices compares metrics", self.refused("curve", RING, "--compare-slices", "--format", "csv"))

    def test_radial_motion_is_compared_when_asked(self):
        few = ("--set", "radial_slices=2", "--points", 3)
        asked = json.loads(self.ok("curve", PLATE, "--compare-radial", "--format", "json", *few))["radial"]
        for radial, block in (("false", "without"), ("true", "radial_motion")):
            text = PLATE.read_text().replace("radial_slices: auto", f"radial_slices: 2\n    radial_motion: {radial}")
            alone = json.loads(self.ok("curve", self.write("radial.yaml", text), "--format", "json", "--points", 3))
            self.assertEqual(asked[block], alone["metrics"])
        self.assertLess(asked["radial_motion"]["max_overall_efficiency"], asked["without"]["max_overall_efficiency"])
        self.assertIn("radial_motion needs the wave's radial shape", self.refused("curve", RING, "--compare-radial"))
        self.assertIn("--compare-radial compares metrics", self.refused("curve", PLATE, "--compare-radial", "--format", "csv"))

    def test_settings_change_the_motor_and_replace_alternatives(self):
        motor = json.loads(self.ok("curve", RING, "--set", "preload=140 N", "--set", "G=1 GPa", "--format", "json"))["motor"]
        self.assertEqual(motor["preload"], 140)
        self.assertEqual(motor["shear_modulus"], 1e9)
        self.assertNotIn("poisson_ratio", motor)

    def test_motors_at_the_edge_have_a_curve(self):
        for setting in ("preload=0 N", "amplitude=0 m", "mu=0", "mu_0=0.4", "E=500 GPa", "preload=1e6 N",
                        "inertia=0 Pa.s^2", "loss_factor=0"):
            with self.subTest(setting):
                done = program.twum("curve", RING, "--set", setting, "--format", "json")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                json.loads(done.stdout)


class Fields(program.Case):
    def test_fields_at_a_torque_are_those_at_its_speed(self):
        at = json.loads(self.ok("fields", RING, "--torque", "0.5 N.m", "--samples", 5, "--format", "json"))
        self.assertAlmostEqual(at["torque"], 0.5, delta=1e-9)
        speed = repr(at["speed"]) + " rad/s"
        same = json.loads(self.ok("fields", RING, "--speed", speed, "--samples", 5, "--format", "json"))
        self.assertEqual(at["fields"], same["fields"])
        self.assertEqual(program.twum("fields", RING, "--torque", "50 N.m").returncode, 1)

    def test_formats_agree(self):
        result = json.loads(self.ok("fields", RING, "--speed", "130 rpm", "--samples", 25, "--format", "json"))
        rows = list(csv.reader(io.StringIO(
            self.ok("fields", RING, "--speed", "130 rpm", "--samples", 25, "--format", "csv"))))
        self.assertEqual(rows[0], ["phase [rad]", "pressure [Pa]", "traction [Pa]", "displacement [m]",
                                   "stator_velocity [m/s]", "layer_velocity [m/s]", "radial_velocity [m/s]",
                                   "radial_traction [Pa]", "state"])
        self.assertEqual(len(rows), 26)
        for row, sample in zip(rows[1:], result["fields"]):
            self.assertEqual([float(x) for x in row[:8]], [sample[n] for n in (
                "phase", "pressure", "traction", "displacement", "stator_velocity", "layer_velocity", "radial_velocity",
                "radial_traction")])
        self.assertIn("free", {sample["state"] for sample in result["fields"]})
        self.assertTrue(self.ok("fields", RING, "--speed", "130 rpm").startswith("ring-60 at 130 rpm"))


if __name__ == "__main__":
    program.main()
