# SPDX-License-Identifier: Apache-2.0
"""Files of impedance analysers, network analysers, loggers and scopes, made from made-up motors: a fit finds the motor again."""
import cmath
import json
import math

import program
from program import DRIVE, RING, twum

# A circuit whose values are not those of the motor file. Modal mass and force factor are the file's, so that L is, too.
TRUTH = {"resonance_frequency": 39050.0, "quality_factor": 180.0, "blocked_capacitance": 8.2e-9}
MASS, FORCE_FACTOR, LOSS_TANGENT = 0.025, 0.55, 0.01
FREQUENCIES = [38000 + 50 * k for k in range(45)]


def admittance(frequency):
    """Of the circuit: R, L and C in series, beside C_0 with its loss."""
    omega, resonance = 2 * math.pi * frequency, 2 * math.pi * TRUTH["resonance_frequency"]
    inductance = MASS / FORCE_FACTOR**2
    capacitance = 1 / (resonance**2 * inductance)
    resistance = math.sqrt(inductance / capacitance) / TRUTH["quality_factor"]
    motional = resistance + 1j * omega * inductance + 1 / (1j * omega * capacitance)
    return 1j * omega * TRUTH["blocked_capacitance"] * (1 - 1j * LOSS_TANGENT) + 1 / motional


def reflection(frequency, reference):
    z = 1 / admittance(frequency)
    return (z - reference) / (z + reference)


def pair(number, form):
    if form == "RI":
        return number.real, number.imag
    size, angle = abs(number), math.degrees(cmath.phase(number))
    return (20 * math.log10(size) if form == "DB" else size), angle


def touchstone(unit, form, reference):
    scale = {"HZ": 1, "KHZ": 1e3, "MHZ": 1e6}[unit]
    rows = "".join(f"{f / scale:.9g} {a:.12g}\t{b:.12g} ! point\n"
                   for f in FREQUENCIES for a, b in [pair(reflection(f, reference), form)])
    return f"! Phase A of stator 7, phase B shorted\n# {unit} S {form} R {reference}\n{rows}"


def table(heading, of, separator=",", comma=False):
    rows = "".join(separator.join(f"{x:.9g}" for x in (f, *of(admittance(f)))) + "\n" for f in FREQUENCIES)
    return separator.join(heading) + "\n" + (rows.replace(".", ",") if comma else rows)


def impedance_and_phase(y):
    return abs(1 / y), math.degrees(cmath.phase(1 / y))


class Impedances(program.Case):
    def fitted(self, name, content, more=""):
        """Fits the free stator to a file, checks the estimates, and returns what is said of the file."""
        self.write(name, content)
        study = self.write("fit.yaml", f"twum: 1\nmotor: {DRIVE}\nstudy:\n  kind: calibrate\n  data: {name}\n{more}"
                           "  variables:\n    resonance_frequency: {min: 38 kHz, max: 40 kHz}\n"
                           "    quality_factor: {min: 50, max: 600}\n    blocked_capacitance: {min: 2 nF, max: 20 nF}\n")
        done = twum("run", study, "-o", self.folder / "fit", "--fresh")
        # The residuals are those of the ninth digit, which have no scatter to judge a fit by: 1 is as right as 0.
        self.assertIn(done.returncode, (0, 1), done.stderr)
        estimates = json.loads((self.folder / "fit/summary.json").read_text())["estimates"]
        for parameter, value in TRUTH.items():
            # The files have nine digits. The resistance at resonance is 1 / 30 of the reactance around it, and a quality factor
            # is known from it: 1e-9 times less than 1000 remains below 1e-6.
            self.assertAlmostEqual(estimates[parameter]["value"] / value, 1, delta=1e-6, msg=parameter)
        return done.stderr

    def test_touchstone(self):
        for unit, form, reference in (("HZ", "RI", 50), ("KHZ", "MA", 50), ("MHZ", "DB", 75)):
            said = self.fitted("z.s1p", touchstone(unit, form, reference))
            self.assertIn(f"z.s1p is read as: Touchstone, S11 with a reference of {reference} ohm", said)

    def test_touchstone_as_a_program_with_utf16_or_old_line_ends_saves_it(self):
        said = self.fitted("z.s1p", touchstone("HZ", "RI", 50).replace("\n", "\r").encode("utf-16"))
        self.assertIn("text in UTF-16", said)
        self.assertIn("Touchstone", said)

    def test_conductance_and_susceptance(self):
        said = self.fitted("z.csv", "Analyser 5,Level 0.5 V\n\n" + table(('"Freq[Hz]"', '"G[S]"', '"B[S]"'), lambda y: (y.real, y.imag)))
        self.assertIn("z.csv is read as: an impedance analyser's table of G and B, headings on line 3", said)

    def test_resistance_and_reactance_of_a_german_spreadsheet(self):
        content = table(("Frequency (Hz)", "Rs (Ohm)", "Xs (Ohm)"), lambda y: ((1 / y).real, (1 / y).imag), ";", comma=True)
        said = self.fitted("z.csv", content.encode("utf-16"))
        self.assertIn("an impedance analyser's table of R and X, text in UTF-16, columns separated by semicolons, decimal commas", said)

    def test_impedance_and_phase(self):
        for headings in (("Frequency (Hz)", "|Z| (Ω)", "θ (deg)"), ("Freq-Hz", "Z-Ohm", "Phase-deg"), ("f [Hz]", "Impedance [Ohm]", "Phase [°]")):
            said = self.fitted("z.csv", table(headings, impedance_and_phase), "  scatter: by-column\n")
            self.assertIn("an impedance analyser's table of |Z| and phase", said)

    def test_impedance_and_phase_have_errors_of_two_sizes(self):
        self.write("z.csv", table(("Frequency (Hz)", "|Z| (Ohm)", "Phase (deg)"), impedance_and_phase))
        study = self.write("fit.yaml", f"twum: 1\nmotor: {DRIVE}\nstudy:\n  kind: calibrate\n  data: z.csv\n"
                                       "  variables: {quality_factor: {min: 50, max: 600}}\n")
        self.assertIn("'scatter: by-column'", self.refused("run", study, "-o", self.folder / "fit"))

    def test_what_a_pair_does_not_need_is_told(self):
        content = table(("Frequency (Hz)", "R (Ohm)", "X (Ohm)", "Cs (F)"), lambda y: ((1 / y).real, (1 / y).imag, 1e-9))
        self.assertIn("columns that the study does not use: 'Cs (F)'", self.fitted("z.csv", content))

    def test_foreign_headings_are_named_in_the_study(self):
        content = table(("CH0", "CH1", "CH2"), lambda y: (1e3 * y.real, -1e3 * y.imag))
        said = self.fitted("z.csv", content, "  columns:\n    frequency: {column: CH0, unit: Hz}\n"
                           "    conductance: {column: 2, unit: mS}\n    susceptance: {column: CH2, unit: mS, sign: reversed}\n")
        self.assertNotIn("does not use", said)

    def test_a_conductance_of_the_other_sign_is_called_that(self):
        self.write("z.csv", table(("f (Hz)", "G (S)", "B (S)"), lambda y: (-y.real, -y.imag)))
        study = self.write("fit.yaml", f"twum: 1\nmotor: {DRIVE}\nstudy:\n  kind: calibrate\n  data: z.csv\n"
                                       "  variables: {quality_factor: {min: 50, max: 600}}\n")
        said = twum("run", study, "-o", self.folder / "fit").stdout.decode()
        self.assertIn("The signs of conductance look reversed", said)

    def test_what_is_wrong_in_a_touchstone_file_is_told_at_its_line(self):
        for row, words in (("38000 0.5", "2 words in a line"), ("38000 0.5 x", "'x' is not a number"), ("38000 -1 0", "short circuit")):
            self.write("z.s1p", f"# HZ S RI R 50\n37000 0.5 0.5\n{row}\n")
            study = self.write("fit.yaml", f"twum: 1\nmotor: {DRIVE}\nstudy:\n  kind: calibrate\n  data: z.s1p\n"
                                           "  variables: {quality_factor: {min: 50, max: 600}}\n")
            said = self.refused("check", study)
            self.assertIn("z.s1p:3:1: ", said)
            self.assertIn(words, said)


class Loads(program.Case):
    """Torque and speed of test stands. With one slice the stall torque is mu F_N r."""

    def setUp(self):
        super().setUp()
        self.curve = json.loads(self.ok("curve", RING, "--points", "12", "--set", "kinetic_friction=0.23", "--format", "json"))["curve"][:-1]

    def fitted(self, content, more=""):
        self.write("bench.csv", content)
        study = self.write("fit.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: bench.csv\n{more}"
                                       "  variables: {kinetic_friction: {min: 0.05, max: 0.5}}\n")
        done = twum("run", study, "-o", self.folder / "fit", "--fresh")
        # The residuals are those of the ninth digit, which have no scatter to judge a fit by: 1 is as right as 0.
        self.assertIn(done.returncode, (0, 1), done.stderr)
        estimate = json.loads((self.folder / "fit/summary.json").read_text())["estimates"]["kinetic_friction"]["value"]
        self.assertAlmostEqual(estimate, 0.23, delta=1e-6)  # the files have nine digits
        return done.stderr

    def rows(self, line):
        return "".join(line(k, point["speed"] * 30 / math.pi, point["torque"]) for k, point in enumerate(self.curve))

    def test_a_logger_with_lines_above_units_below_and_columns_of_its_own(self):
        rows = self.rows(lambda k, speed, torque: f"{0.1 * k:.1f},{speed:.9g},{1e3 * torque:.9g},ok\n")
        said = self.fitted("Logger,DX-4\nFirmware,1.30\nInterval,0.1\n\nTime,speed,torque,State\ns,rpm,mN.m,\n" + rows)
        self.assertIn("bench.csv is read as: headings on line 5, a row of units on line 6", said)
        self.assertIn("columns that the study does not use: 'Time [s]', 'State'", said)

    def test_foreign_headings_and_a_reversed_sign(self):
        rows = self.rows(lambda k, speed, torque: f"{k};{speed:.9g};{-100 * torque:.9g}\n").replace(".", ",")
        self.fitted('"Nr.";"n [1/min]";"M"\n' + rows,
                    '  columns: {speed: {column: "n [1/min]", unit: r/min}, torque: {column: 3, unit: Ncm, sign: reversed}}\n')

    def test_a_heading_of_one_letter_serves_where_the_study_names_it(self):
        self.fitted("n [rpm],M [N.m]\n" + self.rows(lambda k, speed, torque: f"{speed:.9g},{torque:.9g}\n"),
                    '  columns: {speed: "n [rpm]", torque: M}\n')

    def test_the_own_table_of_a_curve_is_read(self):
        own = self.ok("curve", RING, "--points", "12", "--set", "kinetic_friction=0.23", "--format", "csv")
        self.assertIn("'output_power [W]'", self.fitted("".join(own.splitlines(True)[:-1])))

    def test_a_table_without_headings_loses_no_row(self):
        self.write("bench.csv", "85,0.765\n105,0.74\n125,0.465\n")
        study = self.write("fit.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: bench.csv\n"
                           "  columns: {speed: {column: 1, unit: rpm}, torque: {column: 2, unit: N.m}}\n"
                           "  variables: {kinetic_friction: {min: 0.05, max: 0.5}}\n")
        self.assertIn("bench.csv:1:1: speed: a number where the headings should be: '85'", self.refused("check", study))

    def test_columns_that_are_not_there_or_named_twice_are_refused(self):
        self.write("bench.csv", "n,M\n1,2\n")
        for entry, words in (("{speed: rpm, torque: M}", "no column 'rpm', which 'columns' of the study names; expected one of 'n', 'M'"),
                             ("{speed: 7, torque: M}", "no column 7"), ("{speed: n, torque: 1}", "column 1 has another meaning already"),
                             ("{speed: 1, torque: 9}", "no column 9"), ("{sped: n}", "'sped' is not a quantity that a table may contain"),
                             ("{speed: 0.5, torque: M}", "expected the number of a column"),
                             ("{speed: {column: n, sign: up}, torque: M}", "reversed")):
            study = self.write("fit.yaml", f"twum: 1\nmotor: {RING}\nstudy:\n  kind: calibrate\n  data: bench.csv\n"
                                           f"  columns: {entry}\n  variables: {{kinetic_friction: {{min: 0.05, max: 0.5}}}}\n")
            self.assertIn(words, self.refused("check", study))


if __name__ == "__main__":
    program.main()
