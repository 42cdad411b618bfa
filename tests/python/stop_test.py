# SPDX-License-Identifier: Apache-2.0
"""Long calls from Python can be stopped and watched, and do not hinder the end of the interpreter."""
import pathlib
import subprocess
import sys
import threading
import unittest

import numpy as np
import twum

DRIVEN = pathlib.Path(__file__).resolve().parents[2] / "examples/motors/drive-60.yaml"
LONG = {"kind": "sweep", "sampling": "sobol", "samples": 500000, "metrics": ["stall_torque"],
        "variables": {"preload": {"min": "60 N", "max": "300 N"}}}


def question():
    problem = twum.DesignProblem(twum.Motor(DRIVEN)).vary("preload", "60 N", "300 N")
    return problem.vary("voltage", "50 V", "120 V").maximize("peak_power")


def set_event():
    event = threading.Event()
    event.set()
    return event


class Stop(unittest.TestCase):
    def test_a_search_that_is_stopped_answers_with_what_it_has(self):
        self.assertEqual(question().solve(stop=set_event()).outcome, "budget")
        self.assertEqual(question().size(("0.1 N.m", "50 rpm"), stop=set_event()).outcome, "budget")
        self.assertEqual(question().maximize("stall_torque").front(stop=set_event()), [])

    def test_a_search_is_stopped_while_it_runs(self):
        event, told = threading.Event(), []

        def progress(done, total, best):
            told.append((done, total, best))
            event.set()

        # A random search takes every evaluation that it gets: these would last for an hour.
        answer = question().solve(solver="nlopt:isres", max_evaluations=10**7, stop=event, progress=progress)
        self.assertEqual(answer.outcome, "budget")
        self.assertTrue(told)
        self.assertGreaterEqual(answer.evaluations, told[0][0])
        self.assertLess(answer.evaluations, 10**6)

    def test_an_error_in_progress_ends_a_search(self):
        def progress(done, total, best):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            question().solve(progress=progress)

    def test_designs_that_were_not_computed_say_so(self):
        loads = np.linspace(60, 300, 20000)
        answer = twum.evaluate(twum.Motor(DRIVEN), {"preload": loads}, "peak_power", jobs=1, stop=set_event())
        stopped = answer["status"] == "stopped"
        self.assertTrue(stopped.any())
        self.assertTrue(np.isnan(answer["peak_power"][stopped]).all())
        derived = twum.gradients(twum.Motor(DRIVEN), {"preload": loads}, "peak_power", jobs=1, stop=set_event())["peak_power"]
        stopped = derived.status == "stopped"
        self.assertTrue(stopped.any())
        self.assertTrue(np.isnan(derived["preload"][stopped]).all())

    def test_a_batch_tells_its_progress(self):
        told = []
        loads = np.linspace(60, 300, 3000)
        twum.evaluate(twum.Motor(), {"preload": loads}, "peak_power, max_efficiency, no_load_speed", jobs=1,
                      progress=lambda *now: told.append(now))
        self.assertTrue(all(0 < done <= total == 3000 and best == "" for done, total, best in told), told[:3])

    def test_a_study_that_is_stopped_is_interrupted(self):
        result = twum.run(LONG, motor=twum.Motor(), stop=set_event())
        self.assertEqual(result.outcome, "interrupted")
        self.assertLess(len(result.rows["preload"]), 500000)

    def test_what_cannot_stop_or_watch_is_refused(self):
        with self.assertRaisesRegex(TypeError, "is_set"):
            question().solve(stop=True)
        with self.assertRaisesRegex(TypeError, "progress"):
            question().solve(progress=1)

    def test_a_daemon_thread_within_a_call_lets_the_interpreter_end(self):
        calls = ("question().solve()",
                 "twum.evaluate(twum.Motor(DRIVEN), {'preload': [60 + i * .01 for i in range(20000)]}, 'peak_power', jobs=1)",
                 "twum.run(LONG, motor=twum.Motor())")
        for call in calls:
            program = (f"import sys, threading, time\nsys.path.insert(0, {str(pathlib.Path(__file__).parent)!r})\n"
                       "from stop_test import *\n"
                       f"threading.Thread(target=lambda: {call}, daemon=True).start()\ntime.sleep(0.3)\n")
            with self.subTest(call):
                done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
                self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
