# SPDX-License-Identifier: Apache-2.0
"""twum plot: in the pictures of every kind of study no text is cut off at the edge of the page or covers another one."""
import time

import page
from page import twum

STUDIES = ("optimize-ring-60", "size-driven", "pareto-torque-speed", "sweep-grid", "sweep-latin-hypercube", "sensitivity-sobol",
           "sensitivity-morris", "sensitivity-local", "tolerances", "calibrate", "paper-figure-4", "frequency-voltages", "efficiency-map", "robust-ring-60")
BOXES = """[...document.querySelectorAll('text')].filter((t) => t.textContent.trim()).map((t) => { const b = t.getBoundingClientRect();
    return [t.textContent, b.left, b.right, b.top, b.bottom]; })"""


class Pictures(page.Page):
    def boxes(self, path):
        self.browser.send("Page.navigate", {"url": "file://" + str(path)})
        while not self.browser.value(f"document.readyState === 'complete' && decodeURI(location.href).endsWith('{path.parent.parent.name}/plots/{path.name}')"):
            time.sleep(0.02)
        # What stands on a white ground is drawn twice, at one place.
        return [list(box) for box in dict.fromkeys(map(tuple, self.browser.value(BOXES)))]

    def test_texts_are_whole_and_apart(self):
        self.browser.send("Emulation.setDeviceMetricsOverride", {"width": 1000, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
        for study in STUDIES:
            directory = self.result(study)
            twum("plot", directory)
            for path in sorted((directory / "plots").glob("*.svg")):
                with self.subTest(study=study, picture=path.name):
                    width, height = [float(v) for v in path.read_text().split('viewBox="0 0 ')[1].split('"')[0].split()]
                    boxes = self.boxes(path)
                    self.assertGreater(len(boxes), 5)
                    for text, left, right, top, bottom in boxes:
                        self.assertTrue(left >= 0 and right <= width and top >= 0 and bottom <= height, (text, left, right, top, bottom))
                    for i, (text, left, right, top, bottom) in enumerate(boxes):
                        for other, l, r, t, b in boxes[i + 1:]:
                            # Boxes of letters are higher than the letters by a third.
                            over = min(right, r) - max(left, l) > 1 and min(bottom, b) - max(top, t) > 6
                            self.assertFalse(over, (text, other))


if __name__ == "__main__":
    page.main()
