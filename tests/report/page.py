# SPDX-License-Identifier: Apache-2.0
"""What the tests of report pages share: results of the examples, and a page that is asked what it shows."""
import functools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

ROOT = pathlib.Path(__file__).resolve().parents[2]
RPM = 3.141592653589793 / 30
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve()) if len(sys.argv) > 1 else None


def twum(*arguments, **options):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600, **options)
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    return done


def scratch_folder(cleanup):
    scratch = tempfile.TemporaryDirectory(prefix="twum-report-")
    cleanup(scratch.cleanup)
    return pathlib.Path(scratch.name)


@functools.cache
def shared_results():
    return scratch_folder(unittest.addModuleCleanup)


@functools.cache
def shared_browser():
    browser = Browser()
    unittest.addModuleCleanup(browser.close)
    return browser


class Page(unittest.TestCase):
    """One browser and one result of each example for all tests of a module, a scratch folder for each class."""

    @classmethod
    def setUpClass(cls):
        cls.folder = scratch_folder(cls.addClassCleanup)
        cls.browser = shared_browser()

    def result(self, name, *options):
        """Result directory of an example; a copy, where the tests' fixture has run it already."""
        directory = shared_results() / "".join((name, *options))
        made = pathlib.Path(os.environ.get("TWUM_RESULTS", "")) / directory.name
        if not directory.exists() and (made / "summary.json").exists():
            shutil.copytree(made, directory)
        if not directory.exists():
            twum("run", ROOT / "examples/studies" / f"{name}.yaml", *options, "-o", directory)
        return directory

    def open(self, directory, **options):
        self.browser.open(directory / "report.html", **options)
        return json.loads((directory / "summary.json").read_text())

    def clean(self, directory):
        """No error, no request but the page itself."""
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual([u for u in self.browser.requests() if not u.startswith(("blob:", "data:"))],
                         ["file://" + str(directory / "report.html")])

    def barriers(self):
        """What axe-core finds on the page that keeps people from using it: rules of WCAG 2.2 A and AA and of good practice."""
        self.browser.value((ROOT / "tests/third_party/axe-core/axe.min.js").read_text() + "; true")
        return self.browser.value("axe.run(document).then(r => r.violations.map(v => [v.id, v.help, v.nodes.map(n => n.target.join(' ')).slice(0, 3)]))")

    def table(self, name):
        """{name as typed in the first cell: SI values of the others}"""
        return self.browser.value("""Object.fromEntries([...document.querySelectorAll(`[data-table="%s"] tbody tr`)].map(
            (tr) => [tr.cells[0].dataset.name ?? tr.cells[0].textContent, [...tr.cells].slice(1).map((td) => td.dataset.value === undefined ? td.textContent : Number(td.dataset.value))]))""" % name)

    @staticmethod
    def typed(name, value):
        """A value of a summary as tables hold it: slices as a motor file has them, other numbers in SI."""
        return value if name != "radial_slices" or value > 0 else f"auto {-value:g}".removesuffix(" 0")

    def text(self, selector):
        """What an element says, with plain blanks."""
        return self.browser.value("document.querySelector(%s).textContent" % json.dumps(selector)).replace("\u00a0", " ")

    def lines(self, selector):
        return [t.replace("\u00a0", " ") for t in self.browser.value("[...document.querySelectorAll(%s)].map(n => n.textContent)" % json.dumps(selector))]

    def box(self, chart):
        """Rectangle of a chart's plotting area, in the viewport."""
        return self.browser.value("""(() => { const n = document.querySelector(`[data-chart="%s"]`); n.scrollIntoView({block: 'center'});
            const r = (n.querySelector('.u-over') || n.querySelector('canvas')).getBoundingClientRect(); return [r.left, r.top, r.width, r.height]; })()""" % chart)

    def scale(self, chart, axis):
        return self.browser.value("""(() => { const s = document.querySelector(`[data-chart="%s"]`).plot.scales.%s; return [s.min, s.max]; })()""" % (chart, axis))

    def colours(self, selector):
        """How many different colours each canvas shows: 1 is an empty picture."""
        return self.browser.value("""[...document.querySelectorAll(`%s`)].map((c) => { const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
            const seen = new Set(); for (let i = 0; i < p.length; i += 4) if (p[i + 3]) seen.add(p[i] << 16 | p[i + 1] << 8 | p[i + 2]); return seen.size; })""" % selector)


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=1)
