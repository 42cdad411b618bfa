# SPDX-License-Identifier: Apache-2.0
"""Design of travelling wave ultrasonic motors.

    import twum

    motor = twum.Motor("ring-60.yaml", preload="140 N")     # a file, or keywords alone
    motor.stall_torque                                      # metrics, in SI units
    motor.torque_at("100 rpm")
    motor.curve().plot()                                    # arrays of NumPy
    motor.gradients("peak_power")["peak_power"]["thickness"]
    twum.evaluate(motor, {"preload": loads}, "stall_torque, no_load_speed")
    twum.gradients(motor, {"preload": loads}, "stall_torque")["stall_torque"]["preload"]
    motor.move("20 ms", switched_off=[("15 ms", "20 ms")])["speed"]
    twum.run("study.yaml").summary

Numbers are in SI units, texts carry their unit. parameter_table() and metric_table() list the names.
"""
try:
    from ._twum import (
        DesignProblem,
        Derivative,
        Error,
        EvaluationError,
        FileError,
        InputError,
        Motor,
        OperatingPoint,
        StoreError,
        __version__,
        engineering,
        evaluate,
        gradients,
        metric_table,
        parameter_table,
        quantity,
        solver_table,
    )
except ModuleNotFoundError as error:
    if error.name != f"{__name__}._twum":
        raise
    from ._missing import how_to_build

    raise ImportError(how_to_build()) from None
from .answers import Json
from .results import Curve, Derivatives, Fields, Motion, Optimum, OwnMetric, Plant, Study, StudyResult, read_result, run

__all__ = [
    "Curve",
    "Derivative",
    "Derivatives",
    "DesignProblem",
    "Error",
    "EvaluationError",
    "Fields",
    "FileError",
    "InputError",
    "Json",
    "Motion",
    "Motor",
    "OperatingPoint",
    "Optimum",
    "OwnMetric",
    "Plant",
    "StoreError",
    "Study",
    "StudyResult",
    "__version__",
    "engineering",
    "evaluate",
    "gradients",
    "metric_table",
    "parameter_table",
    "quantity",
    "read_result",
    "run",
    "solver_table",
]

# Users see these names where they find them.
for _shown in (DesignProblem, Derivative, Motor, OperatingPoint, evaluate, gradients):
    try:
        _shown.__module__ = "twum"
    except (AttributeError, TypeError):  # of a compiled function it is fixed
        pass
del _shown
