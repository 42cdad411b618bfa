# SPDX-License-Identifier: Apache-2.0
"""Commands, options, help, and what is said about mistakes in them."""
import program
from program import RING

COMMANDS = ("curve", "fields", "evaluate", "check", "metrics", "parameters", "schema", "init")


class Help(program.Case):
    def test_every_command_has_help_with_examples(self):
        self.assertIn("Exit status", self.ok("--help"))
        for command in COMMANDS:
            with self.subTest(command):
                text = self.ok(command, "--help")
                self.assertIn("Examples:", text)
                self.assertIn(f"twum {command}", text)

    def test_version(self):
        version, solvers, licence = self.ok("--version").splitlines()
        self.assertRegex(version, r"^twum \d+\.\d+\.\d+$")
        self.assertRegex(solvers, r"^solvers: NLopt \d+\.\d+")
        self.assertRegex(solvers, r", SUNDIALS \d+\.\d+")
        # Both together may not be passed on; GSL alone makes it GPL-3.
        both = "GSL" in solvers and "Ipopt" in solvers
        self.assertEqual(licence.startswith("licence of this program: for your own use"), both)
        self.assertEqual("GPL-3" in licence, "GSL" in solvers)


class Mistakes(program.Case):
    def test_no_command(self):
        self.assertIn("Subcommands", self.refused())

    def test_unknown_command(self):
        self.assertEqual(self.refused("curv", RING),
                         "twum: unknown command 'curv'; did you mean 'curve'? ('twum --help' lists the commands)\n")
        self.assertIn("expected one of curve", self.refused("paint"))

    def test_an_empty_text_is_not_the_default(self):
        for command, option in (("curve", "--output"), ("curve", "--points"), ("curve", "--set"), ("evaluate", "--metrics"),
                                ("evaluate", "--designs"), ("evaluate", "--jobs"), ("run", "--output"), ("curve", "--plot")):
            with self.subTest(command, option=option):
                self.assertIn(f"{option} is given as an empty text; give a value, or leave it out",
                              self.refused(command, RING, option, "", cwd=self.folder))
        self.assertIn("empty text", self.refused("run", RING, "-o", "", cwd=self.folder))
        self.assertIn("empty text", self.refused("check", "", cwd=self.folder))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_unknown_option(self):
        self.assertEqual(self.refused("curve", RING, "--fromat", "csv"),
                         "twum curve: unexpected '--fromat'; did you mean '--format'?\n")
        self.refused("metrics", "-x")
        self.refused("curve", RING, "extra")

    def test_missing_arguments(self):
        for arguments in (["curve"], ["fields", RING], ["evaluate"], ["check"], ["schema"], ["init"],
                          ["curve", RING, "--set"], ["curve", RING, "--points"]):
            with self.subTest(arguments):
                self.refused(*arguments)

    def test_wrong_values(self):
        for arguments in (["curve", RING, "--format", "xml"], ["curve", RING, "--points", "1"],
                          ["curve", RING, "--points", "many"], ["curve", RING, "--points", "-5"],
                          ["curve", RING, "--points", "1e3"], ["curve", RING, "--points", "99999999999999999999"],
                          ["curve", RING, "--speeds", "100"], ["curve", RING, "--speeds", "100 Hz"],
                          ["curve", RING, "--speeds", "1 rpm,"], ["curve", RING, "--speeds", "nan rpm"],
                          ["curve", RING, "--speeds", "1 rpm", "--points", "5"],
                          ["fields", RING, "--speed", "5 N"], ["fields", RING, "--speed", ""],
                          ["fields", RING, "--speed", "1 rpm", "--samples", "0"],
                          ["schema", "engine"], ["init", "engine"], ["metrics", "--format", "yaml"]):
            with self.subTest(arguments):
                self.refused(*arguments)

    def test_a_speed_beyond_the_wave_is_refused(self):
        self.assertIn("speed", self.refused("curve", RING, "--speeds", "-1e6 rpm"))
        self.refused("fields", RING, "--speed", "-1e6 rpm")

    def test_settings(self):
        self.assertEqual(self.refused("curve", RING, "--set", "thicknes=3 mm", "--set", "preload=3 mm"),
                         "twum: --set thicknes: unknown parameter 'thicknes'; did you mean 'thickness'?\n"
                         "--set preload: '3 mm' is a length [m]; expected a force [N] such as '160 N'\n")
        for setting in ("", "=", "preload", "preload=", "=3", "preload=160", "n=9.5", "mu_0=0.1", "h=1e999 m"):
            with self.subTest(setting):
                self.refused("check", RING, "--set", setting)
        self.refused("check", RING, "--set", "nu=0.3", "--set", "G=1 GPa")
        self.ok("check", RING, "--set", "nu=0.3", "--set", "F_N=140 N")


if __name__ == "__main__":
    program.main()
