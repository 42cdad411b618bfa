# SPDX-License-Identifier: Apache-2.0
"""The page of twum explore in a real browser, and its panel in reports: designer_test.py TWUM"""
import json
import pathlib
import re
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from designer_page import PANEL, Designer  # noqa: E402
from page import ROOT, main, twum  # noqa: E402

MOTORS = sorted(path.stem for path in (ROOT / "examples/motors").glob("*.yaml"))
OF_HEAT = ("thermal_time_constant", "continuous_torque", "start_temperature", "stator_peak_temperature", "rotor_peak_temperature", "housing_peak_temperature",
           "contact_peak_temperature")
HOSTILE = "</script><script>window.hacked=1</script><img src=x onerror=hacked=1> \"quoted\" 'single' 電動機 محرك µ " + "long " * 40


class Looks(Designer):
    def test_every_example_opens_clean_and_drawn_at_every_width(self):
        for name in MOTORS:
            for width, dark in ((1400, False), (400, False), (360, False), (1400, True)):
                with self.subTest(name, width=width, dark=dark):
                    page = self.explore(name, width=width, dark=dark)
                    self.quiet(page)
                    self.assertEqual(self.text("h1"), name + " designer")
                    # Axes, their words and a line with its smoothed edges are many colours.
                    drawn = self.colours("main .chart canvas, main canvas.wave")
                    # A start and a stop, of a motor that has one, take two more.
                    self.assertTrue(len(drawn) == (8 if name == "moving-60" else 6) and all(n > 8 for n in drawn), drawn)
                    # Nothing sticks out of the page.
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)

    def test_the_page_admits_no_script_but_its_own_and_no_request(self):
        page = self.explore("ring-60").read_text()
        policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page)[1]
        self.assertNotIn("unsafe-inline", policy)
        self.assertRegex(policy, r"^default-src 'none'; script-src 'wasm-unsafe-eval' 'sha256-[\w+/]{43}='; style-src 'sha256-[\w+/]{43}='; base-uri 'none'; form-action 'none'$")
        self.browser.value("document.body.append(Object.assign(document.createElement('script'), {textContent: 'window.hacked = 1'})); fetch('x.json').catch(() => 0)")
        self.assertIsNone(self.browser.value("window.hacked"))
        self.assertTrue(any("Content Security Policy" in text for text in self.browser.complaints()))

    def test_names_of_files_stay_text(self):
        folder = self.folder / "hostile"
        folder.mkdir()
        text = (ROOT / "examples/motors/ring-60.yaml").read_text().replace("name: ring-60", "name: " + json.dumps(HOSTILE, ensure_ascii=False))
        (folder / "motor.yaml").write_text(text)
        for width in (1400, 360):
            page = self.explore("hostile-motor", folder / "motor.yaml", width=width)
            self.quiet(page)
            self.assertIsNone(self.browser.value("window.hacked"))
            self.assertIn(HOSTILE.strip(), self.text("h1"))
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)


    def test_axe_finds_no_barrier(self):
        for name, width, dark in (("ring-60", 1400, False), ("ring-60", 360, True), ("plate-60", 1400, True), ("drive-60", 400, False)):
            with self.subTest(name, width=width, dark=dark):
                self.explore(name, width=width, dark=dark)
                self.assertEqual(self.barriers(), [])

    def test_every_control_has_a_name_and_every_id_is_one(self):
        # What a reader of the screen says, and what it cannot do without.
        for name in ("ring-60", "plate-60"):
            self.explore(name)
            nameless = self.browser.value("""[...document.querySelectorAll('button, input:not([type=file]), select, canvas[role], svg[role], [role=img]')].filter((n) =>
                !(n.getAttribute('aria-label') || n.textContent.trim() && n.tagName === 'BUTTON' || n.labels?.length && [...n.labels].every((l) => l.textContent.trim()))).map((n) => n.outerHTML.slice(0, 120))""")
            self.assertEqual(nameless, [])
            self.assertEqual(self.browser.value("(ids => ids.length - new Set(ids).size)([...document.querySelectorAll('[id]')].map(n => n.id))"), 0)
            self.assertEqual(self.browser.value("document.querySelectorAll('h1').length"), 1)

    def test_a_motor_without_terminals_has_no_line_for_them(self):
        for name, shown in (("ring-60", False), ("drive-60", True)):
            self.explore(name)
            words = self.browser.value("[...document.querySelectorAll('.legend span')].filter(n => n.getClientRects().length).map(n => n.textContent)")
            self.assertEqual(["at the terminals" in words, "input" in words], [shown, shown], name)

    def test_the_powers_of_a_driven_motor_have_the_input(self):
        self.explore("drive-60")
        shown = self.browser.value(f"(c => c.plot.data[1 + 2 * c.shape.lines.findIndex(l => l.name === 'input')].map(v => v === null ? null : v * c.unit.divisor))({PANEL}.charts[1])")
        losses = self.browser.value(f"[...{PANEL}.curve.output_power].map((v, i) => v + ['friction_power', 'layer_loss', 'stator_loss', 'dielectric_loss'].reduce((s, n) => s + {PANEL}.curve[n][i], 0))")
        # Input is output and losses (T7.10, D4.2); the sum has five terms of which each is rounded.
        for power, whole in zip(shown, losses):
            if power is not None:
                self.assertAlmostEqual(power, whole, delta=1e-9 * max(losses))
        self.assertIn("input", self.lines(".pair .legend span"))

    def test_a_motor_with_a_coil_of_the_driver_says_that_the_page_leaves_it_out(self):
        text = (ROOT / "examples/motors/drive-60.yaml").read_text()
        (self.folder / "coil.yaml").write_text(text + "  driver: {inductance: 1 mH, off_resistance: 450 ohm}\n")
        self.quiet(self.explore("coil", self.folder / "coil.yaml"))
        self.assertIn("without the circuit of the driver", self.text(".left-out"))
        saved = self.browser.value(f"motorYaml({PANEL}.state.motor, {PANEL}.tables)")
        self.assertRegex(saved, r"inductance: 0.001 H")
        self.assertRegex(saved, r"off_resistance: 450 ohm")

    def test_a_motor_with_radial_motion_says_that_the_page_leaves_it_out(self):
        text = (ROOT / "examples/motors/plate-60.yaml").read_text()
        (self.folder / "radial.yaml").write_text(re.sub(r"(?m)^    wavelengths:", "    radial_motion: true\n    wavelengths:", text, count=1))
        told = "document.querySelector('.left-out').offsetHeight > 0"
        page = self.explore("radial", self.folder / "radial.yaml")
        self.quiet(page)
        self.assertTrue(self.browser.value(told))
        self.assertIn("without the radial motion", self.text(".left-out"))
        # It stays in a motor that the page saves and reads again.
        saved = self.browser.value(f"motorYaml({PANEL}.state.motor, {PANEL}.tables)")
        self.assertIn("radial_motion: true", saved)
        self.assertEqual(self.browser.value(f"readMotorYaml({json.dumps(saved)}, {PANEL}.tables, {PANEL}.core).besides['stator.radial_motion']"), "true")
        self.explore("drive-60")
        self.assertFalse(self.browser.value(told))

    def test_the_scale_of_the_cross_section_can_be_read(self):
        for name in ("ring-60", "plate-60"):
            for width in (1400, 400):
                with self.subTest(name, width=width):
                    self.explore(name, width=width)
                    # Letters of 11 px have boxes of 12 px and more; those of the page around them have 16 px.
                    height = self.browser.value("document.querySelector('.section text').getBoundingClientRect().height")
                    self.assertTrue(9 < height < 20, height)

    def test_temperatures_are_those_of_the_motor_in_the_file(self):
        self.explore("warm-60")
        told = json.loads(twum("curve", ROOT / "examples/motors/warm-60.yaml", "--points", 2, "--format", "json").stdout)["metrics"]
        shown = dict(zip(self.lines(".fixed span"), self.lines(".fixed strong")))
        self.assertEqual(len(shown), len(OF_HEAT))
        for name in OF_HEAT:
            number, unit = re.split(r"\s", shown[name.replace("_", " ")])
            factor, zero = {"°C": (1, 273.15), "s": (1, 0), "N·m": (1, 0), "mN·m": (1e-3, 0)}[unit]
            value = float(number) * factor + zero
            self.assertAlmostEqual(value, told[name], delta=5.1e-4 * abs(told[name] - zero), msg=name)  # four digits
        # They do not follow the sliders, and are pale then.
        opacity = "getComputedStyle(document.querySelector('.fixed')).opacity"
        self.assertEqual(self.browser.value(opacity), "1")
        self.set("preload", 150)
        self.rest()
        self.assertLess(float(self.browser.value(opacity)), 0.5)
        self.explore("drive-60")
        self.assertEqual(self.browser.value("document.querySelector('.fixed').offsetHeight"), 0)

    def test_a_printed_page_is_as_wide_as_the_paper_and_says_what_was_asked(self):
        self.explore("moving-60")
        self.browser.send("Emulation.setEmulatedMedia", {"media": "print"})
        self.browser.settle()
        width, page, sliders = self.browser.value("[document.querySelector('.right').clientWidth, document.getElementById('page').clientWidth, document.querySelector('.left').clientWidth]")
        self.assertGreater(width, 0.9 * page)
        self.assertEqual(sliders, 0)
        # The duty that is held, and the motor that starts and stops.
        for box in (".hold .exact", ".motion .exact"):
            self.assertGreater(self.browser.value(f"document.querySelector('{box}').offsetHeight"), 0)
        self.browser.send("Emulation.setEmulatedMedia", {"media": ""})

    def test_the_numbers_of_an_axis_do_not_reach_its_name(self):
        # The longest number of each upright axis in the letters of the axis, and its room, of which 8 px lie
        # between number and plot.
        room = """[...document.querySelectorAll('.chart')].filter(n => n.plot?.axes[1]._values).map(({plot: u}) => { u.ctx.save(); u.ctx.font = u.axes[1].font[0];
            const longest = Math.max(...u.axes[1]._values.map(v => u.ctx.measureText(v).width)) / devicePixelRatio; u.ctx.restore(); return u.axes[1]._size - 8 - longest; })"""
        for width in (1400, 400):
            self.explore("moving-60", width=width)
            # A flywheel of 100 kg m^2 reaches 0.002 rpm: "0.0015" takes more than the usual room.
            self.set("load_inertia", 100)
            self.rest()
            rooms = self.browser.value(room)
            self.assertEqual(len(rooms), 7)
            print(f"room of numbers on upright axes at {width} px: {min(rooms):.1f} px or more")
            self.assertGreaterEqual(min(rooms), 0, rooms)

    def test_the_torque_curve_stays_in_sight_on_a_phone(self):
        self.explore("ring-60", width=360, height=740)
        self.browser.value("document.querySelector('[data-parameter=preload]').scrollIntoView()")
        self.browser.settle()
        top, bottom = self.browser.value("(r => [r.top, r.bottom])(document.querySelector('.chief').getBoundingClientRect())")
        self.assertGreaterEqual(top, 0)
        self.assertLess(bottom, 0.6 * 740)


class Numbers(Designer):
    def test_curves_and_metrics_are_those_of_the_command(self):
        for name in MOTORS:
            with self.subTest(name):
                self.explore(name)
                told = json.loads(twum("curve", ROOT / "examples/motors" / f"{name}.yaml", "--points", 161, "--format", "json").stdout)
                for column in set(told["curve"][0]) - {"zones", "squeals"}:
                    own = [row[column] for row in told["curve"]]
                    shown = self.browser.value(f"[...{PANEL}.curve[{json.dumps(column)}]].map(v => Number.isFinite(v) ? v : null)")
                    self.assertEqual([v is None for v in own], [v is None for v in shown], column)
                    # Another libm rounds sines and roots otherwise; the solver stops at some 1e-12 of the scale.
                    scale = max((abs(v) for v in own if v is not None), default=0)
                    self.assertLessEqual(max((abs(a - b) for a, b in zip(own, shown) if a is not None), default=0), 1e-9 * scale, column)
                shown = self.browser.value(f"Object.fromEntries(Object.entries({PANEL}.metrics).map(([n, m]) => [n, m.status === 'ok' ? m.value : null]))")
                # The page's core knows no temperatures and no radial motion.
                told["metrics"] = {metric: value for metric, value in told["metrics"].items()
                                   if metric not in OF_HEAT and metric != "radial_motion_ratio"}
                self.assertEqual(set(shown), set(told["metrics"]))
                for metric, value in told["metrics"].items():
                    if value is None or shown[metric] is None:
                        self.assertEqual(value, shown[metric], metric)
                    else:
                        # A peak or a threshold is found to 1e-9 of itself or of the motor's scale.
                        self.assertAlmostEqual(value, shown[metric], delta=1e-8 * max(abs(value), 1e-9), msg=metric)

    def test_speeds_at_which_a_motor_squeals_are_marked_on_its_torque(self):
        words = "[...document.querySelectorAll('.legend span')].filter(n => n.getClientRects().length).map(n => n.textContent)"
        seen = set()
        for name in MOTORS:
            with self.subTest(name):
                self.explore(name)
                # The program's own points, which are as far apart as those of the page [rad/s].
                points = json.loads(twum("curve", ROOT / "examples/motors" / f"{name}.yaml", "--points", 51, "--format", "json").stdout)["curve"]
                speeds = [p["speed"] for p in points if p["squeals"]]
                ranges = self.browser.value(f"{PANEL}.squeals.ranges")
                self.assertEqual(bool(ranges), bool(speeds))
                self.assertEqual("squeals" in self.browser.value(words), bool(speeds))
                if speeds:
                    self.assertAlmostEqual(ranges[0][0], speeds[0], delta=1e-9 * points[-1]["speed"])
                    self.assertAlmostEqual(ranges[-1][1], speeds[-1], delta=1e-9 * points[-1]["speed"])
                seen.add(bool(speeds))
        self.assertEqual(seen, {True, False})
        # They move with the motor.
        self.explore("drive-60")
        before = self.browser.value(f"{PANEL}.squeals.ranges")
        self.set("preload", 120)
        self.rest()
        self.assertNotEqual(self.browser.value(f"{PANEL}.squeals.ranges"), before)

    def test_a_motor_saved_by_the_page_is_the_motor(self):
        for name in MOTORS:
            with self.subTest(name):
                self.explore(name)
                saved = self.folder / f"{name}-saved.yaml"
                saved.write_text(self.browser.value(f"motorYaml({PANEL}.state.motor, {PANEL}.tables)"))
                again, before = (json.loads(twum("curve", path, "--points", 5, "--format", "json").stdout) for path in (saved, ROOT / "examples/motors" / f"{name}.yaml"))
                self.assertEqual(again["motor"], before["motor"])
                self.assertEqual(again["metrics"], before["metrics"])

    def test_a_motor_file_opened_in_the_page_is_what_the_command_reads(self):
        self.explore("ring-30")
        for name in MOTORS:
            with self.subTest(name):
                text = (ROOT / "examples/motors" / f"{name}.yaml").read_text()
                read = self.browser.value(f"readMotorYaml({json.dumps(text)}, {PANEL}.tables, {PANEL}.core)")
                page = self.folder / f"{name}.html"
                twum("explore", ROOT / "examples/motors" / f"{name}.yaml", "-o", page)
                told = json.loads(page.read_text().split('id="data">')[1].split("</script>")[0])["motor"]
                # What a file leaves at its default is not stated by the page's reader where the core has the same default.
                for parameter, value in read["values"].items():
                    self.assertEqual(told["values"].get(parameter), value, parameter)
                self.assertEqual({k: v for k, v in read.items() if k not in ("values", "besides")}, {k: v for k, v in told.items() if k not in ("values", "besides")})
                # What the page keeps as it is: the entries of the file, as typed there; here in SI units, with those left at 0.
                self.assertLessEqual(set(read["besides"]), set(told["besides"]))

    def test_an_equivalent_circuit_is_read_as_the_command_reads_it(self):
        self.explore("ring-30")
        modal = r"(?m)^    (resonance_frequency|modal_mass|quality_factor|force_factor|blocked_capacitance): .*\n"
        circuit = "    equivalent_circuit: {motional_resistance: 132.5 ohm, motional_inductance: 82.7 mH, motional_capacitance: 0.2014 nF, blocked_capacitance: 8.5 nF, force_factor: 0.55 N/V}\n"
        given = (ROOT / "examples/motors/drive-60.yaml").read_text()
        text = re.sub(modal, "", given).replace("    loss_tangent", circuit + "    loss_tangent")
        (self.folder / "circuit.yaml").write_text(text)
        told = json.loads(twum("curve", self.folder / "circuit.yaml", "--points", 2, "--format", "json").stdout)["motor"]
        read = self.browser.value(f"readMotorYaml({json.dumps(text)}, {PANEL}.tables, {PANEL}.core).values")
        for name in ("resonance_frequency", "modal_mass", "quality_factor", "force_factor", "blocked_capacitance"):
            # A root and four products, each rounded once.
            self.assertAlmostEqual(read[name], told[name], delta=1e-15 * told[name], msg=name)
        for wrong, words in ((text.replace("132.5 ohm", "132.5 V"), "stator.equivalent_circuit.motional_resistance: 132.5 V has the unit V"),
                             (text.replace("82.7 mH", "0 H"), "motional_inductance: 0 H must be above 0"),
                             (text.replace(", force_factor: 0.55 N/V", ""), "stator.equivalent_circuit.force_factor: missing"),
                             (given.replace("    loss_tangent", circuit + "    loss_tangent"), "follows from equivalent_circuit; leave one of the two out")):
            said = self.browser.value(f"(() => {{ try {{ readMotorYaml({json.dumps(wrong)}, {PANEL}.tables, {PANEL}.core); return 'accepted'; }} catch (e) {{ return e.message; }} }})()")
            self.assertIn(words, said)

    def test_wrong_motor_files_are_refused_with_their_entry(self):
        self.explore("ring-60")
        text = (ROOT / "examples/motors/ring-60.yaml").read_text()
        for change, words in (((" 1.6 um", " 1.6 kg"), "stator.amplitude: 1.6 kg has the unit kg"), (("  preload: 160 N", ""), "missing preload"),
                              (("thickness", "thicknes"), "contact_layer.thicknes: this page does not read"), (("twum: 1", "twum: 2"), "begins with \"twum: 1\""),
                              (("kinetic: 0.2 ", "kinetic: [ "), "")):
            said = self.browser.value("(() => { try { readMotorYaml(%s, %s.tables, %s.core); return 'accepted'; } catch (e) { return e.constructor.name + ': ' + e.message; } })()" % (json.dumps(text.replace(*change, 1)), PANEL, PANEL))
            self.assertTrue(said.startswith("MotorFileError: "), said)
            self.assertIn(words, said)

    def test_a_study_saved_by_the_page_passes_the_check_and_keeps_the_motor(self):
        self.explore("ring-60")
        self.browser.value(f"""(() => {{ const {{ limits }} = {PANEL}; limits.metric.value = 'torque_at'; limits.metric.dispatchEvent(new Event('change'));
            limits.at.value = '100 rpm'; limits.value.value = '0.5 N.m'; limits.addLimit(); limits.metric.value = 'max_pressure'; limits.sense.value = '<='; limits.value.value = '10 MPa'; limits.addLimit(); }})()""")
        self.rest()
        self.assertEqual(self.lines(".limits li span"), ["torque at 100 rpm at least 500 mN·m", "max pressure at most 10 MPa"])
        self.assertRegex(self.lines(".limits li b")[0], r"holds: 8\d\d")
        self.browser.value("window.URL.createObjectURL = (blob) => { window.saved = blob; return 'blob:none'; }; document.querySelector('.study button').click()")
        study = self.browser.value("window.saved.text()")
        path = self.folder / "saved-study.yaml"
        path.write_text(study)
        self.assertIn("a valid study file (optimize)", twum("check", path).stdout)
        self.assertIn("torque_at(10.47197551196597", study)


class Sizing(Designer):
    def test_a_motor_sized_by_hand_and_by_the_study_of_the_page_meet(self):
        # One parameter is free and one limit binds: the largest peak power is where the limit is met exactly, which the page's
        # solver finds by moving the preload until the pressure has its limit, and the study by its own search.
        self.explore("ring-60")
        self.browser.value(f"""(() => {{ const p = {PANEL}; p.state.view.lock = {{ metric: 'max_pressure', parameter: 'preload', value: 3e6 }}; p.changed = true; }})()""")
        self.browser.settle()
        self.rest()
        by_hand = self.browser.value(f"{PANEL}.state.motor.values.preload")
        study = self.browser.value(f"""studyYaml({PANEL}.state.opened, {PANEL}.tables, [{{ name: 'preload', min: 60, max: 600 }}], {{ sense: 'maximize', metric: 'peak_power' }},
            [{{ metric: 'max_pressure', argument: 'none', at: 0, sense: '<=', value: 3e6 }}])""")
        (self.folder / "sized.yaml").write_text(study)
        twum("run", self.folder / "sized.yaml", "-o", self.folder / "sized")
        best = json.loads((self.folder / "sized/summary.json").read_text())["best"]["design"]["preload"]
        # The study keeps a limit to a millionth; preload grows with pressure no faster than to its power of 3/2.
        self.assertAlmostEqual(best, by_hand, delta=2e-6 * by_hand)


class InReports(Designer):
    """The panel in a report, opened on the motor that one chooses."""

    def opened(self, name, button="p.explore button"):
        summary = self.open(self.result(name))
        self.browser.value(f"document.querySelector({json.dumps(button)}).click()")
        until = time.monotonic() + 30
        while not self.browser.value("insideReport.panel?.waiting === null && !insideReport.panel.changed"):
            self.assertLess(time.monotonic(), until)
            time.sleep(0.02)
        self.clean(self.result(name))
        return summary

    def metric(self, name):
        return self.browser.value(f"insideReport.panel.metrics.{name}.value")

    def test_the_optimum_opens_with_its_metrics(self):
        summary = self.opened("optimize-ring-60")
        self.assertEqual(self.text(".designer h2"), "best design designer")
        for name in ("peak_power", "no_load_speed", "max_pressure"):
            # The page holds the design to the last digit; another libm rounds otherwise.
            self.assertAlmostEqual(self.metric(name), summary["best"]["metrics"][name], delta=1e-9 * summary["best"]["metrics"][name])

    def test_the_chosen_point_of_a_front_opens(self):
        summary = self.opened("pareto-power-wear", "#chosen p.explore button")
        chosen = int(re.search(r"Point (\d+)", self.text("#chosen h2"))[1]) - 1
        self.assertAlmostEqual(self.metric("peak_power"), summary["front"][chosen]["metrics"]["peak_power"], delta=1e-9 * summary["front"][chosen]["metrics"]["peak_power"])

    def test_a_sample_opens(self):
        self.opened("sweep-sobol", "[data-design] p.explore button")
        row = int(re.match(r"design (\d+)", self.text(".designer h2"))[1]) - 1
        shown, own = self.browser.value(f"(c => [insideReport.panel.metrics[c.name].value, c.values[{row}]])(rows.columns.find(c => Object.hasOwn(insideReport.panel.metrics, c.name)))")
        self.assertAlmostEqual(shown, own, delta=1e-9 * abs(own))

    def test_a_report_grows_by_less_than_600_kilobytes(self):
        page = (self.result("optimize-ring-60") / "report.html").read_text()
        core = re.search(r'id="core">([^<]*)<', page)[1]
        # What cmake/EmbedReport.cmake leaves of the sources: imports, comments that have lines of their own, empty lines and
        # indents stay out of the page.
        left_out = re.compile(r"\nimport [^;]*;|\n *(//[^\n]*|/\*\*.*?\*/)|(?<=\n)export ", re.S)
        parts = sum(len(re.sub(r"\n[\n ]+", "\n", left_out.sub("", path.read_text()))) for path in (ROOT / "studies/page/designer").glob("*.*"))
        tables = sum(len(json.dumps(json.loads(page.split('id="data">')[1].split("</script>")[0])[key])) for key in ("designer", "parameters", "metrics"))
        self.assertLess(len(core) + parts + tables, 600e3)


class Without(Designer):
    def test_a_page_without_the_core_says_what_is_missing(self):
        page = self.explore("ring-60")
        bare = self.folder / "bare.html"
        bare.write_text(re.sub(r'"core":"[^"]*"', '"core":""', page.read_text()))
        self.browser.open(bare)
        self.assertEqual(self.browser.complaints(), [])
        self.assertIn("built without the core for pages", self.text(".verdict"))
        self.assertIn("scripts/install-deps.sh", self.text(".verdict"))


if __name__ == "__main__":
    main()
