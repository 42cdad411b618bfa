# SPDX-License-Identifier: Apache-2.0
"""Every dtype and container of numbers against every argument that takes an array: taken as it is meant, or refused."""
import array
import collections
import datetime
import decimal
import fractions
import math
import unittest
import warnings

import numpy as np
import twum

MOTOR = twum.Motor()
ISSUES = (twum.InputError, TypeError)

# Each stands for 100 and 140, in SI units; torques would be beyond the motor's and give NaN.
TAKEN = {
    "list": [100.0, 140], "tuple": (100, 140.0), "range": range(100, 141, 40), "deque": collections.deque([100, 140]),
    "generator": lambda: (x for x in (100, 140)), "iterator": lambda: iter([100, 140]), "keys": {100: 0, 140: 1}.keys(),
    "array.array": array.array("d", [100, 140]), "memoryview": memoryview(array.array("i", [100, 140])),
    "of numpy scalars": [np.float32(100), np.int8(100) + np.int16(40)], "of arrays without a dimension": [np.array(100), np.array(140.0)],
    "fractions": [fractions.Fraction(200, 2), fractions.Fraction(140)], "decimals": [decimal.Decimal(100), decimal.Decimal("140")],
    "objects": np.array([100, 140.0], dtype=object), "strided": np.array([100.0, 0, 140, 0])[::2],
    "reversed": np.array([140.0, 100])[::-1], "read-only": np.frombuffer(np.array([100.0, 140]).tobytes()),
    "big-endian": np.array([100, 140], dtype=">f8"), "without a masked entry": np.ma.array([100.0, 140], mask=False),
    **{f"dtype {code}": np.array([100, 140], dtype=code) for code in ("u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g")}}

REFUSED = {
    "truth values": np.array([True, False]), "truth values in a list": [100.0, True], "numpy truth values in a list": [100.0, np.True_],
    "complex": np.array([1 + 2j, 3]), "complex in a list": [1.0, 1j], "dates": np.array(["2020-01-01"], dtype="M8[D]"),
    "durations": np.array([5], dtype="m8[s]"), "dates in a list": [datetime.date(2020, 1, 1)], "bytes": b"12",
    "bytearray": bytearray(b"12"), "array of bytes": np.array([b"1", b"2"]), "records": np.zeros(2, dtype=[("a", "f8")]),
    "masked": np.ma.array([100.0, 1e20], mask=[False, True]), "masked in a list": [100.0, np.ma.masked],
    "none": [100.0, None], "array with none": np.array([100.0, None]), "ragged": [[100.0], [100.0, 140.0]],
    "ragged arrays": [np.ones((2, 2)), np.ones((2, 3))], "set": {100.0, 140.0}, "frozenset": frozenset([100.0]), "dict": {100.0: 1},
    "object": object(), "beyond a float": [10**400], "none alone": None}

# Also where one number is asked for.
SCALARS_REFUSED = {
    "truth value": True, "numpy truth value": np.True_, "array of one truth value": np.array(True), "complex": 1 + 2j,
    "numpy complex": np.complex128(3), "date": np.datetime64("2020-01-01"), "duration": np.timedelta64(5, "s"), "bytes": b"5",
    "masked": np.ma.masked, "array of a complex": np.array(3 + 0j), "beyond a float": 10**400, "record": np.zeros((), dtype=[("a", "f8")])}


def made(values):
    return values() if callable(values) else values


def answer(call, values):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return call(made(values))


# What each call takes for the numbers it was given, in SI units, where its answer repeats them.
ECHOES = {
    "evaluate": lambda values: twum.evaluate(MOTOR, {"preload": values}, "preload")["preload"],
    "gradients": lambda values: twum.gradients(MOTOR, {"preload": values}, "preload")["preload"].value,
    "curve": lambda values: MOTOR.curve(values).speed}
POINTS = {
    "torque_at": lambda values: MOTOR.torque_at(values), "speed_at": lambda values: MOTOR.speed_at(values),
    "wear_intensity_at": lambda values: MOTOR.wear_intensity_at(values),
    "wear_intensity_at(torque)": lambda values: MOTOR.wear_intensity_at(torque=values)}
SCALARS = {
    "Motor": lambda value: twum.Motor(preload=value), "replace": lambda value: MOTOR.replace(preload=value), "point": MOTOR.point,
    "fields": MOTOR.fields, "vary": lambda value: twum.DesignProblem(MOTOR).vary("preload", 1, value),
    "start": lambda value: twum.DesignProblem(MOTOR).vary("preload", 1, 200, start=value),
    "choose": lambda value: twum.DesignProblem(MOTOR).choose("lining", {"a": {"preload": value}}),
    "run": lambda value: twum.run({"study": {"kind": "curve"}}, motor=MOTOR, set={"preload": value})}


class Arrays(unittest.TestCase):
    def test_numbers_of_every_kind_are_taken_as_they_are(self):
        for kind, values in TAKEN.items():
            for name, call in ECHOES.items():
                with self.subTest(name, kind=kind):
                    self.assertEqual(answer(call, values).tolist(), [100, 140])
            for name, call in POINTS.items():
                with self.subTest(name, kind=kind):
                    # The same numbers as doubles: the conversion of each kind to a double is exact.
                    np.testing.assert_array_equal(answer(call, values), call(np.array([100.0, 140.0])))

    def test_what_is_no_real_number_is_refused_by_name(self):
        for kind, values in REFUSED.items():
            for name, call in {**ECHOES, **POINTS}.items():
                if (name, kind) == ("curve", "none alone"):
                    continue  # a curve at speeds of its own choice
                with self.subTest(name, kind=kind), self.assertRaisesRegex(ISSUES, "preload|speed|torque|wear"):
                    answer(call, values)

    def test_one_number_is_read_as_strictly(self):
        for kind, value in SCALARS_REFUSED.items():
            for name, call in {**SCALARS, **ECHOES, **POINTS}.items():
                with self.subTest(name, kind=kind), self.assertRaises(ISSUES):
                    answer(call, value)

    def test_texts_with_units_may_stand_in_lists(self):
        for texts in (["100 N", "0.14 kN"], np.array(["100 N", "0.14 kN"]), [100, "140 N"], ("100 N", 140.0)):
            self.assertEqual(ECHOES["evaluate"](texts).tolist(), [100, 140])
        with self.assertRaisesRegex(twum.InputError, "preload: .*mass"):
            ECHOES["evaluate"](["140 N", "3 kg"])
        speeds = MOTOR.torque_at(["100 rpm", "110 rpm"])
        self.assertEqual(speeds.tolist(), [MOTOR.torque_at("100 rpm"), MOTOR.torque_at("110 rpm")])
        self.assertEqual(MOTOR.speed_at(["0.4 N.m"]).tolist(), [MOTOR.speed_at("0.4 N.m")])

    def test_shapes_are_kept_or_refused(self):
        table = np.array([[1.0, 2, 3], [4, 5, 6]])
        for values in (table, table.tolist(), np.asfortranarray(table)):
            self.assertEqual(MOTOR.torque_at(values).shape, (2, 3))
            for call in ECHOES.values():
                with self.assertRaisesRegex(twum.InputError, "one dimension"):
                    call(values)
        for call in (*ECHOES.values(), *POINTS.values()):
            for nothing in ([], np.array([]), ()):
                self.assertEqual(call(nothing).shape, (0,))

    def test_numbers_that_are_not_finite_fail_for_themselves(self):
        answers = twum.evaluate(MOTOR, {"preload": [math.nan, math.inf, 160]}, "stall_torque")
        self.assertEqual([status == "ok" for status in answers["status"]], [False, False, True])

    def test_a_study_may_hold_arrays(self):
        def swept(points, metrics):
            study = {"kind": "sweep", "sampling": "grid", "metrics": metrics,
                     "variables": {"preload": {"min": "100 N", "max": "140 N", "points": points}}}
            return twum.run({"study": study}, motor=MOTOR).rows["preload"].tolist()

        self.assertEqual(swept(np.int64(2), np.array(["stall_torque", "max_torque"])), [100, 140])
        self.assertEqual(swept(2, ["stall_torque", np.str_("max_torque")]), [100, 140])
        for wrong in (np.array([True]), np.True_, 2j, np.complex64(2), np.ma.array([2.0], mask=[True]), np.ma.masked, {2}, b"2",
                      np.datetime64("2020-01-01"), np.array([2])):
            with self.subTest(wrong=wrong), self.assertRaises(ISSUES):
                swept(wrong, ["stall_torque"])


if __name__ == "__main__":
    unittest.main()
