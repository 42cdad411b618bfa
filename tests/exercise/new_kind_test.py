# SPDX-License-Identifier: Apache-2.0
"""A new kind of study as an exercise (CONTRIBUTING.md, How to add): the lines that it takes are added to copies of the
headers that list the kinds, what includes them is compiled into a scratch folder, and the program answers in the
terminal, in Markdown, on the page and as a picture. Nothing of apps or of the page is changed.

    new_kind_test.py BUILD        a build folder of CMake with Ninja that is up to date; some minutes
"""
import concurrent.futures
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/report"))
from browser import Browser  # noqa: E402

STUDY = f"twum: 1\nmotor: {ROOT}/examples/motors/ring-60.yaml\nstudy: {{kind: squeeze, points: 7}}\n"


def part(name):
    """The lines of a file below its first comments."""
    return (HERE / name).read_text().split("\n\n", 1)[1] + "\n"


# Header: text, and what stands in its place.
CHANGES = {
    "include/twum/studies/study.hpp": [
        ("/// The question of a study: one", part("squeeze_study.hpp") + "/// The question of a study: one"),
        ("MotionStudy>;", "MotionStudy, SqueezeStudy>;"), ("  motion\n};", "  motion,\n  squeeze\n};")],
    "include/twum/studies/study_result.hpp": [
        ("/// Answer of a study, by kind.", part("squeeze_result.hpp") + "/// Answer of a study, by kind."),
        ("MotionResult>;", "MotionResult, SqueezeResult>;")],
    "src/results/answers.hpp": [
        ("Json answer_json(const MotionResult& result);", "Json answer_json(const MotionResult& result);\nJson answer_json(const SqueezeResult& result);")],
    "src/telling/tellings.hpp": [
        ("Headline headline_of(const MotionResult&", "Headline headline_of(const SqueezeResult& answer, const StudyResult& result);\nHeadline headline_of(const MotionResult&"),
        ("std::vector<Section> sections_of(const MotionResult&", "std::vector<Section> sections_of(const SqueezeResult& answer, const Sources& sources);\nstd::vector<Section> sections_of(const MotionResult&")],
}


def add_lines(folder):
    for name, changes in CHANGES.items():
        text = (ROOT / "studies" / name).read_text()
        for old, new in changes:
            assert text.count(old) == 1, (name, old)
            text = text.replace(old, new)
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, (command, done.stdout[-3000:], done.stderr[-3000:])
    return done.stdout


def compiled(words, folder, source=None):
    """Compiles as a command of the build does, with the changed headers first, into the folder; the object."""
    words = [word for word in words if word not in ("-MD",)]
    for flag in ("-MT", "-MF"):
        del words[words.index(flag):words.index(flag) + 2]
    target = folder / (re.sub(r"\W+", "_", source or words[words.index("-o") + 1]) + ".o")
    words[words.index("-o") + 1] = str(target)
    if source:
        words[-1] = source
    first = next(i for i, word in enumerate(words) if word.startswith("-I"))
    return words[:first] + [f"-I{folder}/include", f"-I{folder}/src"] + words[first:], target


def build(build_folder, folder):
    """The program with the new kind, from the commands that build it without."""
    commands = run(["ninja", "-C", str(build_folder), "-t", "commands", "twum"]).splitlines()
    of = {name: [shlex.split(c) for c in commands if f" -o {name}/CMakeFiles/" in c] for name in ("studies", "apps/cli")}
    jobs = [compiled(words, folder) for words in of["studies"] + of["apps/cli"]]
    unity = next(words for words in of["studies"] if "Unity" in words[-1])
    jobs.append(compiled(unity, folder, str(HERE / "squeeze_study.cpp")))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda job: run(job[0], cwd=build_folder), jobs))
    link = [word for word in shlex.split(commands[-1])[2:-2] if not word.startswith("apps/cli/")]
    at = link.index("studies/libtwum_studies.a")
    link[at:at + 1] = [str(target) for _, target in jobs]
    link[link.index("-o") + 1] = str(folder / "twum")
    run(link, cwd=build_folder)
    return folder / "twum"


def check(program, folder):
    (folder / "asked.yaml").write_text(STUDY)
    said = run([program, "run", folder / "asked.yaml", "-o", folder / "out"])
    # ring-60 has 160 N and 848 mN.m: friction holds twice as much under twice the preload.
    for words in ("squeeze", "A preload of 320 N holds 1.69", "Held by the preload"):
        assert words in said, (words, said)
    told = run([program, "report", folder / "out", "--format", "md"])
    for words in ("holding torque over the preload of ring-60", "## Held by the preload", "| preload | torque |", "| 320 N |"):
        assert words in told, (words, told)
    names = run([program, "plot", folder / "out"])
    assert "squeeze.svg" in names and "squeeze.png" in names, names
    assert "squeeze" in run([program, "schema", "study"])
    run([program, "verify", folder / "out"])
    browser = Browser()
    try:
        browser.open(folder / "out/report.html")
        assert not browser.complaints(), browser.complaints()
        line = browser.value("[...document.querySelector('[data-chart=squeeze]').plot.data[1]]")
        assert len(line) == 7 and abs(line[-1] / line[0] - 4) < 1e-9, line
        assert browser.value("document.querySelectorAll('[data-table=squeeze] tbody tr').length") == 7
        assert "Held by the preload" in browser.value("document.querySelector('nav').textContent")
    finally:
        browser.close()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="twum-kind-") as scratch:
        scratch = pathlib.Path(scratch)
        add_lines(scratch)
        check(build(pathlib.Path(sys.argv[1]).resolve(), scratch), scratch)
    print("the new kind answers everywhere")
