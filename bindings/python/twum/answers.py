# SPDX-License-Identifier: Apache-2.0
"""Types of what summary.json holds: the parts of an answer that programs ask for most, SI units, None: no value."""
from __future__ import annotations

from typing import Dict, Mapping, Sequence, TypedDict, Union

Json = Union[None, bool, int, float, str, Sequence["Json"], Mapping[str, "Json"]]  # any other part
Values = Dict[str, Union[float, None]]  # by name


class Goal(TypedDict):
    """What a search wants."""

    metric: str
    sense: str  # 'maximize' or 'minimize'


class SearchCertificate(TypedDict):
    """The evidence that a design is a local optimum; see Certificate."""

    passed: bool
    second_order: bool
    reason: str
    infeasibility: float | None
    stationarity: float | None
    complementarity: float | None
    gain: float | None
    curvature: float | None
    weights: list[float]
    prices: list[float]
    findings: list[dict[str, Json]]


class LimitState(TypedDict):
    """A limit of a study at a design."""

    text: str  # as typed
    metric: str
    unit: str
    sense: str
    lower: float | None
    upper: float | None
    value: float | None
    limit: float | None
    violation: float | None
    tolerance: float | None
    active: bool
    multiplier: float | None
    gain_per_percent: float | None


class BoundState(TypedDict):
    """A variable at the end of its range."""

    variable: str
    side: str
    limit: float | None
    multiplier: float | None
    gain_per_percent: float | None


class _Choice(TypedDict, total=False):
    choice: dict[str, str]  # the set that the design has of each choice
    statistics: Values  # of the motors that are built to it


class Design(_Choice):
    """A design that a search has found."""

    design: dict[str, float]
    metrics: Values
    constraints: list[LimitState]
    bounds: list[BoundState]
    certificate: SearchCertificate


class Estimate(TypedDict):
    """A parameter that a calibration has found, with its interval."""

    value: float
    low: float | None
    high: float | None
    sd: float | None
    at_bound: Json
    interval: str
    cut_off: Json
    remark: str


class FailureRegion(TypedDict):
    """Where evaluations failed for a reason."""

    reason: str
    count: int
    where: dict[str, dict[str, Union[float, str, None]]]
