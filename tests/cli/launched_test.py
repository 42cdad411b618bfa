# SPDX-License-Identifier: Apache-2.0
"""A build without MPI that mpirun has started several times, as the environment says."""
import program
from program import RING, twum

LAUNCHERS = [("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"), ("PMI_SIZE", "PMI_RANK"),
             ("SLURM_STEP_NUM_TASKS", "PMIX_RANK")]


class Launched(program.Case):
    def setUp(self):
        super().setUp()
        self.study = self.write("study.yaml", f"twum: 1\nmotor: {RING}\nstudy: {{kind: curve, points: 3}}\n")

    def test_the_first_process_says_why_nothing_runs(self):
        for size, rank in LAUNCHERS:
            with self.subTest(size):
                said = self.refused("run", self.study, cwd=self.folder, env={size: "3", rank: "0"})
                self.assertEqual(said.count("\n"), 1)
                for words in ("started 3 times at once", "no MPI", "--jobs", "TWUM_WITH_MPI=ON"):
                    self.assertIn(words, said)
                self.assertFalse((self.folder / "results").exists())

    def test_the_others_say_nothing(self):
        for size, rank in LAUNCHERS:
            done = twum("run", self.study, cwd=self.folder, env={size: "3", rank: "2"})
            self.assertEqual((done.returncode, done.stdout, done.stderr), (2, b"", ""))

    def test_other_commands_are_for_one_process(self):
        said = self.refused("curve", RING, env={"OMPI_COMM_WORLD_SIZE": "2", "OMPI_COMM_WORLD_RANK": "0"})
        self.assertIn("only 'twum run' shares its work", said)

    def test_one_process_of_a_launcher_is_one_process(self):
        self.ok("run", self.study, cwd=self.folder, env={"OMPI_COMM_WORLD_SIZE": "1", "OMPI_COMM_WORLD_RANK": "0"})

    def test_a_batch_script_that_starts_one_process_is_none_of_several(self):
        self.ok("run", self.study, cwd=self.folder, env={"SLURM_NTASKS": "8", "SLURM_PROCID": "0"})


if __name__ == "__main__":
    program.main()
