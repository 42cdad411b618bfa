# SPDX-License-Identifier: Apache-2.0
"""A worker thread that sizes motors, tells its progress, and can be cancelled, as behind a window with two buttons."""
import threading

import twum


class Worker:
    def __init__(self, problem, duty):
        self.cancelled = threading.Event()
        self.evaluations = 0
        self.best = None
        self.error = None
        self._thread = threading.Thread(target=self._run, args=(problem, duty), daemon=True)
        self._thread.start()

    def _run(self, problem, duty):
        try:
            self.best = problem.size(duty, stop=self.cancelled, progress=self._tell)
        except twum.Error as error:
            self.error = error

    def _tell(self, done, total, best):
        self.evaluations = done

    def cancel(self):
        self.cancelled.set()

    def wait(self):
        self._thread.join()
        return self.error or self.best


problem = twum.DesignProblem(twum.Motor()).vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
problem.limit("max_pressure <= 10 MPa")
print("finished:", Worker(problem, ("0.5 N.m", "100 rpm")).wait().outcome)
cancelled = Worker(problem, [("0.5 N.m", "100 rpm"), ("0.6 N.m", "50 rpm")])
cancelled.cancel()
print("cancelled:", cancelled.wait().outcome)
print("refused:", Worker(problem, ("0.5 N.m", "1 mm")).wait())
