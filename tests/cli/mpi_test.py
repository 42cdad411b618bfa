# SPDX-License-Identifier: Apache-2.0
"""A build with MPI under mpirun: several processes give the results of one."""
import os
import pathlib
import re
import subprocess

import program
from kill_study import kill_often
from mpi_study import AS_ROOT, compare, mpirun
from program import RING, ROOT

STUDIES = ROOT / "examples/studies"
# One of each kind, Ipopt among the solvers; scripts/test-long.sh takes all examples.
EACH_KIND = ["calibrate", "choose-lining", "optimize-ring-60-ipopt", "paper-figure-4", "pareto-driven", "sensitivity-local",
             "sensitivity-morris", "sensitivity-sobol", "size-05Nm-100rpm", "sweep-latin-hypercube", "tolerances", "robust-ring-60"]
SWEEP = """twum: 1
motor: {motor}
study:
  kind: sweep
  variables:
    preload: {{min: 60 N, max: 300 N}}
    amplitude: {{min: 0.8 um, max: 2.2 um}}
  sampling: lhs
  samples: {samples}
  metrics: [peak_power, no_load_speed]
"""


def together(*arguments, **more):
    """The program, started three times by mpirun."""
    return mpirun(3, program.PROGRAM, *arguments, **more)


def shown_commands():
    """Those that docs/guide/clusters.md shows."""
    page = (ROOT / "docs/guide/clusters.md").read_text()
    return re.findall(r"^```sh mpi\n(.*?)^```$", page, re.M | re.S)


class SeveralProcesses(program.Case):
    def sweep(self, samples):
        return self.write("sweep.yaml", SWEEP.format(motor=RING, samples=samples))

    def one_message(self, done, text):
        """What is wrong with the input is said once; what mpirun says itself does not count."""
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        ours = [line for line in done.stderr.splitlines() if "twum" in line and text in line]
        self.assertEqual(len(ours), 1, done.stderr)

    def test_every_kind_gives_the_bytes_of_one_process(self):
        for name in EACH_KIND:
            with self.subTest(name):
                compare(program.PROGRAM, STUDIES / f"{name}.yaml", self.folder, jobs=2)
        # They are those of one process to the byte, whose results other tests verify; that the command reads them is shown by one.
        self.ok("verify", self.folder / "together" / "choose-lining")

    def test_a_killed_process_ends_the_run_which_goes_on_to_the_same_bytes(self):
        self.assertGreater(kill_often(program.PROGRAM, self.sweep(20000), count=4, jobs=1, processes=3), 0)

    def test_a_run_of_one_process_goes_on_with_several(self):
        study, folder = self.sweep(40000), self.folder / "out"
        process = subprocess.Popen([program.PROGRAM, "run", study, "-o", folder, "--jobs", "1"], stdout=subprocess.DEVNULL)
        try:
            process.wait(1)
        except subprocess.TimeoutExpired:
            process.kill()
        process.wait()
        self.assertEqual(together("run", study, "-o", folder).returncode, 0)
        self.ok("run", study, "-o", self.folder / "peace")
        self.assertEqual((folder / "results.csv").read_bytes(), (self.folder / "peace/results.csv").read_bytes())

    def test_the_commands_of_the_guide(self):
        (self.folder / "examples").symlink_to(ROOT / "examples")
        path = f"{pathlib.Path(program.PROGRAM).parent}:{os.environ['PATH']}"
        self.assertGreater(len(shown_commands()), 1)
        for commands in shown_commands():
            done = subprocess.run(["bash", "-e", "-c", commands], cwd=self.folder, capture_output=True, text=True, timeout=600,
                                  env={**os.environ, **AS_ROOT, "PATH": path})
            self.assertEqual(done.returncode, 0, (commands, done.stderr))

    def test_a_wrong_study_is_refused_once(self):
        self.one_message(together("run", self.folder / "missing.yaml"), "cannot be read")
        self.one_message(together("run", "-"), "standard input")

    def test_other_commands_are_refused(self):
        self.one_message(together("check", RING), "started 3 times at once; only 'twum run'")

    def test_processes_that_read_another_study_are_named(self):
        ours = self.folder / "ours"
        ours.mkdir()
        (ours / "study.yaml").write_text(SWEEP.format(motor=RING, samples=100))
        other = self.folder / "other"
        other.mkdir()
        (other / "study.yaml").write_text(SWEEP.format(motor=RING, samples=101))
        start = ["sh", "-c", 'cd "$1/$([ "$OMPI_COMM_WORLD_RANK" = 2 ] && echo other || echo ours)" && exec "$0" run study.yaml',
                 program.PROGRAM, self.folder]
        done = mpirun(3, *start)
        self.one_message(done, "process 2 reads another study")
        (other / "study.yaml").write_text("twum: 1\n")
        done = mpirun(3, *start)
        self.one_message(done, "process 2 cannot read the study")

    def test_functions_of_another_library_are_noticed(self):
        """Debian's sequential MUMPS has an MPI_Comm_rank that says 0 to every process."""
        libraries = subprocess.run(["ldd", program.PROGRAM], capture_output=True, text=True, check=True).stdout
        mumps = re.search(r"=> (\S*/libdmumps_seq\S*)", libraries)
        if mumps is None:
            self.skipTest("a build without Ipopt")
        done = together("run", self.sweep(10), cwd=self.folder, options=["-x", f"LD_PRELOAD={mumps.group(1)}"])
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("but the loaded MPI library reports number", done.stderr)


if __name__ == "__main__":
    program.main()
