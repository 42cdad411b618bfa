# SPDX-License-Identifier: Apache-2.0
"""Order, notation and pictures of report pages: figures_test.py TWUM"""
import csv
import json
import math
import pathlib
import random
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import ROOT, RPM, Page, main, twum  # noqa: E402

PREFIXES = {"T": 1e12, "G": 1e9, "M": 1e6, "k": 1e3, "": 1, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}
# Colours do not move what stands on a page: dark once for the widest and once for a phone.
WIDTHS = ((1400, False), (1400, True), (400, True), (360, False))
PAPER = 794  # A4 at 96 px an inch

# Words of up to 20 letters that stand on two lines.
BROKEN = """(() => { const found = []; const range = document.createRange(); const walk = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) for (const {0: word, index} of walk.currentNode.data.matchAll(/[^\\s\\-\\/]{2,20}/g)) {
        range.setStart(walk.currentNode, index); range.setEnd(walk.currentNode, index + word.length);
        if (!walk.currentNode.parentElement.closest('pre, code') && new Set([...range.getClientRects()].map((r) => Math.round(r.top))).size > 1) found.push(word); }
    return found; })()"""


class Order(Page):
    """The answer, the picture, then the rest; at every width."""

    STUDIES = ("optimize-ring-60", "size-05Nm-100rpm", "pareto-power-wear", "sweep-sobol", "sweep-grid", "paper-figure-4", "tolerances", "calibrate",
               "sensitivity-morris", "frequency-voltages", "efficiency-map", "robust-ring-60")

    def test_a_picture_follows_the_verdict_and_nothing_is_empty_or_cut(self):
        for study in self.STUDIES:
            directory = self.result(study)
            for width, dark in WIDTHS:
                with self.subTest(study, width=width, dark=dark):
                    self.open(directory, width=width, dark=dark)
                    self.clean(directory)
                    verdict, picture = self.browser.value("[...document.querySelectorAll('.card')].slice(0, 2).map((c) => [c.classList.contains('verdict'), c.querySelectorAll('canvas, .bars svg').length])")
                    self.assertTrue(verdict[0])
                    self.assertGreater(picture[1], 0)
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                    # A card has a title and more than that, or is the verdict.
                    bare = self.browser.value("[...document.querySelectorAll('.card:not(.verdict)')].filter((c) => !c.querySelector('h2') || c.innerText.trim() === c.querySelector('h2').innerText.trim() && !c.querySelector('canvas, details')).length")
                    self.assertEqual(bare, 0)
                    # Below the axis of a chart there is no more than the card's own margin [px].
                    gaps = self.browser.value("""[...document.querySelectorAll('.card')].filter((c) => c.lastElementChild.classList.contains('figure'))
                        .map((c) => c.getBoundingClientRect().bottom - c.querySelector('.figure:last-child canvas').getBoundingClientRect().bottom)""")
                    self.assertLessEqual(max(gaps, default=0), 25)
                    self.assertEqual(self.browser.value(BROKEN), [])
                    # Bars have room: no shorter than a word of twelve letters, with the zero line at 1 % of it.
                    self.assertGreaterEqual(min(self.browser.value("[...document.querySelectorAll('.bars svg')].map((s) => s.getBoundingClientRect().width)"), default=96), 95)

    def test_paper_holds_the_page_in_dark_ink(self):
        for study in self.STUDIES:
            with self.subTest(study):
                self.open(self.result(study), width=PAPER, dark=True)
                self.browser.send("Emulation.setEmulatedMedia", {"media": "print"})
                self.browser.value("dispatchEvent(new Event('beforeprint'))")
                self.browser.settle()
                self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), PAPER)
                ink, card = self.browser.value("['--ink', '--card'].map((n) => getComputedStyle(document.documentElement).getPropertyValue(n).trim())")
                self.assertLess(int(ink[1:3], 16), 64)  # red of the text
                self.assertEqual(card, "#fff")
                self.assertTrue(all(n > 8 for n in self.colours("main canvas")))
                # Nothing to press is on paper; headings that sort a table are its words there.
                self.assertEqual(self.browser.value("[...document.querySelectorAll('button')].filter((b) => b.getClientRects().length && !b.closest('th')).length"), 0)
                self.browser.value("dispatchEvent(new Event('afterprint'))")
                self.browser.send("Emulation.setEmulatedMedia", {"media": ""})

    def test_the_contents_lead_to_every_part(self):
        self.open(self.result("optimize-ring-60"))
        titles = self.lines(".card h2")
        self.assertEqual(self.lines("nav a"), titles)
        self.assertTrue(self.browser.value("[...document.querySelectorAll('nav a')].every((a) => document.querySelector(a.getAttribute('href')))"))

    def test_a_long_table_shows_all_its_rows_when_asked_and_on_paper(self):
        summary = self.open(self.result("pareto-power-wear"))
        shown = "[...document.querySelectorAll('[data-table=front] tbody tr')].filter((r) => r.getClientRects().length).length"
        self.assertEqual(self.browser.value(shown), 8)
        self.browser.send("Emulation.setEmulatedMedia", {"media": "print"})
        self.assertEqual(self.browser.value(shown), len(summary["front"]))
        self.browser.send("Emulation.setEmulatedMedia", {"media": ""})
        self.browser.value("[...document.querySelectorAll('button')].find((b) => b.textContent.startsWith('Show all 50 rows')).click()")
        self.assertEqual(self.browser.value(shown), len(summary["front"]))


class Notation(Page):
    def test_units_are_written_as_in_a_textbook(self):
        for study in Order.STUDIES:
            with self.subTest(study):
                self.open(self.result(study))
                # What is as one types it: the study, file names, the names column, and the program's notes on the model.
                text = self.browser.value("""(() => { for (const n of document.querySelectorAll('pre, code, #notes, [data-table=names], [data-table=motor]')) n.remove();
                    return document.querySelector('main').innerText; })()""")
                self.assertEqual(re.findall(r"\S*(?:\^\d|\bN\.m|[\d\xa0 ]um\b|\de[+-]\d)\S*", text), [])

    def test_values_read_as_on_the_terminal(self):
        said = twum("run", ROOT / "examples/studies/optimize-ring-60.yaml", "-o", self.folder / "said").stdout
        self.open(self.folder / "said")
        rows = self.browser.value("[...document.querySelectorAll('[data-table=metrics] tbody tr, [data-table=design] tbody tr')].map((r) => [r.cells[0].dataset.name ?? r.cells[0].textContent, r.cells[1].textContent, r.cells[2].textContent])")
        self.assertGreater(len(rows), 15)
        for name, *values in rows:
            # Letters that the page has and not every terminal.
            plain = [v.replace("\u00a0", " ").replace("µ", "u").replace("·", ".").replace("²", "^2") for v in values]
            self.assertRegex(said, re.escape(name) + r"  +" + r"  +".join(map(re.escape, plain)) + r"( |\n)", name)

    def test_a_value_reads_back_to_four_digits(self):
        self.open(self.result("optimize-ring-60"))
        chance = random.Random(5)
        for unit, shown in (("m", "m"), ("Pa", "Pa"), ("N.m", "N·m"), ("W/m^2", "W/m²"), ("N.s/m", "N·s/m")):
            for _ in range(40):
                value = chance.choice((-1, 1)) * 10 ** chance.uniform(-11.9, 12.9)
                number, text = self.browser.value(f"engineering({value!r}, '{unit}')").split("\u00a0")
                self.assertTrue(text.endswith(shown))
                self.assertAlmostEqual(float(number) * PREFIXES[text[:-len(shown)]], value, delta=5.001e-4 * abs(value))
                self.assertLess(abs(float(number)), 1000 if abs(value) < 9.999e14 else math.inf)
        for unit in ("kg/m^3", "1/s"):  # a prefix would be wrong
            self.assertNotRegex(self.browser.value(f"engineering(12345, '{unit}')"), "[kM](kg|1/)")
        self.assertEqual(self.browser.complaints(), [])  # a unit that the program did not list


class Figures(Page):
    def press(self, text, within="main"):
        self.browser.value("[...document.querySelectorAll('%s button')].find((b) => b.textContent === '%s').click()" % (within, text))
        self.browser.settle()

    def test_a_drag_zooms_and_escape_goes_back(self):
        self.open(self.result("optimize-ring-60"))
        whole = self.scale("torque", "x")
        left, above, width, height = self.box("torque")
        self.browser.drag(left + 0.25 * width, above + 0.5 * height, left + 0.75 * width, above + 0.505 * height)
        low, high = self.scale("torque", "x")
        pixel = (whole[1] - whole[0]) / width
        self.assertAlmostEqual(low, whole[0] + 0.25 * (whole[1] - whole[0]), delta=2 * pixel)
        self.assertAlmostEqual(high, whole[0] + 0.75 * (whole[1] - whole[0]), delta=2 * pixel)
        wide = high - low
        self.browser.value("document.querySelector('[data-chart=torque]').focus()")
        self.browser.key("+")
        # What lies outside has no mark and no label.
        inside = self.browser.value("(() => { const u = document.querySelector('[data-chart=torque]').plot; return u.options.marks.filter((m) => isInside(u, m.x, m.y)).map((m) => m.x); })()")
        marks = self.browser.value("document.querySelector('[data-chart=torque]').plot.options.marks.map((m) => [m.x, m.y])")
        low, high = self.scale("torque", "x")
        self.assertEqual(inside, [x for x, _ in marks if low <= x <= high])
        near = self.scale("torque", "x")
        self.assertAlmostEqual(near[1] - near[0], wide / 2, delta=2 * pixel)
        self.browser.key("Escape")
        self.assertEqual(self.scale("torque", "x"), whole)

    def test_a_logarithmic_axis_has_the_geometric_mean_in_its_middle(self):
        self.open(self.result("pareto-power-wear"))
        for key, ask in (("x", "width"), ("y", "height")):
            self.press("log " + key)
            low, high = self.scale("front", key)
            self.assertGreater(low, 0)
            place = self.browser.value("document.querySelector('[data-chart=front]').plot.valToPos(%r, '%s')" % (math.sqrt(low * high), key))
            self.assertAlmostEqual(place, self.browser.value("document.querySelector('[data-chart=front] .u-over').client%s" % ask.capitalize()) / 2, delta=0.5)
        # Numbers stand at whole multiples of a power of ten, several of them on either axis.
        for axis in (0, 1):
            shown = self.browser.value("(() => { const u = document.querySelector('[data-chart=front]').plot; return u.axes[%d]._values.filter((v) => v !== '').map(Number); })()" % axis)
            self.assertGreater(len(shown), 3)
            for v in shown:
                leading = v / 10 ** math.floor(math.log10(v) + 1e-9)
                self.assertAlmostEqual(leading, round(leading), delta=1e-6)
        self.press("log x")
        # The point chosen by a click is still the one under it.
        x, y = self.browser.value("(() => { const u = document.querySelector('[data-chart=front]').plot; return [u.valToPos(u.data[0][3], 'x'), u.valToPos(u.data[1][3], 'y')]; })()")
        left, above, _, _ = self.box("front")
        self.browser.click(left + x, above + y)
        power = self.browser.value("document.querySelector('[data-chart=front]').plot.data[0][3]")
        chosen = int(re.search(r"Point (\d+)", self.text("#chosen h2"))[1]) - 1
        self.assertAlmostEqual(self.browser.value("summary.front[%d].metrics.peak_power" % chosen), power, delta=1e-9 * power)

    def test_a_saved_picture_is_the_chart_in_light_colours(self):
        self.open(self.result("optimize-ring-60"), dark=True)
        name, width, height, corner, colours = self.browser.value("""new Promise((done) => {
            saveBlob = async (name, blob) => { const image = await createImageBitmap(blob); const c = document.createElement('canvas'); c.width = image.width; c.height = image.height;
              const ctx = c.getContext('2d'); ctx.drawImage(image, 0, 0); const p = ctx.getImageData(0, 0, c.width, c.height).data; const seen = new Set();
              for (let i = 0; i < p.length; i += 4) seen.add(p[i] << 16 | p[i + 1] << 8 | p[i + 2]); done([name, c.width, c.height, [...p.slice(0, 3)], seen.size]); };
            [...document.querySelectorAll('button')].find((b) => b.textContent === 'Save picture').click(); })""")
        self.assertEqual(name, "Torque: before and after.png")
        own = self.browser.value("(() => { const c = document.querySelector('[data-chart=torque] canvas'); return [c.width, c.height]; })()")
        self.assertEqual(width, own[0])
        self.assertGreater(height, own[1])  # title and legend stand above
        self.assertEqual(corner, [255, 255, 255])
        self.assertGreater(colours, 20)
        self.assertTrue(self.browser.value("isDark()"))

    def test_limits_and_duty_stand_on_the_curves_where_the_study_has_them(self):
        self.open(self.result("size-05Nm-100rpm"))
        place = "data.sections.flatMap((s) => s.charts).find((c) => c?.name === '%s').bounds.map((b) => [b.x / rpm, b.y, b.least])"
        (x, y, least), = self.browser.value(place % "torque")
        self.assertAlmostEqual(x, 100, delta=1e-9)
        self.assertEqual((y, least), (0.5, True))
        (x, y, least), = self.browser.value(place % "wear intensity")
        self.assertAlmostEqual(x, 100, delta=1e-9)
        self.assertEqual((y, least), (1e4, False))
        # An efficiency at a load stands at the speed at which the motor carries it.
        (x, y, least), = self.browser.value(place % "efficiency")
        table = twum("evaluate", self.result("size-05Nm-100rpm") / "best.yaml", "--metrics", "speed_at(0.5 N.m)").stdout
        row, = csv.DictReader(table.splitlines())
        speed = next(float(v) for k, v in row.items() if k.startswith("speed_at")) / RPM
        self.assertAlmostEqual(x, speed, delta=1e-3 * speed)  # 161 points of the curve, linear between them
        self.assertEqual((y, least), (0.2, True))

    def test_speeds_at_which_a_motor_squeals_are_marked_on_its_torque(self):
        directory = self.result("optimize-ring-60")
        self.open(directory)
        self.assertIn("squeals", self.lines(".card:has([data-chart=torque]) .legend span"))
        squeals = self.browser.value("data.sections[0].charts[0].series.map((s) => s.broad ?? [])")
        self.assertEqual(squeals[0], [])
        (first, last), = squeals[1]
        # The program's own points, which are as far apart as those of the page [rad/s].
        points = json.loads(twum("curve", directory / "best.yaml", "--points", 51, "--format", "json").stdout)["curve"]
        speeds = [p["speed"] for p in points if p["squeals"]]
        self.assertEqual((first, last), (speeds[0], speeds[-1]))

    def test_labels_of_a_front_cover_no_point(self):
        for study in ("pareto-power-wear", "pareto-torque-speed"):
            self.open(self.result(study))
            covered = self.browser.value("""(() => { const u = document.querySelector('[data-chart="front"]').plot; const places = drawnPlaces(u); const taken = [];
                let hidden = 0; for (const m of u.options.marks) { const [x, y] = [u.valToPos(m.x, 'x', true), u.valToPos(m.y, 'y', true)]; drawLabel(u, m.text, x, y, taken, places); }
                for (const b of taken) hidden += places.filter(([x, y]) => x > b.left && x < b.right && Math.abs(y - b.y) < 5).length; return hidden; })()""")
            self.assertEqual(covered, 0, study)

    def test_the_search_is_not_flattened_by_outliers(self):
        directory = self.result("optimize-ring-60")
        summary = self.open(directory)
        low, high = self.scale("search", "y")
        with open(directory / "results.csv", newline="") as file:
            powers = [float(row["peak_power [W]"]) for row in csv.DictReader(file) if row["peak_power [W]"]]
        best = summary["best"]["metrics"]["peak_power"]
        self.assertTrue(low < best < high)
        self.assertGreater(max(powers), 2 * best)  # of motors that violate a limit
        self.assertLess(high, 1.2 * best)
        beyond = sum(not low <= p <= high for p in powers)
        self.assertIn(f"{beyond} of them lie beyond the axis", self.text("section:has([data-chart=search])"))


class Front(Page):
    def test_a_point_has_its_file_every_metric_and_its_motor_to_save(self):
        directory = self.result("pareto-power-wear")
        summary = self.open(directory)
        for point in (0, 17):
            self.browser.value("document.querySelector('[data-chart=parallel]').parallel.choose(%d)" % point)
            name = self.text("#chosen code")
            self.assertEqual(name, f"front/{point + 1:02d}.yaml")
            self.browser.value("save = (name, text) => { window.saved = [name, text]; }; [...document.querySelectorAll('#chosen button')].find((b) => b.textContent === 'Save motor').click()")
            self.assertEqual(self.browser.value("window.saved"), [f"{point + 1:02d}.yaml", (directory / name).read_text()])
            shown = self.table(f"point-metrics-{point + 1}")
            self.assertEqual({k: v[1] for k, v in shown.items()}, summary["front"][point]["metrics"])


class Track(Page):
    def test_the_contact_is_shown_over_the_track_and_beside_one_slice(self):
        (self.folder / "wide.yaml").write_text(f"twum: 1\nmotor: {ROOT}/tests/data/motors/ring-60.yaml\nset: {{radial_slices: 8}}\nstudy: {{kind: curve}}\n")
        twum("run", self.folder / "wide.yaml", "-o", self.folder / "wide")
        self.open(self.folder / "wide")
        self.clean(self.folder / "wide")
        pictures = "[data-chart='track pressure'] canvas, [data-chart='track slip speed'] canvas"
        self.assertTrue(all(n > 100 for n in self.colours(pictures)))
        self.assertEqual(len(self.colours(pictures)), 2)
        self.browser.value("[...document.querySelectorAll('button')].find((b) => b.textContent === 'Compare with one slice').click()")
        self.browser.settle()
        speeds, torques = self.browser.value("(() => { const { data } = document.querySelector('[data-chart=torque]').plot; return [[...data[0]], [...data[2]]]; })()")
        unit = self.browser.value("displayUnit(largest(curves.map(c => c.torque)), 'N.m').divisor")
        told = json.loads(twum("curve", ROOT / "tests/data/motors/ring-60.yaml", "--speeds", f"{speeds[150]!r} rpm", "--format", "json").stdout)
        # Point 150 of 161.
        self.assertAlmostEqual(torques[150] * unit, told["curve"][0]["torque"], delta=1e-9 * abs(torques[0] * unit))


if __name__ == "__main__":
    main()
