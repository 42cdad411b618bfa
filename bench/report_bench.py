# SPDX-License-Identifier: Apache-2.0
"""How fast the report of a large sweep is: report_bench.py TWUM [ROWS]

Prints the seconds until the page is built and drawn, until a drag on the scatter has filtered every
view, and until a hover has named its design. Needs chromium; nothing here passes or fails."""
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests/report"))
from browser import Browser  # noqa: E402

STUDY = """twum: 1
motor: {motor}
study:
  kind: sweep
  sampling: sobol
  samples: {rows}
  variables:
    amplitude: {{min: 0.8 um, max: 2.4 um}}
    preload: {{min: 60 N, max: 300 N}}
    thickness: {{min: 0.1 mm, max: 1 mm, scale: log}}
    youngs_modulus: {{min: 0.5 GPa, max: 20 GPa, scale: log}}
  metrics: [stall_torque, no_load_speed, peak_power, max_pressure]
"""


def cpu(browser):
    """Processor time of the page's thread since it was opened [s]."""
    metrics = {m["name"]: m["value"] for m in browser.send("Performance.getMetrics")["metrics"]}
    return metrics["TaskDuration"]


def measure(browser, directory):
    browser.send("Performance.enable", {"timeDomain": "threadTicks"})
    page = pathlib.Path(directory).resolve() / "report.html"
    print(f"page               {page.stat().st_size / 1e6:.1f} MB")
    took = browser.open(page)
    print(f"open and draw      {took:.2f} s, of which the page's own work {cpu(browser):.2f} s of processor")
    left, top, width, height = browser.value(
        "(() => { const n = document.querySelector('[data-chart=scatter]'); n.scrollIntoView({block: 'center'});"
        " const r = n.querySelector('.u-over').getBoundingClientRect(); return [r.left, r.top, r.width, r.height]; })()")
    before = cpu(browser)
    begin = time.monotonic()
    browser.drag(left + 0.3 * width, top + 0.3 * height, left + 0.6 * width, top + 0.7 * height)
    browser.settle()
    print(f"choose by dragging {time.monotonic() - begin:.2f} s ({cpu(browser) - before:.2f} s of processor), "
          f"{browser.value('document.querySelector(`[data-count]`).textContent')}")
    before = cpu(browser)
    begin = time.monotonic()
    browser.move(left + 0.45 * width, top + 0.5 * height)
    print(f"hover              {time.monotonic() - begin:.2f} s ({cpu(browser) - before:.2f} s of processor), "
          f"{browser.value('document.querySelector(`[data-design] p`).textContent')}")
    print("complaints         ", browser.complaints() or "none")


def main():
    program = pathlib.Path(sys.argv[1])
    browser = Browser()
    try:
        if program.is_dir():
            measure(browser, program)
            return
        with tempfile.TemporaryDirectory(prefix="twum-bench-") as folder:
            study = pathlib.Path(folder) / "large.yaml"
            rows = int(sys.argv[2]) if len(sys.argv) > 2 else 100000
            study.write_text(STUDY.format(motor=ROOT / "tests/data/motors/ring-60.yaml", rows=rows))
            subprocess.run([program, "run", study, "-o", folder + "/out"], check=True, stdout=subprocess.DEVNULL)
            measure(browser, folder + "/out")
    finally:
        browser.close()


if __name__ == "__main__":
    main()
