# SPDX-License-Identifier: Apache-2.0
"""Motors from Python: making them, what they answer, what is refused and how."""
import inspect
import json
import math
import os
import pathlib
import pickle
import subprocess
import unittest

import numpy as np
import twum

ROOT = pathlib.Path(__file__).resolve().parents[2]
RING = ROOT / "tests/data/motors/ring-60.yaml"
PROGRAM = os.environ.get("TWUM_PROGRAM")


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60)


class Making(unittest.TestCase):
    def test_units_and_si_numbers_mean_the_same(self):
        a = twum.Motor(thickness="0.25 mm", youngs_modulus="2 GPa", preload="120 N")
        b = twum.Motor(thickness=0.00025, youngs_modulus=2e9, preload=np.float64(120))
        self.assertEqual(a.parameters, b.parameters)

    def test_symbols_are_names_too(self):
        self.assertEqual(twum.Motor(h="0.25 mm").thickness, twum.Motor(thickness="0.25 mm").thickness)

    def test_a_file_and_its_overrides(self):
        motor = twum.Motor(RING, preload="140 N")
        self.assertEqual((motor.name, motor.preload, motor.contact_radius), ("ring-60", 140, 0.0265))
        self.assertEqual(motor.parameters, twum.Motor(str(RING)).replace(preload=140).parameters)

    def test_replacing_leaves_the_motor_alone(self):
        motor = twum.Motor()
        motor.replace(preload=100)
        self.assertEqual(motor.preload, 160)

    def test_pickled_and_written_motors_are_the_same_to_the_last_bit(self):
        motor = twum.Motor(RING, thickness=0.3e-3 * math.pi / 3, shear_modulus="1.23456789 GPa")
        again = pickle.loads(pickle.dumps(motor))
        self.assertEqual((again.name, again.parameters), (motor.name, motor.parameters))
        self.assertEqual(again.metrics(), motor.metrics())


class Answers(unittest.TestCase):
    def test_torque_of_the_plateau_is_mu_f_r(self):
        # Theory section 8: the whole contact slips one way at rest. A product of three inputs: rounding only.
        motor = twum.Motor(kinetic_friction=0.25, static_friction=0.25)
        self.assertAlmostEqual(motor.stall_torque, 0.25 * 160 * 0.0265, delta=4e-15)
        self.assertAlmostEqual(motor.torque_at(0.0), motor.stall_torque, delta=4e-15)

    def test_the_powers_balance_all_along_the_curve(self):
        curve = twum.Motor(RING).curve(points=101)
        lost = curve.output_power + curve.friction_power + curve.layer_loss - curve.stator_power
        # To rounding of powers of the scale mu_0 F_N V0 = 12 W, theory section 7.
        self.assertLess(np.abs(lost).max(), 1e-12 * 12)
        np.testing.assert_allclose(curve.output_power, curve.torque * curve.speed, rtol=1e-15, atol=1e-15)

    def test_a_driven_motor_has_what_its_terminals_see(self):
        motor = twum.Motor(ROOT / "examples/motors/drive-60.yaml")
        curve = motor.curve(points=31)
        parts = curve.output_power + curve.friction_power + curve.layer_loss + curve.stator_loss + curve.dielectric_loss
        # The contact's powers balance to 1e-12 of some ten watts.
        np.testing.assert_allclose(curve.electrical_power, parts, rtol=1e-10, atol=1e-10)
        np.testing.assert_allclose(curve.electrical_power, 2 * curve.voltage * curve.phase_current * curve.power_factor, rtol=1e-12)
        self.assertGreater(motor.metrics()["start_voltage"], motor.metrics()["hold_voltage"])
        point = motor.point(curve.speed[7])
        self.assertEqual((point.amplitude, point.phase_lag), (curve.amplitude[7], curve.phase_lag[7]))
        self.assertIsNone(twum.Motor(RING).curve(points=3).voltage)
        self.assertTrue(math.isnan(twum.Motor(RING).point(1.0).voltage))

    def test_one_torque_three_ways(self):
        motor = twum.Motor(RING)
        speed = 110 * math.pi / 30
        at = motor.torque_at("110 rpm")
        self.assertEqual(motor.point("110 rpm").torque, at)
        self.assertEqual(motor.metrics("torque_at(110 rpm)"), {"torque_at(110 rpm)": at})
        self.assertEqual(list(motor.curve(["110 rpm"]).torque), [at])
        np.testing.assert_allclose(motor.torque_at([speed, speed]), [at, at], rtol=1e-13)

    def test_speed_at_undoes_torque_at(self):
        motor = twum.Motor(RING)
        for rpm in (105, 120, 135):
            speed = rpm * math.pi / 30
            # speed_at is a root to a few ulp; the slope of this curve is of the order torque / speed.
            self.assertAlmostEqual(motor.speed_at(motor.torque_at(speed)), speed, delta=1e-9)

    def test_torque_integrates_the_traction(self):
        motor = twum.Motor(RING)
        fields = motor.fields("120 rpm", samples=20001)
        mean = np.trapz(fields.traction, fields.phase) / (2 * math.pi)
        area = 2 * math.pi * motor.contact_radius * motor.contact_width
        # The trapezoid rule errs where the traction has kinks and jumps: within one step of 3e-4 rad
        # of a maximum of 0.5 MPa, over 2 pi.
        self.assertAlmostEqual(mean * area * motor.contact_radius, fields.point.torque, delta=2e-4)

    def test_gradients_are_slopes(self):
        motor = twum.Motor(RING)
        gradients = motor.gradients("peak_power", "torque_at(120 rpm)")
        for name, derivative in gradients.items():
            self.assertEqual(derivative.status, "ok")
            for parameter in ("preload", "amplitude", "thickness", "kinetic_friction"):
                x = getattr(motor, parameter)
                step = 1e-5 * x
                values = [motor.replace(**{parameter: x + s}).metrics(name)[name] for s in (-step, step)]
                slope = (values[1] - values[0]) / (2 * step)
                # Truncation is of relative order (1e-5)^2 times the curvature, rounding 1e-16 / 1e-5 = 1e-11.
                self.assertAlmostEqual(derivative[parameter] * x, slope * x, delta=1e-7 * abs(derivative.value) + 1e-7,
                                       msg=(name, parameter))

    @unittest.skipUnless(PROGRAM, "the command is not built")
    def test_the_command_prints_the_same_numbers(self):
        printed = json.loads(program("curve", RING, "--points", 21, "--format", "json").stdout)
        motor = twum.Motor(RING)
        curve = motor.curve(points=21)
        self.assertEqual(printed["metrics"], motor.metrics())
        for name in ("speed", "torque", "friction_power", "stick_fraction"):
            self.assertEqual([point[name] for point in printed["curve"]], list(getattr(curve, name)))

    @unittest.skipUnless(PROGRAM, "the command is not built")
    def test_a_curve_knows_where_its_motor_squeals(self):
        seen = set()
        for name in ("ring-60", "drive-60"):
            path = ROOT / "examples/motors" / f"{name}.yaml"
            printed = json.loads(program("curve", path, "--points", 21, "--format", "json").stdout)
            squeals = twum.Motor(path).curve(points=21).squeals
            self.assertEqual(squeals, [point["squeals"] for point in printed["curve"]])
            seen |= set(squeals)
        self.assertEqual(seen, {True, False, None})

    def test_the_data_sheet_is_that_of_the_command(self):
        motor = twum.Motor(ROOT / "examples/motors/drive-60.yaml")
        for options, given in (((), {}), (("--torque", "0.5 N.m"), {"torque": 0.5}), (("--speed", "100 rpm"), {"speed": "100 rpm"}),
                               (("--torque", "0.5 N.m", "--speed", "60 rpm"), {"torque": 0.5, "speed": "60 rpm"})):
            done = subprocess.run([PROGRAM, "datasheet", "-", "-o", "-", *options], input=motor.file_text(), capture_output=True, text=True, timeout=60)
            self.assertEqual(motor.datasheet(**given), done.stdout)
        with self.assertRaisesRegex(twum.EvaluationError, "torque-out-of-reach"):
            motor.datasheet(1.0, torque=100.0)
        with self.assertRaises(twum.EvaluationError):
            motor.datasheet(torque="100 N.m")

    def test_what_has_no_value_says_so(self):
        motor = twum.Motor(modal_damping=0)
        self.assertTrue(math.isnan(motor.metrics("max_efficiency")["max_efficiency"]))
        self.assertEqual(motor.status("max_efficiency", "stall_torque"),
                         {"max_efficiency": "undefined", "stall_torque": "ok"})
        with self.assertRaisesRegex(twum.EvaluationError, "max_efficiency.*undefined") as caught:
            motor.max_efficiency
        self.assertEqual(caught.exception.reason, "undefined")
        with self.assertRaisesRegex(twum.EvaluationError, "speed_at.*unreachable"):
            motor.speed_at("5 N.m")
        self.assertTrue(np.isnan(motor.speed_at([5.0])).all())


class Refusals(unittest.TestCase):
    def refused(self, call, *words, error=twum.InputError):
        with self.assertRaises(error) as caught:
            call()
        for word in words:
            self.assertIn(word, str(caught.exception))
        return str(caught.exception)

    @unittest.skipUnless(PROGRAM, "the command is not built")
    def test_the_words_are_those_of_the_command(self):
        for name, value in {"thickness": "-0.3 mm", "preload": "3 kg", "poisson_ratio": "0.7", "thicknes": "1 mm"}.items():
            said = program("curve", RING, "--set", f"{name}={value}").stderr
            text = self.refused(lambda: twum.Motor(RING, **{name: value}))
            self.assertEqual(text.split(": ", 1)[-1].strip(), said.split(f"--set {name}: ", 1)[-1].strip())
        said = program("evaluate", RING, "--designs", "-", "--metrics", "stal_torque").stderr
        self.assertIn(self.refused(lambda: twum.Motor().metrics("stal_torque")), said)

    def test_everything_wrong_is_said_at_once(self):
        self.refused(lambda: twum.Motor(thickness="3 N", preload="1 kg", wavelength=9, amplitude=-1e-6), "thickness",
                     "force", "preload", "mass", "unknown parameter", "wavelengths", "amplitude must be at least 0 m")

    def test_a_number_out_of_range(self):
        self.refused(lambda: twum.Motor(thickness=-3e-4), "thickness", "at least 1e-08 m", "-0.0003")
        self.refused(lambda: twum.Motor(preload=math.nan), "preload", "nan")
        self.refused(lambda: twum.Motor(static_friction=0.1), "static_friction", "kinetic_friction")

    def test_other_objects_are_a_type_error(self):
        for value in ([1, 2], None, True, {}):
            self.refused(lambda: twum.Motor(preload=value), "preload", error=TypeError)

    def test_a_speed_beyond_the_waves(self):
        motor = twum.Motor()
        beyond = -2 * math.pi * motor.frequency / motor.wavelengths
        for call in (motor.point, motor.curve, motor.fields, motor.torque_at):
            self.refused(lambda: call(1.01 * beyond), "rotor speed", "rad/s")
        self.refused(lambda: motor.point("100 mm"), "speed", "length", "100 rpm")

    def test_a_file_that_is_not_there_or_wrong(self):
        self.refused(lambda: twum.Motor("no-such.yaml"), "no-such.yaml")
        self.refused(lambda: twum.Motor(ROOT / "tests/data/motor_errors/negative.yaml"), "negative.yaml:", "^",
                     error=twum.FileError)

    def test_errors_are_what_python_calls_them(self):
        self.assertTrue(issubclass(twum.InputError, ValueError))
        self.assertTrue(issubclass(twum.FileError, twum.InputError))
        self.assertTrue(issubclass(twum.StoreError, OSError))


class Help(unittest.TestCase):
    def test_docstrings_are_the_tables(self):
        for row in twum.parameter_table() + twum.metric_table():
            text = inspect.getdoc(getattr(twum.Motor, row["name"]))
            self.assertIn(row["text"].lower(), text.lower())
            self.assertIn(f"[{row['unit']}]", text)
        for row in twum.parameter_table():
            self.assertIn(row["name"], inspect.getdoc(twum.Motor))

    def test_signatures_can_be_read(self):
        self.assertEqual(str(inspect.signature(twum.Motor.curve)), "(self, speeds=None, *, points=51)")
        self.assertEqual(str(inspect.signature(twum.evaluate)), "(motor, designs, metrics, *, jobs=0, stop=None, progress=None)")

    def test_tables_are_complete(self):
        self.assertEqual((len(twum.parameter_table()), len(twum.metric_table())), (118, 100))
        self.assertEqual(twum.engineering(1.6e-6, "m"), "1.6 um")
        self.assertAlmostEqual(twum.quantity("30 rpm", "rad/s"), math.pi, delta=1e-15)


class Plots(unittest.TestCase):
    def test_lines_hold_the_numbers(self):
        try:
            import matplotlib.pyplot as pyplot
        except ImportError:
            self.skipTest("matplotlib is not there")
        motor = twum.Motor(RING)
        curve = motor.curve()
        axes = curve.plot()
        np.testing.assert_array_equal(axes.lines[0].get_ydata(), curve.torque)
        np.testing.assert_array_equal(axes.figure.axes[-1].lines[0].get_ydata(), curve.output_power)
        fields = motor.fields("120 rpm")
        above, below = fields.plot()
        np.testing.assert_array_equal(above.lines[0].get_ydata() * 1e6, fields.pressure / 1e6 * 1e6)
        np.testing.assert_array_equal(below.lines[1].get_ydata(), fields.layer_velocity)
        for figure in (axes.figure, above.figure):
            figure.canvas.draw()
        pyplot.close("all")


if __name__ == "__main__":
    unittest.main()
