# SPDX-License-Identifier: Apache-2.0
"""metrics and parameters, and the reference pages made from them."""
import csv
import io
import json

import program
from program import ROOT


class Lists(program.Case):
    def test_formats_agree(self):
        for command, count in (("metrics", 24), ("parameters", 18)):
            objects = json.loads(self.ok(command, "--format", "json"))
            self.assertEqual(len(objects), count)
            self.assertEqual(objects, list(csv.DictReader(io.StringIO(self.ok(command, "--format", "csv")))))
            table = self.ok(command).splitlines()
            self.assertEqual(len(table), count + 1)
            for thing, line in zip(objects, table[1:]):
                self.assertTrue(line.startswith(thing["name"]))
                self.assertTrue(thing["unit"] and thing["text"])

    def test_reference_pages_are_up_to_date(self):
        for command in ("metrics", "parameters"):
            page = ROOT / f"docs/reference/{command}.md"
            self.assertEqual(page.read_text(), self.ok(command, "--format", "markdown"),
                             f"run: twum {command} --format markdown -o {page.relative_to(ROOT)}")


if __name__ == "__main__":
    program.main()
