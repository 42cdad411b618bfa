# SPDX-License-Identifier: Apache-2.0
"""twum datasheet: what the page says against the other commands, on phones, screens and paper."""
import base64
import json
import re
import subprocess
import time

import page
from page import PROGRAM, ROOT, RPM, twum

MOTORS = ROOT / "examples/motors"
FULL = [word for pair in ("voltage_ratio=0.95", "phase_error=5 deg", "mode_splitting=0.001", "sensor_force_factor=0.05 N/V",
                          "sensor_capacitance=1 nF", "sensor_load_capacitance=1 nF", "sensor_load_resistance=1 Mohm",
                          "sensor_position=10 deg", "rotor_mass=50 g", "thickness=1 mm") for word in ("--set", pair)]
PREFIXES = {"": 1, "T": 1e12, "G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}
UNITS = {"rpm": RPM, "%": 0.01, "N·m": 1, "W": 1, "m": 1, "Pa": 1, "V": 1, "Hz": 1, "A": 1, "": 1, "W/m²": 1, "rad": 1}
# Boxes of the texts of all drawings, and of the drawings themselves, on the screen.
TEXTS = """[...document.querySelectorAll('svg')].flatMap((svg) => { const out = svg.getBoundingClientRect();
    return [...svg.querySelectorAll('text')].map((t) => { const b = t.getBoundingClientRect();
        return [t.textContent, b.left, b.right, b.top, b.bottom, out.left, out.right, out.top, out.bottom]; }); })"""


def si(text):
    """The SI value of a text such as "1.036 N·m"."""
    number, unit = (text.split(" ") + [""])[:2]
    if unit in UNITS:
        return float(number) * UNITS[unit]
    return float(number) * PREFIXES[unit[0]] * UNITS[unit[1:]]


class Sheet(page.Page):
    def sheet(self, *arguments):
        path = self.folder / "sheet.html"
        self.assertEqual(twum("datasheet", *arguments, "-o", path).stdout, f"{path}\n")
        return path

    def show(self, path, width):
        self.browser.events.clear()
        self.browser.send("Emulation.setDeviceMetricsOverride", {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600})
        self.browser.send("Emulation.setEmulatedMedia", {"media": ""})
        self.browser.send("Page.navigate", {"url": "file://" + str(path)})
        while not self.browser.value("document.readyState === 'complete' && location.href.endsWith('sheet.html') && !!document.querySelector('footer')"):
            time.sleep(0.02)
        self.browser.settle()

    def lines(self):
        """{heading: {name: value}} of the lists."""
        return self.browser.value("""Object.fromEntries([...document.querySelectorAll('section')].map((s) => [s.querySelector('h2').textContent,
            Object.fromEntries([...s.querySelectorAll('tr')].map((r) => [...r.children].map((c) => c.textContent.replaceAll('\u00a0', ' '))))]))""")

    def test_a_life_names_its_end_and_is_left_out_with_one_slice(self):
        motor = MOTORS / "worn-60.yaml"
        life = json.loads(twum("life", motor, "--torque", "0.5 N.m", "--points", "2", "--set", "preload_spring=0 N/m", "--format", "json").stdout)
        self.show(self.sheet(motor, "--torque", "0.5 N.m", "--set", "preload_spring=0 N/m"), 1400)
        rated = self.lines()["Rated point"]
        # four digits are shown; the load is that of the speed at which the sheet has its point
        self.assertLess(abs(float(rated["life at this load"].split()[0]) * 3600 / life["life"]["end"]["seconds"] - 1), 1e-3)
        self.assertIn("start voltage", rated["end of the life"])
        self.show(self.sheet(motor, "--torque", "0.5 N.m", "--set", "radial_slices=1"), 1400)
        self.assertEqual(self.lines()["Rated point"]["life at this load"], "not known with one slice")

    def test_numbers_are_those_of_the_curve(self):
        for motor in ("ring-60", "drive-60"):
            with self.subTest(motor):
                self.show(self.sheet(MOTORS / f"{motor}.yaml"), 1400)
                sheet = self.lines()
                metrics = json.loads(twum("curve", MOTORS / f"{motor}.yaml", "--points", "2", "--format", "json").stdout)["metrics"]
                shown = {**sheet["Performance and limits"], **sheet.get("Electrical", {})}
                for name, metric in (("stall torque", "stall_torque"), ("no-load speed", "no_load_speed"), ("peak power", "peak_power"),
                                     ("max efficiency (including stator loss)", "max_efficiency"), ("max pressure", "max_pressure"), ("start voltage", "start_voltage")):
                    if metrics.get(metric) is not None:
                        # Four digits: half a unit of the fourth is at most 1 / 2000 of the value.
                        self.assertAlmostEqual(si(shown[name]) / metrics[metric], 1, delta=1 / 2000)

    def test_the_rated_point_is_the_best_or_the_one_given(self):
        ring = self.sheet(MOTORS / "ring-60.yaml")
        self.show(ring, 1400)
        sheet = self.lines()
        self.assertEqual(sheet["Rated point"]["output power"], sheet["Performance and limits"]["peak power"])
        self.show(self.sheet(MOTORS / "drive-60.yaml"), 1400)
        sheet = self.lines()
        self.assertEqual(sheet["Rated point"]["overall efficiency"], sheet["Electrical"]["max overall efficiency"])
        self.show(self.sheet(MOTORS / "drive-60.yaml", "--torque", "0.5 N.m"), 1400)
        rated = self.lines()["Rated point"]
        self.assertEqual(rated["torque"], "500 mN·m")
        # Power is torque times speed, and all losses and the output make up the electrical power; four digits each.
        self.assertAlmostEqual(si(rated["output power"]), 0.5 * si(rated["speed"]), delta=2e-3 * si(rated["output power"]))
        whole = sum(si(rated[name]) for name in ("output power", "friction power", "layer loss", "stator loss", "dielectric loss"))
        self.assertAlmostEqual(whole, si(rated["electrical power"]), delta=3e-3 * whole)
        self.assertAlmostEqual(si(rated["output power"]) / si(rated["electrical power"]), si(rated["overall efficiency"]), delta=2e-3)

    def test_a_torque_and_a_speed_are_held_by_the_drive(self):
        for motor, change in (("drive-60", ()), ("drive-60", ("--set", "voltage=100 V")), ("ring-60", ())):
            with self.subTest(motor, change=change):
                path = MOTORS / f"{motor}.yaml"
                self.show(self.sheet(path, *change, "--torque", "0.5 N.m", "--speed", "60 rpm"), 1400)
                rated = self.lines()["Rated point"]
                self.assertEqual((rated["torque"], rated["speed"]), ("500 mN·m", "60 rpm"))
                names = {"output power": "output_power_at", "friction power": "friction_power_at"}
                text = self.browser.value("document.body.textContent").replace("\u00a0", " ")
                self.assertIn("Held by the drive", text)
                self.assertIn("Curves and limits are those of the fixed drive", text)
                if motor == "drive-60":
                    rated["drive frequency"] = re.search(r"Held by the drive at ([\d.]+ kHz)\.", text)[1]
                    names |= {"drive frequency": "drive_frequency_at", "voltage": "drive_voltage_at", "electrical power": "electrical_power_at",
                              "phase current": "phase_current_at"}
                metrics = ", ".join(f"{name}(0.5 N.m, 60 rpm)" for name in names.values())
                row = twum("evaluate", path, *change, "--metrics", metrics).stdout.splitlines()[-1].split(",")
                for name, value in zip(names, row):
                    self.assertAlmostEqual(si(rated[name]) / float(value), 1, delta=1 / 2000, msg=name)  # four digits are shown

    def test_a_held_point_beyond_the_curve_is_in_the_charts(self):
        # At a high frequency the fixed drive is slow; a drive that follows holds more than its no-load speed.
        self.show(self.sheet(MOTORS / "drive-60.yaml", "--set", "frequency=43 kHz", "--torque", "0.3 N.m", "--speed", "120 rpm"), 1400)
        self.assertLess(si(self.lines()["Performance and limits"]["no-load speed"]), 120 * RPM)
        boxes = self.browser.value("""[...document.querySelectorAll('.wide > div > svg')].map((svg) => {
            const out = svg.getBoundingClientRect();
            const mark = [...svg.querySelectorAll('path')].find((p) => p.getAttribute('d').endsWith('h0')).getBoundingClientRect();
            return [mark.left - out.left, out.right - mark.right, mark.top - out.top, out.bottom - mark.bottom]; })""")
        self.assertEqual(len(boxes), 3)
        self.assertGreaterEqual(min(min(box) for box in boxes), 0)

    def test_marks_are_on_their_curves(self):
        self.show(self.sheet(MOTORS / "drive-60.yaml"), 1400)
        # The curve of the terminals is the last one of its chart.
        charts = self.browser.value("""[...document.querySelectorAll('.wide > div > svg')].map((svg) => {
            const paths = [...svg.querySelectorAll('path')].map((p) => p.getAttribute('d'));
            return [paths.find((d) => d.endsWith('h0')), paths.filter((d) => d.length > 500).at(-1)]; })""")
        self.assertEqual(len(charts), 3)
        for mark, d in charts:
            x, y = map(float, re.fullmatch(r"M([\d.]+) ([\d.]+)h0", mark).groups())
            points = [tuple(map(float, p)) for p in re.findall(r"[ML]([\d.]+) ([\d.]+)", d)]
            (x0, y0), (x1, y1) = max(p for p in points if p[0] <= x), min(p for p in points if p[0] > x)
            # Straight between 240 places: the sag of a curve 200 high is far below a tenth.
            self.assertAlmostEqual(y, y0 + (y1 - y0) * (x - x0) / (x1 - x0), delta=0.1)

    def test_nothing_is_cut_or_asked_for(self):
        for motor in ("ring-60", "drive-60", "plate-60", "disc-90"):
            path = self.sheet(MOTORS / f"{motor}.yaml")
            for width in (360, 400, 1400):
                with self.subTest(motor=motor, width=width):
                    self.show(path, width)
                    self.assertEqual(self.browser.complaints(), [])
                    self.assertEqual(self.browser.requests(), ["file://" + str(path)])
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                    boxes = self.browser.value(TEXTS)
                    self.assertGreater(len(boxes), 20)
                    for text, left, right, top, bottom, *out in boxes:
                        self.assertTrue(left >= out[0] - 1 and right <= out[1] + 1 and top >= out[2] - 1 and bottom <= out[3] + 1, text)
                    for i, (text, left, right, top, bottom, *_) in enumerate(boxes):
                        for other, l, r, t, b, *_ in boxes[i + 1:]:
                            over = min(right, r) - max(left, l) > 1 and min(bottom, b) - max(top, t) > 3
                            self.assertFalse(over, (text, other))

    def test_it_prints_on_one_sheet_of_a4(self):
        for arguments in (("ring-60",), ("drive-60",), ("plate-60",), ("plate-60", *FULL),
                          ("plate-60", "--torque", "0.3 N.m"), ("plate-60", "--torque", "0.3 N.m", "--speed", "60 rpm")):
            with self.subTest(arguments):
                self.show(self.sheet(MOTORS / f"{arguments[0]}.yaml", *arguments[1:]), 1000)
                pdf = base64.b64decode(self.browser.send("Page.printToPDF", {"preferCSSPageSize": True, "printBackground": True})["data"])
                self.assertEqual(len(re.findall(rb"/Type /Page\b(?!s)", pdf)), 1)
                box = [float(v) for v in re.search(rb"/MediaBox \[([^\]]*)\]", pdf)[1].split()]
                self.assertAlmostEqual(box[2] / 72 * 25.4, 210, delta=0.5)
                self.assertAlmostEqual(box[3] / 72 * 25.4, 297, delta=0.5)

    def test_motors_that_drive_nothing_have_a_sheet(self):
        for motor, setting in (("ring-60", "amplitude=0 m"), ("ring-60", "preload=0 N"), ("drive-60", "voltage=1 V"), ("ring-60", "mu_0=0.4")):
            with self.subTest(setting):
                self.show(self.sheet(MOTORS / f"{motor}.yaml", "--set", setting), 1400)
                self.assertEqual(self.browser.complaints(), [])
        self.show(self.sheet(MOTORS / "drive-60.yaml", "--set", "voltage=1 V"), 1400)
        text = self.browser.value("document.body.textContent")
        self.assertIn("drives no load at any speed", text)
        self.assertIn("There is none: this motor drives no load.", text)

    def test_names_are_text(self):
        motor = (MOTORS / "ring-60.yaml").read_text()
        for name in ("<script>alert(1)</script>", "<!--SHEET-->", "</title><b>", "&lt;", "a\"b'c", "größe 電動機"):
            with self.subTest(name):
                path = self.folder / "hostile.yaml"
                path.write_text(motor.replace("name: ring-60", "name: " + json.dumps(name, ensure_ascii=False)))
                self.show(self.sheet(path), 1400)
                self.assertEqual(self.browser.value("document.querySelector('h1').textContent"), name)
                self.assertEqual(self.browser.value("document.title"), name + " - data sheet")
                self.assertEqual(self.browser.value("document.querySelectorAll('script, b').length"), 0)


class Command(page.Page):
    def run_in(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, check=False)

    def test_the_motor_of_a_study(self):
        directory = self.result("optimize-ring-60")
        done = self.run_in("datasheet", directory)
        self.assertEqual(done.stdout, "optimize-ring-60-datasheet.html\n", done.stderr)
        # The motor says of its file where it is; all else is the same.
        ours = (self.folder / "optimize-ring-60-datasheet.html").read_text()
        self.assertEqual(ours, self.run_in("datasheet", directory / "best.yaml", "-o", "-").stdout)
        front = self.run_in("datasheet", self.result("pareto-torque-speed"))
        self.assertEqual(front.returncode, 2)
        self.assertIn("give a motor file, such as one in ", front.stderr)

    def test_where_it_comes_from(self):
        text = self.run_in("datasheet", MOTORS / "ring-60.yaml", "-o", "-").stdout
        self.assertIn(re.search(r"[\d.]+", self.run_in("--version").stdout)[0], text)
        self.assertIn("ring-60.yaml", text)
        hashes = [re.search(r"Hash of the motor: ([0-9a-f]{16})\.", self.run_in("datasheet", MOTORS / "ring-60.yaml", "--set", f"preload={n} N", "-o", "-").stdout)[1]
                  for n in (160, 160.0001)]
        self.assertEqual(hashes[0], re.search(r"Hash of the motor: (\w+)", text)[1])
        self.assertNotEqual(hashes[0], hashes[1])

    def test_refusals(self):
        ring = MOTORS / "ring-60.yaml"
        weak = self.run_in("datasheet", ring, "--speed", "10 rpm", "--torque", "5 N.m", "-o", "x.html")
        self.assertEqual(weak.returncode, 1)
        self.assertIn("does not hold this torque at this speed: torque-out-of-reach", weak.stderr)
        self.assertEqual(self.run_in("datasheet", ring, "--speed", "0 rpm", "--torque", "0.5 N.m").returncode, 2)
        self.assertEqual(self.run_in("datasheet", ring, "--torque", "5 N.m", "-o", "x.html").returncode, 1)
        self.assertFalse((self.folder / "x.html").exists())
        self.assertEqual(self.run_in("datasheet", ring, "-o", ring).returncode, 2)


if __name__ == "__main__":
    page.main()
