# SPDX-License-Identifier: Apache-2.0
"""Many designs at once from Python."""
import signal
import threading
import time
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
                             ({"preload": [1.0], "F_N": [2.0]}, "preload is given twice"),
                             ({"poisson_ratio": [0.3], "G": [1e9]}, "exclude each other"),
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


class Gradients(unittest.TestCase):
    def setUp(self):
        self.motor = twum.Motor()

    def test_a_batch_is_its_designs_one_by_one(self):
        batch = designs(12)
        for fixed in (False, True):
            answer = twum.gradients(self.motor, batch, METRICS, fixed_static_friction=fixed, jobs=2)
            for i in range(12):
                one = self.motor.replace(thickness="0.25 mm", preload=batch["preload"][i], amplitude=batch["amplitude"][i])
                for name, derivative in one.gradients(METRICS, fixed_static_friction=fixed).items():
                    many = answer[name]
                    self.assertEqual((many.value[i], many.smoothness[i], many.status[i]),
                                     (derivative.value, derivative.smoothness, derivative.status))
                    self.assertEqual({key: column[i] for key, column in many.gradient.items()}, derivative.gradient)

    def test_derivatives_are_those_of_the_values(self):
        """Against Richardson's extrapolation of central differences of twum.evaluate().

        At steps h = 2^-10 of the parameter and h / 2 it errs by h^4 / 480 times the fifth derivative. The
        torque falls from its plateau to nothing within the last third of the speeds: singularities an eighth
        of the parameter away, or more, make the fifth derivative 5! 8^5 f at most, and the error 8e-9 f. Values
        are good to about 1e-13 f, times 3 / h: 3e-10 f.
        """
        batch = {key: np.asarray(values) for key, values in designs(8).items() if key != "thickness"}
        batch["thickness"] = np.full(8, 0.25e-3)
        answer = twum.gradients(self.motor, batch, METRICS)

        def values(name, factor):
            return twum.evaluate(self.motor, {**batch, name: batch[name] * factor}, METRICS)

        def differences(name, metric, step):
            return (values(name, 1 + step)[metric] - values(name, 1 - step)[metric]) / (2 * step)

        for metric, derivatives in answer.items():
            smooth = np.isin(derivatives.smoothness, ["smooth", "flat"])
            self.assertGreater(smooth.sum(), 4, metric)
            for name in batch:
                fine, coarse = (differences(name, metric, step) for step in (2**-11, 2**-10))
                elasticity = derivatives[name] * batch[name]
                error = np.abs((4 * fine - coarse) / 3 - elasticity) / np.abs(derivatives.value)
                self.assertLess(error[smooth].max(), 1e-8, (metric, name))

    def test_a_parameter_goes_by_its_symbol_too(self):
        derivatives = twum.gradients(self.motor, {"preload": [100.0, 140.0]}, ["holding_torque"])["holding_torque"]
        # d(mu_0 F_N r) / dF_N = mu_0 r, a product of two.
        np.testing.assert_allclose(derivatives["F_N"], 0.2 * 0.0265, rtol=4e-16)
        self.assertIs(derivatives["F_N"], derivatives["preload"])
        self.assertEqual(derivatives["thickness"].tolist(), [0, 0])
        with self.assertRaises(KeyError):
            derivatives["pre_load"]

    def test_a_design_that_fails_does_not_stop_the_others(self):
        asked = {"thickness": [3e-4, -3e-4], "preload": "160 N"}
        derivatives = twum.gradients(self.motor, asked, "no_load_speed")["no_load_speed"]
        self.assertEqual((derivatives.status[0], derivatives.smoothness[0]), ("ok", "smooth"))
        self.assertIn("thickness must be at least 1e-08 m", derivatives.status[1])
        self.assertEqual(derivatives.smoothness[1], "undefined")
        self.assertTrue(np.isnan(derivatives.value[1]) and np.isnan(derivatives["preload"][1]))
        self.assertEqual(twum.gradients(self.motor, {"preload": []}, "stall_torque")["stall_torque"].value.shape, (0,))

    def test_expressions_have_derivatives_by_the_product_rule(self):
        answers = twum.gradients(self.motor, {"thickness": [1e-4]}, ["preload", "peak_power", "preload * peak_power"])
        load, power, product = answers.values()
        self.assertEqual((load["preload"][0], load["thickness"][0]), (1, 0))
        expected = power.value[0] + load.value[0] * power["preload"][0]
        self.assertAlmostEqual(product["preload"][0], expected, delta=1e-12 * abs(expected))


class Patience(unittest.TestCase):
    def test_a_signal_ends_a_batch(self):
        class Enough(Exception):
            pass

        def stop(*_):
            raise Enough

        before = signal.signal(signal.SIGALRM, stop)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        begin = time.monotonic()
        # All metrics take some 40 microseconds a design: 40 seconds if nothing ended it.
        metrics = [row["name"] for row in twum.metric_table() if not row["takes"]]
        with self.assertRaises(Enough):
            twum.evaluate(twum.Motor(), {"preload": np.full(1_000_000, 160.0)}, metrics, jobs=1)
        self.assertLess(time.monotonic() - begin, 10)

    def test_an_answer_knows_a_metric_as_it_was_typed(self):
        asked = "peak_power / (1 W)"
        motor = twum.Motor()
        for metrics in (asked, [asked], f"stall_torque, {asked}"):
            self.assertIn(asked, twum.evaluate(motor, {"preload": [60.0]}, metrics))
            self.assertIn(asked, twum.gradients(motor, {"preload": [60.0]}, metrics))
            self.assertIn(asked, motor.metrics(metrics))
        best = twum.DesignProblem(motor).vary("preload", 60, 100).maximize(asked).solve()
        self.assertEqual(list(best.objective), [asked])

    def test_equal_motors_are_one_key(self):
        self.assertEqual(twum.Motor(preload=140.0), twum.Motor(preload="140 N"))
        self.assertNotEqual(twum.Motor(preload=140.0), twum.Motor(preload=141.0))
        self.assertNotEqual(twum.Motor(), "motor")
        self.assertEqual(len({twum.Motor(preload=140.0), twum.Motor(preload=140.0), twum.Motor()}), 2)


if __name__ == "__main__":
    unittest.main()
