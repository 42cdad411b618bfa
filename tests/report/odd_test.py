# SPDX-License-Identifier: Apache-2.0
"""Report pages of answers that are none, or hardly one, and of very many motors: odd_test.py TWUM"""
import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import ROOT, RPM, Page, main, twum  # noqa: E402

RING = ROOT / "tests/data/motors/ring-60.yaml"


class Study(Page):
    def study(self, name, entries, settings="", motor=RING):
        """Runs a study of a motor and opens its page; its summary."""
        (self.folder / f"{name}.yaml").write_text(f"twum: 1\nmotor: {motor}\n{settings}study: {{{entries}}}\n")
        twum("run", self.folder / f"{name}.yaml", "-o", self.folder / name)
        return self.show(name)

    def show(self, name, **options):
        summary = self.open(self.folder / name, **options)
        self.clean(self.folder / name)
        return summary

    def stored(self, name):
        with open(self.folder / name / "results.csv", newline="") as file:
            return [{key.split(" [")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]


class Odd(Study):
    """Answers that are none, or hardly one."""

    STUDIES = {
        "infeasible": ("optimize", "variables: {preload: {min: 60 N, max: 300 N}}, maximize: peak_power, "
                       "constraints: [no_load_speed >= 400 rpm, stall_torque >= 0.8 N.m]", "No design keeps every limit"),
        "no-front": ("pareto", "variables: {preload: {min: 60 N, max: 300 N}}, objectives: [{maximize: peak_power}, "
                     "{minimize: max_pressure}], constraints: [no_load_speed >= 400 rpm]", "cannot be reached: the most found"),
        "free": ("optimize", "variables: {preload: {min: 60 N, max: 300 N}}, maximize: peak_power", "preload ≤ 300 N, the end of its range"),
        "one-variable": ("sweep", "sampling: grid, variables: {preload: {min: 0.001 N, max: 3 kN, points: 5}}, "
                         "metrics: [speed_at(0.9 N.m)]", "5 designs, 1 of them failed or incomplete"),
        "dead": ("curve", "points: 5", "cannot drive a load"),
    }

    def test_pages_say_so(self):
        for name, (kind, entries, words) in self.STUDIES.items():
            with self.subTest(name):
                self.study(name, f"kind: {kind}, {entries}", 'set: {kinetic_friction: "0"}\n' if name == "dead" else "")
                self.assertIn(words, self.text(".verdict"))

    def test_a_motor_whose_peak_power_cannot_be_computed_is_not_said_to_drive_no_load(self):
        summary = self.study("no-peak", "kind: curve, points: 5", "set: {loss_factor: 0.001, static_friction: 0.4}\n")
        self.assertIsNone(summary["curves"][0]["metrics"]["peak_power"])
        self.assertGreater(summary["curves"][0]["metrics"]["stall_torque"], 0.5)
        self.assertRegex(self.text(".verdict"), r"has no peak power that could be computed\. Its stall torque is \d+ mN·m\.")
        self.assertNotIn("cannot drive a load", self.text(".verdict"))
        self.assertIn("Points: failed or incomplete", self.lines("h2"))
        # What a reason means is said with the words that the program has for it.
        meanings = self.browser.value("data.reasons")
        self.assertEqual(set(meanings), {"undefined", "unreachable", "no-periodic-state", "not-converged", "resonance", "unresolved", "inaccurate", "out-of-range",
                                        "pulled-out", "no-running-branch", "no-dead-branch", "unstable-amplitude", "backward-wave-unknown", "does-not-pull-out",
                                        "torque-out-of-reach", "voltage-too-low", "amplitude-too-low", "outside-frequency-range", "thermally-unstable", "temperature-out-of-range",
                                          "no-steady-temperature", "too-hot-at-no-load", "never-too-hot", "does-not-wear", "does-not-start", "does-not-stop", "wear-localizes"})
        self.assertEqual(self.lines("[data-table=failures] td")[:2], ["no-periodic-state", meanings["no-periodic-state"]])

    def test_points_of_curves_are_not_counted_as_motors(self):
        self.study("family", "kind: curve, points: 3, family: {preload: [100 N, 160 N, 220 N]}")
        self.assertIn("points computed9", self.text(".facts"))
        self.assertIn("3 motors", self.text(".verdict"))

    def test_a_front_without_a_knee_says_so_and_begins_at_an_end(self):
        front = "kind: pareto, variables: {preload: {min: 60 N, max: 300 N}}, objectives: [{maximize: stall_torque}, {minimize: max_pressure}], points: 5"
        self.assertIsNone(self.study("no-knee", front)["knee"])
        self.assertIn("The front has no knee", self.text(".verdict"))
        self.assertRegex(self.text(".verdict"), "It runs from .+ to .+\\.")
        self.assertEqual([t for t in [self.text("#chosen h2"), *self.lines("[data-table=front] td")] if "knee" in t], [])
        self.assertIn("Point 1", self.text("#chosen h2"))


class ZeroLimit(Study):
    """A limit at 0, of which a millionth is nothing."""

    STUDY = ("kind: optimize, solver: nlopt:cobyla, variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 0.8 um, max: %s}}, "
             "minimize: no_load_speed, constraints: [torque_at(120 rpm) >= 0 N.m]")

    def shown(self):
        return self.table("limits")["torque_at(120 rpm) >= 0 N.m"]

    def test_it_is_kept_where_the_certificate_says_so(self):
        summary = self.study("zero", self.STUDY % "2.2 um")
        self.assertTrue(summary["best"]["certificate"]["passed"])
        self.assertIn("torque at 120 rpm ≥ 0 N·m: moved to -", self.text(".verdict"))
        # The best is among those that keep every limit, and the best of the chart: others within the same tolerance are
        # nearer than 1e-6 to it.
        inside = self.browser.value("""(() => { const at = (name) => rows.columns.find((c) => c.name === name).values; const best = summary.best.design;
            const kept = document.querySelector('[data-chart=search]').plot.data[2];
            return kept.filter((_, i) => at('preload')[i] === best.preload && at('amplitude')[i] === best.amplitude); })()""")
        self.assertLess(0, len(inside))
        self.assertNotIn(None, inside)
        best = self.browser.value("document.querySelector('[data-chart=search]').plot.data[3].at(-1)") * RPM
        self.assertAlmostEqual(best, summary["best"]["metrics"]["no_load_speed"], delta=1e-6 * best)
        self.assertEqual(self.shown()[0], "binds")

    def test_it_is_broken_by_as_much_as_the_motor_misses_it(self):
        unreachable = self.study("unreachable", self.STUDY % "1 um")
        self.assertRegex(self.shown()[0], "broken by .*mN·m")
        self.assertEqual(self.shown()[2], -unreachable["best"]["constraints"][0]["violation"])


class Calibration(Study):
    STUDY = "kind: calibrate, data: %s.csv, variables: {kinetic_friction: {min: 0.05, max: %s}}"

    def calibrate(self, name, points, most="0.5"):
        (self.folder / f"{name}.csv").write_text("speed [rpm],torque [N.m]\n" + points)
        return self.study(name, self.STUDY % (name, most))

    def test_points_at_negative_speeds_are_on_the_chart_with_the_curve_through_them(self):
        summary = self.calibrate("negative", "-40,0.86\n-10,0.852\n20,0.85\n60,0.84\n100,0.83\n")
        low, high = self.scale("fit", "x")
        self.assertLess(low, -40)
        self.assertGreater(high, 100)
        speeds, torques = (self.browser.value("data.sections[0].charts[0].series[0].%s" % name) for name in "xy")
        # The curve begins and ends at a point: the same motor at the same speed, to the seven digits of a chart.
        for at, point in ((0, summary["data"][0]), (-1, summary["data"][-1])):
            self.assertAlmostEqual(speeds[at], point["speed"], delta=1e-6 * abs(point["speed"]))
            self.assertAlmostEqual(torques[at], point["fitted"], delta=1e-6 * point["fitted"])

    def test_one_point_leaves_nothing_undetermined_but_freedom(self):
        summary = self.calibrate("one", "60,0.84\n")
        self.assertEqual([(e["remark"], e["low"]) for e in summary["estimates"].values()], [("hardly determined", None)])
        self.assertRegex(self.text(".verdict"), r"The points do not determine all of these parameters. The best fit has kinetic friction 0\.\d+ \(hardly determined\)\.")
        # Without an interval there is no band either, rather than one without width.
        self.assertEqual(self.lines(".legend")[0], "fitmeasured")
        self.assertEqual(self.browser.value("document.querySelector('[data-chart=fit]').plot.data.length"), 1 + 2)

    def test_an_estimate_at_an_end_of_its_range_is_said_to_be_held(self):
        self.calibrate("held", "60,0.84\n", "0.1")
        self.assertIn("kinetic friction 0.1 (at its max)", self.text(".verdict"))


    def test_an_outlier_is_marked_among_the_points(self):
        speeds = range(10, 140, 10)
        truth = [0.848, 0.848, 0.847, 0.846, 0.845, 0.843, 0.840, 0.834, 0.824, 0.806, 0.770, 0.690, 0.520]
        wrong = "".join(f"{s},{t - (0.2 if s == 50 else 0)}\n" for s, t in zip(speeds, truth))
        summary = self.calibrate("outlier", wrong)
        self.assertEqual([summary["data"][o["point"]]["where"] for o in summary["outliers"]], ["outlier.csv:6"])
        marked = [row for row in self.lines("[data-table=points] tr") if "outlier" in row]
        self.assertEqual(len(marked), 1)
        self.assertIn("50 rpm", marked[0])
        self.assertIn("contact radius", " ".join(self.lines("[data-table=moves] tr")))

    def test_each_kind_of_data_has_a_chart_of_residuals(self):
        (self.folder / "kinds.csv").write_text("torque [N.m],speed_at [rpm],speed_at_sd [rpm],no_load_speed [rpm],no_load_speed_sd [rpm]\n"
                                               "0.1,138,1,141,1\n0.3,133,1,140,1\n0.5,127,1,142,1\n")
        self.study("kinds", "kind: calibrate, data: kinds.csv, starts: 1, variables: {amplitude: {min: 1 um, max: 2.2 um}}")
        self.assertTrue(self.browser.value("['speed_at', 'no_load_speed'].every((n) => document.querySelector(`[data-chart='residuals ${n}']`))"))

    def test_each_table_has_a_value_and_a_curve_of_its_own(self):
        for name, torque in (("left", 0.84), ("right", 0.74)):
            (self.folder / (name + ".csv")).write_text("speed [rpm],torque [N.m]\n" + "".join(f"{s},{torque + d}\n" for s, d in ((2, 0.002), (4, -0.003), (6, 0.001))))
        summary = self.study("tables", "kind: calibrate, data: [left.csv, right.csv], starts: 1, per_file: [kinetic_friction], "
                             "variables: {kinetic_friction: {min: 0.05, max: 0.5}}")
        self.assertEqual([e["file"] for e in summary["estimates"].values()], ["left.csv", "right.csv"])
        rows = " ".join(self.lines("[data-table=estimates] tr"))
        self.assertTrue("kinetic friction (left.csv)" in rows and "kinetic friction (right.csv)" in rows, rows)
        self.assertTrue({"left.csv", "right.csv"} <= set(" ".join(self.lines(".legend")).replace("csv", "csv ").split()), self.lines(".legend"))

        # One chart of both tables: a curve, its points and the two edges of its band for each, over the speed.
        self.assertEqual(self.browser.value("document.querySelector('[data-chart=fit]').plot.data.length"), 1 + 4 * 2)
        self.assertRegex(" ".join(self.lines("[data-table=plan] tr")), r"\((left|right)\.csv\)")
        # The plateau is linear in the friction: the profile is 1 where the interval ends.
        for name, e in summary["estimates"].items():
            self.assertEqual(self.browser.value(f"Boolean(document.querySelector('[data-chart=\"profile {name}\"]').plot)"), True)
            for end in (e["low"], e["high"]):
                rise = self.browser.value(f"(({{x, y}}) => y[x.findIndex((v) => Math.abs(v / {end!r} - 1) < 1e-6)])"
                                          f"(data.sections.flatMap((s) => s.charts).find((c) => c.name === 'profile {name}').series[0])")
                self.assertAlmostEqual(rise, 1, delta=1e-6)

    def test_an_impedance_circle_has_its_parts_and_itself(self):
        # 1 / (R + jX) beside a capacitance, about the resonance of drive-60.
        rows = "frequency [Hz],conductance [S],conductance_sd [S],susceptance [S],susceptance_sd [S]\n"
        for f in range(38700, 39301, 60):
            y = 1 / complex(132, 132 * 153 * (f / 39000 - 39000 / f)) + 2j * math.pi * f * 8.5e-9
            rows += f"{f},{y.real},1e-4,{y.imag},1e-4\n"
        (self.folder / "circle.csv").write_text(rows)
        summary = self.study("circle", "kind: calibrate, data: circle.csv, starts: 1, variables: {quality_factor: {min: 50, max: 400}, "
                             "modal_mass: {min: 10 g, max: 60 g}}", motor=ROOT / "tests/data/motors/drive-60.yaml")
        self.assertEqual(len(summary["data"]), 22)
        for chart in ("fit conductance", "fit susceptance", "circle"):
            self.assertTrue(self.browser.value(f"Boolean(document.querySelector('[data-chart=\"{chart}\"]').plot)"), chart)
        # Round: both axes have the same length for a millisiemens, to a pixel or two of more than 300.
        plot = "document.querySelector('[data-chart=circle]').plot"
        along, up = (self.browser.value(f"{plot}.bbox.{side} / ({plot}.scales.{axis}.max - {plot}.scales.{axis}.min)")
                     for side, axis in (("width", "x"), ("height", "y")))
        self.assertAlmostEqual(along / up, 1, delta=0.01)

    def test_without_data_the_page_is_the_plan(self):
        summary = self.study("first", "kind: calibrate, variables: {kinetic_friction: {min: 0.05, max: 0.5}}")
        self.assertEqual(len(summary["plan"]), 10)
        self.assertIn("Nothing is measured yet", self.text(".verdict"))
        self.assertEqual(self.lines("[data-table=estimates]"), [])
        self.assertIn("The first measurements", self.lines("h2"))


class Moves(Study):
    def test_an_optimum_says_how_it_changes_with_what_is_fixed(self):
        self.study("moves", "kind: size, variables: {preload: {min: 60 N, max: 300 N}}, duty: [{torque: 0.5 N.m, speed: 20 rpm}]")
        row = next(row for row in self.lines("[data-table=moves] tr") if "kinetic friction" in row)
        # Torque is mu F r: 1 % more friction takes 1 % less preload.
        self.assertIn("-1 %", row)


class TwoLimits(Study):
    def test_no_bar_of_a_histogram_is_on_both_sides_of_either_limit(self):
        windows = {"wide": (0.8, 0.9), "near": (0.84, 0.85), "least": (0.8, 5), "most": (0.1, 0.9), "none": (0.9, 0.8), "exact": None}
        for name, window in windows.items():
            # At last limits that two motors meet exactly.
            least, most = window or sorted(values)[300::1300]
            with self.subTest(name):
                self.study("two-" + name, "kind: uncertainty, samples: 2000, variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}, "
                           f"metrics: [stall_torque], limits: [stall_torque >= {least} N.m, stall_torque <= {most} N.m]")
                kept, failed = self.browser.value("(() => { const d = document.querySelector('[data-chart^=histogram]').plot.data; return [d[1], d[2]]; })()")
                self.assertEqual([i for i, (k, f) in enumerate(zip(kept, failed)) if k and f], [])
                values = [float(row["stall_torque"]) for row in self.stored("two-" + name)]
                inside = sum(least <= v <= most for v in values)
                self.assertEqual([sum(filter(None, kept)), sum(filter(None, failed))], [inside, len(values) - inside])


class Many(Study):
    """More than the 100,000 motors that a page holds: a part of them, which it never takes for all."""

    # Every second point of a Sobol sequence, as with any even step, lies in one half of a variable's range.
    SWEEP = ("kind: sweep, sampling: sobol, samples: %d, metrics: [max_pressure], "
             "variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 1 um, max: 2 um}}")

    def test_designs_keep_their_numbers_and_fill_the_space(self):
        summary = self.study("designs", self.SWEEP % 100003)
        self.assertIn("This page holds one in 2 of the 100003 motors that were computed; results.csv has all of them.", self.text(".verdict"))
        stored = self.stored("designs")
        self.assertEqual(self.browser.value("rows.count"), 50002)
        self.browser.value("save = (name, text) => { window.saved = text; }; [...document.querySelectorAll('.save')].find((b) => b.textContent === 'Save as CSV' && b.closest('section').querySelector('[data-table=designs]')).click()")
        saved = list(csv.DictReader(self.browser.value("window.saved").splitlines()))
        self.assertEqual(len({row["design"] for row in saved}), 50002)
        for row in saved:
            of = stored[int(row["design"]) - 1]
            self.assertEqual([float(row[k]) for k in ("preload [N]", "amplitude [m]", "max_pressure [Pa]")], [float(of[k]) for k in ("preload", "amplitude", "max_pressure")])
        self.fills_the_space("Array.from({length: rows.count}, (_, i) => i)", 50002)
        self.first_design(summary, stored)
        self.table_of_designs(stored)
        self.densities_of_all(stored)

    def densities_of_all(self, stored):
        """The picture counts every design, not those on the page; what is chosen is of those, and the page says so."""
        self.assertIn("The colours count all 100003 designs; selecting and pointing use the 50002 designs on this page", self.text("main"))
        cells, lows = self.browser.value("(() => { const c = countsOf(0, 1); return [Array.from({length: c.n}, (_, i) => Array.from({length: c.n}, (_, j) => c.at(i, j))), [...c.x]]; })()")
        preloads = [float(row["preload"]) for row in stored]
        self.assertEqual(sum(map(sum, cells)), len(stored))
        # A column of cells holds the designs between its edges; those on an edge by rounding may be in either.
        for i in (0, 37, 99):
            inside = sum(lows[i] <= p < lows[i + 1] or i == 99 and p == lows[100] for p in preloads)
            self.assertAlmostEqual(sum(cells[i]), inside, delta=2)
        turned = self.browser.value("(() => { const c = countsOf(1, 0); return c.at(3, 37); })()")
        self.assertEqual(turned, cells[37][3])
        self.assertGreater(self.colours("[data-chart=scatter] canvas")[0], 20)

    def fills_the_space(self, which, least):
        """As many rows in either half of each range, to 5 standard deviations of a fair coin."""
        for name, middle in (("preload", 180), ("amplitude", 1.5e-6)):
            values = self.browser.value("(() => { const { values } = rows.columns.find((c) => c.name === '%s'); return %s.map((i) => values[i]); })()" % (name, which))
            self.assertLessEqual(least, len(values))
            self.assertAlmostEqual(sum(v < middle for v in values), len(values) / 2, delta=2.5 * len(values) ** 0.5)

    def test_lines_drawn_of_many_fill_the_space(self):
        self.study("lines", self.SWEEP % 6000)
        self.assertIn("one in 4 of them is drawn", self.text("main"))
        self.assertEqual(self.browser.value("rows.count"), 6000)
        self.fills_the_space("(() => { const p = document.querySelector('[data-chart=parallel]').parallel; const seen = []; p.line = (_, i) => seen.push(i); p.draw(); return seen; })()", 1500)

    def first_design(self, summary, stored):
        """The one shown first has the most of a metric, and is not taken for another."""
        number = int(self.browser.value("document.querySelector('[data-design]').textContent.match(/Design (\\d+)/)[1]"))
        said = self.browser.value("engineering(%r, 'Pa')" % float(stored[number - 1]["max_pressure"])).replace("\u00a0", " ")
        self.assertIn("max pressure" + said, self.text("[data-design]"))
        top = summary["metrics"]["max_pressure"]["highest"]["row"] + 1
        held = set(self.browser.value("Array.from({length: rows.count}, (_, i) => rowNumber(i))"))
        if top in held:
            self.assertEqual(number, top)
        else:
            self.assertEqual(number, max(held, key=lambda n: float(stored[n - 1]["max_pressure"])))
            self.assertIn(f"the highest max pressure on this page; that of all is design {top}", self.text("[data-design]"))

    def table_of_designs(self, stored):
        self.assertIn("results.csv has every design", self.text("main"))
        lines = self.table("designs")
        self.assertEqual(len(lines), 100)
        for number, (preload, *_) in lines.items():
            self.assertEqual(preload, float(stored[int(number) - 1]["preload"]))

    def test_a_yield_after_loosening_is_told_from_the_yield_of_all(self):
        self.study("yield", "kind: uncertainty, samples: 100003, variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}, "
                             "metrics: [max_pressure], limits: [max_pressure <= 2.15 MPa, contact_half_length >= 0.1 mm]")
        self.assertIn("one in 2 of the 100003 motors", self.text(".verdict"))
        tight, inactive = self.lines(".holders li")[:2]
        self.assertIn("kept by 100 % of the motors; loosening it by 1 % changes nothing", inactive)
        pressures = [float(row["max_pressure"]) for row in self.stored("yield")]
        said = float(tight.split("the yield is ")[1].split(" %")[0]) / 100
        # Of all motors, not only of those that the page holds, to four digits of a percentage.
        self.assertAlmostEqual(said, sum(p <= 1.01 * 2.15e6 for p in pressures) / len(pressures), delta=5.1e-5)


if __name__ == "__main__":
    main()
