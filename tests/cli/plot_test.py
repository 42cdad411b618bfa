# SPDX-License-Identifier: Apache-2.0
"""--plot: files, what the pictures show, hostile names, failures."""
import json
import math
import os
import re
import struct
import xml.etree.ElementTree as ElementTree

import program
from picture import BLUE, SVG, Picture, scale
from program import DRIVE, RING, ROOT

RPM = math.pi / 30
HOSTILE = ("<script>alert(1)</script>", "it's '; system('touch hacked'); '", "a`touch hacked`b", "@x {/Bold y} ~z^2_3 \\n",
           '"quoted" & more', "größe 電動機 µ", "x" * 5000, "line\\nbreak", "%d %s $1", "set output 'hacked'", " ")


class Curve(program.Case):
    def picture(self, *arguments):
        path = self.folder / "curve.svg"
        self.ok("curve", *arguments, "--plot", path)
        return Picture(path)

    def test_axes_and_line_are_those_of_the_data(self):
        picture = self.picture(RING)
        data = json.loads(self.ok("curve", RING, "--format", "json"))
        right = max(y for _, _, y in picture.texts if y < 840)
        self.assertIn("speed [rpm]", picture.words())
        self.assertIn("torque [mN·m]", picture.words())
        self.assertIn("power [W]", picture.words())
        tics_x = picture.numbers(0, right - 20, right)
        per_rpm, zero = scale(tics_x)
        line = picture.lines[BLUE][0]
        # Coordinates have two decimals, so an end of the line is known to 0.01 pixels.
        last = data["curve"][-1]["speed"] / RPM
        self.assertAlmostEqual((line[0][0] - zero) / per_rpm, 0, delta=0.02 / per_rpm)
        self.assertAlmostEqual((line[-1][0] - zero) / per_rpm, last, delta=0.02 / per_rpm)
        # Labels of the vertical axis stand a constant below their tics, so only differences count.
        tics_y = picture.numbers(1, 0, line[0][0])
        top = {v: y for v, y in tics_y.items() if abs(v) >= 100}
        per_torque, _ = scale(top)
        fall = 1e3 * (data["curve"][-1]["torque"] - data["curve"][0]["torque"])
        self.assertAlmostEqual((line[-1][1] - line[0][1]) / per_torque, fall, delta=0.04 / abs(per_torque))

    def test_the_contact_efficiency_falls_to_0_at_no_load(self):
        picture = self.picture(RING)
        per_rpm, zero = scale(picture.numbers(0, max(y for _, _, y in picture.texts if y < 840) - 20, 840))
        no_load = json.loads(self.ok("curve", RING, "--format", "json"))["metrics"]["no_load_speed"] / RPM
        line = picture.lines[BLUE][-1][2:]  # behind the two points of its sample in the key
        # The picture's coordinates have two decimals; the panel is over 150 pixels high for 100 %.
        self.assertAlmostEqual((line[-1][0] - zero) / per_rpm, no_load, delta=0.02 / per_rpm)
        self.assertAlmostEqual(line[-1][1], line[0][1], delta=0.02)
        self.assertGreater(line[0][1] - min(y for _, y in line), 140)

    def test_metrics_are_marked_with_their_values(self):
        words = " | ".join(self.picture(RING).words())
        metrics = json.loads(self.ok("curve", RING, "--format", "json"))["metrics"]
        for pattern, value in ((r"stall ([\d.]+) mN.m", metrics["stall_torque"] * 1e3),
                               (r"plateau to ([\d.]+) rpm", metrics["plateau_speed"] / RPM),
                               (r"no load ([\d.]+) rpm", metrics["no_load_speed"] / RPM),
                               (r"peak power ([\d.]+) W at", metrics["peak_power"]),
                               (r"W at ([\d.]+) rpm", metrics["speed_at_peak_power"] / RPM)):
            # Labels have three digits: half a unit of the third is at most 1 / 200 of the value.
            self.assertAlmostEqual(float(re.search(pattern, words)[1]) / value, 1, delta=1 / 200)

    def test_a_quality_factor_counts_as_damping(self):
        given = ("--set", "amplitude=1.7 um")
        self.assertTrue({"stator", "of the motor at its terminals"} <= set(self.picture(DRIVE, *given).words()))
        undamped = self.picture(DRIVE, *given, "--set", "modal_damping=0 N.s/m").words()
        self.assertFalse({"stator", "stator loss", "with the stator's loss"} & set(undamped))

    def test_what_becomes_of_the_electrical_power_is_stacked(self):
        path = self.folder / "drive.svg"
        point = json.loads(self.ok("curve", DRIVE, "--speeds", "0 rpm, 100 rpm", "--plot", path, "--format", "json"))["curve"][0]
        picture = Picture(path)
        self.assertTrue({"output", "friction", "layer", "stator", "ceramic", "electrical power [W]"} < set(picture.words()))
        fills = []
        for element in ElementTree.parse(path).getroot().iter(SVG + "polygon"):
            places = [tuple(map(float, p)) for p in re.findall(r"(-?[\d.]+),(-?[\d.]+)", element.get("points"))]
            if len(places) > 500:
                fills.append(places)
        self.assertEqual(len(fills), 5)
        # At rest, on the left: each share is as high as its loss in parts of the friction's.
        left = min(x for places in fills for x, _ in places)
        heights = []
        for places in fills:
            edge = [y for x, y in places if x < left + 0.3]
            heights.append(max(edge) - min(edge))
        losses = [point["output_power"], point["friction_power"], point["layer_loss"], point["stator_loss"], point["dielectric_loss"]]
        # Coordinates have two decimals.
        for height, loss in zip(heights, losses):
            self.assertAlmostEqual(height / heights[1], loss / losses[1], delta=0.03 / heights[1])

    def test_where_the_running_wave_ends_is_marked(self):
        words = " | ".join(self.picture(DRIVE, "--set", "voltage=50 V").words())
        metrics = json.loads(self.ok("curve", DRIVE, "--set", "voltage=50 V", "--format", "json"))["metrics"]
        torque = float(re.search(r"pull-out ([\d.]+) mN.m at", words)[1])
        self.assertAlmostEqual(torque / metrics["pull_out_torque"] / 1e3, 1, delta=1 / 200)
        self.assertNotIn("stall", words)

    def test_png_has_its_size(self):
        path = self.folder / "curve.png"
        self.ok("curve", RING, "--plot", path)
        head = path.read_bytes()[:24]
        self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", head[16:24]), (1440, 1708))
        self.assertGreater(path.stat().st_size, 20000)

    def test_the_same_picture_every_time_beside_the_same_table(self):
        for name in ("a.svg", "b.svg"):
            self.ok("curve", RING, "--plot", self.folder / name)
        self.assertEqual((self.folder / "a.svg").read_bytes(), (self.folder / "b.svg").read_bytes())
        self.assertEqual(self.ok("curve", RING, "--plot", self.folder / "c.svg"), self.ok("curve", RING))

    def test_motors_at_the_edge_have_a_picture(self):
        for setting in ("preload=0 N", "amplitude=0 m", "mu=0", "mu_0=0.4", "E=500 GPa", "modal_damping=0 N.s/m"):
            with self.subTest(setting):
                path = self.folder / "edge.svg"
                done = program.twum("curve", RING, "--set", setting, "--plot", path)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                Picture(path)

    def test_speeds_given_set_the_range(self):
        picture = self.picture(RING, "--speeds", "100 rpm, 120 rpm")
        self.assertTrue({"100", "120"} < set(picture.words()))
        self.assertNotIn("0 rpm", picture.words())
        self.picture(RING, "--speeds", "100 rpm")

    def test_hostile_names_are_text(self):
        motor = (ROOT / "examples/motors/ring-60.yaml").read_text()
        for name in HOSTILE:
            with self.subTest(name[:40]):
                file = self.write("m.yaml", motor.replace("name: ring-60", "name: " + json.dumps(name, ensure_ascii=False)))
                path = self.folder / "hostile.svg"
                self.ok("curve", file, "--plot", path, cwd=self.folder)
                if name.strip() and "\\n" not in name:
                    shown = " ".join(Picture(path).words())
                    self.assertIn(" ".join(name[:40].split()), " ".join(shown.split()))
                self.assertFalse(list(self.folder.glob("**/hacked")))


class Fields(program.Case):
    def test_zones_are_where_they_are(self):
        path = self.folder / "fields.svg"
        data = json.loads(self.ok("fields", RING, "--speed", "133 rpm", "--format", "json", "--plot", path))
        picture = Picture(path)
        words = picture.words()
        for word in ("pressure [MPa]", "traction [kPa]", "surface velocity [mm/s]", "friction bound", "stick",
                     "phase of the wave, crest at 0 [deg]", "stator", "layer"):
            self.assertIn(word, words)
        lowest = max(y for text, _, y in picture.texts if re.fullmatch(r"-?\d+", text))
        per_degree, zero = scale(picture.numbers(0, lowest - 1, lowest + 1))
        boxes = re.findall(r"fill = 'rgb\((.*?)\)' points = '([\d.]+),[\d.]+ ([\d.]+),[\d.]+ ([\d.]+),", path.read_text())
        edges = sorted({round((float(x) - zero) / per_degree, 1) for _, *xs in boxes for x in xs if float(x) > 0})
        for zone in data["zones"]:
            for phase in (math.degrees(zone["from"]), math.degrees(zone["to"])):
                # Pixels have two decimals; rounding above is to 0.1 degree.
                self.assertTrue(any(abs(edge - phase) < 0.1 for edge in edges), (phase, edges))

    def test_both_bounds_where_friction_has_two(self):
        path = self.folder / "fields.svg"
        self.ok("fields", RING, "--set", "mu_0=0.25", "--speed", "100 rpm", "--plot", path)
        self.assertTrue({"kinetic bound", "static bound"} <= set(Picture(path).words()))

    def test_no_picture_without_an_answer(self):
        path = self.folder / "f.png"
        self.ok("fields", RING, "--speed", "500 rpm", "--plot", path)
        self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))


class Refusals(program.Case):
    def test_other_endings(self):
        for name in ("x.pdf", "x", "svg", "x.SVGZ", "-", "x.svg.txt"):
            with self.subTest(name):
                self.assertIn(".svg or .png", self.refused("curve", RING, "--plot", name, cwd=self.folder))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_paths_that_cannot_be_written(self):
        for path in (self.folder / "absent/x.svg", "/proc/x.png"):
            self.assertIn("cannot be written", self.refused("curve", RING, "--plot", path, status=3))
        (self.folder / "folder.svg").mkdir()
        self.assertIn("directory", self.refused("fields", RING, "--speed", "9 rpm", "--plot", self.folder / "folder.svg",
                                                status=3))

    def test_files_of_the_same_command(self):
        motor = self.write("motor.svg", (ROOT / "examples/motors/ring-60.yaml").read_bytes())
        self.assertIn("another file", self.refused("curve", motor, "--plot", motor))
        self.refused("curve", RING, "-o", self.folder / "a.svg", "--plot", self.folder / "a.svg")

    def test_without_gnuplot(self):
        path = self.folder / "x.svg"
        text = self.refused("curve", RING, "--plot", path, status=3, env={"PATH": str(self.folder)})
        self.assertIn("gnuplot-nox", text)
        self.assertFalse(path.exists())

    def test_a_gnuplot_that_fails(self):
        fake = self.write("gnuplot", "#!/bin/sh\necho 'no fonts today' >&2\nexit 1\n")
        os.chmod(fake, 0o755)
        text = self.refused("curve", RING, "--plot", self.folder / "x.svg", status=3,
                            env={"PATH": f"{self.folder}:{os.environ['PATH']}"})
        self.assertIn("no fonts today", text)


if __name__ == "__main__":
    program.main()
