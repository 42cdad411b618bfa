# SPDX-License-Identifier: Apache-2.0
"""Temperatures and lives of a motor in Python: one call each."""
import pathlib
import unittest

import twum

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOTOR = twum.Motor(ROOT / "examples/motors/warm-60.yaml")


class Heat(unittest.TestCase):
    def test_temperatures_are_those_of_the_command(self):
        # docs/guide/heat.md shows them as printed
        self.assertAlmostEqual(MOTOR.stator_temperature_at(torque=0.5), 329.67003235813155, delta=1e-9)
        self.assertAlmostEqual(MOTOR.temperature_margin_at(torque="0.5 N.m"), 20.62851592564624, delta=1e-9)
        self.assertLess(MOTOR.stator_temperature_at("60 rpm", torque=0.5), 353.15)
        self.assertAlmostEqual(MOTOR.thermal_time_constant, 632.7575451619698, delta=1e-6)

    def test_degrees_celsius(self):
        hot = MOTOR.replace(ambient_temperature="40 degC")
        self.assertEqual(hot.ambient_temperature, 313.15)
        self.assertGreater(hot.stator_temperature_at(torque=0.5), MOTOR.stator_temperature_at(torque=0.5))
        with self.assertRaisesRegex(twum.InputError, "is a temperature"):
            MOTOR.replace(rotor_heat_capacity="40 degC")

    def test_the_operation_of_its_file(self):
        self.assertGreater(MOTOR.stator_peak_temperature, MOTOR.ambient_temperature)
        self.assertLess(MOTOR.duty_limit_at("100 rpm", torque=0.5), 1 + 1e-12)

    def test_a_life(self):
        worn = twum.Motor(ROOT / "examples/motors/worn-60.yaml").replace(radial_slices=1)
        faster = worn.replace(specific_wear="4e-6 mm^3/(N.m)")
        self.assertAlmostEqual(4 * faster.life_at(torque=0.5) / worn.life_at(torque=0.5), 1, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
