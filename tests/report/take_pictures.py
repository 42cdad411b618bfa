# SPDX-License-Identifier: Apache-2.0
"""Pictures of report pages for the documentation: take_pictures.py RESULTS PICTURES"""
import base64
import pathlib
import sys

from browser import Browser

# Name of the picture, the study, the height of the page's top that it shows at most [px]: it ends with a card.
SHOTS = (("report-optimize", "optimize-ring-60", 1800), ("report-pareto", "pareto-power-wear", 1700),
         ("report-sweep", "sweep-sobol", 1700), ("report-curve", "paper-figure-4", 1950),
         ("report-uncertainty", "tolerances", 900))


def main():
    results, pictures = map(pathlib.Path, sys.argv[1:])
    browser = Browser()
    try:
        for name, study, height in SHOTS:
            browser.open((results / study / "report.html").resolve(), width=1240)
            height = browser.value("12 + Math.max(...[...document.querySelectorAll('.card')].map(c => c.getBoundingClientRect().bottom + scrollY).filter(b => b < %d))" % height)
            shot = browser.send("Page.captureScreenshot", {
                "format": "png", "captureBeyondViewport": True,
                "clip": {"x": 0, "y": 0, "width": 1240, "height": height, "scale": 0.8}})
            (pictures / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))
    finally:
        browser.close()


if __name__ == "__main__":
    main()
