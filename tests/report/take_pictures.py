# SPDX-License-Identifier: Apache-2.0
"""Pictures of report pages for the documentation: take_pictures.py RESULTS PICTURES"""
import base64
import pathlib
import sys
import time

from browser import Browser

# Name of the picture, the study, the height of the page's top that it shows at most [px]: it ends with a card.
SHOTS = (("report-optimize", "optimize-ring-60", 1750), ("report-pareto", "pareto-power-wear", 2300),
         ("report-sweep", "sweep-sobol", 1700), ("report-curve", "paper-figure-4", 1700),
         ("report-uncertainty", "tolerances", 1000))


# The designer with a pinned motor, a load and a limit, as someone would have it who has moved the preload.
DESIGNER = """(() => { const p = document.getElementById('page').panel; p.pin(); p.playing = false; p.setValue('preload', 190);
    p.limits.act((view) => { view.load = { rest: 0.2, rise: 0.3 / (100 * rpm) }; view.limits.push({ metric: 'torque_at', argument: 'speed', at: 100 * rpm, sense: '>=', value: 0.7 }); }); })()"""


def save(browser, path, height):
    shot = browser.send("Page.captureScreenshot", {"format": "png", "captureBeyondViewport": True,
                                                   "clip": {"x": 0, "y": 0, "width": 1240, "height": height, "scale": 0.8}})
    path.write_bytes(base64.b64decode(shot["data"]))


def main():
    results, pictures = map(pathlib.Path, sys.argv[1:])
    browser = Browser()
    try:
        for name, study, height in SHOTS:
            browser.open((results / study / "report.html").resolve(), width=1240)
            height = browser.value("12 + Math.max(...[...document.querySelectorAll('.card')].map(c => c.getBoundingClientRect().bottom + scrollY).filter(b => b < %d))" % height)
            save(browser, pictures / f"{name}.png", height)
        browser.open((results / "designer.html").resolve(), width=1240)
        browser.value(DESIGNER)
        time.sleep(2)  # until the marks beside the sliders are there
        save(browser, pictures / "designer.png", 1330)
    finally:
        browser.close()


if __name__ == "__main__":
    main()
