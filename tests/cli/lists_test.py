# SPDX-License-Identifier: Apache-2.0
"""metrics, parameters and solvers, and the reference pages made from tables."""
import csv
import io
import json

import program
from program import ROOT


class Lists(program.Case):
    def test_formats_agree(self):
        for command, count in (("metrics", 100), ("parameters", 118)):
            objects = json.loads(self.ok(command, "--format", "json"))
            self.assertEqual(len(objects), count)
            self.assertEqual(objects, list(csv.DictReader(io.StringIO(self.ok(command, "--format", "csv")))))
            table = self.ok(command).splitlines()
            self.assertEqual(len(table), count + 1)
            for thing, line in zip(objects, table[1:]):
                self.assertTrue(line.startswith(thing["name"]))
                self.assertTrue(thing["unit"] and thing["text"])

    def test_reference_pages_are_up_to_date(self):
        for command in ("metrics", "parameters", "solvers"):
            page = ROOT / f"docs/reference/{command}.md"
            self.assertEqual(page.read_text(), self.ok(command, "--format", "markdown"),
                             f"run: twum {command} --format markdown -o {page.relative_to(ROOT)}")

    def test_solvers(self):
        solvers = {row["name"]: row for row in json.loads(self.ok("solvers", "--format", "json"))}
        self.assertEqual(list(solvers), [line.split()[0] for line in self.ok("solvers").splitlines()[1:]])
        # What the methods are by their definition.
        self.assertEqual(solvers["nlopt:slsqp"]["gradient"], "needed")
        self.assertEqual(solvers["nlopt:slsqp"]["equality"], "yes")
        self.assertEqual(solvers["nlopt:cobyla"]["gradient"], "")
        self.assertEqual(solvers["nlopt:bobyqa"]["inequality"], "augmented")
        self.assertEqual((solvers["nlopt:isres"]["global"], solvers["nlopt:isres"]["stochastic"]), ("yes", "yes"))
        self.assertTrue(all(row["available"] in ("yes", "no") and row["text"] for row in solvers.values()))

    def test_solver_options(self):
        options = json.loads(self.ok("solvers", "--options", "--format", "json"))
        self.assertEqual({row["solver"] for row in options} - {"nlopt", "ipopt"}, set())
        self.assertTrue(all(row["name"] and row["type"] in ("number", "integer", "text") and row["text"]
                            for row in options))
        self.assertIn("## Options", self.ok("solvers", "--format", "markdown"))

    def test_study_page(self):
        page = ROOT / "docs/reference/study-file.md"
        self.assertEqual(page.read_text(), self.ok("schema", "study", "--format", "markdown"))
        for kind in ("curve", "sweep", "sensitivity", "optimize", "pareto", "size", "uncertainty", "calibrate", "frequency"):
            self.assertIn(f"\n## {kind}\n", page.read_text())
        self.assertIn("twum parameters", self.refused("schema", "motor", "--format", "markdown"))

    def test_every_example_is_listed(self):
        page = (ROOT / "examples/studies/README.md").read_text()
        for study in sorted((ROOT / "examples/studies").glob("*.yaml")):
            self.assertIn(f"[{study.name}]({study.name})", page)
            self.assertIn("a valid study file", self.ok("check", study))


if __name__ == "__main__":
    program.main()
