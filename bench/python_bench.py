# SPDX-License-Identifier: Apache-2.0
"""What the Python module costs beside C++: import, one call, a batch.

    PYTHONPATH=BUILD/python /usr/bin/python3 bench/python_bench.py BUILD/bench/twum_batch_bench [DESIGNS]

The two sides of the batch take turns, on one thread; processor time and the smallest of the times count,
so that other load on the machine does not. Both do all of it: parameters in, designs made, metrics out.
"""
import subprocess
import sys
import time
import timeit

ROUNDS = 5


def import_seconds():
    """Of twum itself, after NumPy is there."""
    code = "import numpy, time; t = time.process_time(); import twum; print(time.process_time() - t)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
               for _ in range(ROUNDS))


def batch(count):
    import numpy as np
    import twum

    steps = np.arange(count, dtype=float)
    begin = time.process_time()
    designs = {"preload": 60 + 240 * np.fmod(0.618 * steps, 1), "amplitude": 0.8e-6 + 1.4e-6 * np.fmod(0.414 * steps, 1)}
    answer = twum.evaluate(twum.Motor(), designs, "stall_torque, no_load_speed, torque_at(10.5 rad/s)", jobs=1)
    seconds = time.process_time() - begin
    return seconds, [sum(values.tolist()) for name, values in answer.items() if name != "status"]


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    times = {"C++": [], "Python": []}
    for _ in range(ROUNDS):
        words = subprocess.run([program, str(count), "1"], capture_output=True, text=True, check=True).stdout.split()
        seconds, sums = batch(count)
        assert sums == [float(word) for word in words[1:]], "the two sides compute something else"
        times["C++"].append(float(words[0]))
        times["Python"].append(seconds)
    fastest = {side: min(values) for side, values in times.items()}
    import twum

    motor = twum.Motor()
    call = min(timeit.repeat(lambda: motor.point(10.0), number=2000, repeat=ROUNDS)) / 2000
    print(f"import twum            {1e3 * import_seconds():8.1f} ms")
    print(f"motor.point(10.0)      {1e6 * call:8.2f} us")
    for side, seconds in fastest.items():
        print(f"{count} designs, {side:7} {1e3 * seconds:8.1f} ms")
    print(f"Python / C++           {fastest['Python'] / fastest['C++']:8.3f}")


if __name__ == "__main__":
    main()
