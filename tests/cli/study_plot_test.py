# SPDX-License-Identifier: Apache-2.0
"""twum plot: the pictures of every kind of study show the numbers of its results; what is refused."""
import csv
import json
import math
import os
import pathlib
import shutil
import struct

import program
from picture import BLUE, GREEN, VERMILION, Picture, scale
from program import DRIVE, RING, ROOT

SWEEP = """twum: 1
motor: %s
study: {kind: sweep, sampling: grid, metrics: [stall_torque, no_load_speed], variables: {%s}}
"""
PRELOAD, AMPLITUDE = "preload: {min: 60 N, max: 300 N, points: 6}", "amplitude: {min: 1 um, max: 2 um, points: 4}"
SEVERAL = """twum: 1
motor: %s
study: {kind: calibrate, data: points.csv, variables: {kinetic_friction: {min: 0.1, max: 0.4}, force_factor: {min: 0.3 N/V, max: 1 N/V}}}
"""
POINTS = """no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque [N.m],holding_torque_sd [N.m],start_voltage [V],start_voltage_sd [V]
146,1,1.04,0.01,56,3
145,1,1.05,0.01,58,3
"""


def share(value, low, high):
    return (value - low) / (high - low)


class Pictures(program.Case):
    def drawn(self, study, text=None):
        """Pictures of a study by name, and its result directory."""
        path = self.write(study + ".yaml", text) if text else ROOT / "examples/studies" / f"{study}.yaml"
        directory = self.folder / study
        made = pathlib.Path(os.environ.get("TWUM_RESULTS", "")) / study
        if text is None and (made / "summary.json").exists():  # of the tests' fixture
            shutil.copytree(made, directory)
        else:
            done = program.twum("run", path, "-o", directory)
            self.assertIn(done.returncode, (0, 1), done.stderr)
        names = [pathlib.Path(line).relative_to(directory / "plots") for line in self.ok("plot", directory).splitlines()]
        self.assertEqual(sorted(names), sorted(p.relative_to(directory / "plots") for p in (directory / "plots").iterdir()))
        pictures = {name.stem: Picture(directory / "plots" / name) for name in names if name.suffix == ".svg"}
        for name, picture in pictures.items():
            head = (directory / "plots" / f"{name}.png").read_bytes()[:24]
            self.assertEqual(struct.unpack(">II", head[16:24]), tuple(2 * side for side in picture.size), name)
        self.summary = json.loads((directory / "summary.json").read_text())
        with open(directory / "results.csv", newline="") as file:
            lines = list(csv.reader(file))
        self.columns = {name.split(" [")[0]: [float(line[i] or "nan") for line in lines[1:]] for i, name in enumerate(lines[0][:-1])}
        return pictures

    def assert_places(self, dots, xs, ys):
        """Dots lie where values do, between the first and the last of them; places have two decimals."""
        across = [x for x, _ in dots]
        up = [y for _, y in dots]
        for places, values in ((across, xs), (up, ys)):
            low, high = values.index(min(values)), values.index(max(values))
            size = abs(places[high] - places[low])
            self.assertGreater(size, 100)
            for place, value in zip(places, values, strict=True):
                self.assertAlmostEqual(share(place, places[low], places[high]), share(value, values[low], values[high]), delta=0.02 / size)

    def assert_parallel(self, picture, columns):
        """A line for each design, which crosses each axis where the value lies between the lowest and the highest."""
        lines = [piece for piece in picture.pieces[BLUE] if len(piece) == len(columns)]
        self.assertEqual(len(lines), len(columns[0]))
        for k, values in enumerate(columns):
            low, high = min(values), max(values)
            # What differs by rounding alone stands in the middle of the page.
            one = high - low <= 1e-6 * max(abs(low), abs(high))
            self.assertEqual(len({line[k][1] for line in lines}), 1)
            for line, value in zip(lines, values):
                # From 30 to 690 points across the page, written with two decimals.
                self.assertAlmostEqual(line[k][0], 30 + 660 * (0.5 if one else share(value, low, high)), delta=0.02 if not one else 0.1)

    def test_the_front_is_that_of_the_summary(self):
        pictures = self.drawn("pareto-torque-speed")
        self.assertEqual(set(pictures), {"front", "along-the-front", "parallel", "curves"})
        front = [point["metrics"] for point in self.summary["front"]]
        picture = pictures["front"]
        self.assert_places(picture.dots[BLUE], [p["stall_torque"] for p in front], [p["no_load_speed"] for p in front])
        self.assertTrue({"stall torque [N·m]", "no-load speed [rpm]", "largest stall torque", "largest no-load speed"} <= set(picture.words()))
        preload = [point["design"]["preload"] for point in self.summary["front"]]
        count = len(preload)
        self.assert_places(pictures["along-the-front"].dots[BLUE][:count], [p["stall_torque"] for p in front], preload)
        goals = [[point[goal["metric"]] for point in front] for goal in self.summary["objectives"]]
        design = [[point["design"][name] for point in self.summary["front"]] for name in self.summary["front"][0]["design"]]
        # A variable that is the same in all points, but for rounding, has no axis.
        self.assert_parallel(pictures["parallel"], goals + [values for values in design if max(values) - min(values) > 1e-6 * abs(max(values))])

    def test_the_search_is_that_of_the_rows(self):
        pictures = self.drawn("optimize-ring-60")
        self.assertEqual(set(pictures), {"curves", "search"})
        self.assertIn("squeals", pictures["curves"].words())  # of the best design
        dots = pictures["search"].dots
        power, count = self.columns["peak_power"], len(self.columns["peak_power"])
        kept = [all(self.columns[c["metric"]][i] * sign >= sign * c["limit"] - 1e-6 * abs(c["limit"]) for c in self.summary["best"]["constraints"]
                    for sign in ((1,) if c["sense"] == "at least" else (-1,))) for i in range(count)]
        self.assertEqual(len(dots[GREEN]), sum(kept))
        self.assertEqual(len(dots["rgb(187, 187, 187)"]), count - sum(kept))
        # Dots beyond the axis, which ends a little above the best, stand at its ends; the others where their values are.
        grey = dots["rgb(187, 187, 187)"]
        broken = [(i, p) for i, (p, k) in enumerate(zip(power, kept)) if not k]
        top, bottom = min(y for _, y in grey), max(y for _, y in grey)
        inside = [n for n, (_, y) in enumerate(grey) if top + 0.1 < y < bottom - 0.1]
        self.assert_places([grey[n] for n in inside], [broken[n][0] for n in inside], [broken[n][1] for n in inside])
        self.assertLess(max(broken[n][1] for n in inside), 1.2 * self.summary["best"]["metrics"]["peak_power"])
        first, last = (min(inside, key=lambda n: grey[n][1] * sign) for sign in (1, -1))
        watts = (broken[first][1] - broken[last][1]) / (grey[first][1] - grey[last][1])
        high, low = (broken[first][1] + watts * (y - grey[first][1]) for y in (top, bottom))
        beyond = sum(not low <= p <= high for p in power)
        self.assertIn(f"optimize-ring-60: course of the search; {beyond} beyond the axis are drawn at its edge", pictures["search"].words())
        # The best is found early: the line ends as high as the highest green dot.
        self.assertAlmostEqual(pictures["search"].pieces[BLUE][-1][-1][1], min(y for _, y in dots[GREEN]), delta=0.02)

    def test_curves_before_and_after_with_the_duty(self):
        pictures = self.drawn("size-05Nm-100rpm")
        picture = pictures["curves"]
        self.assertTrue({"before", "best design", "at least", "torque [mN·m]", "speed [rpm]"} <= set(picture.words()))
        # The best design carries the duty of 0.5 N.m at 100 rpm, and its speed falls from there: the triangle is on or below the line.
        (x, y), = [place for place in picture.rises if place[1] < 320]  # in the first panel
        line = picture.lines[VERMILION][0]
        above = [height for place, height in line if abs(place - x) < 2]
        self.assertTrue(above and min(above) <= y + 1.5, (x, y, above))
        # The duty is 0.5 N.m at 100 rpm. Labels of the vertical axis stand a constant below their tics: half a letter.
        per_rpm, zero = scale(picture.numbers(0, 850, picture.size[1]))
        self.assertAlmostEqual((x - zero) / per_rpm, 100, delta=0.02 / per_rpm)
        picture.texts = [text for text in picture.texts if text[2] < 320]  # of the first panel
        per_torque, zero = scale(picture.numbers(1, 50, 92))
        self.assertAlmostEqual((y - zero) / per_torque, 500, delta=6 / abs(per_torque))

    def test_histograms_count_every_motor(self):
        pictures = self.drawn("tolerances")
        self.assertTrue({"histogram-stall_torque", "histogram-peak_power", "curves", "fields"} <= set(pictures))
        torque = self.columns["stall_torque"]
        boxes = pictures["histogram-stall_torque"].boxes
        heights = {colour: sum(low - high for _, _, high, low in boxes[colour]) for colour in (BLUE, VERMILION)}
        kept = sum(value >= 0.75 for value in torque)
        # Heights have two decimals, on some 30 bars of together 5000 points.
        self.assertAlmostEqual(heights[BLUE] / (heights[BLUE] + heights[VERMILION]), kept / len(torque), delta=1e-3)
        self.assertAlmostEqual(max(right for _, right, _, _ in boxes[VERMILION]), min(left for left, _, _, _ in boxes[BLUE]), delta=0.02)
        self.assertTrue({"≥ 750 mN·m", "5 %", "50 %", "95 %", "keeps the limit", "violates the limit"} <= set(pictures["histogram-stall_torque"].words()))

    def test_bars_are_as_long_as_the_effects(self):
        for study, size in (("sensitivity-sobol", lambda e: e["total"]["value"]), ("sensitivity-morris", lambda e: e["mu_star"]),
                            ("sensitivity-local", lambda e: abs(e["elasticity"]))):
            with self.subTest(study):
                pictures = self.drawn(study)
                effects = self.summary["indices"]["peak_power"]
                sizes = sorted((size(e) for e in effects.values() if size(e) is not None), reverse=True)
                picture = pictures["effects-peak_power"]
                outer = {"sensitivity-sobol": ["rgb(140, 197, 227)"], "sensitivity-morris": [BLUE], "sensitivity-local": [BLUE, VERMILION]}[study]
                bars = [(high, right - left) for colour in outer for left, right, high, low in picture.boxes.get(colour, []) if low - high > 15]
                lengths = [length for _, length in sorted(bars)]
                for length, value in zip(lengths, sizes):
                    self.assertAlmostEqual(length / lengths[0], value / sizes[0], delta=0.05 / lengths[0])
                self.assertIn("kinetic friction", picture.words())

    def test_a_map_has_a_cell_for_each_design(self):
        pictures = self.drawn("map", SWEEP % (RING, PRELOAD + ", " + AMPLITUDE))
        self.assertEqual(set(pictures), {"map-stall_torque", "map-no_load_speed", "designs", "parallel"})
        cells = [box for boxes in pictures["map-stall_torque"].boxes.values() for box in boxes if box[1] - box[0] > 40 and box[3] - box[2] > 30]
        self.assertEqual(len(cells), 24)
        self.assert_places(pictures["designs"].dots[BLUE], self.columns["stall_torque"], self.columns["no_load_speed"])

    def test_a_sweep_of_one_variable_is_a_line(self):
        picture = self.drawn("line", SWEEP % (RING, PRELOAD))["lines"]
        self.assert_places(picture.dots[BLUE][:6], self.columns["preload"], self.columns["stall_torque"])
        self.assertTrue({"preload [N]", "stall torque [N·m]", "no-load speed [rpm]"} <= set(picture.words()))

    def test_many_variables_are_shown_one_by_one(self):
        pictures = self.drawn("sweep-latin-hypercube")
        self.assert_parallel(pictures["parallel"], list(self.columns.values()))
        picture = pictures["designs-peak_power"]
        count = len(self.columns["preload"])
        self.assertEqual(len(picture.dots[BLUE]), 5 * count)
        self.assert_places(picture.dots[BLUE][2 * count:3 * count], self.columns["preload"], self.columns["peak_power"])

    def test_a_density_counts_every_design(self):
        sweep = "twum: 1\nmotor: %s\nstudy: {kind: sweep, sampling: sobol, samples: 6000, metrics: [contact_ratio, max_pressure], variables: {%s}}\n"
        ranges = "preload: {min: 60 N, max: 300 N}, amplitude: {min: 1 um, max: 2 um}"
        picture = self.drawn("many", sweep % (RING, ranges))["designs"]
        self.assertNotIn(BLUE, picture.dots)
        self.assertIn("designs in a cell", picture.words())
        boxes = [box for shade in picture.boxes.values() for box in shade if box[1] - box[0] < 40 and box[1] < 600]
        left, right = min(b[0] for b in boxes), max(b[1] for b in boxes)
        top, bottom = min(b[2] for b in boxes), max(b[3] for b in boxes)
        (xs, ys) = self.columns["contact_ratio"], self.columns["max_pressure"]
        place = lambda v, values, low, high: low + (high - low) * share(v, min(values), max(values))  # noqa: E731
        for x, y in zip(xs[::20], ys[::20]):
            across, up = place(x, xs, left, right), place(y, ys, bottom, top)
            self.assertTrue(any(l - 0.02 <= across <= r + 0.02 and high - 0.02 <= up <= low + 0.02 for l, r, high, low in boxes), (x, y))
        # Cells along either side for ten designs in each; those that hold a design are drawn.
        n = int((6000 / 10) ** 0.5)
        cells = {tuple(min(n - 1, int(n * share(v, min(values), max(values)))) for v, values in ((x, xs), (y, ys))) for x, y in zip(xs, ys)}
        self.assertEqual(len(boxes), len(cells))
        self.assertGreater(len(picture.boxes), 3)  # shades

    def test_a_calibration_shows_points_fit_and_residuals(self):
        pictures = self.drawn("calibrate")
        self.assertEqual(set(pictures), {"fit", "residuals", "curves", "fields"} | {f"profile-{name}" for name in self.summary["estimates"]})
        data = self.summary["data"]
        measured = pictures["fit"].dots["rgb(  0,   0,   0)"]
        self.assert_places(measured, [p["speed"] for p in data], [p["torque"] for p in data])
        self.assert_places(pictures["residuals"].dots[BLUE], [p["speed"] for p in data], [p["residual"] for p in data])
        # The fitted line passes each point at the distance of its residual.
        (x0, y0), (x1, y1) = measured[0], measured[-1]
        per_torque = (y1 - y0) / (data[-1]["torque"] - data[0]["torque"])
        line = pictures["fit"].lines[BLUE][-1]
        for (x, y), point in zip(measured, data):
            left, right = max(p for p in line if p[0] <= x + 0.01), min(p for p in line if p[0] >= x - 0.01)
            here = left[1] if right[0] == left[0] else left[1] + (right[1] - left[1]) * (x - left[0]) / (right[0] - left[0])
            # Straight between 161 places of a line some 600 points long: the sag of the steepest part is below half a point.
            self.assertAlmostEqual(y - here, per_torque * point["residual"], delta=0.5)

    def test_readings_of_several_kinds(self):
        (self.folder / "points.csv").write_text(POINTS)
        pictures = self.drawn("several", SEVERAL % DRIVE)
        for name, label in (("no_load_speed", "measured - fitted [rpm]"), ("holding_torque", "measured - fitted [mN·m]"), ("start_voltage", "measured - fitted [V]")):
            self.assertIn(label, pictures[f"residuals-{name}"].words())
        self.assertNotIn("fit", pictures)

    def test_every_kind_of_data_is_drawn_with_its_fit(self):
        # Admittances on a circle of the diameter 7 mS beside 2 mS: near enough to those of the motor for a fit to end.
        angles = [0.3 * k for k in range(-8, 9)]
        rows = [(39000 + 127 * math.tan(a / 2), 3.5e-3 * (1 + math.cos(a)), 2e-3 - 3.5e-3 * math.sin(a)) for a in angles]
        (self.folder / "circle.csv").write_text("frequency [Hz],conductance [S],conductance_sd [S],susceptance [S],susceptance_sd [S]\n" +
                                                "".join(f"{f},{g},1e-3,{b},1e-3\n" for f, g, b in rows))
        pictures = self.drawn("circle", f"twum: 1\nmotor: {DRIVE}\nstudy: {{kind: calibrate, data: circle.csv, "
                                        "variables: {quality_factor: {min: 50, max: 400}, modal_mass: {min: 10 g, max: 60 g}}}\n")
        self.assertTrue({"fit-conductance", "fit-susceptance", "circle", "residuals-conductance", "residuals-susceptance"} <= set(pictures))
        self.assertNotIn("fit", pictures)
        black = "rgb(  0,   0,   0)"
        frequency, conductance, susceptance = zip(*rows)
        self.assert_places(pictures["fit-conductance"].dots[black], frequency, conductance)
        self.assert_places(pictures["fit-susceptance"].dots[black], frequency, susceptance)
        self.assert_places(pictures["circle"].dots[black], conductance, susceptance)
        self.assertTrue(pictures["circle"].lines[BLUE])
        # Round: a millisiemens is as long along as up, to the two decimals of the places.
        scales = []
        for places, values in zip(zip(*pictures["circle"].dots[black]), (conductance, susceptance), strict=True):
            low, high = values.index(min(values)), values.index(max(values))
            scales.append(abs(places[high] - places[low]) / (values[high] - values[low]))
        self.assertAlmostEqual(scales[0] / scales[1], 1, delta=1e-3)

    def test_each_setting_of_the_bench_has_its_curve(self):
        (self.folder / "two.csv").write_text("speed [rpm],torque [N.m],amplitude_at [um],torque_sd [N.m],amplitude_at_sd [um],voltage [V]\n" +
                                             "".join(f"{n},{t},{a},0.1,0.1,{v}\n" for n, t, a, v in
                                                     ((20, 1.03, 1.57, 110), (90, 0.85, 1.62, 110), (20, 1.04, 1.7, 130), (90, 0.91, 1.73, 130))))
        pictures = self.drawn("two", SEVERAL.replace("points.csv", "two.csv") % DRIVE)
        self.assertTrue({"fit", "fit-amplitude_at"} <= set(pictures))
        for name in ("fit", "fit-amplitude_at"):
            self.assertTrue({"voltage 110 V", "voltage 130 V"} <= set(pictures[name].words()))

    def test_families_of_curves_and_responses(self):
        pictures = self.drawn("drive-voltages")
        self.assertEqual(set(pictures), {"curves", "terminals"})
        for picture in pictures.values():
            self.assertTrue({"voltage 50 V", "voltage 90 V", "voltage 120 V"} <= set(picture.words()))
        response = self.drawn("response", f"twum: 1\nmotor: {DRIVE}\nstudy: {{kind: frequency}}\n")
        self.assertEqual(set(response), {"response"})
        family = self.drawn("responses", f"twum: 1\nmotor: {DRIVE}\nstudy: {{kind: frequency, points: 21, "
                                         "family: {voltage: [80 V, 120 V]}}\n")
        self.assertTrue({"voltage 80 V", "voltage 120 V", "frequency [kHz]"} <= set(family["responses"].words()))

    def test_tolerances_of_a_search(self):
        pictures = self.drawn("robust-ring-60")
        self.assertTrue({"curves", "density-stall_torque", "risk", "tolerances", "yield"} <= set(pictures))
        gains = sorted((abs(t["gain_per_percent_tighter"]) for t in self.summary["robust"]["tolerances"]), reverse=True)
        bars = [right - left for left, right, high, low in sorted(pictures["tolerances"].boxes[BLUE], key=lambda box: box[2])]
        for bar, gain in zip(bars, gains):
            self.assertAlmostEqual(bar / bars[0], gain / gains[0], delta=0.05 / bars[0])
        density, = [d for d in self.summary["robust"]["densities"] if d["metric"] == "stall_torque"]
        bars = pictures["density-stall_torque"].boxes[BLUE]
        shares = [v for i, v in enumerate(density["motors"]) if v > 0 and density["first"] + (i + 0.5) * density["width"] >= density["lower"]]
        tallest = max(low - high for _, _, high, low in bars)
        for (_, _, high, low), value in zip(bars, shares):
            # gnuplot draws no box lower than a fraction of a point.
            self.assertAlmostEqual((low - high) / tallest, value / max(shares), delta=0.3 / tallest)


class Command(program.Case):
    def result(self, study="study: {kind: curve, points: 5}"):
        path = self.write("s.yaml", f"twum: 1\nmotor: {RING}\n{study}\n")
        self.ok("run", path, "-o", self.folder / "out")
        return self.folder / "out"

    def test_another_directory_and_the_same_bytes(self):
        directory = self.result()
        before = {p.name: p.read_bytes() for p in directory.iterdir()}
        paths = self.ok("plot", directory, "-o", self.folder / "a/b").split("\n")[:-1]
        self.assertEqual({str(p) for p in (self.folder / "a/b").iterdir()}, set(paths))
        again = self.ok("plot", directory, "-o", self.folder / "c").split("\n")[:-1]
        for one, other in zip(paths, again, strict=True):
            self.assertEqual(pathlib.Path(one).read_bytes(), pathlib.Path(other).read_bytes())
        self.assertEqual({p.name: p.read_bytes() for p in directory.iterdir()}, before)
        self.ok("plot", directory)
        self.ok("verify", directory)

    def test_names_of_studies_are_text(self):
        path = self.write("it's `touch hacked` $x_2.yaml", f"twum: 1\nmotor: {RING}\nstudy: {{kind: curve, family: {{preload: [100 N, 160 N]}}}}\n")
        self.ok("run", path, "-o", self.folder / "out", cwd=self.folder)
        self.ok("plot", self.folder / "out", cwd=self.folder)
        self.assertIn("it's `touch hacked` $x_2: curves", Picture(self.folder / "out/plots/curves.svg").words())
        self.assertFalse(list(self.folder.glob("**/hacked")))

    def test_what_is_no_finished_study_is_refused(self):
        self.assertIn("no such directory", self.refused("plot", self.folder / "absent"))
        empty = self.folder / "empty"
        empty.mkdir()
        self.assertIn("not a result directory: it has no study.yaml; give a directory that 'twum run' wrote", self.refused("plot", empty))
        directory = self.result()
        summary = json.loads((directory / "summary.json").read_text())
        (directory / "summary.json").write_text(json.dumps({**summary, "outcome": "interrupted"}))
        self.assertIn("run it again to complete its result", self.refused("plot", directory))
        self.assertFalse((directory / "plots").exists())

    def test_a_study_without_an_answer_says_where_the_reason_is(self):
        path = self.write("p.yaml", f"twum: 1\nmotor: {RING}\nstudy: {{kind: pareto, points: 5, objectives: [{{maximize: peak_power}}, "
                                    "{maximize: stall_torque}], variables: {preload: {min: 60 N, max: 300 N}}, "
                                    "constraints: [stall_torque >= 50 N.m]}\n")
        program.twum("run", path, "-o", self.folder / "out")
        text = self.refused("plot", self.folder / "out", status=1)
        self.assertIn(f"no answer to draw; {self.folder}/out/report.html says why", text)

    def test_motors_without_values_leave_what_there_is(self):
        path = self.write("u.yaml", f"twum: 1\nmotor: {RING}\nset: {{amplitude: 0 m}}\nstudy: {{kind: uncertainty, samples: 64, "
                                    "metrics: [speed_at(0.5 N.m), holding_torque], variables: {preload: {sd: 3 %}}}\n")
        self.ok("run", path, "-o", self.folder / "out")
        names = {pathlib.Path(line).stem for line in self.ok("plot", self.folder / "out").splitlines()}
        self.assertEqual(names, {"histogram-holding_torque", "scatter-preload-holding_torque", "curves", "fields"})

    def test_without_gnuplot(self):
        text = self.refused("plot", self.result(), status=3, env={"PATH": str(self.folder)})
        self.assertIn("gnuplot-nox", text)

    def test_where_nothing_can_be_written(self):
        directory = self.result()
        (self.folder / "file").write_text("")
        text = self.refused("plot", directory, "-o", self.folder / "file", status=3)
        self.assertIn("choose another one with -o", text)
        self.assertNotIn("Success", text)
        os.chmod(directory, 0o555)
        self.addCleanup(os.chmod, directory, 0o755)
        if os.geteuid() != 0:
            self.assertIn("cannot be made", self.refused("plot", directory, status=3))


if __name__ == "__main__":
    assert math.isclose(share(3, 2, 4), 0.5)
    program.main()
