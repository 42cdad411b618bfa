# SPDX-License-Identifier: Apache-2.0
"""Sizes a gearbox and a motor together with an optimizer of your own, SciPy's SLSQP. The joint needs 2 N.m at
2 rad/s, and the stator power is minimized. The gradients of the motor are exact; the chain rule adds the gearbox."""
import numpy as np
import twum
from scipy.optimize import minimize

TORQUE, SPEED, NAMES = 2.0, 2.0, ("preload", "amplitude")
SCALE = np.array([100.0, 1e-6, 1.0])  # preload [N], amplitude [m], gear ratio


def motor_of(x):
    return twum.Motor(**dict(zip(NAMES, x * SCALE)))


def power(x):
    """Stator power at the motor's speed, and its gradient: the speed is that of the joint times the ratio."""
    motor, speed = motor_of(x), SPEED * x[2]
    metric = motor.gradients(f"stator_power_at({speed!r} rad/s)").popitem()[1]
    step = 1e-6 * speed
    by_speed = (motor.stator_power_at(speed + step) - motor.stator_power_at(speed - step)) / (2 * step)
    return metric.value, np.array([metric[name] for name in NAMES] + [by_speed * SPEED]) * SCALE


def spare_torque(x):
    """Torque of the motor minus the torque that the joint needs through the gearbox with its loss."""
    return motor_of(x).torque_at(SPEED * x[2]) - TORQUE / x[2] * (1 + 0.03 * np.log(x[2]))


best = minimize(power, [1.6, 1.6, 5.0], jac=True, method="SLSQP", bounds=[(0.6, 3), (0.8, 2.2), (2.5, 9)],
                constraints=[{"type": "ineq", "fun": spare_torque}])
print(f"{best.message}: {best.fun:.3f} W for {TORQUE * SPEED:.1f} W of work")
print(f"ratio {best.x[2]:.3f}, preload {best.x[0] * SCALE[0]:.1f} N, amplitude {best.x[1]:.3f} um")
assert best.success and spare_torque(best.x) > -1e-6
