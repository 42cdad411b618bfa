# SPDX-License-Identifier: Apache-2.0
"""stator --solid: CalculiX for real on a coarse mesh, its files read and integrated again, and what goes wrong."""
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import time

import numpy

import program
from program import DRIVE, ROOT

PLATE = ROOT / "examples/motors/plate-30.yaml"


def cards(path):
    """The lines of an input file of CalculiX below each of its keywords: [(keyword, [values of a line])]."""
    found = []
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith("*"):
            found.append((line, []))
        else:
            found[-1][1].append([part for part in line.split(",") if part.strip()])
    return found


class Solution:
    """The mesh of a sector and its lowest mode, as the files say."""

    def __init__(self, deck, results, order):
        self.order = order
        self.bricks = {}
        density = {}
        for keyword, rows in cards(deck):
            if keyword.startswith("*NODE,"):
                self.nodes = numpy.array([[float(x) for x in row[1:]] for row in rows])
            elif keyword.startswith("*ELEMENT"):
                name = keyword.rsplit("=", 1)[1]
                flat = [int(x) for row in rows for x in row]
                self.bricks[name] = numpy.array(flat).reshape(-1, 21)[:, 1:] - 1
            elif keyword.startswith("*MATERIAL"):
                material = keyword.rsplit("=", 1)[1]
            elif keyword == "*DENSITY":
                density[material] = float(rows[0][0])
            elif keyword.startswith("*CYCLIC SYMMETRY MODEL"):
                self.sectors = int(keyword.split("N=", 1)[1].split(",")[0])
        self.density = density
        self.motion = self.first_mode(results)

    def first_mode(self, results):
        parts, rows = [], None
        for line in pathlib.Path(results).read_text().splitlines():
            if "E I G E N V A L U E    N U M B E R" in line and len(parts) == 2:
                break
            if "R E A L   P A R T" in line or "I M A G I N A R Y" in line:
                rows = numpy.zeros_like(self.nodes)
                parts.append(rows)
            words = line.split()
            if rows is not None and len(words) == 4 and words[0].isdigit():
                rows[int(words[0]) - 1] = [float(x) for x in words[1:]]
        return parts[0] + 1j * parts[1]

    # Places of the 20 nodes in the brick, corners first, as CalculiX's manual draws them.
    CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
    EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]

    def functions(self, x):
        """Shape functions, found from what they have to be: monomials of the brick that are 1 at one node."""
        return self.monomials(numpy.array([x])) @ self.coefficients()

    @classmethod
    def places(cls):
        corners = numpy.array(cls.CORNERS, float)
        return numpy.vstack([corners, [(corners[a] + corners[b]) / 2 for a, b in cls.EDGES]])

    @staticmethod
    def monomials(x):
        a, b, c = x.T
        return numpy.array([1 + 0 * a, a, b, c, a * b, b * c, c * a, a * a, b * b, c * c, a * a * b, a * a * c, b * b * a,
                            b * b * c, c * c * a, c * c * b, a * b * c, a * a * b * c, b * b * c * a, c * c * a * b]).T

    def coefficients(self):
        return numpy.linalg.inv(self.monomials(self.places()))

    def at(self, brick, x, step=1e-5):
        """Position, motion and Jacobian at places of a brick; slopes by central differences, whose error is 1e-10."""
        inverse = self.coefficients()
        value = self.monomials(x) @ inverse
        place, motion = value @ self.nodes[brick], value @ self.motion[brick]
        slopes = []
        for d in range(3):
            e = numpy.zeros(3)
            e[d] = step
            slopes.append((self.monomials(x + e) - self.monomials(x - e)) @ inverse @ self.nodes[brick] / (2 * step))
        return place, motion, slopes

    GAUSS = numpy.polynomial.legendre.leggauss(5)

    def over_bricks(self, name, density):
        """Integral of density(position, motion) over the bricks of a material."""
        points, weights = self.GAUSS
        x = numpy.array([(a, b, c) for a in points for b in points for c in points])
        w = numpy.array([a * b * c for a in weights for b in weights for c in weights])
        total = 0
        for brick in self.bricks.get(name, []):
            place, motion, (da, db, dc) = self.at(brick, x)
            volume = numpy.einsum("ij,ij->i", numpy.cross(da, db), dc)
            total += numpy.sum(w * volume * density(place, motion))
        return total

    def over_end(self, name, radius, side):
        """Integral of u_r e^(-i n phi) over the faces of a material at a radius; these are the brick's faces a = side."""
        points, weights = self.GAUSS
        x = numpy.array([(side, b, c) for b in points for c in points])
        w = numpy.array([b * c for b in weights for c in weights])
        total = 0
        for brick in self.bricks[name]:
            place, motion, (_, db, dc) = self.at(brick, x)
            if abs(math.hypot(*place[0][:2]) - radius) > 1e-6:
                continue
            normal = numpy.cross(db, dc)
            total += numpy.sum(w * self.phase(place) * numpy.einsum("ij,ij->i", motion[:, :2], normal[:, :2])) * side
        return total

    def phase(self, place):
        return numpy.exp(-1j * self.order * numpy.arctan2(place[:, 1], place[:, 0]))

    def force_over_voltage(self, inner, outer):
        """Integral of (d u_x / dx + d u_y / dy) e^(-i n phi) over the ceramic by the divergence theorem, without strains. The
        sides of the sector cancel: there the integrand repeats itself."""
        def circumferential(place, motion):
            x, y = place[:, 0], place[:, 1]
            return (x * motion[:, 1] - y * motion[:, 0]) / (x * x + y * y) * self.phase(place)
        return (1j * self.order * self.over_bricks("CERAMIC", circumferential) +
                self.over_end("CERAMIC", outer, 1) + self.over_end("CERAMIC", inner, -1))

    def mass(self):
        return sum(rho * self.over_bricks(name, lambda place, motion: numpy.sum(abs(motion) ** 2, axis=1))
                   for name, rho in self.density.items())

    def tip(self, radius):
        """Mean of the motion e^(-i n phi) over the top at a radius, along radius, circumference and axis: 5 Gauss points on each
        of the top edges there."""
        points, weights = self.GAUSS
        top = self.nodes[:, 2].max()
        x = numpy.array([(-1.0, b, 1.0) for b in points])
        sums, whole = numpy.zeros(3, complex), 0
        for brick in self.bricks["METAL"]:
            place, motion, (_, db, _) = self.at(brick, x)
            if abs(math.hypot(*place[0][:2]) - radius) > 1e-6 or abs(place[0][2] - top) > 1e-9:
                continue
            angle = numpy.arctan2(place[:, 1], place[:, 0])
            c, s = numpy.cos(angle), numpy.sin(angle)
            local = numpy.array([c * motion[:, 0] + s * motion[:, 1], c * motion[:, 1] - s * motion[:, 0], motion[:, 2]])
            length = weights * numpy.linalg.norm(db, axis=1)
            sums += (local * self.phase(place) * length).sum(axis=1)
            whole += length.sum()
        return sums / whole


class Solid(program.Case):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="twum solid ")
        cls.results = pathlib.Path(cls.scratch.name) / "results"
        cls.done = program.twum("stator", PLATE, "--solid", "--mesh", "2", "--write", "-o", cls.results,
                                "--plot", cls.results / "wave.svg", "--format", "json")
        cls.answer = json.loads(cls.done.stdout) if cls.done.stdout else None

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def setUp(self):
        super().setUp()
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_the_solid_is_near_the_plate_and_its_coarser_mesh(self):
        solid, plate, coarser = (self.answer[name] for name in ("solid", "plate", "coarser_mesh"))
        # docs/theory/stator-plate.md, section 6: 1.5 % once the share of the teeth's stiffness fits; the example's is 2 % off.
        self.assertAlmostEqual(solid["resonance_frequency"] / plate["resonance_frequency"], 1, delta=0.04)
        # A coarse mesh: half the bricks, with errors of a per cent.
        self.assertAlmostEqual(coarser["resonance_frequency"] / solid["resonance_frequency"], 1, delta=0.02)
        self.assertAlmostEqual(solid["modal_mass"] / plate["modal_mass"], 1, delta=0.1)
        self.assertAlmostEqual(solid["force_factor"] / plate["force_factor"], 1, delta=0.1)
        self.assertAlmostEqual(solid["tangential_ratio"] / plate["tangential_ratio"], 1, delta=0.1)
        self.assertAlmostEqual(solid["radial_ratio"] / plate["radial_ratio"], 1, delta=0.2)

    def test_numbers_follow_from_the_files_of_the_solver(self):
        motor, solid = self.answer["motor"], self.answer["solid"]
        n = motor["wavelengths"]
        files = Solution(self.results / "wave.inp", self.results / "wave.dat", n)
        self.assertEqual(files.sectors, 60)
        # CalculiX prints seven digits, and takes 8 points a brick where this rule has 125: the mass of a curved brick differs by
        # the square of its angle, (2 pi / 180)^2 = 1e-3, times a number well below 1.
        self.assertAlmostEqual(files.mass(), 1, delta=1e-3)
        radial, tangential, axial = files.tip(motor["contact_radius"])
        # F2.1 and F2.2: Simpson's rule against Gauss's over an angle of 2 pi / 60 times n = 6: (0.6 / 2)^4 / 180 = 5e-5.
        self.assertAlmostEqual(solid["modal_mass"] / (0.5 * 60 / abs(axial) ** 2), 1, delta=2e-4)
        # F2.3, where Simpson's errors cancel in part.
        self.assertAlmostEqual(solid["tangential_ratio"] / abs(tangential / axial), 1, delta=1e-4)
        self.assertAlmostEqual(solid["radial_ratio"] / abs(radial / tangential), 1, delta=1e-4)
        stretch = files.force_over_voltage(motor["ceramic_inner_radius"], motor["ceramic_outer_radius"])
        e = motor["ceramic_d31"] * motor["ceramic_youngs_modulus"] / (1 - motor["ceramic_poisson_ratio"])
        waves = motor["electrodes_waves_per_phase"]
        # The pattern of half waves of alternating sign has the part 4 / pi of cos(n phi); it covers N_w / n of the circumference,
        # and half of the square of a cosine is left: N_w / n 4 / pi 60 / 2.
        theta = abs(e * stretch / axial) / motor["ceramic_thickness"] * waves / n * 4 / math.pi * 60 / 2
        # F2.4: three Gauss points of a brick against five: 1e-5 in smooth fields.
        self.assertAlmostEqual(solid["force_factor"] / theta, 1, delta=1e-4)

    def test_a_picture_of_the_wave(self):
        picture = (self.results / "wave.svg").read_text()
        for word in ("plate", "solid", "ceramic", "cross-section at the crest"):
            self.assertIn(word, picture)

    def test_modes_tell_the_separation(self):
        modes = self.answer["solid"]["modes"]
        drive = [mode for mode in modes if mode["drive"]]
        self.assertEqual([mode["wavelengths"] for mode in drive], [6])
        nearest = min(abs(mode["frequency"] - drive[0]["frequency"]) for mode in modes if not mode["drive"])
        self.assertAlmostEqual(self.answer["solid"]["mode_separation"], nearest, delta=1e-9 * drive[0]["frequency"])
        shape = self.answer["solid"]["shape"]
        self.assertEqual((shape[0]["radius"], shape[-1]["radius"]), (5e-3, 15e-3))
        self.assertEqual({row["radius"]: row["R"] for row in shape}[13.25e-3], 1)

    def test_the_written_motor_has_the_solid_s_frequency_and_all_its_comments(self):
        copy = self.results / "plate-30-solid.yaml"
        self.assertIn("plate-30-solid.yaml", self.done.stderr)
        before, after = PLATE.read_text(), copy.read_text()
        share = self.answer["fitted_plate"]["teeth_stiffness_share"]
        words = after.split("stiffness_share: ")
        self.assertEqual(before.split("stiffness_share: ")[0], words[0])
        self.assertAlmostEqual(float(words[1].split("}")[0]) / share, 1, delta=1e-5)
        self.assertEqual(before.split("}", 3)[3], after.split("}", 3)[3])
        again = json.loads(self.ok("stator", copy, "--format", "json"))["modal_data"]
        solid = self.answer["solid"]["resonance_frequency"]
        # The share is written to six digits, and the frequency moves by less than half of it.
        self.assertAlmostEqual(again["resonance_frequency"] / solid, 1, delta=1e-5)
        self.assertAlmostEqual(again["force_factor"], self.answer["fitted_plate"]["force_factor"], delta=1e-5)

    def using(self, change=lambda text: text):
        """A motor file with the data of the solid beside its geometry."""
        text = PLATE.read_text().replace("    geometry:", f"    solid: {self.results}/solid.yaml\n    geometry:")
        return self.write("using.yaml", change(text))

    def test_a_motor_takes_the_solid_s_data(self):
        used = json.loads(self.ok("stator", self.using(), "--format", "json"))["modal_data"]
        for name in ("resonance_frequency", "modal_mass", "force_factor", "blocked_capacitance"):
            self.assertEqual(used[name], self.answer["solid"][name])
        table = self.ok("evaluate", self.using(), "--metrics", "radial_motion_ratio").splitlines()
        value = float(table[1].split(",")[0])
        # R's slope over the circumference's wave against the motion of the tips: the same where teeth turn as they stand, to a
        # tenth of the shear in the ring below.
        self.assertAlmostEqual(value / self.answer["solid"]["radial_ratio"], 1, delta=0.1)

    def test_a_changed_stator_is_refused_with_what_changed(self):
        error = self.refused("stator", self.using(lambda text: text.replace("height: 1 mm", "height: 1.1 mm")))
        self.assertIn("stator.solid: the stator has changed since it was solved: teeth_height is 1.1 mm, but was 1 mm", error)
        error = self.refused("stator", self.using(lambda text: text.replace("inner_edge: clamped", "inner_edge: free")))
        self.assertIn("inner_edge is free, but was clamped", error)
        # Only the plate has this number.
        self.ok("stator", self.using(lambda text: text.replace("stiffness_share: 0.0445", "stiffness_share: 0.1")))

    def test_data_of_a_solid_need_its_geometry_beside_them(self):
        text = pathlib.Path(DRIVE).read_text().replace("    wavelengths", f"    solid: {self.results}/solid.yaml\n    wavelengths", 1)
        self.assertIn("must be given together with the 'geometry' that was solved", self.refused("stator", self.write("drive.yaml", text)))

    def test_data_that_cannot_be_read_are_told_at_the_entry(self):
        error = self.refused("stator", self.using(lambda text: text.replace("solid.yaml", "no.yaml")))
        self.assertIn("using.yaml:", error)
        self.assertIn("no.yaml: cannot be read", error)
        error = self.refused("stator", self.using(lambda text: text.replace(f"{self.results}/solid.yaml", str(PLATE))))
        self.assertIn("motor.stator.solid: ", error)
        self.assertIn("solid: missing", error)


class Refusals(program.Case):
    def test_without_the_solver_its_package_is_named(self):
        error = self.refused("stator", PLATE, "--solid", status=3, env={"PATH": str(self.folder)})
        self.assertIn("install the Debian package calculix-ccx", error)

    def fake(self, script):
        path = self.write("ccx", "#!/bin/sh\n" + script)
        path.chmod(0o755)
        return {"PATH": f"{self.folder}:{os.environ['PATH']}", "TMPDIR": str(self.temporary())}

    def temporary(self):
        folder = self.folder / "temporary"
        folder.mkdir(exist_ok=True)
        return folder

    def test_a_failing_solver_has_its_message_passed_on(self):
        error = self.refused("stator", PLATE, "--solid", status=3, env=self.fake("echo ' *ERROR in x: no'; exit 201"))
        self.assertIn("*ERROR in x: no", error)
        self.assertEqual(list(self.temporary().iterdir()), [])

    def test_a_solver_without_results_is_told(self):
        error = self.refused("stator", PLATE, "--solid", status=3, env=self.fake("echo done > $2.dat"))
        self.assertIn("CalculiX printed no modes", error)

    def test_a_stop_request_ends_the_solver_within_a_second(self):
        env = self.fake("exec sleep 60")
        with subprocess.Popen([program.PROGRAM, "stator", str(PLATE), "--solid"], env={**os.environ, **env},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
            time.sleep(1)
            begin = time.monotonic()
            running.send_signal(signal.SIGINT)
            self.assertEqual(running.wait(timeout=10), 130)
            self.assertLess(time.monotonic() - begin, 1)
            # Nobody else holds the pipe: the solvers are gone, too.
            running.communicate(timeout=1)
        self.assertEqual(list(self.temporary().iterdir()), [])

    def test_what_cannot_be_asked_is_refused_before_the_solver_runs(self):
        env = self.fake("exec sleep 60")
        self.assertIn("given by its geometry", self.refused("stator", DRIVE, "--solid", env=env))
        self.assertIn("--mesh", self.refused("stator", PLATE, "--solid", "--mesh", "1", env=env))
        self.assertIn("--mesh", self.refused("stator", PLATE, "--mesh", "2", env=env))
        self.assertIn("--write", self.refused("stator", PLATE, "--write", env=env))
        self.assertIn("folder", self.refused("stator", PLATE, "--solid", "-o", self.folder / "out.json", env=env))
        self.assertIn("--torque", self.refused("stator", PLATE, "--solid", "--torque", "0.1 N.m", env=env))
        self.assertIn("teeth_count must be",
                      self.refused("stator", PLATE, "--solid", "--set", "teeth_count=12", env=env))


if __name__ == "__main__":
    program.main()
