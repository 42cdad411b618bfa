# SPDX-License-Identifier: Apache-2.0
"""What a report says a limit is worth, against the study run again with that limit moved: worth_test.py TWUM"""
import csv
import json
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import ROOT, Page, main, twum  # noqa: E402

# One slice. Over the width of the contact the knee lies nearer to the end of a range than a step of a limit moves it.
NARROW = ("--set", "radial_slices=1")


class Worth(Page):
    """What the page says a limit is worth, against searches of their own with that limit moved to both sides."""

    # Limit as the page names it: what stands in the study, its value, and which way is looser.
    LIMITS = {
        "no_load_speed >= 100 rpm": (">= {} rpm", 100, -1),
        "wear_intensity_at(80 rpm) <= 5 kW/m^2": ("<= {} kW/m^2", 5, 1),
        "preload": ("max: {} N", 300, 1),
        "kinetic_friction": ("max: {}}}", 0.35, 1),
        "amplitude": ("max: {} um", 2.2, 1),
        "youngs_modulus": ("max: {} GPa", 20, 1),
        "thickness": ("min: {} mm", 0.1, -1),
    }
    STEP = 1e-3
    # Of a symmetric difference with such a step the error is the third derivative times STEP^2, while
    # a search ends within 1e-8 of its value, some 1e-6 of the least difference here: 1 % is ample.
    WITHIN = 0.01

    def best_of(self, text):
        path = self.folder / "moved.yaml"
        path.write_text(text.replace("../motors", str(ROOT / "examples/motors")))
        shutil.rmtree(self.folder / "moved", ignore_errors=True)
        twum("run", path, *NARROW, "-o", self.folder / "moved")
        return json.loads((self.folder / "moved" / "summary.json").read_text())["best"]["metrics"]

    def worth(self, name, text, metric):
        """Change of a metric of the best design when the limit is loosened by 1 %."""
        form, value, looser = self.LIMITS[name]
        self.assertIn(form.format(value), text)
        ends = [self.best_of(text.replace(form.format(value), form.format(repr(value * (1 + looser * side * self.STEP)))))[metric] for side in (1, -1)]
        return (ends[0] - ends[1]) / (2 * self.STEP) * 0.01

    def bound(self):
        """Cells of the limits that bind."""
        limits = {name: cells for name, cells in self.table("limits").items() if cells[0] == "binds"}
        self.assertLess(1, len(limits))
        return limits

    def same(self, said, found, name):
        self.assertAlmostEqual(said, found, delta=self.WITHIN * abs(found), msg=name)

    def test_gains_of_an_optimum(self):
        self.open(self.result("optimize-ring-60", *NARROW))
        text = (ROOT / "examples/studies/optimize-ring-60.yaml").read_text()
        limits = self.bound()
        self.assertEqual(len(limits), 5)
        for name, cells in limits.items():
            self.same(cells[4], self.worth(name, text, "peak_power"), name)

    def one_goal(self, goal, limit):
        """The study of the front as an optimization of one goal."""
        head, rest = (ROOT / "examples/studies/pareto-power-wear.yaml").read_text().split("  objectives:")
        constraints = rest.split("  constraints:")[1].split("  points:")[0]
        return head.replace("kind: pareto", "kind: optimize") + f"  {goal}\n  constraints:{constraints}{limit}"

    def test_gains_at_the_knee_are_those_of_one_goal_with_the_other_held(self):
        summary = self.open(self.result("pareto-power-wear", *NARROW))
        self.assertIn("knee", self.text("#chosen h2"))
        knee = summary["front"][summary["knee"]]["metrics"]
        wear = "wear_intensity_at(80 rpm)"
        held_wear = self.one_goal("maximize: peak_power", f"    - {wear} <= {knee[wear]!r} W/m^2\n")
        held_power = self.one_goal(f"minimize: {wear}", f"    - peak_power >= {knee['peak_power']!r} W\n")
        for name, cells in self.bound().items():
            self.same(cells[4], self.worth(name, held_wear, "peak_power"), name)
            self.same(cells[5], self.worth(name, held_power, wear), name)

    def test_gains_at_an_end_are_those_of_its_goal_alone(self):
        summary = self.open(self.result("pareto-power-wear", *NARROW))
        self.browser.value("document.querySelector('[data-chart=parallel]').parallel.choose(%d)" % summary["ends"][0])
        self.browser.settle()
        self.assertIn("largest peak power", self.text("#chosen h2"))
        limits = self.bound()
        self.assertIn("amplitude", limits)
        for name, cells in limits.items():
            self.same(cells[4], self.worth(name, self.one_goal("maximize: peak_power", ""), "peak_power"), name)

    def test_a_whole_number_at_the_end_of_its_range_is_named(self):
        # The example has its best within the range; with one wave less allowed it lies at the end.
        waves = int(json.loads((self.result("size-05Nm-100rpm", *NARROW) / "summary.json").read_text())["best"]["design"]["wavelengths"])
        self.assertLess(waves, 11)
        end = waves - 1
        text = (ROOT / "examples/studies/size-05Nm-100rpm.yaml").read_text()
        self.assertIn("max: 11}", text)
        self.best_of(text.replace("max: 11}", f"max: {end}}}"))
        directory = self.folder / "moved"
        summary = self.open(directory)
        self.assertEqual(summary["best"]["design"]["wavelengths"], end)
        line = next(l for l in self.lines(".holders li") if l.startswith(f"number of wavelengths ≤ {end}"))
        # The best with one wavelength less, from the table of results: those that carry the duty within the limits.
        with open(directory / "results.csv", newline="") as file:
            rows = [{k.split(" [")[0]: v for k, v in r.items()} for r in csv.DictReader(file)]
        rows = [r for r in rows if r["status"] == "ok" and float(r["wavelengths"]) == end - 1]
        slack = 1 - 1e-6  # to which a search meets its limits
        keep = [float(r["max_pressure"]) for r in rows if float(r["torque_at(100 rpm)"]) >= 0.5 * slack and float(r["efficiency_at(0.5 N.m)"]) >= 0.2 * slack
                and float(r["wear_intensity_at(100 rpm)"]) <= 1e4 / slack and float(r["layer_aspect"]) <= 0.1 / slack]
        self.assertIn(f"{min(keep) / 1e6:.4g} MPa", line)


class Newcomer(Page):
    """What is best, what stops it, what would one gain by moving it: said on top of the page, with units."""

    def knee_power(self):
        """Peak power [W] of the point farthest beyond the line through the ends of the front."""
        front = json.loads((self.result("pareto-power-wear") / "summary.json").read_text())["front"]
        points = [(p["metrics"]["peak_power"], p["metrics"]["wear_intensity_at(80 rpm)"]) for p in front]
        (p0, w0), (p1, w1) = points[0], points[-1]
        return max(points, key=lambda point: (w1 - w0) * (point[0] - p0) / (p1 - p0) - (point[1] - w0))[0]

    def test_the_words_on_top_answer_the_three_questions(self):
        # Of this motor, and of the one that the study has found.
        before, best = (json.loads(twum("curve", motor, "--points", 2, "--format", "json").stdout)["metrics"]["peak_power"]
                        for motor in (ROOT / "examples/motors/ring-60.yaml", self.result("optimize-ring-60") / "best.yaml"))
        expected = {
            "optimize-ring-60": (rf"best design found has a peak power of {best:.4g} W, against {before:.4g} W before",
                                 r"Most restrictive limit: no-load speed ≥ 100 rpm: 1 % looser, at 99 rpm, changes peak power by \+\d+ mW"),
            "size-05Nm-100rpm": (r"best design found has a max pressure of 1\.\d+ MPa",
                                 r"contact radius ≤ 30 mm, the end of its range: 1 % looser, at 30\.3 mm, changes max pressure by -\d"),
            "pareto-power-wear": (rf"knee has peak power {self.knee_power():.3g} W",
                                  r"preload ≤ 300 N, the end of its range: 1 % looser, at 303 N, changes peak power by \+\S+ m?W "
                                  r"\(\S+ %\) or wear intensity at 80 rpm by -"),
            "tolerances": (r"90\.\d+ % of the motors keep every limit",
                           r"stall torque ≥ 750 mN·m: kept by \S+ % of the motors; loosened by 1 %, to 742\.5 mN·m, the yield is 9\d\.\d+ %"),
        }
        for name, patterns in expected.items():
            with self.subTest(name):
                self.open(self.result(name))
                answer, worth = patterns
                self.assertRegex(self.text(".verdict"), answer)
                self.assertRegex(self.text("main"), worth)
                # Two sentences, and the word that says what the colour means.
                self.assertEqual(len(self.lines(".verdict > p:not(.pill)")), 2)
                self.assertTrue(self.text(".verdict .pill"))

    def test_two_efficiencies_are_told_apart(self):
        self.open(self.result("optimize-ring-60"))
        self.assertIn("Efficiency also includes the loss in the vibrating stator, so it is smaller", self.text("main"))

    def test_parts_of_the_motor_are_named(self):
        self.open(self.result("optimize-ring-60", *NARROW))
        self.assertIn("contact layer thickness ≥ 100 µm, the end of its range", self.text("main"))


if __name__ == "__main__":
    main()
