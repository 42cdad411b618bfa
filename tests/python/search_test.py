# SPDX-License-Identifier: Apache-2.0
"""Questions about motors from Python: optima, fronts, sizing, two at once, Ctrl-C."""
import _thread
import pathlib
import pickle
import threading
import unittest

import twum

ROOT = pathlib.Path(__file__).resolve().parents[2]
RING = ROOT / "tests/data/motors/ring-60.yaml"


def question(motor):
    problem = twum.DesignProblem(motor)
    problem.vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
    return problem.limit("max_pressure <= 10 MPa").limit("wear_intensity_at(100 rpm) <= 10 kW/m^2")


class Search(unittest.TestCase):
    def test_the_least_preload_that_holds(self):
        # mu_0 F_N r >= T: the least preload is T / (mu_0 r), to the solver's feasibility of 1e-8.
        problem = twum.DesignProblem(twum.Motor()).vary("preload", 10, 500).minimize("preload")
        best = problem.limit("holding_torque >= 0.53 N.m").solve()
        self.assertEqual(best.outcome, "optimal")
        self.assertAlmostEqual(best.design["preload"], 0.53 / (0.2 * 0.0265), delta=1e-5)
        self.assertEqual(best.motor.preload, best.design["preload"])
        limit = best.limits[0]
        self.assertTrue(limit["active"])
        # The multiplier is the preload that one N.m costs.
        self.assertAlmostEqual(limit["multiplier"], 1 / (0.2 * 0.0265), delta=1e-3)

    def test_what_cannot_be_says_what_gives_way(self):
        problem = twum.DesignProblem(twum.Motor()).vary("preload", 10, 100).minimize("max_pressure")
        answer = problem.limit("holding_torque >= 0.8 N.m").solve()
        self.assertEqual(answer.outcome, "infeasible")
        # At 100 N the motor holds 0.53 N.m: 0.27 N.m short.
        self.assertAlmostEqual(answer.relaxation[0]["amount"], 0.8 - 0.53, delta=1e-6)
        self.assertAlmostEqual(answer.impossible[0]["best"], 0.53, delta=1e-6)
        self.assertEqual(answer.impossible[0]["ends"], [0])
        # The preload alone would have to reach 0.8 N.m / (0.2 * 26.5 mm); searches end within 1e-8 of a limit.
        self.assertEqual((answer.ranges[0]["variable"], answer.ranges[0]["side"]), ("preload", "upper"))
        self.assertAlmostEqual(answer.ranges[0]["limit_alone"], 0.8 / (0.2 * 0.0265), delta=1e-4)

    def test_a_sized_motor_carries_its_duty(self):
        best = question(twum.Motor(RING)).size(("0.5 N.m", "100 rpm"))
        self.assertEqual(best.outcome, "optimal")
        self.assertGreaterEqual(best.motor.torque_at("100 rpm"), 0.5 * (1 - 1e-7))
        self.assertLessEqual(best.motor.max_pressure, 10e6)
        self.assertEqual(best.objective["max_pressure"], best.motor.max_pressure)

    def test_two_threads_sizing_at_once_find_the_same(self):
        def size(torque, answers, key):
            answers[key] = question(twum.Motor(RING)).size((torque, "100 rpm"))

        alone, together = {}, {}
        for torque in ("0.5 N.m", "0.4 N.m"):
            size(torque, alone, torque)
        threads = [threading.Thread(target=size, args=(torque, together, (torque, i)))
                   for torque in alone for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(together), 4)
        for (torque, _), answer in together.items():
            self.assertEqual(answer.design, alone[torque].design)
            self.assertEqual(answer.certificate, alone[torque].certificate)

    def test_a_front_trades(self):
        front = question(twum.Motor(RING)).maximize("stall_torque").maximize("no_load_speed").front(points=6)
        self.assertGreater(len(front), 2)
        torque = [one.objective["stall_torque"] for one in front]
        speed = [one.objective["no_load_speed"] for one in front]
        order = sorted(range(len(front)), key=torque.__getitem__)
        self.assertEqual(order, sorted(range(len(front)), key=speed.__getitem__, reverse=True))

    def test_what_is_derived_moves_along(self):
        problem = twum.DesignProblem(twum.Motor()).vary("contact_radius", "20 mm", "30 mm").maximize("contact_radius")
        best = problem.derive("contact_width", "0.1 * contact_radius").solve()
        self.assertEqual(best.motor.contact_width, 0.1 * best.design["contact_radius"])
        self.assertEqual(best.choice, {})

    def test_the_best_of_a_choice_is_that_of_the_closed_form(self):
        # mu_0 F_N r at most: the largest friction and the largest radius.
        linings = {"low": {"mu": 0.1, "mu_0": 0.1}, "high": {"kinetic_friction": 0.3, "static_friction": "0.3"}}
        problem = twum.DesignProblem(twum.Motor()).vary("preload", 60, 300).maximize("holding_torque")
        best = problem.choose("lining", linings).choose("ring", {"a": {"contact_radius": "20 mm"}, "b": {"contact_radius": 0.03}}).solve()
        self.assertEqual(best.choice, {"lining": "high", "ring": "b"})
        self.assertEqual(list(best.design), ["preload"])
        # The preload is at its bound, up to the rounding of the search's scale.
        self.assertAlmostEqual(best.objective["holding_torque"], 0.3 * 300 * 0.03, delta=1e-9)
        self.assertEqual((best.motor.kinetic_friction, best.motor.contact_radius), (0.3, 0.03))

    def test_sets_come_from_files(self):
        folder = ROOT / "examples/studies/linings"
        problem = twum.DesignProblem(twum.Motor(RING)).vary("preload", 60, 300).maximize("holding_torque")
        best = problem.choose("lining", [folder / "peek.yaml", str(folder / "ptfe-peek.yaml")]).solve()
        self.assertEqual(best.choice, {"lining": str(folder / "peek.yaml")})
        self.assertEqual(best.motor.youngs_modulus, 3.6e9)

    def test_wrong_questions_are_refused(self):
        problem = twum.DesignProblem(twum.Motor())
        for call, words in ((lambda: problem.vary("pre", 1, 2), "unknown parameter 'pre'"),
                            (lambda: problem.vary("preload", "1 mm", "2 mm"), "length"),
                            (lambda: problem.vary("preload", 1, 2, scale="lag"), "did you mean 'log'"),
                            (lambda: problem.limit("max_presure <= 1 MPa"), "max_pressure"),
                            (lambda: problem.maximize("peak"), "unknown metric"),
                            (lambda: problem.solve(), "variable"),
                            (lambda: problem.derive("contact_width", "2 N"), "force"),
                            (lambda: problem.choose("lining", {"a": {"preload": "1 mm"}}), "length"),
                            (lambda: problem.choose("lining", ["absent.yaml"]), "absent.yaml: cannot be read"),
                            (lambda: question(twum.Motor()).maximize("peak_power").choose("lining", {"a": {"preload": 1}}).solve(),
                             "preload is varied, and 'a' of 'lining' gives it too"),
                            (lambda: question(twum.Motor()).solve(), "objective"),
                            (lambda: question(twum.Motor()).size([]), "duty"),
                            (lambda: question(twum.Motor()).size((1, "2 mm")), "duty: speed.*length"),
                            (lambda: question(twum.Motor()).size((1, 2), solver="ipop"), "ipopt"),
                            (lambda: question(twum.Motor()).size((1, 2), seeds=1), "did you mean 'seed'")):
            with self.assertRaisesRegex(twum.InputError, words):
                call()

    def test_a_function_as_metric_finds_what_the_metric_finds(self):
        # The holding torque mu_0 F_N r is a metric of twum, too.
        def holding(motor):
            return motor.static_friction * motor.preload * motor.contact_radius

        def slopes(motor):  # mu_0 keeps its ratio to mu, so mu moves it
            return {"preload": holding(motor) / motor.preload, "contact_radius": holding(motor) / motor.contact_radius,
                    "kinetic_friction": holding(motor) / motor.kinetic_friction}

        own, ours = question(twum.Motor(RING)).maximize("peak_power"), question(twum.Motor(RING)).maximize("peak_power")
        found = own.limit("holding", holding, upper=0.7, gradient=slopes, unit="N.m").solve(jobs=2)
        wanted = ours.limit("holding_torque <= 0.7 N.m").solve()
        self.assertEqual(found.outcome, "optimal")
        self.assertEqual(found.limits[2]["text"], "holding <= 0.7 N.m")
        # Three products may be rounded in another order, and both searches end within 1e-6 of the limit.
        self.assertAlmostEqual(found.design["preload"], wanted.design["preload"], delta=1e-4)
        self.assertIn("limit holding <= 0.7 N.m", repr(own))

    def test_a_function_without_derivatives_takes_a_solver_without_gradients(self):
        def off(motor):
            return (motor.holding_torque - 0.53) ** 2

        problem = twum.DesignProblem(twum.Motor()).vary("preload", 60, 300).minimize(off, unit="N^2.m^2")
        with self.assertRaisesRegex(twum.InputError, "derivatives"):
            problem.solve()
        best = problem.solve(solver="nlopt:sbplx")
        self.assertEqual(list(best.objective), ["off"])
        # The preload 0.53 / (mu_0 r); the solver ends at 1e-4 of the range.
        self.assertAlmostEqual(best.design["preload"], 100, delta=0.1)

    def test_what_a_metric_raises_reaches_the_caller(self):
        def broken(motor):
            raise ZeroDivisionError("of mine")

        def none(motor):
            raise twum.EvaluationError("not for sale")

        def problem(function):
            return twum.DesignProblem(twum.Motor()).vary("preload", 60, 300).minimize(function)

        with self.assertRaisesRegex(ZeroDivisionError, "of mine"):
            problem(broken).solve(solver="nlopt:sbplx")
        self.assertEqual(problem(none).solve(solver="nlopt:sbplx", max_evaluations=20).outcome, "failed")
        with self.assertRaisesRegex(TypeError, "pickled"):
            pickle.dumps(problem(broken))
        with self.assertRaisesRegex(twum.InputError, "letters, digits"):
            problem(lambda motor: 1.0)

    def test_ctrl_c_ends_a_search(self):
        timer = threading.Timer(0.2, _thread.interrupt_main)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:  # a search may be done before the signal comes
                question(twum.Motor(RING)).maximize("stall_torque").maximize("no_load_speed").front(points=60)
        timer.join()


if __name__ == "__main__":
    unittest.main()
