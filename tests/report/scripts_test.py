# SPDX-License-Identifier: Apache-2.0
"""The pages' scripts and styles: lines that one can read, and names that the joined script can hold."""
import collections
import pathlib
import re
import unittest

PAGE = pathlib.Path(__file__).resolve().parents[2] / "studies/page"
MODULES = sorted(PAGE.glob("*.js")) + sorted(PAGE.glob("designer/*.js"))
LONGEST = 120


class Scripts(unittest.TestCase):
    def test_lines_are_short(self):
        long = [f"{path.name}:{number}" for path in [*MODULES, *PAGE.glob("**/*.css")]
                for number, line in enumerate(path.read_text().splitlines(), 1) if len(line) > LONGEST]
        self.assertEqual(long, [])

    def test_every_module_is_in_a_page(self):
        listed = (PAGE.parent / "CMakeLists.txt").read_text()
        for path in MODULES:
            self.assertRegex(listed, r"\b" + path.stem + r"\b", path.name)

    def test_no_name_is_declared_twice(self):
        # The build joins the modules of a page to one script (cmake/EmbedReport.cmake).
        declared = re.compile(r"^(?:export )?(?:async )?(?:function|class|const|let) (\w+)", re.M)
        places = collections.defaultdict(list)
        for path in MODULES:
            for name in declared.findall(path.read_text()):
                places[name].append(path.name)
        self.assertEqual({name: found for name, found in places.items() if len(found) > 1}, {})

    def test_joined_lines_are_those_that_the_build_takes_out(self):
        for path in MODULES:
            for number, line in enumerate(path.read_text().splitlines(), 1):
                if re.match(r"\s*(import|export)\b", line):
                    self.assertRegex(line, r"^(import [{]|export (async )?(function|class|const) )", f"{path.name}:{number}")


if __name__ == "__main__":
    unittest.main(verbosity=1)
