# SPDX-License-Identifier: Apache-2.0
"""The Debian package on a clean Debian 12: a chroot that debootstrap has made. As root.

    chroot_test.py FOLDER_OF_PACKAGES [CHROOT]

makes the chroot, or takes the one given, which keeps what was installed for the package.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCRIPT = r"""
set -e
cd "$(mktemp -d)"
cp /srv/twum_*.deb .
chmod 755 .
export DEBIAN_FRONTEND=noninteractive
apt-get -q update
apt-get -q -y --no-install-recommends install ./twum_*.deb
twum --version
twum init motor -o ring.yaml
twum curve ring.yaml --points 3
twum explore ring.yaml
grep -q '"core":"H4sI' ring.html
twum init optimize --motor ring.yaml -o study.yaml
twum run study.yaml -o result || [ $? -le 1 ]
python3 -c "import twum; print('torque', twum.Motor('ring.yaml').stall_torque)"
python3 -c "import twum; print(twum.gradients(twum.Motor('ring.yaml'), {'preload': [140, 160]}, 'peak_power')['peak_power']['preload'])"
test -s /usr/share/bash-completion/completions/twum
dpkg -s twum | grep -E '^(Version|Depends):'
apt-get -q -y remove twum
test ! -e /usr/bin/twum
"""


def prepared(chroot):
    if not (chroot / "usr/bin/apt-get").exists():
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", str(chroot)], check=True, stdout=subprocess.DEVNULL)
        # The sources of packages, and how to get there, are the machine's.
        shutil.rmtree(chroot / "etc/apt/sources.list.d", ignore_errors=True)
        (chroot / "etc/apt/sources.list").unlink(missing_ok=True)
        shutil.copytree("/etc/apt/sources.list.d", chroot / "etc/apt/sources.list.d")
        shutil.copytree("/etc/apt/apt.conf.d", chroot / "etc/apt/apt.conf.d", dirs_exist_ok=True)
        shutil.copy("/etc/resolv.conf", chroot / "etc/resolv.conf")


def check(packages, chroot):
    prepared(chroot)
    found = sorted(packages.glob("twum_*.deb"))
    if len(found) != 1:
        sys.exit(f"{packages}: expected one twum_*.deb, found {len(found)}")
    shutil.copy(found[0], chroot / "srv")
    done = subprocess.run(["chroot", str(chroot), "bash", "-c", SCRIPT], stdout=subprocess.PIPE, text=True)
    print(done.stdout)
    if done.returncode:
        sys.exit(f"the package does not work on a clean Debian 12: exit {done.returncode}")
    # Theory section 8: the whole contact slips at rest, so the torque is mu F_N r of the file from `twum init`.
    torque = float(done.stdout.split("torque ")[-1].split()[0])
    assert abs(torque - 0.2 * 160 * 0.0265) < 1e-12, torque


if __name__ == "__main__":
    if len(sys.argv) > 2:
        check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
    else:
        with tempfile.TemporaryDirectory() as scratch:
            check(pathlib.Path(sys.argv[1]), pathlib.Path(scratch))
