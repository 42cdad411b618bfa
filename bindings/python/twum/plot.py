# SPDX-License-Identifier: Apache-2.0
"""Plots with matplotlib, which is only needed here. The axes they return are for adding to."""
from typing import Any

import numpy as np

_RPM = 30 / np.pi
_ZONE_COLOURS = {"slip+": "tab:orange", "stick": "tab:green", "slip-": "tab:purple"}


def _new_axes(count: int = 1) -> Any:
    import matplotlib.pyplot as pyplot  # type: ignore[import]

    return pyplot.subplots(count, 1, sharex=True, layout="constrained")[1]


def curve(curve: Any, axes: Any = None) -> Any:
    """Torque and output power over speed. Returns the axes; the power's are axes.figure.axes[-1]."""
    axes = _new_axes() if axes is None else axes
    axes.plot(curve.speed * _RPM, curve.torque, label="torque", color="tab:blue")
    axes.axhline(0, color="0.7", linewidth=0.8)
    axes.set(xlabel="speed [rpm]", ylabel="torque [N.m]", title=curve.motor.name)
    power = axes.twinx()
    power.plot(curve.speed * _RPM, curve.output_power, "--", label="output power", color="tab:red")
    power.set_ylabel("output power [W]")
    axes.legend(handles=axes.lines[:1] + power.lines[:1], loc="best")
    return axes


def fields(fields: Any, axes: Any = None) -> Any:
    """Pressure and traction above velocities, over the phase of the wave. Returns both axes."""
    above, below = _new_axes(2) if axes is None else axes
    above.plot(fields.phase, fields.pressure / 1e6, label="pressure")
    above.plot(fields.phase, fields.traction / 1e6, label="traction")
    above.set_ylabel("[MPa]")
    below.plot(fields.phase, fields.stator_velocity, label="stator")
    below.plot(fields.phase, fields.layer_velocity, label="layer")
    below.set(xlabel="phase [rad]", ylabel="velocity [m/s]")
    for one in (above, below):
        shown = set()
        for state, begin, end in fields.zones:
            one.axvspan(begin, end, color=_ZONE_COLOURS[state], alpha=0.15,
                        label=None if state in shown else state)
            shown.add(state)
        one.legend(loc="best")
    above.set_title(f"{fields.motor.name} at {fields.point.speed * _RPM:.4g} rpm")
    return above, below
