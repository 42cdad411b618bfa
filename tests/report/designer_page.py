# SPDX-License-Identifier: Apache-2.0
"""What the tests of the designer share: the page of twum explore, and its panel."""
import json
import time

from page import ROOT, Page, twum

PANEL = "document.getElementById('page').panel"


class Designer(Page):
    def explore(self, name, motor=None, **options):
        """Opens the page of an example, or of another motor file, and waits until everything has been computed."""
        page = self.folder / f"{name}.html"
        if not page.exists():
            twum("explore", motor or ROOT / "examples/motors" / f"{name}.yaml", "-o", page)
        self.browser.open(page, **options)
        self.rest()
        return page

    def rest(self):
        """Waits until the page has nothing left to compute."""
        until = time.monotonic() + 60
        while not self.browser.value(f"(p => !p || (p.waiting === null && !p.changed))({PANEL})"):
            self.assertLess(time.monotonic(), until, "the page does not come to rest")
            time.sleep(0.02)

    def quiet(self, page):
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual([u for u in self.browser.requests() if not u.startswith(("blob:", "data:"))], ["file://" + str(page)])

    def set(self, name, value):
        self.browser.value(f"{PANEL}.setValue({json.dumps(name)}, {value!r}); true")
        self.browser.settle()
