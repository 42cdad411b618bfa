# SPDX-License-Identifier: Apache-2.0
"""The report page of every example in a real browser: report_test.py TWUM"""
import csv
import json
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import PROGRAM, ROOT, RPM, Page, main, twum  # noqa: E402

# The page of robust-drive-60 is made as that of robust-ring-60, after a hundred seconds of processor time.
STUDIES = sorted(path for path in (ROOT / "examples/studies").glob("*.yaml") if path.stem != "robust-drive-60")
HOSTILE = "</script><script>window.hacked=1</script><img src=x onerror=hacked=1> \"quoted\" 'single' 電動機 محرك µ " + "long " * 40


class Examples(Page):
    def test_every_example_opens_clean_and_drawn_at_every_width(self):
        for study in STUDIES:
            directory = self.result(study.stem)
            for width, dark in ((1400, False), (400, True)):
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
            self.assertEqual(shown[name][:2], [self.typed(name, summary["before"]["design"][name]), self.typed(name, value)])
        limits = self.table("limits")
        for limit in summary["best"]["constraints"]:
            state, value = limits[limit["text"]][:2]
            self.assertEqual(value, limit["value"])
            self.assertEqual(state == "binds", limit["active"])
        # Everything that binds, ends of ranges too, the most valuable first; first in the table as well.
        binding = sorted([(c["gain_per_percent"], c["text"]) for c in summary["best"]["constraints"] if c["active"]] +
                         [(b["gain_per_percent"], b["variable"]) for b in summary["best"]["bounds"]], reverse=True)
        self.assertEqual(list(limits)[:len(binding)], [name for _, name in binding])
        listed = self.lines("section:has([data-table=limits]) .holders li")
        self.assertEqual(len(listed), len(binding))
        for (_, name), line in zip(binding, listed):
            self.assertIn(name.split(" ")[0].split("_")[0], line.lower().replace("'", "").replace("-", " "))

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
        read = self.text('[data-chart="torque"] + .read')
        self.assertRegex(read, r"speed [\d.]+ rpm")
        speed = float(re.search(r"speed ([\d.]+) rpm", read)[1])
        # Half the axis, to the nearest of 301 points.
        self.assertAlmostEqual(speed, last / 2, delta=last / 300)

    def test_the_electrical_power_is_stacked_up_to_the_terminals(self):
        folder = self.folder / "driven"
        folder.mkdir()
        (folder / "alone.yaml").write_text(f"twum: 1\nmotor: {ROOT}/examples/motors/drive-60.yaml\nstudy: {{kind: curve}}\n")
        twum("run", folder / "alone.yaml", "-o", folder / "out")
        self.open(folder / "out")
        self.clean(folder / "out")
        sums = self.browser.value("document.querySelector('[data-chart=\"electrical power\"]').plot.data.slice(1).map(a => [...a])")
        power = self.browser.value("[...curves[0].electrical_power]")
        unit = self.browser.value("displayUnit(largest([curves[0].electrical_power]), 'W').divisor")
        output = self.browser.value("[...curves[0].output_power]")
        self.assertEqual(len(sums), 5)
        shown = [i for i, p in enumerate(output) if p >= 0]
        self.assertGreater(len(shown), 100)
        for i in shown:
            # The losses are stacked; together they are the electrical power, to rounding of the page's numbers [W].
            self.assertEqual([s[i] for s in sums], sorted(s[i] for s in sums))
            self.assertAlmostEqual(sums[-1][i] * unit, power[i], delta=1e-9 * power[0])
        self.assertTrue(all(s[i] is None for s in sums for i in range(len(output)) if i not in shown))

    def test_fields_follow_the_cursor_and_the_keys(self):
        self.open(self.result("paper-figure-4"))
        left, above, width, height = self.box("torque")
        self.browser.move(left + 0.2 * width, above + height / 2)
        before = self.text("[data-fields]")
        self.browser.move(left + 0.8 * width, above + height / 2)
        after = self.text("[data-fields]")
        self.assertNotEqual(before, after)
        self.browser.value("""document.querySelector('[data-chart="torque"]').focus()""")
        self.browser.key("End")
        self.assertNotEqual(self.text("[data-fields]"), after)
        self.browser.key("Home")
        self.assertRegex(self.text("[data-fields]"), r"at 0 rpm")

    def test_traction_stays_within_the_friction_bounds_and_reaches_them_where_it_slips(self):
        self.open(self.result("paper-figure-4"))
        # The fields begin at the speed of peak power, where this motor sticks and slips.
        self.assertIn("stick", self.text("[data-fields]"))
        inside, slips = self.browser.value("""(() => { const u = document.querySelector('[data-chart="traction"]').plot;
            const [phase, bound, , traction] = u.data;
            let most = 0; let touching = 0; let slipping = 0;
            const frame = readFields(curves[4]).frames.reduce((a, b) => Math.abs(b.speed - curves[4].metrics.speed_at_peak_power) < Math.abs(a.speed - curves[4].metrics.speed_at_peak_power) ? b : a);
            phase.forEach((p, i) => { if (bound[i] <= 0) return; most = Math.max(most, Math.abs(traction[i]) / bound[i]);
              const zone = frame.zones.find(([, from, to]) => p * Math.PI / 180 > from && p * Math.PI / 180 < to);
              if (zone && zone[0] !== 0) { slipping++; if (Math.abs(traction[i] / bound[i] - zone[0]) < 1e-5) touching++; } });
            return [most, touching / slipping]; })()""")
        # Single precision: 24 bits in traction and in pressure.
        self.assertLess(inside, 1 + 1e-6)
        self.assertEqual(slips, 1)

    def test_front_click_shows_the_motor_of_the_point(self):
        summary = self.open(self.result("pareto-power-wear"))
        first, second = (o["metric"] for o in summary["objectives"][:2])
        order = sorted(range(len(summary["front"])), key=lambda i: summary["front"][i]["metrics"][first])
        target = order[len(order) // 3]
        left, above, width, height = self.box("front")
        x, y = self.browser.value("""(() => { const u = document.querySelector('[data-chart="front"]').plot; const i = %d;
            return [u.valToPos(u.data[0][i], 'x'), u.valToPos(u.data[1][i], 'y')]; })()""" % (len(order) // 3))
        self.browser.click(left + x, above + y)
        self.assertIn(f"Point {target + 1}", self.browser.value("document.querySelector('#chosen h2').textContent"))
        shown = self.table(f"point-{target + 1}")
        for name, value in summary["front"][target]["design"].items():
            self.assertEqual(shown[name][1], self.typed(name, value))
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
        self.assertIn("Design 8", self.text("[data-design]"))
        self.assertEqual(self.browser.value("document.querySelectorAll('[data-design] + div svg').length"), 1)

    def test_arrow_keys_step_through_the_designs_from_left_to_right(self):
        self.open(self.result("sweep-sobol"))
        order = self.browser.value("""(() => { const c = rows.columns[document.querySelector('select[aria-label=across]').value].values;
            return [...c.keys()].sort((a, b) => c[a] - c[b] || a - b); })()""")
        self.browser.value("document.querySelector('[data-chart=scatter]').focus()")
        for key, place in (("Home", 0), ("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", len(order) - 1)):
            self.browser.key(key)
            self.assertTrue(self.text("[data-design]").startswith(f"Design {order[place] + 1}wave"), key)

    def test_colours_of_a_scatter_make_a_map(self):
        self.open(self.result("sweep-sobol"))
        plain = self.colours("[data-chart=scatter] canvas")[0]
        self.browser.value("(() => { const s = document.querySelector('select[aria-label=colour]'); s.value = rows.columns.findIndex(c => c.name === 'peak_power'); s.dispatchEvent(new Event('change')); })()")
        self.browser.settle()
        self.assertGreater(self.colours("[data-chart=scatter] canvas")[0], plain + 20)

    def test_filter_by_limits_keeps_what_the_table_of_results_says(self):
        directory = self.result("sweep-sobol")
        self.open(directory)
        with open(directory / "results.csv", newline="") as file:
            table = list(csv.DictReader(file))
        self.browser.value("""(() => { for (const [label, value] of [['least no-load speed', 100], ['most stall torque', '1,2']]) {
            const n = document.querySelector(`input[aria-label="${label}"]`); n.value = value; n.dispatchEvent(new Event('change')); } })()""")
        inside = sum(1 for r in table if float(r["no_load_speed [rad/s]"]) >= 100 * RPM and float(r["stall_torque [N.m]"]) <= 1.2)
        self.assertEqual(self.browser.value("Number(document.querySelector('[data-count] b').textContent)"), inside)
        self.assertLess(0, inside)

    def test_map_of_two_variables_reads_its_cells_by_mouse_and_keys(self):
        summary = self.open(self.result("sweep-grid"))
        # Nine amplitudes across, five preloads up: the cell at the upper right is the last of both.
        left, above, width, height = self.box("heat")
        self.browser.move(left + width - 3, above + 3)
        read = self.text("[data-chart=heat] + .read")
        self.assertIn("wave amplitude 2.4 µm", read)
        self.assertIn("preload 240 N", read)
        self.browser.value("document.querySelector('[data-chart=heat]').focus()")
        self.browser.key("ArrowLeft")
        self.assertIn("wave amplitude 2.2 µm", self.text("[data-chart=heat] + .read"))
        self.browser.key("ArrowDown")
        self.assertIn("preload 200 N", self.text("[data-chart=heat] + .read"))
        # From there to the cell with the most of the metric, which reads as the summary says.
        name = self.browser.value("data.sections[0].charts[document.querySelector('select[aria-label=metric]').value].series[0].z").removeprefix("rows/")
        most = summary["metrics"][name]
        sides = [sorted(set(self.browser.value("[...rows.columns.find((c) => c.name === '%s').values]" % v))) for v in ("amplitude", "preload")]
        across, up = (side.index(most["highest"]["design"][v]) - side.index(at) for side, v, at in zip(sides, ("amplitude", "preload"), (sides[0][-2], sides[1][-2])))
        for steps, keys in ((across, ("ArrowLeft", "ArrowRight")), (up, ("ArrowDown", "ArrowUp"))):
            for _ in range(abs(steps)):
                self.browser.key(keys[steps > 0])
        shown = self.browser.value("engineering(%r, unitOf('%s'))" % (most["max"], name)).replace("\u00a0", " ")
        self.assertIn(shown, self.text("[data-chart=heat] + .read"))

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

    def test_uncertainty_tables_are_those_of_the_summary(self):
        summary = self.open(self.result("tolerances"))
        spread = self.table("spread")
        for name, metric in summary["metrics"].items():
            self.assertEqual(spread[name][:2], [metric["mean"], metric["sd"]])
        sums = self.browser.value("[...document.querySelectorAll('[data-chart^=histogram]')].map(n => [1, 2].map(k => n.plot.data[k].reduce((a, b) => a + (b || 0), 0)))")
        self.assertEqual([a + b for a, b in sums], [m["count"] for m in summary["metrics"].values()])
        # The bars beyond a limit are the motors that break it; the limit is on the axis, and no bar is on both sides.
        for name, (_, failed) in zip(summary["metrics"], sums):
            limits = [l for l in summary["limits"] if l["metric"] == name]
            self.assertEqual(failed, round(sum(1 - l["kept"]["value"] for l in limits) * summary["samples"]))
            low, high = self.scale("histogram " + name, "x")
            for limit in limits:
                unit = self.browser.value("displayUnit(largest([rows.columns.find(c => c.name === '%s').values]), unitOf('%s')).divisor" % (name, name))
                self.assertTrue(low < limit["limit"] / unit < high)
        both = self.browser.value("[...document.querySelectorAll('[data-chart^=histogram]')].map(n => n.plot.data[1].filter((a, i) => a > 0 && n.plot.data[2][i] > 0).length)")
        self.assertEqual(both, [0] * len(both))

    def test_yield_after_loosening_a_limit_is_that_of_the_stored_motors(self):
        directory = self.result("tolerances")
        summary = self.open(directory)
        with open(directory / "results.csv", newline="") as file:
            table = list(csv.DictReader(file))
        limit = min(summary["limits"], key=lambda l: l["kept"]["value"])
        others = [l for l in summary["limits"] if l is not limit]
        self.assertEqual(limit["sense"], "at least")
        column = {l["metric"]: next(k for k in table[0] if k.split(" [")[0] == l["metric"]) for l in summary["limits"]}
        keep = sum(float(r[column[limit["metric"]]]) >= 0.99 * limit["limit"] and all(float(r[column[o["metric"]]]) >= o["limit"] for o in others) for r in table)
        line = self.lines("section:has([data-table=yield]) .holders li")[0]
        self.assertIn(f"the yield is {100 * keep / len(table):.4g} %", line)

    def test_calibration_tables_are_those_of_the_summary(self):
        summary = self.open(self.result("calibrate"))
        estimates = self.table("estimates")
        for name, estimate in summary["estimates"].items():
            self.assertEqual(estimates[name][:3], [estimate["value"], estimate["low"], estimate["high"]])
        points = self.browser.value("summary.data.length")
        self.assertEqual(points, len(summary["data"]))

    @staticmethod
    def told(effect):
        """The total index; where no interactions are seen, that of both indices that is known better."""
        if effect["interactions"]["low"] is None or effect["interactions"]["low"] > 0:
            return effect["total"]
        return min(effect["first"], effect["total"], key=lambda index: index["high"] - index["low"])

    def test_bars_are_sorted_and_as_long_as_the_indices(self):
        summary = self.open(self.result("sensitivity-sobol"))
        lengths = self.browser.value("""[...document.querySelectorAll('.bars')].map(b => [...b.querySelectorAll('svg')].map(s => Number(s.querySelector('rect').getAttribute('width'))))""")
        for bars, effects in zip(lengths, [e for e in summary["indices"].values() if e]):
            self.assertEqual(bars, sorted(bars, reverse=True))
            told = [self.told(e) for e in effects.values()]
            totals = sorted((max(e["value"], 0) for e in told), reverse=True)
            scale = max(1, *(e["high"] for e in told))
            for bar, total in zip(bars, totals):
                # The least length of a bar is 0.4 of 196 units.
                self.assertAlmostEqual(bar, max(196 * total / scale, 0.4), delta=1e-6)


class Hostile(Page):
    """Names chosen to break the page: markup, quotes, other scripts, very long."""

    KINDS = {
        "curve": "points: 11, family: {preload: [100 N, 160 N]}",
        "frequency": "points: 11, torque: 0.3 N.m, family: {preload: [140 N, 170 N]}",
        "sweep": "sampling: grid, variables: {preload: [100 N, 160 N], amplitude: [1 um, 1.6 um]}, metrics: [stall_torque, no_load_speed]",
        "sensitivity": "method: local, variables: {preload: {min: 100 N, max: 160 N}}, metrics: [peak_power]",
        "optimize": "variables: {preload: {min: 60 N, max: 300 N}}, maximize: peak_power",
        "size": "variables: {preload: {min: 60 N, max: 300 N}}, duty: [{torque: 0.5 N.m, speed: 100 rpm}]",
        "pareto": "variables: {preload: {min: 60 N, max: 300 N}}, objectives: [{maximize: stall_torque}, {minimize: max_pressure}], points: 5",
        "uncertainty": "variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}, metrics: [peak_power], limits: [peak_power >= 9 W], samples: 50",
        "calibrate": "variables: {kinetic_friction: {min: 0.05, max: 0.5}}, data: \"it's <i>.csv\"",
    }

    def test_names_are_text_on_the_page_of_every_kind(self):
        folder = self.folder / "hostile"
        folder.mkdir()
        for motor in ("ring-60", "drive-60"):
            text = (ROOT / f"tests/data/motors/{motor}.yaml").read_text()
            text = text.replace(f"name: {motor}", "name: " + json.dumps(HOSTILE, ensure_ascii=False))
            self.assertIn("hacked", text)
            (folder / f"{motor}.yaml").write_text(text)
        (folder / "it's <i>.csv").write_text("speed [rpm],torque [N.m]\n20,0.85\n60,0.84\n100,0.83\n120,0.6\n")
        for kind, entries in self.KINDS.items():
            motor = "drive-60" if kind == "frequency" else "ring-60"
            name = f"a <b>&'{kind}' \u202eمحرك電"
            (folder / f"{name}.yaml").write_text(f"twum: 1\nmotor: {motor}.yaml\nstudy: {{kind: {kind}, {entries}}}\n")
            twum("run", folder / f"{name}.yaml", "-o", folder / kind)
            for width in (1400, 400):
                with self.subTest(kind, width=width):
                    self.open(folder / kind, width=width)
                    self.clean(folder / kind)
                    self.assertIsNone(self.browser.value("window.hacked ?? null"))
                    self.assertEqual(self.browser.value("document.querySelectorAll('main img, main script, main i b, main b b').length"), 0)
                    self.assertEqual(self.browser.value("document.querySelector('h1').textContent"), name)
                    self.assertIn("</script><script>window.hacked=1</script>", self.browser.value("document.querySelector('header').textContent"))
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)


class Command(Page):
    def test_report_again_is_the_same_page(self):
        directory = self.result("optimize-ring-60")
        before = (directory / "report.html").read_bytes()
        (directory / "report.html").unlink()
        self.assertEqual(twum("report", directory).stdout.strip(), str(directory / "report.html"))
        self.assertEqual((directory / "report.html").read_bytes(), before)

    def test_same_bytes_for_any_jobs_times_aside(self):
        other = self.folder / "jobs"
        # The result of the example is of as many jobs as there are cores.
        twum("run", ROOT / "examples/studies/sweep-sobol.yaml", "-o", other, "--jobs", 1 if os.cpu_count() == 3 else 3)
        pages = [re.sub(r'"(started|seconds)":("[^"]*"|[^,}]*)', "", (directory / "report.html").read_text())
                 for directory in (other, self.result("sweep-sobol"))]
        self.assertEqual(pages[0], pages[1])

    def test_a_directory_without_result_is_refused(self):
        done = subprocess.run([PROGRAM, "report", str(self.folder)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("not a result directory: it has no study.yaml; give a directory that 'twum run' wrote", done.stderr)


if __name__ == "__main__":
    main()
