# SPDX-License-Identifier: Apache-2.0
"""Tables of pandas and notebooks: designs as DataFrames, results as DataFrames and as HTML, studies from dictionaries."""
import contextlib
import html.parser
import io
import pathlib
import sys
import tempfile
import types
import unittest
import unittest.mock
import warnings

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
        # A text has its own unit.
        mixed = pandas.DataFrame({"contact_radius (mm)": ["20 mm", 30]})
        found = twum.evaluate(self.motor, mixed, "contact_radius")["contact_radius"]
        np.testing.assert_allclose(found, [0.02, 0.03], rtol=2e-16)

    def test_other_columns_are_told_and_not_used(self):
        frame = pandas.DataFrame({"id": ["a", "b"], "preload": [100.0, 150.0], 7: [1, 2]})
        with self.assertWarnsRegex(UserWarning, "columns that are no parameters and are not used: 'id', '7'"):
            found = twum.evaluate(self.motor, frame, "preload")
        self.assertEqual(found["preload"].tolist(), [100, 150])
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
        back = twum.evaluate(self.motor, pandas.DataFrame({"preload": [100.0]}), "preload")
        self.assertEqual(pandas.DataFrame(back)["status"].tolist(), ["ok"])


class Notebooks(unittest.TestCase):
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
        self.assertEqual([words.strip() for words in said.getvalue().split("\r")[1:]], ["3 of 10 evaluations", "4 evaluations, best 5 W"])
        shown = []
        handle = types.SimpleNamespace(update=shown.append)
        notebook = types.SimpleNamespace(get_ipython=lambda: object(),
                                         display=types.SimpleNamespace(display=lambda words, display_id: shown.append(words) or handle))
        with unittest.mock.patch.dict(sys.modules, {"IPython": notebook}):
            line = twum.results.ProgressLine()
            line(1, 2, "")
            line(2, 2, "")
        self.assertEqual(shown, ["1 of 2 evaluations", "2 of 2 evaluations"])
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(twum.run(SWEEP, motor=RING, progress=True).outcome, "done")


class Studies(unittest.TestCase):
    def test_a_study_is_made_of_a_dictionary(self):
        study = twum.Study(SWEEP, motor=RING)
        study.check()
        self.assertIn("'sweep'", repr(study))
        found, expected = study.run(), twum.run(SWEEP, motor=RING)
        self.assertEqual(found.rows["holding_torque"].tolist(), expected.rows["holding_torque"].tolist())
        self.assertEqual(study.run(set={"kinetic_friction": 0.1}).rows["holding_torque"].tolist(),
                         twum.run(study, set={"kinetic_friction": 0.1}).rows["holding_torque"].tolist())

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
