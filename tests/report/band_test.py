# SPDX-License-Identifier: Apache-2.0
"""The band of a calibration whose intervals are far from linearised ones: band_test.py TWUM"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from page import ROOT, RPM, Page, main, twum  # noqa: E402

# A rated and a no-load speed and two torques of a data sheet: the force factor has a standard deviation of half its value.
SHEET = """torque [N.m],speed_at [rpm],speed_at_sd [rpm],no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque [N.m],holding_torque_sd [N.m],max_torque [N.m],max_torque_sd [N.m]
0.5,100,5,150,5,1.0,0.05,1.0,0.05
"""
STUDY = """twum: 1
motor: {motor}
set: {{radial_slices: 1, frequency: 40 kHz, voltage: 130 V, preload: 160 N}}
study:
  kind: calibrate
  data: sheet.csv
  scatter: stated
  variables:
    force_factor:     {{min: 0.2 N/V, max: 1.2 N/V}}
    kinetic_friction: {{min: 0.1, max: 0.4}}
    youngs_modulus:   {{min: 0.05 GPa, max: 10 GPa, scale: log}}
  derived:
    modal_mass: 25 g * (force_factor / 0.55 N/V)^2
"""


class Band(Page):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "sheet.csv").write_text(SHEET)
        (cls.folder / "fit.yaml").write_text(STUDY.format(motor=ROOT / "examples/motors/drive-60.yaml"))
        twum("run", cls.folder / "fit.yaml", "-o", cls.folder / "fit")

    def chart(self):
        page = (self.folder / "fit/report.html").read_text()
        data = json.loads(page.split('id="data">')[1].split("</script>")[0])

        def charts(part):
            if isinstance(part, dict):
                if part.get("name") == "fit speed_at":
                    yield part
                for one in part.values():
                    yield from charts(one)
            if isinstance(part, list):
                for one in part:
                    yield from charts(one)
        return next(charts(data))

    def numbers(self, series, name):
        return series[name]["values"] if isinstance(series[name], dict) else series[name]

    def test_every_motor_of_the_band_fits_the_points(self):
        summary = json.loads((self.folder / "fit/summary.json").read_text())
        self.assertTrue(any(one["interval"] == "profile" for one in summary["estimates"].values()))
        line = self.chart()["series"][0]
        x, y, low, high = (self.numbers(line, name) for name in ("x", "y", "low", "high"))
        self.assertTrue(all(a <= b <= c for a, b, c in zip(low, y, high)))
        # A motor of the band has a sum of squares of at most S_min + t^2, in standard deviations, and each reading is one of its terms.
        squares = sum((p["residual"] / p["sd"]) ** 2 for p in summary["data"]) if "data" in summary else summary["chi_square"]["value"]
        # The ends are sought to 1e-3 of t^2.
        most = 5 * RPM * math.sqrt(squares + 1.96 ** 2 * 1.002)
        for at, measured in ((0, 150 * RPM), (0.5, 100 * RPM)):
            k = min(range(len(x)), key=lambda i: abs(x[i] - at))
            self.assertLessEqual(high[k], measured + most)
            self.assertGreaterEqual(low[k], measured - most)
            # Nor is it narrower than the band of a number that no other reading holds.
            self.assertGreater(high[k] - low[k], 5 * RPM)
        # No motor turns backward, and none of this size runs at 250 rpm.
        self.assertGreater(min(low), 0)
        self.assertLess(max(high), 200 * RPM)

    def test_every_point_is_in_the_picture(self):
        self.open(self.folder / "fit")
        self.clean(self.folder / "fit")
        dots = self.chart()["series"][1]
        points = sorted(zip(self.numbers(dots, "x"), self.numbers(dots, "y")))
        # The speed without load is the end of the curve of speeds over torques.
        self.assertEqual([x for x, _ in points], [0, 0.5])
        for (_, shown), measured in zip(points, (150 * RPM, 100 * RPM)):
            self.assertAlmostEqual(shown, measured, delta=1e-6 * measured)  # the page has seven digits
        (left, right), (bottom, top) = self.scale("fit speed_at", "x"), self.scale("fit speed_at", "y")
        for torque, speed in points:
            self.assertTrue(left <= torque * 1000 <= right or left <= torque <= right)
            self.assertTrue(bottom <= speed / RPM <= top)
        # The numbers that are no point of a curve have a picture of their own: four, one of each kind.
        self.assertIn("Residuals of single values", self.lines("h2"))
        self.assertEqual(self.browser.value("document.querySelector('[data-chart=\"residuals of single values\"]').plot.data[1].filter(v => v !== null).length"), 4)


if __name__ == "__main__":
    main()
