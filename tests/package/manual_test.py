# SPDX-License-Identifier: Apache-2.0
"""Man page and shell completions: complete, and accepted by the programs that read them."""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

FOLDER = PROGRAM = None


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=60, **options)


def commands():
    """Names of the commands, by the program itself: its complaint about an unknown one lists them."""
    said = run(PROGRAM, "zzzzzzzz").stderr
    return re.search(r"expected one of ([\w, -]*\w)", said)[1].split(", ")


class Manual(unittest.TestCase):
    def test_man_page_has_every_command_and_no_warning(self):
        text = (FOLDER / "twum.1").read_text()
        for name in commands():
            self.assertIn(f".SS twum {name}", text)
        if not shutil.which("man"):
            self.skipTest("man is not there")
        done = run("man", "-l", "--warnings", "-Tutf8", FOLDER / "twum.1", env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def completed_by_bash(self, *words):
        line = " ".join(f"'{word}'" for word in words)
        script = f"source '{FOLDER}/twum.bash'; compopt() {{ :; }}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _twum; " \
                 'printf "%s\\n" "${COMPREPLY[@]}"'
        done = run("bash", "-c", script)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash(self):
        self.assertEqual(set(self.completed_by_bash("twum", "")) - {"-h", "--help", "--version"}, set(commands()))
        self.assertEqual(self.completed_by_bash("twum", "cu"), ["curve"])
        self.assertIn("--points", self.completed_by_bash("twum", "curve", "--p"))
        self.assertEqual(self.completed_by_bash("twum", "curve", "--format", ""), ["table", "csv", "json"])
        self.assertEqual(self.completed_by_bash("twum", "curve", "--set", "thick"), ["thickness="])
        self.assertIn("motor", self.completed_by_bash("twum", "init", ""))

    def test_fish(self):
        if not shutil.which("fish"):
            self.skipTest("fish is not there")
        done = run("fish", "--no-config", "-c", f"source '{FOLDER}/twum.fish'; complete -C 'twum curve --format '")
        words = [line.split("\t")[0] for line in done.stdout.splitlines()]
        self.assertEqual((words, done.stderr), (["csv", "json", "table"], ""))

    def test_zsh(self):
        if not shutil.which("zsh"):
            self.skipTest("zsh is not there")
        done = run("zsh", "-n", FOLDER / "_twum")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((FOLDER / "_twum").read_text().startswith("#compdef twum\n"))


if __name__ == "__main__":
    PROGRAM, FOLDER = (pathlib.Path(sys.argv.pop(1)) for _ in range(2))
    unittest.main(verbosity=1)
