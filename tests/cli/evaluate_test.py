# SPDX-License-Identifier: Apache-2.0
"""evaluate: tables of designs in, tables with metrics out."""
import csv
import io
import json
import random

import program
from program import RING, twum


def table(rows, seed=1):
    numbers = random.Random(seed)
    text = "id,preload [N],amplitude [um],thickness [mm]\n"
    for i in range(rows):
        text += f"{i},{numbers.uniform(60, 300):.4f},{numbers.uniform(0.8, 2.2):.5f},{numbers.uniform(0.1, 1):.5f}\n"
    return text


class Evaluate(program.Case):
    def test_values_are_those_of_the_curve_command(self):
        designs = self.write("designs.csv", "preload [N],note\n140,light\n")
        rows = list(csv.DictReader(io.StringIO(self.ok(
            "evaluate", RING, "--designs", designs, "--metrics", "stall_torque, torque_at(100 rpm), preload"))))
        curve = json.loads(self.ok("curve", RING, "--set", "preload=140 N", "--speeds", "100 rpm", "--format", "json"))
        self.assertEqual(float(rows[0]["stall_torque [N.m]"]), curve["metrics"]["stall_torque"])
        self.assertEqual(float(rows[0]["torque_at(100 rpm) [N.m]"]), curve["curve"][0]["torque"])
        self.assertEqual((rows[0]["note"], rows[0]["preload [N]"], rows[0]["status"]), ("light", "140", "ok"))

    def test_any_number_of_jobs_gives_the_same_bytes(self):
        designs = self.write("designs.csv", table(3000) + "x\n1,2,3,\n")
        results = [self.ok("evaluate", RING, "--designs", designs, "--metrics", "stall_torque, speed_at(0.3 N.m)",
                           "--jobs", jobs) for jobs in (1, 2, 8)]
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])
        self.assertEqual(len(results[0].splitlines()), 3003)

    def test_default_metrics(self):
        designs = self.write("designs.csv", "preload\n160\n")
        header = self.ok("evaluate", RING, "--designs", designs).splitlines()[0]
        self.assertIn("max_efficiency [1]", header)
        undamped = self.ok("evaluate", RING, "--set", "modal_damping=0 N.s/m", "--designs", designs).splitlines()
        self.assertNotIn("max_efficiency", undamped[0])
        self.assertTrue(undamped[1].endswith(",ok"))

    def test_without_a_table_the_motor_itself_is_evaluated(self):
        rows = list(csv.reader(io.StringIO(self.ok(
            "evaluate", RING, "--set", "preload=100 N", "--metrics", "stall_torque, max( preload*2, 1 kN )"))))
        # mu F_N r; of 200 N and 1 kN the larger.
        self.assertEqual(rows[0], ["stall_torque [N.m]", "max(preload * 2, 1 kN) [N]", "status"])
        self.assertAlmostEqual(float(rows[1][0]), 0.2 * 100 * 0.0265, delta=1e-9)
        self.assertEqual(rows[1][1:], ["1000", "ok"])
        self.assertIn("max_efficiency [1]", self.ok("evaluate", RING))
        none = twum("evaluate", RING, "--metrics", "2 * speed_at(50 N.m)")
        self.assertEqual((none.returncode, none.stdout.decode().splitlines()[1]),
                         (1, ",2 * speed_at(50 N.m): unreachable"))

    def test_a_wrong_expression_is_shown_with_a_caret(self):
        done = twum("evaluate", RING, "--metrics", "preload, preload + 5 m")
        self.assertEqual(done.returncode, 2)
        lines = done.stderr.splitlines()
        self.assertIn("'preload' is a force [N], but '5 m' is a length [m]", lines[0])
        self.assertEqual(lines[1][lines[2].index("^")], "+")

    def test_output_file_and_standard_input(self):
        out = self.folder / "ergebnis größe.csv"
        self.assertEqual(self.ok("evaluate", RING, "--designs", "-", "--metrics", "preload", "-o", out,
                                 stdin=b"\xef\xbb\xbfF_N [kN]\r\n0.1\r\n"), "")
        self.assertEqual(out.read_text(), "F_N [kN],preload [N],status\n0.1,100,ok\n")

    def test_failing_designs_do_not_stop_the_others(self):
        designs = self.write("designs.csv", "preload\n160\nabc\n-1\n\n1,2\n80\n")
        done = twum("evaluate", RING, "--designs", designs, "--metrics", "preload, speed_at(0.6 N.m)")
        self.assertEqual(done.returncode, 0)
        rows = list(csv.reader(io.StringIO(done.stdout.decode())))
        self.assertEqual([row[-1] for row in rows], [
            "status", "ok", "line 3: preload: 'abc' is not a number",
            "line 4: preload must be at least 0 N, but is -1 N", "line 6: 2 cells, the header has 1",
            "speed_at(0.6 N.m): unreachable"])
        self.assertEqual({len(row) for row in rows}, {4})
        self.assertIn("4 of 5 designs failed or are incomplete", done.stderr)

    def test_a_table_without_any_answer_has_a_status_of_its_own(self):
        designs = self.write("designs.csv", "preload [N]\nx\n-1\n")
        done = twum("evaluate", RING, "--designs", designs)
        self.assertEqual(done.returncode, 1)
        self.assertIn("2 of 2 designs", done.stderr)

    def test_a_part_of_an_answer_is_an_answer(self):
        designs = self.write("designs.csv", "preload [N]\n160\n")
        done = twum("evaluate", RING, "--set", "modal_damping=0 N.s/m", "--designs", designs,
                            "--metrics", "stall_torque, max_efficiency")
        self.assertEqual(done.returncode, 0)
        self.assertIn("1 of 1 designs failed or are incomplete", done.stderr)
        self.assertIn(b"max_efficiency: undefined", done.stdout)

    def test_reasons_to_doubt_the_model_are_those_of_the_curve_command(self):
        designs = self.write("designs.csv", "thickness [mm]\n0.3\n0.6\n0.8\n")
        done = twum("evaluate", RING, "--designs", designs, "--metrics", "stall_torque", "--jobs", 2)
        curve = twum("curve", RING, "--set", "thickness=0.8 mm", "--format", "csv")
        note, = [line for line in curve.stderr.splitlines() if "contact length" in line]
        self.assertEqual(done.stderr, note.replace("note: ", "note: line 4: ") + "; the same for 1 other, to a smaller extent\n")

    def test_wrong_tables_are_refused(self):
        for text in ("", "\n\n", "id\n1\n", "preload [m]\n1\n", "preload,F_N\n1,2\n", "nu,G\n1,2\n", "preload;h\n1;2\n",
                     'preload,"x\n1,2\n', b"\x00\x01\x02\n1\n"):
            with self.subTest(text):
                self.refused("evaluate", RING, "--designs", self.write("designs.csv", text))
        self.refused("evaluate", RING, "--designs", self.folder / "absent.csv")
        self.refused("evaluate", RING, "--designs", self.folder)

    def test_rows_before_one_that_cannot_be_read_are_not_lost(self):
        designs = self.write("designs.csv", 'preload\n160\n80\n"40\n')
        done = twum("evaluate", RING, "--designs", designs, "--metrics", "preload")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout.decode(), "preload,preload [N],status\n160,160,ok\n80,80,ok\n")
        self.assertIn("designs.csv:4:1: a quotation that does not end", done.stderr)

    def test_wrong_expressions_are_refused_with_a_caret(self):
        designs = self.write("designs.csv", "preload\n160\n")
        self.assertEqual(self.refused("evaluate", RING, "--designs", designs, "--metrics", "stall_torque, torque_at(1 N)"),
                         "twum: --metrics: torque_at: '1 N' is a force [N]; expected an angular speed [rad/s] such as "
                         "'100 rpm'\n  stall_torque, torque_at(1 N)\n                            ^\n")
        for jobs in ("0", "-1", "x", "99999"):
            self.refused("evaluate", RING, "--designs", designs, "--jobs", jobs)

    def test_an_input_is_never_overwritten(self):
        designs = self.write("designs.csv", "preload\n160\n")
        self.assertIn("would be overwritten", self.refused("evaluate", RING, "--designs", designs, "-o", designs))
        self.assertEqual(designs.read_text(), "preload\n160\n")

    def test_a_refused_table_leaves_an_old_result_alone(self):
        old = self.write("result.csv", "precious\n")
        self.refused("evaluate", RING, "--designs", self.write("designs.csv", "colour\nred\n"), "-o", old)
        self.assertEqual(old.read_text(), "precious\n")

    def test_results_may_be_read_back(self):
        designs = self.write("designs.csv", "preload [N],note\n160,a\n-1,b\n")
        once, twice = self.folder / "once.csv", self.folder / "twice.csv"
        metrics = ("--metrics", "stall_torque, peak_power / preload, -peak_power")
        self.ok("evaluate", RING, "--designs", designs, *metrics, "-o", once)
        done = twum("evaluate", RING, "--designs", once, *metrics, "-o", twice)
        self.assertIn("computed anew are not copied: 'stall_torque [N.m]', 'peak_power / preload [m.rad/s]', ''-peak_power [W]', 'status'", done.stderr)
        self.assertEqual(twice.read_text(), once.read_text())
        other = self.ok("evaluate", RING, "--designs", once, "--metrics", "max_pressure").splitlines()
        self.assertEqual(other[0], "preload [N],note,stall_torque [N.m],peak_power / preload [m.rad/s],'-peak_power [W],max_pressure [Pa],status")

    def test_cells_that_a_spreadsheet_would_run_get_an_apostrophe(self):
        cells = {"=1+2": "'=1+2", '"=cmd|x, y"': '"\'=cmd|x, y"', "@sum": "'@sum", "+a": "'+a", "-b": "'-b", "-1.5e3": "-1.5e3",
                 "+2": "+2", "'=x": "'=x", " =y": "'=y", "a=b": "a=b", '"=""q"""': '"\'=""q"""'}
        designs = self.write("designs.csv", "preload [N],=who\n" + "".join(f"160,{cell}\n" for cell in cells))
        lines = self.ok("evaluate", RING, "--designs", designs, "--metrics", "preload / 1 N").splitlines()
        self.assertEqual(lines[0], "preload [N],'=who,preload / 1 N [1],status")
        self.assertEqual(lines[1:], [f"160,{written},160,ok" for written in cells.values()])

    def test_a_table_without_an_answer_ends_with_1(self):
        for text, metrics in (("preload\n160\n120\n", "2 * preload, speed_at(5 N.m)"), ("preload\n-1\n", "preload"),
                              ("preload\n", "stall_torque"), ("preload\nx\n", "stall_torque")):
            done = twum("evaluate", RING, "--designs", self.write("none.csv", text), "--metrics", metrics)
            self.assertEqual(done.returncode, 1, (text, done.stderr))
        self.assertEqual(twum("evaluate", RING, "--metrics", "preload, speed_at(5 N.m)").returncode, 1)
        self.assertIn("no designs below its header", twum("evaluate", RING, "--designs", self.write("e.csv", "preload\n")).stderr)
        self.ok("evaluate", RING, "--designs", self.write("one.csv", "preload\n160\n-1\n"), "--metrics", "stall_torque")

    def test_a_heading_without_a_unit_is_told(self):
        done = twum("evaluate", RING, "--designs", self.write("a.csv", "preload,poisson_ratio,thickness [mm],h2\n160,0.3,0.3,1\n"))
        self.assertIn("columns without a unit are read in SI units: preload [N]; to name the unit, write a heading such as 'preload [N]'", done.stderr)
        done = twum("evaluate", RING, "--designs", self.write("b.csv", "preload [N],poisson_ratio\n160,0.3\n"))
        self.assertNotIn("unit", done.stderr)

    def test_very_wide_rows(self):
        names = ",".join(f"c{i}" for i in range(20000))
        designs = self.write("designs.csv", f"{names},preload\n" + ("1," * 20000 + "160\n") * 20)
        lines = self.ok("evaluate", RING, "--designs", designs, "--metrics", "preload").splitlines()
        self.assertEqual(len(lines), 21)
        self.assertTrue(lines[20].endswith("1,160,160,ok"))


if __name__ == "__main__":
    program.main()
