# SPDX-License-Identifier: Apache-2.0
"""The report page of every example in a real browser: report_test.py TWUM"""
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import Browser  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
STUDIES = sorted((ROOT / "examples/studies").glob("*.yaml"))
HOSTILE = "</script><script>window.hacked=1</script><img src=x onerror=hacked=1> \"quoted\" 'single' 電動機 µ " + "long " * 40
RPM = 3.141592653589793 / 30
PROGRAM = None


def twum(*arguments, **options):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600, **options)
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    return done


class Page(unittest.TestCase):
    """One browser for all; results are made once for each study."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="twum-report-")
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.results = {}
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.scratch.cleanup()

    def result(self, name):
        """Result directory of an example."""
        if name not in self.results:
            directory = self.folder / name
            twum("run", ROOT / "examples/studies" / f"{name}.yaml", "-o", directory)
            self.results[name] = directory
        return self.results[name]

    def open(self, directory, **options):
        self.browser.open(directory / "report.html", **options)
        return json.loads((directory / "summary.json").read_text())

    def clean(self, directory):
        """No error, no request but the page itself."""
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual([u for u in self.browser.requests() if not u.startswith(("blob:", "data:"))],
                         ["file://" + str(directory / "report.html")])

    def table(self, name):
        """{first cell: SI values of the others}"""
        return self.browser.value("""Object.fromEntries([...document.querySelectorAll(`[data-table="%s"] tbody tr`)].map(
            (tr) => [tr.cells[0].textContent, [...tr.cells].slice(1).map((td) => td.dataset.value === undefined ? td.textContent : Number(td.dataset.value))]))""" % name)

    def box(self, chart):
        """Rectangle of a chart's plotting area, in the viewport."""
        return self.browser.value("""(() => { const n = document.querySelector(`[data-chart="%s"]`); n.scrollIntoView({block: 'center'});
            const r = (n.querySelector('.u-over') || n.querySelector('canvas')).getBoundingClientRect(); return [r.left, r.top, r.width, r.height]; })()""" % chart)

    def scale(self, chart, axis):
        return self.browser.value("""(() => { const s = document.querySelector(`[data-chart="%s"]`).plot.scales.%s; return [s.min, s.max]; })()""" % (chart, axis))

    def colours(self, selector):
        """How many different colours each canvas shows: 1 is an empty picture."""
        return self.browser.value("""[...document.querySelectorAll(`%s`)].map((c) => { const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
            const seen = new Set(); for (let i = 0; i < p.length; i += 4) if (p[i + 3]) seen.add(p[i] << 16 | p[i + 1] << 8 | p[i + 2]); return seen.size; })""" % selector)


class Examples(Page):
    def test_every_example_opens_clean_and_drawn_at_every_width(self):
        for study in STUDIES:
            directory = self.result(study.stem)
            for width, dark in ((1400, False), (400, False), (1400, True)):
                with self.subTest(study.stem, width=width, dark=dark):
                    summary = self.open(directory, width=width, dark=dark)
                    self.clean(directory)
                    self.assertEqual(self.browser.value("document.querySelector('h1').textContent"), summary["study"])
                    drawn = self.colours("main canvas")
                    self.assertTrue(drawn or self.browser.value("document.querySelectorAll('[data-chart] svg').length"))
                    # Axes, their words and a line with its smoothed edges are many colours.
                    self.assertTrue(all(n > 8 for n in drawn), drawn)
                    # Nothing sticks out of the page.
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)

    def test_page_makes_no_requests_even_if_it_wanted_to(self):
        page = (self.result("optimize-ring-60") / "report.html").read_text()
        self.assertIn("default-src 'none'", page)
        self.assertNotRegex(page.split('id="data"')[0] + page.rsplit("</script>", 2)[1], r"""(src|href)\s*=\s*["']?(https?:)?//""")


class Numbers(Page):
    def test_optimum_table_and_limits_are_those_of_the_summary(self):
        summary = self.open(self.result("optimize-ring-60"))
        shown = self.table("design")
        for name, value in summary["best"]["design"].items():
            self.assertEqual(shown[name.replace("_", " ")], [summary["before"]["design"][name], value])
        limits = self.table("limits")
        for limit in summary["best"]["constraints"]:
            self.assertEqual(limits[limit["text"]][0], limit["value"])
            self.assertEqual("binds" in limits[limit["text"]], limit["active"])
        verdict = self.browser.value("document.querySelector('.verdict').textContent")
        held = [c for c in summary["best"]["constraints"] if c["active"]]
        self.assertTrue(any(c["text"] in verdict for c in held) or summary["best"]["bounds"] or "No limit" in verdict)

    def test_curve_axes_hold_the_data_and_the_cursor_reads_them(self):
        summary = self.open(self.result("paper-figure-4"))
        last = max(c["last_speed"] for c in summary["curves"]) / RPM
        low, high = self.scale("torque", "x")
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, last, delta=1e-9 * last)
        top = self.browser.value("Math.max(...summary.curves.map(c => c.metrics.max_torque)) / displayUnit(1, 'N.m').divisor")
        bottom, upper = self.scale("torque", "y")
        unit = self.browser.value("displayUnit(largest(curves.map(c => c.torque)), 'N.m').divisor")
        self.assertGreaterEqual(upper, top / unit)
        self.assertLess(upper, 1.3 * top / unit)
        left, above, width, height = self.box("torque")
        self.browser.move(left + width / 2, above + height / 2)
        read = self.browser.value("""document.querySelector('[data-chart="torque"]').nextSibling.textContent""")
        self.assertRegex(read, r"at [\d.]+ rpm")
        speed = float(re.search(r"at ([\d.]+) rpm", read)[1])
        # Half the axis, to the nearest of 301 points.
        self.assertAlmostEqual(speed, last / 2, delta=last / 300)

    def test_fields_follow_the_cursor_and_the_keys(self):
        self.open(self.result("paper-figure-4"))
        title = "document.querySelector('[data-fields]').textContent"
        left, above, width, height = self.box("torque")
        self.browser.move(left + 0.2 * width, above + height / 2)
        before = self.browser.value(title)
        self.browser.move(left + 0.8 * width, above + height / 2)
        after = self.browser.value(title)
        self.assertNotEqual(before, after)
        self.browser.value("""document.querySelector('[data-chart="torque"]').focus()""")
        self.browser.key("End")
        self.assertNotEqual(self.browser.value(title), after)
        self.browser.key("Home")
        self.assertRegex(self.browser.value(title), r"at 0 rpm")

    def test_front_click_shows_the_motor_of_the_point(self):
        summary = self.open(self.result("pareto-power-wear"))
        first, second = (o["metric"] for o in summary["objectives"][:2])
        order = sorted(range(len(summary["front"])), key=lambda i: summary["front"][i]["metrics"][first])
        target = order[len(order) // 3]
        left, above, width, height = self.box("front 0 1")
        x, y = self.browser.value("""(() => { const u = document.querySelector('[data-chart="front 0 1"]').plot; const i = %d;
            return [u.valToPos(u.data[0][i], 'x'), u.valToPos(u.data[1][i], 'y')]; })()""" % (len(order) // 3))
        self.browser.click(left + x, above + y)
        self.assertIn(f"Point {target + 1}", self.browser.value("document.querySelector('#chosen h2').textContent"))
        shown = self.table(f"point-{target + 1}")
        for name, value in summary["front"][target]["design"].items():
            self.assertEqual(shown[name.replace("_", " ")][-1], value)
        self.assertEqual(len(self.table("front")), len(summary["front"]))

    def test_brushing_chooses_what_the_table_of_results_says(self):
        directory = self.result("sweep-sobol")
        self.open(directory)
        with open(directory / "results.csv", newline="") as file:
            table = list(csv.DictReader(file))
        left, above, width, height = self.box("scatter")
        name, unit = self.browser.value("(() => { const k = Number(document.querySelector('select[aria-label=across]').value); return [rows.columns[k].name, rows.columns[k].unit]; })()")
        self.browser.drag(left + 0.25 * width, above + 0.5 * height, left + 0.75 * width, above + 0.502 * height)
        interval = self.browser.value("(() => { const f = document.querySelector('[data-chart=parallel]').parallel.filter; return [...f.intervals.values()][0]; })()")
        low, high = (v * self.browser.value("displayUnit(largest([rows.columns.find(c => c.name === %s).values]), %s).divisor" % (json.dumps(name), json.dumps(unit))) for v in self.scale("scatter", "x"))
        # A quarter of the axis from either end; a pixel is 1 / width of it.
        self.assertAlmostEqual(interval[0], low + 0.25 * (high - low), delta=2 * (high - low) / width)
        self.assertAlmostEqual(interval[1], low + 0.75 * (high - low), delta=2 * (high - low) / width)
        column = next(k for k in table[0] if k.split(" [")[0] == name)
        inside = sum(1 for row in table if row[column] and interval[0] <= float(row[column]) <= interval[1])
        self.assertEqual(self.browser.value("Number(document.querySelector('[data-count] b').textContent)"), inside)
        self.assertLess(inside, len(table))

    def test_hover_shows_the_design_with_its_curve(self):
        directory = self.result("sweep-sobol")
        self.open(directory)
        left, above, width, height = self.box("scatter")
        x, y = self.browser.value("""(() => { const u = document.querySelector('[data-chart="scatter"]').plot;
            const [cx, cy] = [...document.querySelectorAll('select[aria-label=across], select[aria-label=up]')].map(s => rows.columns[s.value]);
            return [u.valToPos(cx.values[7] / displayUnit(largest([cx.values]), cx.unit).divisor, 'x'), u.valToPos(cy.values[7] / displayUnit(largest([cy.values]), cy.unit).divisor, 'y')]; })()""")
        self.browser.move(left + x, above + y)
        self.assertIn("Design 8", self.browser.value("document.querySelector('[data-design]').textContent"))
        self.assertEqual(self.browser.value("document.querySelectorAll('[data-design] + div svg').length"), 1)

    def test_parallel_axes_choose_and_escape_frees(self):
        self.open(self.result("sweep-sobol"))
        left, above, width, height = self.box("parallel")
        x, top = self.browser.value("document.querySelector('[data-chart=parallel]').parallel.place(0, 0.9)")
        _, bottom = self.browser.value("document.querySelector('[data-chart=parallel]').parallel.place(0, 0.5)")
        self.browser.drag(left + x, above + top, left + x, above + bottom)
        count = "Number(document.querySelector('[data-count] b').textContent)"
        chosen = self.browser.value(count)
        self.assertLess(0, chosen)
        self.assertLess(chosen, self.browser.value("rows.count"))
        self.browser.value("document.querySelector('[data-chart=parallel]').focus()")
        self.browser.key("Escape")
        self.assertEqual(self.browser.value(count), self.browser.value("rows.count"))

    def test_uncertainty_and_calibration_tables_are_those_of_the_summary(self):
        summary = self.open(self.result("tolerances"))
        spread = self.table("spread")
        for name, metric in summary["metrics"].items():
            self.assertEqual(spread[name][:2], [metric["mean"], metric["sd"]])
        counted = self.browser.value("[...document.querySelectorAll('[data-chart^=histogram]')].map(n => n.plot.data[1].reduce((a, b) => a + (b || 0), 0))")
        self.assertEqual(counted, [m["count"] for m in summary["metrics"].values()])
        summary = self.open(self.result("calibrate"))
        estimates = self.table("estimates")
        for name, estimate in summary["estimates"].items():
            self.assertEqual(estimates[name][:3], [estimate["value"], estimate["low"], estimate["high"]])
        points = self.browser.value("summary.data.length")
        self.assertEqual(points, len(summary["data"]))

    def test_bars_are_sorted_and_as_long_as_the_indices(self):
        summary = self.open(self.result("sensitivity-sobol"))
        lengths = self.browser.value("""[...document.querySelectorAll('.bars')].map(b => [...b.querySelectorAll('svg')].map(s => Number(s.querySelector('rect').getAttribute('width'))))""")
        for bars, effects in zip(lengths, [e for e in summary["indices"].values() if e]):
            self.assertEqual(bars, sorted(bars, reverse=True))
            totals = sorted((max(e["total"]["value"], 0) for e in effects.values()), reverse=True)
            scale = max(1, *(e["total"]["high"] for e in effects.values()))
            for bar, total in zip(bars, totals):
                # The least length of a bar is 0.4 of 196 units.
                self.assertAlmostEqual(bar, max(196 * total / scale, 0.4), delta=1e-6)


class Hostile(Page):
    def test_names_are_text(self):
        motor = (ROOT / "examples/motors/ring-60.yaml").read_text().replace("name: ring-60", "name: " + json.dumps(HOSTILE, ensure_ascii=False))
        self.assertIn("hacked", motor)
        folder = self.folder / "hostile"
        folder.mkdir()
        (folder / "m.yaml").write_text(motor)
        (folder / "a <b>&'x'.yaml").write_text("twum: 1\nmotor: m.yaml\nstudy:\n  kind: curve\n  points: 11\n")
        twum("run", folder / "a <b>&'x'.yaml", "-o", folder / "out")
        self.open(folder / "out")
        self.clean(folder / "out")
        self.assertIsNone(self.browser.value("window.hacked ?? null"))
        self.assertEqual(self.browser.value("document.querySelectorAll('main img, main script, main b b').length"), 0)
        self.assertEqual(self.browser.value("document.querySelector('h1').textContent"), "a <b>&'x'")
        self.assertIn("</script><script>window.hacked=1</script>", self.browser.value("document.querySelector('header').textContent"))
        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), 1400)


class Odd(Page):
    """Answers that are none, or hardly one."""

    STUDIES = {
        "infeasible": ("optimize", "variables: {preload: {min: 60 N, max: 300 N}}, maximize: peak_power, "
                       "constraints: [no_load_speed >= 400 rpm, stall_torque >= 0.8 N.m]", "No design keeps every limit"),
        "no-front": ("pareto", "variables: {preload: {min: 60 N, max: 300 N}}, objectives: [{maximize: peak_power}, "
                     "{minimize: max_pressure}], constraints: [no_load_speed >= 400 rpm]", "out of reach"),
        "free": ("optimize", "variables: {preload: {min: 60 N, max: 300 N}}, maximize: peak_power", "What stops it: preload"),
        "one-variable": ("sweep", "sampling: grid, variables: {preload: {min: 0.001 N, max: 3 kN, points: 5}}, "
                         "metrics: [speed_at(0.9 N.m)]", "5 designs, 1 of them without a full answer"),
        "dead": ("curve", "points: 5", "drives no load"),
    }

    def test_pages_say_so(self):
        for name, (kind, entries, words) in self.STUDIES.items():
            with self.subTest(name):
                study = self.folder / f"{name}.yaml"
                settings = 'set: {kinetic_friction: "0"}\n' if name == "dead" else ""
                study.write_text(f"twum: 1\nmotor: {ROOT}/examples/motors/ring-60.yaml\n{settings}study: {{kind: {kind}, {entries}}}\n")
                twum("run", study, "-o", self.folder / name)
                self.open(self.folder / name)
                self.clean(self.folder / name)
                self.assertIn(words, self.browser.value("document.querySelector('.verdict').innerText"))


class Command(Page):
    def test_report_again_is_the_same_page(self):
        directory = self.result("optimize-ring-60")
        before = (directory / "report.html").read_bytes()
        (directory / "report.html").unlink()
        self.assertEqual(twum("report", directory).stdout.strip(), str(directory / "report.html"))
        self.assertEqual((directory / "report.html").read_bytes(), before)

    def test_same_bytes_for_any_jobs_times_aside(self):
        pages = []
        for jobs in (1, 3):
            directory = self.folder / f"jobs-{jobs}"
            twum("run", ROOT / "examples/studies/sweep-sobol.yaml", "-o", directory, "--jobs", jobs)
            page = (directory / "report.html").read_text()
            pages.append(re.sub(r'"(started|seconds)":("[^"]*"|[^,}]*)', "", page))
        self.assertEqual(pages[0], pages[1])

    def test_a_directory_without_result_is_refused(self):
        done = subprocess.run([PROGRAM, "report", str(self.folder)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("holds no result", done.stderr)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=1)
