# SPDX-License-Identifier: Apache-2.0
"""Motors whose stator is given by its geometry, and the catalogue of materials."""
import json
import math
import pathlib
import re

import program
from program import DRIVE, ROOT

PLATE = str(ROOT / "examples/motors/plate-60.yaml")


class Plate(program.Case):
    def stator(self, *arguments):
        return json.loads(self.ok("stator", PLATE, *arguments, "--format", "json"))

    def test_modes_are_listed_around_the_drive_s(self):
        answer = self.stator("--modes", "41")["plate"]
        drive = [mode for mode in answer["modes"] if mode["drive"]]
        self.assertEqual([mode["wavelengths"] for mode in drive], [9])
        others = [mode for mode in answer["modes"] if not mode["drive"]]
        nearest = min(abs(mode["frequency"] - drive[0]["frequency"]) for mode in others)
        self.assertAlmostEqual(answer["mode_separation"], nearest, delta=1e-9 * drive[0]["frequency"])
        self.assertEqual({mode["wavelengths"] for mode in answer["modes"]}, {7, 8, 9, 10, 11})
        frequencies = [mode["frequency"] for mode in answer["modes"]]
        self.assertEqual(frequencies, sorted(frequencies))
        self.assertEqual(len(self.stator("--modes", "3")["plate"]["modes"]), 3)

    def test_the_shape_is_zero_at_the_clamp_and_one_at_the_contact(self):
        answer = self.stator()
        shape = answer["plate"]["shape"]
        self.assertEqual(shape[0]["radius"], 12.5e-3)
        self.assertAlmostEqual(shape[0]["R"], 0, delta=1e-12)
        below = max(row["radius"] for row in shape if row["radius"] <= 26.5e-3)
        at = {row["radius"]: row["R"] for row in shape}[below]
        self.assertLess(abs(at - 1), 0.2)  # R grows by 8 % per mm there, rows stand 0.35 mm apart

    def test_the_table_marks_the_drive(self):
        text = self.ok("stator", PLATE, "--modes", "4")
        self.assertEqual(len(re.findall(r"^drive +9 ", text, re.M)), 1)
        self.assertIn("mode_separation", text)
        self.assertIn("motional_resistance", text)

    def test_a_picture_of_the_modes(self):
        path = self.folder / "modes.svg"
        self.ok("stator", PLATE, "--plot", path)
        picture = path.read_text()
        self.assertIn("contact track", picture)
        self.assertIn("drive, 39", picture)
        for part in ("web", "ring", "teeth", "ceramic", "glue"):
            self.assertIn(f">{part}<", picture)

    def test_modes_without_a_geometry_are_refused(self):
        self.assertIn("given by its geometry", self.refused("stator", DRIVE, "--modes", "4"))
        self.assertIn("--modes", self.refused("stator", PLATE, "--modes", "many"))

    def test_a_parameter_of_the_geometry_can_be_set(self):
        before = self.stator()["modal_data"]
        after = self.stator("--set", "substrate_density=9680 kg/m^3", "--set", "ceramic_density=8360 kg/m^3",
                            "--set", "glue_density=1320 kg/m^3")["modal_data"]
        # All densities by a tenth: the mass as well, the frequency by its root.
        self.assertAlmostEqual(after["modal_mass"] / before["modal_mass"], 1.1, delta=1e-9)
        self.assertAlmostEqual(after["resonance_frequency"] / before["resonance_frequency"], 1.1 ** -0.5, delta=1e-9)
        self.assertIn("follows from the geometry", self.refused("stator", PLATE, "--set", "modal_mass=20 g"))
        self.assertIn("ceramic_outer_radius must be at most 30 mm (substrate_outer_radius), but is 31 mm",
                      self.refused("stator", PLATE, "--set", "ceramic_outer_radius=31 mm"))
        self.assertIn("needs a stator that is given by its geometry",
                      self.refused("stator", DRIVE, "--set", "ceramic_thickness=1 mm"))


    def notes(self, *changes):
        text = pathlib.Path(PLATE).read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        done = program.twum("check", self.write("changed.yaml", text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_too_few_and_too_slender_teeth_are_noted(self):
        self.assertNotIn("teeth", self.notes())
        few = self.notes(("count: 90", "count: 26"))
        self.assertIn("2.89 teeth per wavelength", few)
        self.assertIn("at least 27 teeth", few)
        self.assertNotIn("teeth per wavelength", self.notes(("count: 90", "count: 27")))
        # Euler's cantilever of 1.01 x 4 mm: 1.8751^2 / (2 pi) sqrt(E I / rho A) / h^2, 36 kHz, against a drive of 34 kHz.
        slender = self.notes(("height: 1.6 mm", "height: 4 mm"))
        width = 2 * math.pi * 23e-3 / 90 - 0.6e-3
        own = 1.8751 ** 2 / (2 * math.pi) * math.sqrt(110e9 * width ** 2 / 12 / 8800) / 4e-3 ** 2
        self.assertIn(f"would bend by themselves at {own / 1e3:.4g} kHz", slender)

    def test_radii_that_touch_leave_their_own_rows_out_alone(self):
        study = self.write("study.yaml", f"""twum: 1
motor: {PLATE}
study:
  kind: optimize
  variables:
    ceramic_thickness: {{min: 0.3 mm, max: 0.9 mm}}
  maximize: force_factor
  solver: {{name: nlopt:slsqp, starts: 1, seed: 1}}
""")
        self.ok("run", study, "-o", self.folder / "out")
        answer = json.loads((self.folder / "out/summary.json").read_text())
        self.assertNotIn("moves_missing", answer)
        self.assertIn("teeth_height", answer["moves"])
        touching = answer["moves_touching"]
        self.assertEqual(touching["teeth_outer_radius"], "substrate_outer_radius")
        for radius in touching:
            self.assertNotIn(radius, answer["moves"])
        page = (self.folder / "out/report.html").read_text()
        self.assertIn(" has no row, because it equals ", page)


class Materials(program.Case):
    def test_the_catalogue_is_that_of_the_repository(self):
        listed = json.loads(self.ok("materials", "--format", "json"))
        names = sorted(path.stem for path in (ROOT / "materials").glob("*.yaml"))
        self.assertEqual([one["name"] for one in listed["materials"]], names)
        self.assertEqual(listed["units"]["youngs_modulus"], "Pa")
        prefixes = {"GPa": 1e9, "MPa": 1e6}
        for one in listed["materials"]:
            text = (ROOT / f"materials/{one['name']}.yaml").read_text()
            self.assertIn(f"\nkind: {one['kind']}\n", text)
            number, unit = re.search(r"youngs_modulus: *{value: ([^ ]+) (\w+), ", text).groups()
            self.assertAlmostEqual(one["youngs_modulus"] / (float(number) * prefixes[unit]), 1, delta=1e-15)

    def test_one_material_has_its_sources(self):
        material = json.loads(self.ok("materials", "apc-840", "--format", "json"))
        self.assertEqual((material["d31"], material["units"]["d31"]), (-125e-12, "m/V"))
        self.assertIn("americanpiezo.com", material["sources"]["d31"])
        self.assertEqual(material["sources"]["poisson_ratio"], "typical")
        self.assertIn("Lead zirconate titanate", self.ok("materials", "apc-840"))

    def test_an_unknown_material_has_a_near_one(self):
        self.assertIn("did you mean 'apc-840'?", self.refused("materials", "apc-84"))

    def test_a_material_gives_what_the_file_leaves_out(self):
        text = pathlib.Path(PLATE).read_text()
        named = self.write("named.yaml", text)
        typed = self.write("typed.yaml", text.replace(
            "material: phosphor-bronze-c51000", "youngs_modulus: 110 GPa, poisson_ratio: 0.34, density: 8800 kg/m^3, "
            "conductivity: 77 W/(m.K), specific_heat: 380 J/(kg.K)"))
        other = self.write("other.yaml", text.replace(
            "material: phosphor-bronze-c51000", "material: phosphor-bronze-c51000, density: 8000 kg/m^3"))
        motors = [json.loads(self.ok("stator", path, "--format", "json"))["motor"] for path in (named, typed, other)]
        self.assertEqual(motors[0], motors[1])
        self.assertEqual(motors[2]["substrate_density"], 8000)
        self.assertEqual(motors[2]["substrate_youngs_modulus"], 110e9)

    def test_a_lining_gives_layer_and_friction(self):
        text = pathlib.Path(PLATE).read_text()
        for line in ("    youngs_modulus: 0.9 GPa\n    poisson_ratio: 0.38\n    density: 1500 kg/m^3\n"
                     "    loss_factor: 0.05\n", "    kinetic: 0.23\n"):
            self.assertIn(line, text)
            text = text.replace(line, "    material: ptfe-peek\n")
        motor = json.loads(self.ok("stator", self.write("lined.yaml", text), "--format", "json"))["motor"]
        self.assertEqual((motor["youngs_modulus"], motor["kinetic_friction"], motor["loss_factor"]), (3e9, 0.12, 0.03))


if __name__ == "__main__":
    program.main()
