# SPDX-License-Identifier: Apache-2.0
"""What calls return: curves, fields, optima, results of studies."""
from __future__ import annotations

import csv
import io
import json
import numbers
import os
import pathlib
import sys
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Callable, Literal, Mapping, Sequence, TypedDict, Union, cast, overload

import numpy as np

from . import _twum
from .answers import Design, Estimate, FailureRegion, Goal, Json

if TYPE_CHECKING:
    from matplotlib.axes import Axes  # type: ignore[import]
    from numpy.typing import NDArray
    from pandas import DataFrame  # type: ignore[import]

    Floats = NDArray[np.float64]
    Texts = NDArray[np.object_]

_NAMES = {row["symbol"]: row["name"] for row in _twum.parameter_table() if row["symbol"]}


@dataclass(frozen=True, eq=False, repr=False)
class Curve:
    """Torque-speed curve of a motor: arrays over the speeds, SI units, NaN where status is not 'ok'."""

    motor: _twum.Motor
    speed: Floats  # [rad/s]
    torque: Floats  # [N.m]
    output_power: Floats  # [W]
    stator_power: Floats  # [W]
    friction_power: Floats  # [W]
    layer_loss: Floats  # [W]
    contact_efficiency: Floats
    wear_intensity: Floats  # [W/m^2]
    stick_fraction: Floats
    status: list[str]
    # What a motor with modal data has besides.
    amplitude: Floats | None = None  # [m]
    phase_lag: Floats | None = None  # [rad]
    voltage: Floats | None = None  # [V], rms
    phase_current: Floats | None = None  # [A], rms
    power_factor: Floats | None = None
    electrical_power: Floats | None = None  # [W]
    overall_efficiency: Floats | None = None
    dielectric_loss: Floats | None = None  # [W]
    stator_loss: Floats | None = None  # [W]

    @property
    def squeals(self) -> list[bool | None]:
        """Whether the motor squeals at each speed; None where that is not known. Computed anew at each access."""
        return self.motor._squeals(self.speed)

    def to_frame(self) -> DataFrame:
        """The arrays as a DataFrame of pandas, a row for each speed."""
        arrays = {one.name: getattr(self, one.name) for one in fields(self) if one.name != "motor"}
        return _frame({name: values for name, values in arrays.items() if values is not None})

    def __repr__(self) -> str:
        return f"<twum.Curve of {self.motor!r}: {len(self.speed)} speeds; to_frame() is a table, plot() a picture>"

    def plot(self, axes: Axes | None = None) -> Axes:
        """Torque and output power over speed, with matplotlib; returns its axes."""
        from . import plot

        return plot.curve(self, axes)


@dataclass(frozen=True, eq=False, repr=False)
class Fields:
    """The contact along one wave: arrays over the phase, SI units; zones as (state, from, to)."""

    motor: _twum.Motor
    point: _twum.OperatingPoint
    phase: Floats  # [rad], crest at 0
    pressure: Floats  # [Pa]
    traction: Floats  # [Pa], positive in drive direction
    displacement: Floats  # [m]
    stator_velocity: Floats  # [m/s]
    layer_velocity: Floats  # [m/s]
    radial_velocity: Floats  # of the stator's surface [m/s]
    radial_traction: Floats  # outward [Pa]
    zones: list[tuple[str, float, float]]

    def __repr__(self) -> str:
        zones = ", ".join(state for state, _, _ in self.zones)
        return f"<twum.Fields of {self.motor!r}, {self.point!r}: {len(self.phase)} phases, zones {zones}>"

    def to_frame(self) -> DataFrame:
        """The arrays as a DataFrame of pandas, a row for each phase."""
        return _frame({one.name: getattr(self, one.name) for one in fields(self)[2:-1]})

    def plot(self, axes: Sequence[Axes] | None = None) -> tuple[Axes, Axes]:
        """Pressure, traction and velocities over the phase, with matplotlib; returns its two axes."""
        from . import plot

        both: tuple[Axes, Axes] = plot.fields(self, axes)
        return both


class MotionEvent(TypedDict):
    """Something that happens in a motion, SI units."""

    event: str  # such as 'started' or 'held'
    time: float
    speed: float
    angle: float
    amplitude: float


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """A motion in time: arrays over the times, SI units, and what happened.

    motion['speed'] is one of the arrays in `columns`; they end where the motion ends, at `end`.
    """

    motor: _twum.Motor
    columns: dict[str, Floats]  # time, speed, angle, amplitude, torque and others
    events: list[MotionEvent]  # in the order of time
    status: str  # 'ok', or why it ended early
    end: float  # time that was reached [s]
    html: str = ""  # what happened, for notebooks

    def __getitem__(self, name: str) -> Floats:
        return self.columns[name]

    def time_of(self, event: str) -> float:
        """When an event such as 'held' happened first [s]; NaN if it did not."""
        return next((one["time"] for one in self.events if one["event"] == event), float("nan"))

    def to_frame(self) -> DataFrame:
        """The arrays as a DataFrame of pandas, a row for each time."""
        return _frame(self.columns)

    def __repr__(self) -> str:
        what = f"{len(self.columns['time'])} times to {self.end:g} s, {len(self.events)} events"
        return f"<twum.Motion of {self.motor!r}: {what}, {self.status}>"

    def _repr_html_(self) -> str:
        return self.html


@dataclass(frozen=True, eq=False)
class Plant:
    """A motor near a steady state: x' = a x + b u, y = c x + d u for changes of states, inputs and outputs, SI units.

    `control.ss(*plant.matrices)` is the system of python-control.
    """

    motor: _twum.Motor = field(repr=False)
    states: dict[str, float]  # their steady values by name, in the order of the matrices
    inputs: dict[str, float]
    outputs: dict[str, float]
    a: Floats = field(repr=False)
    b: Floats = field(repr=False)
    c: Floats = field(repr=False)
    d: Floats = field(repr=False)
    poles: NDArray[np.complex128]  # without the angle, which integrates the speed; the slowest first [1/s]
    gains: Floats = field(repr=False)  # steady changes of the outputs but the angle over those of the inputs

    @property
    def matrices(self) -> tuple[Floats, Floats, Floats, Floats]:
        return self.a, self.b, self.c, self.d


@dataclass(frozen=True, eq=False)
class Derivatives:
    """A metric of many designs with its exact derivatives: arrays over the designs, SI units.

    derivatives['thickness'] is one of them; it is 0 for a parameter that is not in use, and NaN where
    `status` is not 'ok' or `smoothness` is 'undefined'.
    """

    value: Floats
    gradient: dict[str, Floats] = field(repr=False)  # arrays by the name of the parameter
    smoothness: Texts = field(repr=False)  # texts, as of Derivative
    status: Texts = field(repr=False)  # 'ok', or why a design has no value

    def __getitem__(self, parameter: str) -> Floats:
        return self.gradient[_NAMES.get(parameter, parameter)]

    def to_frame(self) -> DataFrame:
        """The value, its derivatives by name, smoothness and status as a DataFrame of pandas, a row for each design."""
        return _frame({"value": self.value, **self.gradient, "smoothness": self.smoothness, "status": self.status})


class ParameterRow(TypedDict):
    """A row of parameter_table()."""

    name: str
    symbol: str  # '': it has none
    unit: str
    min: float
    max: float
    example: str
    text: str


class MetricRow(TypedDict):
    """A row of metric_table()."""

    name: str
    unit: str
    takes: str  # '': nothing
    text: str


# A row of solver_table(); one name is a keyword.
SolverRow = TypedDict("SolverRow", {"name": str, "text": str, "gradient": bool, "global": bool, "available": bool})


class Limit(TypedDict):
    """A limit or the bound of a variable at a design, SI units."""

    text: str  # as typed, or the name of the variable
    bound: bool
    value: float
    limit: float
    violation: float
    tolerance: float
    active: bool
    multiplier: float  # improvement of the objective per unit of relaxation
    unit: str  # of value and limit, '1': none
    price_unit: str  # of the multiplier, such as 'Pa per N.m'


class Certificate(TypedDict):
    """The evidence that a design is a local optimum."""

    passed: bool
    infeasibility: float
    stationarity: float
    complementarity: float
    curvature: float  # NaN: not measured
    gain: float  # what a step could still gain at most; NaN: not measured
    second_order: bool
    findings: list[str]
    reason: str  # why it did not pass


class Relaxation(TypedDict):
    """By how much a limit has to give, together with the others or alone (NaN: that is not enough)."""

    text: str
    limit: float
    amount: float
    amount_alone: float


class Impossible(TypedDict):
    """A limit that no design within the ranges keeps, even without the others."""

    text: str
    limit: float
    best: float
    certified: bool
    ends: list[int]  # positions in Optimum.ranges


class RangeEnd(TypedDict):
    """An end of a range with a part in it."""

    variable: str
    side: str
    limit: float
    limit_alone: float  # NaN: none was found


class Scan(TypedDict, total=False):
    """What sampling the whole range has found; empty for a point of a front."""

    designs: int
    feasible: int
    better: int
    replaced: bool  # one of these led to the answer
    before: float  # the objective of the local searches


@dataclass(frozen=True, eq=False)
class Optimum:
    """A design that was found, and the evidence for it.

    `outcome` is 'optimal' (feasible, and the certificate of a local optimum passes), 'feasible' (the search stopped short),
    'infeasible' (`impossible`, `relaxation` and `ranges` say why, and what has to change), 'budget' or 'failed'.
    """

    outcome: str
    motor: _twum.Motor = field(repr=False)
    design: dict[str, float]  # the variables, SI
    choice: dict[str, str]  # the set that the design has of each choice, by name
    objective: dict[str, float]
    limits: list[Limit] = field(repr=False)
    certificate: Certificate = field(repr=False)
    relaxation: list[Relaxation] = field(repr=False)
    impossible: list[Impossible] = field(repr=False)
    ranges: list[RangeEnd] = field(repr=False)
    scan: Scan = field(repr=False)
    solver: str
    evaluations: int  # of this search; 0 for a point of a front, which has none of its own
    failures: dict[str, int]


@dataclass(frozen=True)
class OwnMetric:
    """A metric that a function computes from a motor, for the `metrics` of a study.

    `gradient` gives a dictionary from names of parameters to derivatives, in which those that are missing are 0. Without
    it a search needs a solver without gradients. A function that raises EvaluationError has no value for that motor.
    """

    value: Callable[[_twum.Motor], float]
    gradient: Callable[[_twum.Motor], Mapping[str, float]] | None = None
    unit: str = "1"  # SI


@dataclass(frozen=True, eq=False, repr=False)
class StudyResult:
    """Result of a study: the content of summary.json, and the evaluations as arrays, SI units. print() says it in words."""

    summary: Mapping[str, Json]
    rows: dict[str, NDArray[Any]]  # arrays by column name; 'status' holds texts
    text: str = ""  # the summary in words
    directory: "str | None" = None  # where the result is kept, if it is
    html: str = ""  # the same as `text` for notebooks

    @property
    def outcome(self) -> str:
        return str(self.summary["outcome"])

    # A TypedDict is no Mapping[str, Json] for mypy.
    @overload
    def __getitem__(self, name: Literal["study", "kind", "motor", "outcome", "version", "started", "hash", "solver"]) -> str: ...

    @overload
    def __getitem__(self, name: Literal["evaluations", "seed"]) -> int: ...

    @overload
    def __getitem__(self, name: Literal["seconds", "residual_rms", "residual_sd", "hypervolume"]) -> float: ...

    @overload
    def __getitem__(self, name: Literal["model_notes", "variables_without_influence", "notes"]) -> list[str]: ...

    @overload
    def __getitem__(self, name: Literal["failures"]) -> dict[str, int]: ...

    @overload
    def __getitem__(self, name: Literal["units"]) -> dict[str, str]: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["failure_regions"]) -> list[FailureRegion]: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["objective"]) -> Goal: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["objectives"]) -> list[Goal]: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["best"]) -> Design | None: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["front"]) -> list[Design]: ...

    @overload
    def __getitem__(self, name: Literal["metrics"]) -> dict[str, Mapping[str, Json]]: ...

    @overload  # type: ignore[misc]
    def __getitem__(self, name: Literal["estimates"]) -> dict[str, Estimate]: ...

    @overload
    def __getitem__(self, name: str) -> Json: ...

    def __getitem__(self, name: str) -> object:
        return self.summary[name]

    def __repr__(self) -> str:
        place = f" in {self.directory}" if self.directory else ""
        return f"<twum.StudyResult of {self['kind']}{place}: {self.outcome}, {self['evaluations']} evaluations>"

    def __str__(self) -> str:
        return self.text or repr(self)

    def to_frame(self) -> DataFrame:
        """The evaluations as a DataFrame of pandas, columns in SI units."""
        return _frame(self.rows)

    def _repr_html_(self) -> str:
        if self.html or self.directory is None:
            return self.html
        return _twum.kept_html(self.directory)


OwnMetrics = Mapping[str, Union[OwnMetric, Callable[["_twum.Motor"], float]]]


def _frame(columns: Mapping[str, Any]) -> DataFrame:
    import pandas

    return pandas.DataFrame(dict(columns))


def _column(texts: Sequence[str]) -> NDArray[Any]:
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts, dtype=object)


def _rows(text: str) -> dict[str, NDArray[Any]]:
    lines = list(csv.reader(io.StringIO(text, newline="")))
    names = [name.rsplit(" [", 1)[0] for name in lines[0]]
    columns: list[tuple[str, ...]] = list(zip(*lines[1:])) or [() for _ in names]
    return {name: _column(column) for name, column in zip(names, columns)}


def _kept_rows(folder: pathlib.Path) -> dict[str, NDArray[Any]]:
    return _rows((folder / "results.csv").read_bytes().decode("utf-8"))


def read_result(directory: str | os.PathLike[str]) -> StudyResult:
    """The result that a study has left in a directory."""
    folder = pathlib.Path(directory)
    try:
        summary = cast(Mapping[str, Json], json.loads((folder / "summary.json").read_text(encoding="utf-8")))
        return StudyResult(summary, _kept_rows(folder), directory=str(folder))
    except FileNotFoundError as error:
        raise _twum.InputError(f"{folder}: no result of a study; {pathlib.Path(error.filename).name} is missing") from None


def _settings(parameters: Mapping[str, Any]) -> list[str]:
    """Settings as the command line has them; numbers are SI."""
    units = {key: row["unit"] for row in _twum.parameter_table() for key in (row["name"], row["symbol"])}

    def text(name: str, value: Any) -> str:
        if isinstance(value, str):
            return value
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"set: {name}: expected a number or a text with a unit, not {type(value).__name__}")
        try:
            number = repr(float(value))
        except OverflowError:
            raise _twum.InputError(f"set: {name}: this integer is beyond the range of a float") from None
        unit = units.get(name, "1")
        return number + ("" if unit == "1" else f" {unit}")

    return [f"{name}={text(name, value)}" for name, value in parameters.items()]


def _entries(study: Mapping[str, Any], motor: Any) -> dict[str, Any]:
    """A study given as a dictionary, as the entries of a study file."""
    content = dict(study) if "study" in study else {"study": dict(study)}
    content.setdefault("twum", 1)
    if motor is not None and "motor" in content:
        raise _twum.InputError("motor: the study names one; leave out one of the two")
    if isinstance(motor, Mapping):
        content["motor"] = dict(motor)
    elif isinstance(motor, (str, os.PathLike)):
        content["motor"] = os.path.abspath(motor)
    elif motor is not None and not isinstance(motor, _twum.Motor):
        raise TypeError(f"motor: expected a Motor, a path or the entries of a motor file, not {type(motor).__name__}")
    return content


def _own(metrics: OwnMetrics | None) -> list[tuple[str, Any, Any, str]]:
    """Metrics by name, as the compiled part takes them."""
    list_of = [
        (name, one if isinstance(one, OwnMetric) else OwnMetric(one)) for name, one in (metrics or {}).items()
    ]
    return [(name, one.value, one.gradient, one.unit) for name, one in list_of]


def run(
    study: str | os.PathLike[str] | Mapping[str, Any] | Study,
    directory: str | os.PathLike[str] | None = None,
    *,
    motor: Any = None,
    metrics: OwnMetrics | None = None,
    set: Mapping[str, Any] | None = None,
    jobs: int = 0,
    fresh: bool = False,
    progress: Callable[[int, int, str], None] | bool | None = None,
    stop: Any = None,
) -> StudyResult:
    """Runs a study: a file, or a dictionary of its entries with `motor` a Motor or a path.

    Numbers in a dictionary are in SI units, texts carry their unit; its paths are relative to the current folder.
    With a directory everything is kept there, and an interrupted run goes on; `fresh` starts anew. Without one it is
    kept in memory. `metrics` are functions of yours by their names in the study, OwnMetric where there is a unit or a
    gradient; a study with them is kept in memory. `set` replaces parameters of the motor. `progress` is told the evaluations, their total (0: not
    known) and the best so far; True shows them in the notebook or on the terminal. Ctrl-C ends the run; `stop`, such as
    a threading.Event, ends it with the outcome 'interrupted' and the rows so far. FileError says everything that is wrong.
    """
    folder = "" if directory is None else os.fspath(directory)
    how = (folder, _settings(set or {}), jobs, fresh, progress, stop)
    if isinstance(study, Study):
        motor = study.motor if motor is None else motor
        metrics = study.metrics if metrics is None else metrics
        study = study.entries
    if isinstance(study, Mapping):
        summary, text, table, html = _twum.run_entries(_entries(study, motor), motor, _own(metrics), *how)
    elif metrics:
        raise _twum.InputError("metrics: a study file cannot have functions; give the study as a dictionary")
    elif motor is not None:
        raise _twum.InputError("motor: a study file names its motor; give `set` to change parameters")
    else:
        summary, text, table, html = _twum.run_file(os.fspath(study), *how)
    rows = _kept_rows(pathlib.Path(folder)) if table is None else _rows(table)
    return StudyResult(summary, rows, text, None if directory is None else folder, html)


class ProgressLine:
    """Shows the progress of a run in one place: under IPython as a display that is replaced, elsewhere on standard error."""

    def __init__(self) -> None:
        self._display: Any = None
        self._typed = False

    def __call__(self, done: int, total: int, best: str) -> None:
        words = f"{done} of {total} evaluations" if total else f"{done} evaluations"
        self._show(f"{words}, best {best}" if best else words)

    def end(self) -> None:
        """Leaves the line, so that what is printed next begins below."""
        if self._typed:
            print(file=sys.stderr, flush=True)

    def _show(self, words: str) -> None:
        shell = sys.modules.get("IPython")
        plain = {"text/plain": words}
        if shell is None or shell.get_ipython() is None:
            self._typed = True
            print(f"\r{words:<78}", end="", file=sys.stderr, flush=True)
        elif self._display is None:
            self._display = shell.display.display(plain, raw=True, display_id=True)
        else:
            self._display.update(plain, raw=True)


class Study:
    """A question about a motor, made of a dictionary with the entries of a study file.

        study = twum.Study({"kind": "sweep", ...}, motor="ring-60.yaml")
        study.check()
        study.run("results/sweep").to_frame()

    Numbers are in SI units, texts carry their unit. `motor` is a Motor, the path of a motor file or a dictionary of its
    entries. `metrics` are functions of yours, as of run(), which also runs the file of a study.
    """

    def __init__(self, entries: Mapping[str, Any], motor: Any = None, metrics: OwnMetrics | None = None) -> None:
        if not isinstance(entries, Mapping):
            raise TypeError(f"study: expected a dictionary, not {type(entries).__name__}; twum.run() runs a study file")
        self.entries: dict[str, Any] = dict(entries)
        self.motor: Any = motor
        self.metrics = metrics

    def __repr__(self) -> str:
        asked = self.entries.get("study", self.entries)
        return f"<twum.Study {asked.get('kind')!r} of {self.motor!r}>"

    def text(self) -> str:
        """The text of a study file with these entries."""
        return str(_twum.study_text(_entries(self.entries, self.motor), self.motor))

    def check(self, *, set: Mapping[str, Any] | None = None) -> list[str]:
        """Reads the study and the files that it names without running it, and returns notes on them.

        FileError says everything that is wrong.
        """
        return _twum.check_entries(
            _entries(self.entries, self.motor), self.motor, _own(self.metrics), _settings(set or {})
        )

    def run(self, directory: str | os.PathLike[str] | None = None, **how: Any) -> StudyResult:
        """Runs it as run() does, with the same arguments."""
        return run(self, directory, **how)
