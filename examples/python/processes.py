# SPDX-License-Identifier: Apache-2.0
"""Runs searches in two processes at once: motors, questions, answers and errors are sent between them."""
import concurrent.futures

import twum


def best(pressure: str) -> twum.Optimum:
    """The motor with the most power whose lining withstands this pressure."""
    problem = twum.DesignProblem(twum.Motor()).vary("preload", "60 N", "300 N").vary("amplitude", "0.8 um", "2.2 um")
    return problem.maximize("peak_power").limit(f"max_pressure <= {pressure}").solve(starts=2)


if __name__ == "__main__":
    pressures = ["1.5 MPa", "2 MPa", "2.5 MPa", "3 MPa"]
    with concurrent.futures.ProcessPoolExecutor(2) as workers:
        for pressure, found in zip(pressures, workers.map(best, pressures)):
            print(f"{pressure}: {found.outcome}, {twum.engineering(found.motor.peak_power, 'W')}")
