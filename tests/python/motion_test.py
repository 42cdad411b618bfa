# SPDX-License-Identifier: Apache-2.0
"""Motions and linear plants as arrays."""
import csv
import io
import os
import pathlib
import subprocess
import threading
import unittest

import numpy as np

import twum

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("TWUM_PROGRAM")
MOVING = ROOT / "examples/motors/moving-60.yaml"


class Axial(unittest.TestCase):
    def test_a_mass_behind_a_coil(self):
        motor = twum.Motor(MOVING).replace(rotor_mass="0.1 kg", axial_damping="300 N.s/m", driver_inductance="1.3 mH",
                                         driver_resistance="5 ohm", voltage="60 V")
        self.assertEqual(motor.move("3 ms", axial="dynamic").status, "ok")
        self.assertEqual(len(motor.linearize(0.1, axial="dynamic").states), 10)
        point = motor.point(10)
        self.assertAlmostEqual(point.electrical_power, point.output_power + point.friction_power + point.layer_loss + point.stator_loss
                               + point.dielectric_loss + point.driver_loss, delta=1e-9)
        with self.assertRaisesRegex(twum.InputError, "axial: expected 'static' or 'dynamic'"):
            motor.move("3 ms", axial="free")


class Move(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.motor = twum.Motor(MOVING)

    @unittest.skipUnless(PROGRAM, "the command is not built")
    def test_a_motion_is_that_of_the_command(self):
        done = subprocess.run([PROGRAM, "move", MOVING, "--time", "15 ms", "--format", "csv"], capture_output=True, text=True, timeout=60)
        rows = list(csv.reader(io.StringIO(done.stdout)))
        table = {heading.split(" [")[0]: column for heading, column in zip(rows[0], zip(*rows[1:]))}
        motion = self.motor.move("15 ms", switched_off=[("10 ms", "15 ms")], points=len(rows) - 1)
        self.assertEqual(motion.status, "ok")
        self.assertEqual(motion.end, 0.015)
        for name in ("time", "speed", "angle", "amplitude", "torque", "electrical_power", "phase_current"):
            # The command's digits are all of a double's; times are sums of steps there.
            np.testing.assert_allclose(motion[name], np.array(table[name], float), rtol=1e-7, atol=1e-12, err_msg=name)

    def test_what_happens_is_told(self):
        motion = self.motor.move(0.03, switched_off=[(0.02, 0.03)])
        self.assertEqual([one["event"] for one in motion.events if one["event"] in ("released", "started", "held")],
                         ["released", "started", "held"])
        # A stop from the steady state, which the start has reached within 20 ms.
        self.assertAlmostEqual(motion.time_of("held") - 0.02, self.motor.stop_time_at(0), delta=1e-5)
        self.assertTrue(np.isnan(motion.time_of("pulled-out")))
        self.assertEqual(motion["speed"].shape, (401,))

    def test_profiles_are_values_or_rows(self):
        step = self.motor.move("20 ms", load_torque=[("0 ms", 0), ("10 ms", 0), ("10 ms", "0.3 N.m"), (0.02, 0.3)], voltage="130 V")
        np.testing.assert_array_equal(step["load_torque"][[0, 199, 201, 400]], [0, 0, 0.3, 0.3])
        self.assertEqual(set(step["voltage"]), {130.0})
        steady = self.motor.move("5 ms", steady=True, load_torque=0.3)
        self.assertAlmostEqual(steady["speed"][0], self.motor.speed_at("0.3 N.m"), delta=1e-8)
        np.testing.assert_allclose(steady["speed"], steady["speed"][0], rtol=1e-6)

    def test_what_is_wrong_is_told(self):
        for arguments, text in (({"duration": 0.01, "engine": "fast"}, "expected 'averaged' or 'oscillating'"),
                                ({"duration": 0.01, "points": 1}, "at least 2"),
                                ({"duration": 0.01, "voltage": [1, 2]}, "rows of a time and a value"),
                                ({"duration": "0 ms"}, "duration"),
                                ({"duration": 0.01, "frequency": "3 V"}, "frequency"),
                                ({"duration": 0.01, "load_torque": float("nan")}, "load_torque: expected a finite value"),
                                ({"duration": 0.01, "amplitude": "1 um"}, "driven by a voltage; give voltage"),
                                ({"duration": 0.01, "accuracy": 0.5}, "only the oscillating engine")):
            with self.assertRaisesRegex(twum.InputError, text):
                self.motor.move(**arguments)

    def test_it_stops_when_asked_and_tells_how_far_it_is(self):
        stop, told = threading.Event(), []

        def progress(done, total, best):
            told.append((done, total))
            stop.set()

        # Every vibration of two seconds takes several, and is stopped at the first per cent.
        motion = self.motor.move("2 s", engine="oscillating", points=2, stop=stop, progress=progress)
        self.assertEqual(motion.status, "stopped")
        self.assertLess(motion.end, 2)
        self.assertTrue(told and all(0 < done < 100 and total == 100 for done, total in told), told)


class Plant(unittest.TestCase):
    def test_its_numbers_fit_together(self):
        plant = twum.Motor(MOVING).linearize("0.2 N.m")
        self.assertEqual(list(plant.states), ["amplitude", "phase_lag", "speed", "angle"])
        self.assertEqual(list(plant.inputs), ["voltage", "frequency", "load_torque"])
        a, b, c, d = plant.matrices
        poles = np.linalg.eigvals(a[:3, :3])
        # Eigenvalues of a matrix in SI units: rounding reaches them, as their sizes differ by 1e8.
        np.testing.assert_allclose(np.sort_complex(poles), np.sort_complex(plant.poles), rtol=1e-6)
        outputs = [i for i, name in enumerate(plant.outputs) if name != "angle"]
        gains = -c[outputs][:, :3] @ np.linalg.solve(a[:3, :3], b[:3]) + d[outputs]
        self.assertLess(np.abs((plant.gains - gains) / np.abs(gains).max(axis=0)).max(), 1e-9)

    def test_metrics_of_motions_are_those_of_its_plant(self):
        motor = twum.Motor(MOVING)
        plant = motor.linearize(0.2)
        self.assertAlmostEqual(motor.settling_rate_at(0.2), -plant.poles[0].real, delta=1e-6)
        speed = [name for name in plant.outputs if name != "angle"].index("speed")
        self.assertEqual(motor.speed_per_frequency_at("0.2 N.m"), plant.gains[speed, 1])
        self.assertGreater(motor.move_energy("90 deg"), 0)
        self.assertGreater(motor.burst_angle(32), motor.burst_angle(8))


if __name__ == "__main__":
    unittest.main()
