# SPDX-License-Identifier: Apache-2.0
"""Projects of other people find, link and run the installed package, and the tree itself."""
import argparse
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONSUMER = ROOT / "tests/package/consumer"
RING = ROOT / "tests/data/motors/ring-60.yaml"
ARGUMENTS = None
PREFIX = None

# ring-60 slips all round at rest, so its stall torque is mu F_N r (theory section 8), which is also
# mu_0 F_N r, its holding torque. Both are one product of three inputs, exact but for rounding.
HOLDING = 0.2 * 160 * 0.0265


def run(*command, env=None):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=600,
                          env={**os.environ, **(env or {})})


class Case(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="twum package ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def ok(self, *command, env=None):
        done = run(*command, env=env)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def configure(self, *settings):
        return run(ARGUMENTS.cmake, "-S", CONSUMER, "-B", self.folder / "build", "-G", "Ninja",
                   f"-DCMAKE_CXX_COMPILER={ARGUMENTS.compiler}", f"-DCMAKE_PREFIX_PATH={PREFIX}",
                   f"-DCMAKE_CXX_COMPILER_LAUNCHER={ARGUMENTS.launcher}", "-DCMAKE_BUILD_TYPE=Release", *settings)

    def consumer(self, *settings):
        done = self.configure(*settings)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.ok(ARGUMENTS.cmake, "--build", self.folder / "build", "--target", "consumer")
        return self.folder / "build/consumer"

    def check_everything(self, program, env=None):
        """The preload for 0.53 N.m is 0.53 / (mu_0 r) = 100 N."""
        lines = [line.split() for line in self.ok(program, RING, "0.53 N.m", env=env).splitlines()]
        for solver, outcome, preload in lines[:-1]:
            self.assertEqual(outcome, "optimal", solver)
            # The limit holds to feasibility_tolerance = 1e-8 of its gradient's scale; nine digits are printed.
            self.assertAlmostEqual(float(preload), 0.53 / (0.2 * 0.0265), delta=1e-5, msg=solver)
        self.assertIn("nlopt:slsqp", [line[0] for line in lines])
        self.assertEqual(lines[-1][1], ARGUMENTS.version)
        self.assertAlmostEqual(float(lines[-1][2]), HOLDING, delta=1e-9)


class FindPackage(Case):
    def test_all_components(self):
        self.check_everything(self.consumer("-DPART=studies", f"-DWANTED={ARGUMENTS.version}"))

    def test_a_program_with_debug_containers_does_not_link_with_libraries_without(self):
        done = self.configure("-DPART=core", "-DCMAKE_CXX_FLAGS=-D_GLIBCXX_DEBUG")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = run(ARGUMENTS.cmake, "--build", self.folder / "build", "--target", "consumer")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("library_was_built_with_glibcxx_debug", done.stdout)

    def test_a_program_with_headers_of_another_version_does_not_link(self):
        header = self.folder / "twum/base/version.hpp"
        header.parent.mkdir(parents=True)
        own = (PREFIX / "include/twum/base/version.hpp").read_text()
        header.write_text(re.sub(r"(VERSION_MINOR) \d+", r"\1 99", own))
        done = self.configure("-DPART=core")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = run(ARGUMENTS.cmake, "--build", self.folder / "build", "--target", "consumer", env={"CPATH": str(self.folder)})
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"undefined reference to `twum::v\d+_\d+::base::library_has_version_\d+_99'")

    def test_core_alone_needs_no_solver_and_no_yaml(self):
        refused = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("NLopt", "yaml-cpp", "PkgConfig")]
        program = self.consumer("-DPART=core", *refused)
        self.assertAlmostEqual(float(self.ok(program)), HOLDING, delta=4e-16)

    def test_a_program_may_take_eigen_itself_with_other_options(self):
        said = self.ok(self.consumer("-DPART=optim")).split()
        # The parameters that made the points, ones, and the matrix's trace; the fit's tolerance is 1e-10.
        for number, truth in zip(said, (2, 0.5, 20, 40), strict=True):
            self.assertAlmostEqual(float(number), truth, delta=1e-8)

    def test_a_program_with_many_warnings_and_sanitizers(self):
        # The least of (x - 100)^2, and the preload 0.53 / (mu_0 r), both 100 to the accuracy of a search.
        for number in self.ok(self.consumer("-DPART=strict", "-DCMAKE_BUILD_TYPE=Debug")).split():
            self.assertAlmostEqual(float(number), 100, delta=1e-4)

    def test_a_plugin_exports_its_own_function_alone(self):
        """Beside it stand templates of the standard library, which are weak in any program."""
        rows = [row.split() for row in self.ok("nm", "-D", "--defined-only", self.consumer("-DPART=plugin")).splitlines()]
        if list(PREFIX.rglob("libtwum_core.so")):
            return
        self.assertEqual([name for _, kind, name in rows if kind not in "WVu"], ["best_preload"])
        self.assertEqual([name for _, _, name in rows if "4twum" in name], [])

    def test_unknown_component_is_refused_by_name(self):
        done = self.configure("-DPART=motors")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no component 'motors'", " ".join(done.stderr.split()))

    def test_another_minor_version_is_refused(self):
        done = self.configure("-DPART=core", "-DWANTED=0.99")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"version: {ARGUMENTS.version}", done.stderr)


class PkgConfig(Case):
    def test_one_line_builds_a_program(self):
        found = next(PREFIX.rglob("pkgconfig"))
        flags = self.ok("pkg-config", "--cflags", "--libs", "twum", env={"PKG_CONFIG_PATH": str(found)}).split()
        self.ok(ARGUMENTS.compiler, "-std=c++20", CONSUMER / "everything.cpp", *flags, "-o", self.folder / "program")
        self.check_everything(self.folder / "program", env={"LD_LIBRARY_PATH": str(found.parent)})  # for shared ones

    def test_core_names_no_package_of_others(self):
        found = next(PREFIX.rglob("pkgconfig"))
        text = self.ok("pkg-config", "--cflags", "--libs", "twum-core", env={"PKG_CONFIG_PATH": str(found)})
        self.assertEqual([f for f in text.split() if f.startswith("-l")], ["-ltwum_core", "-ltwum_stator", "-ltwum_base"])


class Umbrella(Case):
    def test_core_and_optim_name_every_header_of_theirs(self):
        include = PREFIX / "include"
        for layer in ("core", "motion", "optim"):
            text = (include / f"twum/{layer}.hpp").read_text()
            headers = sorted((include / "twum" / layer).rglob("*.hpp"))
            self.assertGreater(len(headers), 2)
            for header in headers:
                self.assertIn(f"#include <{header.relative_to(include)}>", text)


class Guide(Case):
    def test_its_lines_of_cmake_build_a_program(self):
        guide = (ROOT / "docs/guide/library.md").read_text()
        shown = re.search(r"```cmake\n(.*?)```", guide, re.S)[1]
        (self.folder / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(program LANGUAGES C CXX)\n"
            f"add_executable(program program.cpp)\n{shown}")
        (self.folder / "program.cpp").write_text(
            "#include <twum/twum.hpp>\nint main() { return twum::version()[0] == 0; }\n")
        self.ok(ARGUMENTS.cmake, "-S", self.folder, "-B", self.folder / "build", "-G", "Ninja",
                f"-DCMAKE_CXX_COMPILER={ARGUMENTS.compiler}", f"-DCMAKE_PREFIX_PATH={PREFIX}",
                f"-DCMAKE_CXX_COMPILER_LAUNCHER={ARGUMENTS.launcher}")
        self.ok(ARGUMENTS.cmake, "--build", self.folder / "build")
        self.ok(self.folder / "build/program")


class Examples(Case):
    """examples/cpp is a project outside the tree."""

    def test_each_is_short(self):
        for path in (ROOT / "examples/cpp").glob("*.cpp"):
            self.assertLess(len(path.read_text().splitlines()), 80, path.name)

    def test_all_of_them_run(self):
        build = self.folder / "build"
        self.ok(ARGUMENTS.cmake, "-S", ROOT / "examples/cpp", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                f"-DCMAKE_CXX_COMPILER={ARGUMENTS.compiler}", f"-DCMAKE_PREFIX_PATH={PREFIX}",
                f"-DCMAKE_CXX_COMPILER_LAUNCHER={ARGUMENTS.launcher}")
        self.ok(ARGUMENTS.cmake, "--build", build)
        sources = sorted(path.stem for path in (ROOT / "examples/cpp").glob("*.cpp"))
        self.assertGreater(len(sources), 6)
        arguments = {"curve": [RING], "motion": [ROOT / "examples/motors/moving-60.yaml"],
                     "study": [ROOT / "examples/studies/optimize-ring-60.yaml"],
                     "own_optimizer": [ROOT / "examples/motors/drive-60.yaml"]}
        said = {name: self.ok(build / name, *arguments.get(name, [])) for name in sources if name != "sizing_service"}
        self.check_service(build / "sizing_service")
        self.assertRegex(said["curve"], "slip[+]")
        self.assertRegex(said["motion"], ": ok\n(.|\n)*: held")
        self.assertRegex(said["optimize"], "nlopt:slsqp: optimal")
        self.assertNotIn("not certified", said["front"])
        self.check_fit(said["fit"])
        self.check_size(said["size"])
        self.check_gearbox(said["own_optimizer"])
        self.assertRegex(said["own_limit"], r"^feasible: .* cost (8\.00|7\.99)\n$")

    def check_gearbox(self, text):
        """Another ratio needs more power, as twum evaluate says of the torque and the speed behind the gearbox."""
        ratio, power = map(float, re.search(r"ratio (\S+), (\S+) W", text).groups())
        duty = [f"electrical_power_at({2 / r * (1 + 0.03 * math.log(r))!r} N.m, {2 * r!r} rad/s)" for r in (ratio, 0.98 * ratio, 1.02 * ratio)]
        said = self.ok(pathlib.Path(ARGUMENTS.build) / "bin/twum", "evaluate", ROOT / "examples/motors/drive-60.yaml", "--metrics", ", ".join(duty))
        found, less, more = map(float, said.splitlines()[-1].split(",")[:3])
        self.assertAlmostEqual(found, power, delta=1e-3)  # three decimals are printed
        self.assertLess(found, min(less, more))

    def check_fit(self, text):
        """The points are those of mu = 0.18, E = 2.5 GPa, rounded to 5 mN.m: the intervals hold both."""
        for name, truth in (("kinetic_friction", 0.18), ("youngs_modulus", 2.5e9)):
            low, high = re.search(rf"{name} \S+ \((\S+) to (\S+)\)", text).groups()
            self.assertLess(float(low), truth)
            self.assertLess(truth, float(high))

    def check_service(self, program):
        """Answers come in the order of the requests; a request that is cancelled has an answer too."""
        asked = "0.5 N.m, 100 rpm\n0.5 N.m, 1 mm\n50 N.m, 100 rpm\n0.4 N.m, 50 rpm\ncancel\n"
        done = subprocess.run([program], input=asked, capture_output=True, text=True, timeout=100)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 4, done.stdout + done.stderr)
        for line, words in zip(lines, ("-> optimal: preload", "-> refused: speed: .*length", "-> infeasible", "-> (budget|optimal)")):
            self.assertRegex(line, words)

    def check_size(self, text):
        """C++ and Python say the same of two duties that the drive holds."""
        self.assertTrue(text.startswith("outcome optimal\n"), text)
        module = pathlib.Path(ARGUMENTS.build) / "python"
        if not list(module.glob("twum/_twum*.so")):
            self.skipTest("the Python module is not built")
        env = {"PYTHONPATH": str(module), "PYTHONDONTWRITEBYTECODE": "1"}
        self.assertEqual(self.ok("/usr/bin/python3", ROOT / "examples/python/size.py", env=env), text)


class AddSubdirectory(Case):
    def test_core_is_built_along_as_shared_libraries_with_other_flags(self):
        program = self.consumer("-DPART=core", f"-DTWUM_TREE={ROOT}", "-DTWUM_UNITY=ON", "-DBUILD_SHARED_LIBS=ON",
                                "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -fno-inline -D_GLIBCXX_ASSERTIONS")
        self.assertAlmostEqual(float(self.ok(program)), HOLDING, delta=4e-16)
        self.assertFalse((self.folder / "build/twum/tests").exists())
        library = next((self.folder / "build").rglob("libtwum_core.so"))
        names = [row.split()[-1] for row in self.ok("nm", "-D", "--defined-only", library).splitlines()]
        unversioned = [name for name in names if "4twum" in name and "@@libtwum_core.so." not in name]
        self.assertEqual(unversioned, [])


def setUpModule():
    """Installs, and then moves the prefix: nothing in it may hold its old place."""
    global PREFIX
    scratch = tempfile.TemporaryDirectory(prefix="twum-prefix-")
    unittest.addModuleCleanup(scratch.cleanup)
    first = pathlib.Path(scratch.name) / "first"
    for component in ("dev", "runtime") if ARGUMENTS.shared else ("dev",):
        done = run(ARGUMENTS.cmake, "--install", ARGUMENTS.build, "--prefix", first, "--component", component)
        if done.returncode:
            raise RuntimeError(done.stdout + done.stderr)
    PREFIX = first.rename(pathlib.Path(scratch.name) / "moved")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for name in ("cmake", "build", "compiler", "launcher"):
        parser.add_argument("--" + name, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    cache = (pathlib.Path(ARGUMENTS.build) / "CMakeCache.txt").read_text()
    ARGUMENTS.shared = re.search(r"^BUILD_SHARED_LIBS:\w+=(ON|1|TRUE|YES)$", cache, re.M | re.I) is not None
    ARGUMENTS.version = cache.split("CMAKE_PROJECT_VERSION:STATIC=")[1].split()[0]
    unittest.main(argv=[__file__, *rest], verbosity=1)
