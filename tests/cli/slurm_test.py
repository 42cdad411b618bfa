# SPDX-License-Identifier: Apache-2.0
"""examples/cluster/twum.slurm in a Slurm of one node, made of Debian's slurm-wlm and munge in a folder of its own. As root.

    slurm_test.py PROGRAM
"""
import contextlib
import json
import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import time

import program
from program import RING, ROOT

NEEDED = ("slurmctld", "slurmd", "sbatch", "scancel", "munged", "mpirun")
STUDY = f"""twum: 1
motor: {RING}
study:
  kind: sweep
  variables:
    preload: {{min: 60 N, max: 300 N}}
    amplitude: {{min: 0.8 um, max: 2.2 um}}
  sampling: lhs
  samples: 300000
  metrics: [peak_power, no_load_speed]
"""
CONFIGURATION = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={home}/munge.sock
SlurmUser=root
StateSaveLocation={home}/state
SlurmdSpoolDir={home}/spool
SlurmctldPidFile={home}/slurmctld.pid
SlurmdPidFile={home}/slurmd.pid
SlurmctldLogFile={home}/slurmctld.log
SlurmdLogFile={home}/slurmd.log
SlurmctldPort={controller}
SlurmdPort={daemon}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def end(process):
    """Ends a daemon, which gets 30 s to write its state."""
    with contextlib.suppress(ProcessLookupError):
        os.kill(process, signal.SIGTERM)
        with contextlib.suppress(TimeoutError):
            wait_for(lambda: not alive(process), 30)
        if alive(process):
            os.kill(process, signal.SIGKILL)


def alive(process):
    """A daemon that has ended may wait for its parent as a zombie."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def wait_for(what, seconds=120):
    end_of_time = time.monotonic() + seconds
    while not what():
        if time.monotonic() > end_of_time:
            raise TimeoutError(what)
        time.sleep(0.2)


class Cluster:
    """Slurm's three daemons, with all of their files in one folder."""

    def __init__(self, home):
        self.home = home
        for name in ("state", "spool"):
            (home / name).mkdir(parents=True)
        host = socket.gethostname().split(".")[0]
        (home / "slurm.conf").write_text(CONFIGURATION.format(home=home, host=host, controller=free_port(), daemon=free_port(),
                                                              processors=os.cpu_count()))
        (home / "key").write_bytes(secrets.token_bytes(1024))
        (home / "key").chmod(0o400)
        self.environment = {**os.environ, "SLURM_CONF": str(home / "slurm.conf")}

    def start(self):
        subprocess.run(["munged", "--force", f"--socket={self.home}/munge.sock", f"--key-file={self.home}/key",
                        f"--pid-file={self.home}/munged.pid", f"--log-file={self.home}/munged.log", f"--seed-file={self.home}/seed"], check=True)
        for daemon in ("slurmctld", "slurmd"):
            subprocess.run([daemon], check=True, env=self.environment)

    def stop(self):
        for daemon in ("slurmd", "slurmctld", "munged"):
            file = self.home / f"{daemon}.pid"
            if file.exists():
                end(int(file.read_text()))

    def call(self, *command, **more):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=120,
                              env={**self.environment, **more.pop("environment", {})}, **more)
        assert done.returncode == 0, (command, done.stdout, done.stderr)
        return done.stdout.strip()


class Queue(program.Case):
    def setUp(self):
        super().setUp()
        missing = [name for name in NEEDED if shutil.which(name) is None]
        if missing or os.geteuid() != 0:
            self.skipTest(f"needs root and {missing}")
        # Slurm takes no blank in its paths.
        self.home = pathlib.Path(subprocess.run(["mktemp", "-d"], capture_output=True, text=True, check=True).stdout.strip())
        self.addCleanup(shutil.rmtree, self.home, ignore_errors=True)
        self.cluster = Cluster(self.home / "slurm")
        self.addCleanup(self.cluster.stop)
        self.cluster.start()
        self.study = self.home / "sweep.yaml"
        self.study.write_text(STUDY)

    def submit(self, out):
        """The number of a job with two processes of one thread each, as the guide starts them."""
        path = f"{pathlib.Path(program.PROGRAM).parent}:{os.environ['PATH']}"
        as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "PATH": path}
        return self.cluster.call("sbatch", "--parsable", "--nodes=1", "--ntasks-per-node=2", "--cpus-per-task=1", "--mem=0",
                                 ROOT / "examples/cluster/twum.slurm", self.study, out, cwd=self.home, environment=as_root)

    def state(self, job):
        text = self.cluster.call("scontrol", "show", "job", job)
        return text.split("JobState=")[1].split()[0]

    def said(self, job):
        log = self.home / f"twum-{job}.log"
        return log.read_text() if log.exists() else ""

    def wait_for_end(self, job):
        wait_for(lambda: self.state(job) not in ("PENDING", "RUNNING", "COMPLETING", "CONFIGURING"), 600)
        return self.state(job)

    def test_a_sweep_that_was_cancelled_and_submitted_again_has_the_bytes_of_one_process(self):
        out, alone = self.home / "out", self.home / "alone"
        self.ok("run", self.study, "-o", alone)
        job = self.submit(out)
        database = out / "results.db-wal"
        wait_for(lambda: database.exists() and database.stat().st_size > 200000 or self.state(job) in ("FAILED", "COMPLETED"))
        self.assertEqual(self.state(job), "RUNNING", self.said(job))
        self.cluster.call("scancel", job)
        self.assertEqual(self.wait_for_end(job), "CANCELLED", self.said(job))
        time.sleep(1)  # mpirun's processes end with it
        self.assertFalse((out / "report.html").exists() and (out / "results.csv").read_bytes() == (alone / "results.csv").read_bytes())
        job = self.submit(out)
        self.assertEqual(self.wait_for_end(job), "COMPLETED", self.said(job))
        self.assertEqual((out / "results.csv").read_bytes(), (alone / "results.csv").read_bytes())
        ours, one = (json.loads((folder / "summary.json").read_text()) for folder in (out, alone))
        for times in ("seconds", "started"):
            ours.pop(times), one.pop(times)
        self.assertEqual(ours, one)
        self.assertIn("holds", self.ok("verify", out))


if __name__ == "__main__":
    program.main()
