# SPDX-License-Identifier: Apache-2.0
"""Tables of pandas and notebooks: designs as DataFrames, results as DataFrames and as HTML, studies from dictionaries."""
import contextlib
import html.parser
import io
import pathlib
import re
import sys
import tempfile
import types
import unittest
import unittest.mock
import warnings
import xml.etree.ElementTree

import numpy as np
import twum

try:
    import pandas
except ImportError:
    pandas = None

RING = pathlib.Path(__file__).resolve().parents[2] / "tests/data/motors/ring-60.yaml"
SWEEP = {"kind": "sweep", "sampling": "grid", "metrics": ["holding_torque"], "variables": {"preload": ["100 N", "160 N"]}}


class Page(html.parser.HTMLParser):
    """Elements that are open and closed in order, and the texts of cells."""

    def __init__(self, text):
        super().__init__()
        self.open, self.cells, self.wrong = [], [], []
        self.feed(text)
        self.wrong += self.open

    def handle_starttag(self, tag, _):
        self.open.append(tag)
        if tag in ("td", "th"):
            self.cells.append("")

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)

    def handle_data(self, data):
        if self.open and self.open[-1] in ("td", "th", "b"):
            if self.cells and "td" in self.open or "th" in self.open:
                self.cells[-1] += data


@unittest.skipUnless(pandas, "pandas is not there")
class Frames(unittest.TestCase):
    def setUp(self):
        self.motor = twum.Motor(RING)

    def test_headings_have_units_as_in_tables(self):
        frame = pandas.DataFrame({"preload [N]": [100.0, 150.0], "contact_radius / mm": [20, 30]})
        found = twum.evaluate(self.motor, frame, "holding_torque")["holding_torque"]
        expected = 0.2 * np.array([100.0, 150.0]) * np.array([0.02, 0.03])  # mu_0 F_N r
        np.testing.assert_allclose(found, expected, rtol=4e-16)
        by_name = twum.evaluate(self.motor, dict(frame), "holding_torque")["holding_torque"]  # a dictionary reads them too
        self.assertEqual(by_name.tolist(), found.tolist())
        # A text has its own unit, or that of the heading, as the cell of a table.
        mixed = pandas.DataFrame({"contact_radius (mm)": ["20 mm", 30, "26.5"]})
        found = twum.evaluate(self.motor, mixed, "contact_radius")["contact_radius"]
        np.testing.assert_allclose(found, [0.02, 0.03, 0.0265], rtol=2e-16)
        with self.assertRaisesRegex(twum.InputError, r"column 'preload \[mm\]': 'mm' is a length"):
            twum.evaluate(self.motor, pandas.DataFrame({"preload [mm]": [100.0]}), "preload")

    def test_cells_without_a_value_are_designs_without_one(self):
        for cells in (["100 N", None], pandas.array([100, None], dtype="Int64"), [100.0, float("nan")]):
            for heading in ("preload", "preload [N]"):
                found = twum.evaluate(self.motor, pandas.DataFrame({heading: cells}), "preload")
                self.assertEqual(found["preload"][0], 100)
                self.assertIn("must be a finite number", found["status"][1])
        with self.assertRaises(TypeError):  # not by hand
            twum.evaluate(self.motor, {"preload": ["100 N", None]}, "preload")

    def test_a_parameter_is_given_once(self):
        twice = pandas.DataFrame([[100.0, 150.0]], columns=["preload [N]", "preload [N]"])
        with self.assertRaisesRegex(twum.InputError, r"two columns have the heading 'preload \[N\]'"):
            twum.evaluate(self.motor, twice, "preload")
        twice.columns = ["preload [N]", "preload / N"]
        with self.assertRaisesRegex(twum.InputError, "preload is given twice"):
            twum.evaluate(self.motor, twice, "preload")

    def test_other_columns_are_told_and_not_used(self):
        frame = pandas.DataFrame({"id": ["a", "b"], "preload": [100.0, 150.0], 7: [1, 2]})
        with self.assertWarnsRegex(UserWarning, "columns that are no parameters and are not used: 'id', '7'"):
            found = twum.evaluate(self.motor, frame, "preload")
        self.assertEqual(found["preload"].tolist(), [100, 150])
        near = pandas.DataFrame({"prelod [N]": [100.0], "amplitude [um]": [1.6]})
        with self.assertWarnsRegex(UserWarning, r"'prelod \[N\]' \(did you mean 'preload'\?\)"):
            twum.evaluate(self.motor, near, "preload")
        with self.assertRaisesRegex(twum.InputError, "no column is a parameter"):
            twum.evaluate(self.motor, frame[["id"]], "preload")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(UserWarning):
                twum.evaluate(self.motor, frame, "preload")

    def test_a_letter_that_may_number_the_rows_is_refused(self):
        frame = pandas.DataFrame({"n": [1, 2], "preload": [100.0, 150.0]})
        for designs in (frame, dict(frame)):
            with self.assertRaisesRegex(twum.InputError, "does not say whether wavelengths is meant"):
                twum.evaluate(self.motor, designs, "preload")
        # Typed by hand it is the parameter.
        self.assertEqual(twum.evaluate(self.motor, {"n": [8, 9]}, "wavelengths")["wavelengths"].tolist(), [8, 9])

    def test_derivatives_take_frames_too(self):
        frame = pandas.DataFrame({"preload": [100.0, 150.0]})
        found = twum.gradients(self.motor, frame, "holding_torque")["holding_torque"]["preload"]
        np.testing.assert_allclose(found, [0.2 * 0.0265] * 2, rtol=4e-16)

    def test_results_are_frames(self):
        frame = twum.run(SWEEP, motor=RING).to_frame()
        self.assertEqual(list(frame.columns), ["preload", "holding_torque", "status"])
        np.testing.assert_allclose(frame["holding_torque"], 0.2 * 0.0265 * frame["preload"], rtol=4e-16)
        curve = self.motor.curve(points=5)
        frame = curve.to_frame()
        self.assertEqual(frame["torque"].tolist(), curve.torque.tolist())
        self.assertEqual(len(frame), 5)
        self.assertNotIn("voltage", frame)
        fields = self.motor.fields("100 rpm", samples=20)
        self.assertEqual(fields.to_frame()["pressure"].tolist(), fields.pressure.tolist())
        slopes = twum.gradients(self.motor, {"preload": [100.0, 160.0]}, "holding_torque")["holding_torque"].to_frame()
        np.testing.assert_allclose(slopes["preload"], 0.2 * 0.0265, rtol=4e-16)
        self.assertEqual(slopes["status"].tolist(), ["ok", "ok"])
        back = twum.evaluate(self.motor, pandas.DataFrame({"preload": [100.0]}), "preload")
        self.assertEqual(pandas.DataFrame(back)["status"].tolist(), ["ok"])


class Notebooks(unittest.TestCase):
    def charts_of(self, answer):
        """Charts as XML; every number in them lies within the picture or is relative to a place there."""
        text = answer._repr_html_()
        self.assertEqual(Page(text).wrong, [])
        found = re.findall(r"<svg viewBox.*?</svg>\n(?=<div)", text, re.S)
        for chart in found:
            xml.etree.ElementTree.fromstring(chart)
            self.assertNotRegex(chart, "nan|inf")
        return found

    def test_a_map_and_a_motion_are_drawn(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        drive = twum.Motor(root / "examples/motors/drive-60.yaml", radial_slices=1)
        (chart,) = self.charts_of(twum.run({"kind": "map", "points": "12x8"}, motor=drive))
        for words in ("Overall efficiency", "Speed [rpm]", "Torque [N\u00b7m]"):
            self.assertIn(words, chart.replace("\u00a0", " ").replace("\u202f", " "))
        moving = twum.Motor(root / "examples/motors/moving-60.yaml", radial_slices=1)
        self.assertGreater(len(self.charts_of(moving.move("4 ms"))), 3)

    def test_a_line_ends_where_its_last_point_lies(self):
        moving = twum.Motor(pathlib.Path(__file__).resolve().parents[2] / "examples/motors/moving-60.yaml", radial_slices=1)
        motion = moving.move("4 ms")
        chart = next(one for one in self.charts_of(motion) if ">Angle<" in one)
        points = re.search(r'<path d="M([^"]*)" fill="none" stroke="#3a8fc2"', chart)[1]
        ends = [tuple(float(x) for x in point.split()) for point in (points.split("L")[0], points.split("L")[-1])]
        # The time goes from the left end of the plane, 62, to the right one, 448. The angle begins at 0. Two ticks tell its scale.
        self.assertEqual((ends[0][0], ends[1][0]), (62, 448))
        ticks = re.findall(r'<text x="57" y="([0-9.]+)" text-anchor="end">([-0-9.]+)</text>', chart)
        (low, first), (high, last) = [(float(y) - 4, float(text)) for y, text in (ticks[0], ticks[-1])]
        unit = {"mrad": 1e-3, "rad": 1}[re.search(r"Angle \[(\w+)\]", chart)[1]]
        angle = (first + (ends[1][1] - low) / (high - low) * (last - first)) * unit
        # Places have five digits: 0.005 of some 200 pixels, twice for the ticks.
        self.assertAlmostEqual(angle / motion["angle"][-1], 1, delta=2e-4)

    def test_a_motor_is_a_table_of_its_parameters(self):
        page = Page(twum.Motor(RING, name="<b>&")._repr_html_())
        self.assertEqual(page.wrong, [])
        self.assertIn("contact radius", [cell.replace("\xa0", " ") for cell in page.cells])
        self.assertIn("26.5 mm", [cell.replace("\xa0", " ").replace("\u202f", " ") for cell in page.cells])
        self.assertNotIn("<b>&", twum.Motor(RING, name="<b>&")._repr_html_().replace("&lt;", ""))

    def test_a_result_says_in_a_notebook_what_it_says_anywhere(self):
        with tempfile.TemporaryDirectory() as folder:
            asked = {"kind": "optimize", "minimize": "preload", "variables": {"preload": {"min": "10 N", "max": "500 N"}},
                     "constraints": ["holding_torque >= 0.53 N.m"]}
            result = twum.run(asked, folder + "/out", motor=RING)
            page = Page(result._repr_html_())
            self.assertEqual(page.wrong, [])
            self.assertIn("certified local optimum", result._repr_html_())
            self.assertEqual(twum.read_result(folder + "/out")._repr_html_(), result._repr_html_())

    def test_progress_is_shown_in_one_place(self):
        line = twum.results.ProgressLine()
        with contextlib.redirect_stderr(io.StringIO()) as said:
            line(3, 10, "")
            line(4, 0, "5 W")
            line.end()
        self.assertEqual([words.strip() for words in said.getvalue().split("\r")[1:]], ["3 of 10 evaluations", "4 evaluations, best 5 W"])
        self.assertTrue(said.getvalue().endswith("\n"))
        shown = []

        def show(content, raw, **_):
            self.assertTrue(raw)  # so that the words are shown without quotation marks
            shown.append(content["text/plain"])
            return types.SimpleNamespace(update=show)

        notebook = types.SimpleNamespace(get_ipython=lambda: object(), display=types.SimpleNamespace(display=show))
        with unittest.mock.patch.dict(sys.modules, {"IPython": notebook}):
            line = twum.results.ProgressLine()
            line(1, 2, "")
            line(2, 2, "")
        self.assertEqual(shown, ["1 of 2 evaluations", "2 of 2 evaluations"])

    def test_every_call_that_takes_long_shows_its_progress(self):
        motor = twum.Motor(RING)
        problem = twum.DesignProblem(motor).vary("preload", "60 N", "300 N").maximize("holding_torque")
        calls = {
            "run": lambda: twum.run(SWEEP, motor=RING, progress=True),
            "evaluate": lambda: twum.evaluate(motor, {"preload": [100, 160]}, "holding_torque", progress=True),
            "gradients": lambda: twum.gradients(motor, {"preload": [100, 160]}, "holding_torque", progress=True),
            "solve": lambda: problem.solve(progress=True),
        }
        for name, call in calls.items():
            with self.subTest(name), contextlib.redirect_stderr(io.StringIO()) as said:
                call()
                last = said.getvalue().split("\r")[-1]
                self.assertRegex(last, "^[0-9]+ evaluations" if name == "solve" else "^2 of 2 evaluations")
                self.assertTrue(last.endswith("\n"))
        twum.evaluate(motor, {"preload": [100]}, "holding_torque", progress=False)

    def test_a_motion_says_what_happened(self):
        moving = twum.Motor(pathlib.Path(__file__).resolve().parents[2] / "examples/motors/moving-60.yaml", radial_slices=1)
        motion = moving.move("4 ms", switched_off=[("3 ms", "4 ms")])
        page = Page(motion._repr_html_())
        self.assertEqual(page.wrong, [])
        self.assertIn("the drive is switched off", page.cells)
        self.assertLess(len(repr(motion)), 2000)

    def test_numbers_are_aligned_to_the_right_and_words_to_the_left(self):
        text = twum.Motor(RING)._repr_html_()
        row = next(line for line in text.splitlines() if "radial width of the contact track" in line)
        self.assertEqual([cell.split('"')[0] for cell in row.split('text-align: ')[1:]], ["left", "right", "left"])

    def test_what_calls_return_is_said_in_a_line(self):
        motor = twum.Motor(RING, radial_slices=1)
        driven = twum.Motor(pathlib.Path(RING).with_name("drive-60.yaml"))
        problem = twum.DesignProblem(motor).vary("preload", "60 N", "300 N").maximize("peak_power").limit("max_pressure <= 3 MPa")
        said = {
            "amplitude 1.6 um": motor, "voltage 120 V": driven, "at 0 rpm: torque ": motor.point(0.0),
            "smooth": motor.gradients("holding_torque")["holding_torque"], "11 speeds": motor.curve(points=11),
            "zones slip+, stick, slip+": motor.fields("100 rpm"),
            "of sweep: done, 2 evaluations": twum.run(SWEEP, motor=RING),
            "varies preload, maximizes peak_power, limit max_pressure <= 3 MPa": problem,
        }
        for words, answer in said.items():
            with self.subTest(words):
                self.assertIn(words, repr(answer))
                self.assertNotIn("nan", repr(answer))
                self.assertLess(len(repr(answer)), 600)
        self.assertIn("holding_torque ranges from", str(twum.run(SWEEP, motor=RING)))


class Studies(unittest.TestCase):
    def test_a_study_is_made_of_a_dictionary(self):
        study = twum.Study(SWEEP, motor=RING)
        study.check()
        self.assertIn("'sweep'", repr(study))
        found, expected = study.run(), twum.run(SWEEP, motor=RING)
        self.assertEqual(found.rows["holding_torque"].tolist(), expected.rows["holding_torque"].tolist())
        self.assertEqual(study.run(set={"kinetic_friction": 0.1}).rows["holding_torque"].tolist(),
                         twum.run(study, set={"kinetic_friction": 0.1}).rows["holding_torque"].tolist())

    def test_the_motor_is_a_motor_a_path_or_entries_and_given_once(self):
        entries = {"name": "ring", "stator": {"wavelengths": 9, "contact_radius": "26.5 mm", "contact_width": 0.004,
                                              "neutral_plane_distance": "3 mm", "frequency": "40 kHz", "amplitude": "1.6 um"},
                   "contact_layer": {"thickness": 0.3e-3, "youngs_modulus": "3 GPa", "poisson_ratio": 0.35,
                                     "density": "1800 kg/m^3", "loss_factor": 0.05},
                   "friction": {"kinetic": 0.2}, "preload": "160 N"}
        for motor in (entries, RING, str(RING), twum.Motor(RING)):
            # mu_0 F_N r
            np.testing.assert_allclose(twum.Study(SWEEP, motor=motor).run().rows["holding_torque"], [0.53, 0.848], rtol=4e-16)
        both = twum.Study({"study": SWEEP, "motor": str(RING)}, motor=RING)
        with self.assertRaisesRegex(twum.InputError, "the study names one; leave out one of the two"):
            both.run()
        with self.assertRaisesRegex(TypeError, "motor: expected a Motor, a path or the entries of a motor file, not int"):
            twum.Study(SWEEP, motor=3).check()
        with self.assertRaisesRegex(TypeError, r"expected a dictionary, not str; twum.run\(\) runs a study file"):
            twum.Study("study.yaml")

    def test_a_value_that_is_none_of_a_study_is_named_by_its_entry(self):
        for value, error, words in (({"100 N"}, TypeError, r"study.variables.preload: expected .*, not set"),
                                    ([float("nan")], twum.InputError, r"study.variables.preload\[0\]: nan is not a number"),
                                    ([1j], TypeError, r"study.variables.preload\[0\]: expected .*, not complex")):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                twum.Study({**SWEEP, "variables": {"preload": value}}, motor=RING).check()

    def test_paths_may_be_of_pathlib(self):
        with tempfile.TemporaryDirectory() as folder:
            points = pathlib.Path(folder) / "points.csv"
            points.write_text("speed [rad/s],torque [N.m]\n9,0.765\n12,0.72\n14,0.355\n")
            asked = {"kind": "calibrate", "data": points, "variables": {"kinetic_friction": {"min": 0.05, "max": 0.5}}}
            twum.Study(asked, motor=RING).check()
            points.unlink()
            with self.assertRaisesRegex(twum.InputError, "points.csv: cannot be read"):
                twum.Study(asked, motor=RING).check()

    def test_its_text_is_the_same_study_as_a_file(self):
        study = twum.Study(SWEEP, motor=twum.Motor(RING, preload="120 N"))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "study.yaml"
            path.write_text(study.text())
            self.assertEqual(twum.run(path)["hash"], study.run()["hash"])

    def test_all_that_is_wrong_is_said_without_running_it(self):
        with self.assertRaises(twum.FileError) as caught:
            twum.Study({"kind": "sweep", "sampling": "grid", "metrics": ["stal_torque"], "variables": {"preload": ["1 kg"]}}, motor=RING).check()
        self.assertIn("stal_torque", str(caught.exception))
        self.assertIn("1 kg", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
