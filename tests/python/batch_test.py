# SPDX-License-Identifier: Apache-2.0
"""Many designs at once from Python."""
import threading
import unittest

import numpy as np
import twum

METRICS = "stall_torque, no_load_speed, max_pressure, torque_at(100 rpm)"


def designs(count):
    """Spread over the box by golden ratios."""
    steps = np.arange(count)
    return {"preload": 60 + 240 * (0.618 * steps % 1), "amplitude": 0.8e-6 + 1.4e-6 * (0.414 * steps % 1),
            "thickness": "0.25 mm"}


class Batch(unittest.TestCase):
    def setUp(self):
        self.motor = twum.Motor()

    def test_a_batch_is_its_designs_one_by_one(self):
        batch = designs(40)
        answer = twum.evaluate(self.motor, batch, METRICS)
        for i in range(40):
            one = self.motor.replace(thickness="0.25 mm", preload=batch["preload"][i], amplitude=batch["amplitude"][i])
            for name, value in one.metrics(METRICS).items():
                self.assertEqual(answer[name][i], value)
        self.assertEqual(set(answer["status"]), {"ok"})

    def test_numbers_do_not_depend_on_threads(self):
        one, many = (twum.evaluate(self.motor, designs(3000), METRICS, jobs=jobs) for jobs in (1, 5))
        for name, values in one.items():
            self.assertEqual(values.tolist(), many[name].tolist())

    def test_any_array_of_numbers_will_do(self):
        loads = np.array([100, 0, 140, 0, 180, 0], dtype=np.float32)[::2]
        answer = twum.evaluate(self.motor, {"preload": loads}, ["holding_torque"])["holding_torque"]
        # mu_0 F_N r: a product of three.
        np.testing.assert_allclose(answer, 0.2 * 0.0265 * np.array([100, 140, 180]), rtol=4e-16)
        self.assertEqual(twum.evaluate(self.motor, {"preload": [100, 140]}, "preload")["preload"].tolist(), [100, 140])

    def test_stiffness_and_load_together_scale_the_torque(self):
        # Theory section 8: (E, G, gamma, m, F_N) times c gives the torque times c. A power of two: exact scalings
        # of every input, so the sum of roundings of both sides is the same but for roots, a few ulp.
        c = np.array([1.0, 2.0, 0.25])
        base = self.motor
        scaled = {"youngs_modulus": base.youngs_modulus * c, "density": base.density * c, "preload": base.preload * c}
        torque = twum.evaluate(base, scaled, "torque_at(120 rpm)")["torque_at(120 rpm)"]
        np.testing.assert_allclose(torque, torque[0] * c, rtol=1e-13)

    def test_a_design_that_fails_does_not_stop_the_others(self):
        answer = twum.evaluate(self.motor, {"thickness": [3e-4, -3e-4, np.nan], "preload": "160 N"}, "stall_torque")
        self.assertEqual(answer["status"][0], "ok")
        self.assertEqual(answer["stall_torque"][0], self.motor.stall_torque)
        for status in answer["status"][1:]:
            self.assertIn("thickness must be", status)
        self.assertTrue(np.isnan(answer["stall_torque"][1:]).all())
        beyond = twum.evaluate(self.motor, {"preload": [10.0, 160.0]}, "speed_at(0.5 N.m)")
        self.assertEqual(list(beyond["status"]), ["speed_at(0.5 N.m): unreachable", "ok"])

    def test_nothing_is_nothing(self):
        answer = twum.evaluate(self.motor, {"preload": []}, "stall_torque")
        self.assertEqual((answer["stall_torque"].shape, answer["status"].shape), ((0,), (0,)))

    def test_wrong_questions_are_refused(self):
        for asked, words in (({"preload": [1.0, 2.0], "thickness": [1e-4] * 3}, "3 values, but another parameter has 2"),
                             ({"preload": np.ones((2, 2))}, "one dimension"),
                             ({"preload": [1.0], "F_N": [2.0]}, "say the same"),
                             ({"poisson_ratio": [0.3], "G": [1e9]}, "say the same"),
                             ({"pre_load": [1.0]}, "did you mean 'preload'"),
                             ({"preload": "3 kg"}, "mass")):
            with self.assertRaisesRegex(twum.InputError, words):
                twum.evaluate(self.motor, asked, "stall_torque")
        with self.assertRaisesRegex(twum.InputError, "stall_torque"):
            twum.evaluate(self.motor, {"preload": [1.0]}, "stal_torque")

    def test_other_threads_run_meanwhile(self):
        done = threading.Event()
        worker = threading.Thread(target=lambda: (twum.evaluate(self.motor, designs(4000), METRICS, jobs=1), done.set()))
        worker.start()
        rounds = 0
        while not done.wait(0.001):
            rounds += 1
        worker.join()
        # 4000 designs take tens of milliseconds at the least; with the GIL held there would be no round but the first.
        self.assertGreater(rounds, 3)


if __name__ == "__main__":
    unittest.main()
