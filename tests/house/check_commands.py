# SPDX-License-Identifier: Apache-2.0
"""Runs the commands and programs that the Markdown pages show, and compares what they print.

    check_commands.py TWUM             runs every marked block
    check_commands.py TWUM --update    rewrites the outputs shown instead

A block marked ```sh run is run by bash in a scratch folder that holds a copy of examples/, the blocks
of one page one after the other in the same folder; twum is on PATH. It must exit with 0, or as the
mark says (```sh run exit=2). If the next block of the page is marked ```text output, it is what the
commands print on standard output; a line ... in it stands for any lines (with --update, one such line
is kept with as many lines before and after it).

A block marked ```python run is run likewise by Python, if the module twum was built. A ```yaml block that
begins with `twum: 1` is a file beside examples/motors/*.yaml, and `twum check` has to find it right. A block
marked ```cpp file=PATH shows that file without its licence line; --update copies it.

No two pages write a file or a directory of the same name, so that a reader can run all of them in one folder.

generated_pages.txt lists pages that are, as a whole, the output of a command.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import tree

BLOCK = re.compile(r"^```(?P<info>[^\n`]*)\n(?P<body>.*?)^```[ \t]*$", re.M | re.S)
SECONDS = 120
PYTHON = "/usr/bin/python3"  # whose NumPy is the packaged one, as the module's


def environment(program):
    kept = {key: os.environ[key] for key in ("HOME", "TMPDIR", "ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS")
            if key in os.environ}
    return kept | {"PATH": f"{program.parent}:/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8", "NO_COLOR": "1",
                   "PYTHONPATH": str(module_folder(program)), "PYTHONDONTWRITEBYTECODE": "1", "MPLBACKEND": "Agg"}


def module_folder(program):
    return program.parent.parent / "python"


def command_of(marks, body, folder, program):
    """What runs a block; nothing if it is only to be read."""
    if marks[:2] == ["sh", "run"]:
        return ["bash", "-e", "-c", body]
    if marks[:2] == ["python", "run"] and list(module_folder(program).glob("twum/_twum*.so")):
        return [PYTHON, "-c", body]
    if marks == ["yaml"] and body.startswith("twum: 1"):
        file = pathlib.Path(folder) / "examples/motors/shown.yaml"
        file.write_text(body, encoding="utf-8")
        return ["twum", "check", file]
    return None


def agrees(printed, shown):
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else re.escape(line) + r"\n" for line in shown.splitlines())
    return re.fullmatch(pattern, printed) is not None


def abridged(printed, shown):
    """What the page is to show: all of it, or as many first and last lines as now round a line '...'."""
    lines, now = printed.splitlines(), shown.splitlines()
    if now.count("...") != 1:
        return printed
    head, tail = now.index("..."), len(now) - now.index("...") - 1
    if head + tail >= len(lines):
        return printed
    return "\n".join(lines[:head] + ["..."] + lines[len(lines) - tail:]) + "\n"


def written_in(folder):
    """Names that the blocks of a page have made in their folder. In results/ each study has a directory of its own name."""
    return {name for name in os.listdir(folder) if name not in ("examples", "results")}


def shared_names(written):
    """Complaints about names that several pages write; {page: names}."""
    first, complaints = {}, []
    for page, names in written.items():
        for name in sorted(names):
            if first.setdefault(name, page) != page:
                complaints.append(f"{page}: {name} is also written by {first[name]}; give each page names of its own")
    return complaints


def run_page(page, program, update, written):
    """Number of blocks run, complaints. Adds the names that the page writes."""
    content = tree.text(page)
    blocks = list(BLOCK.finditer(content))
    complaints, edits, count = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(tree.ROOT / "examples", pathlib.Path(folder) / "examples")
        for block, following in zip(blocks, blocks[1:] + [None]):
            marks = block["info"].split()
            command = command_of(marks, block["body"], folder, program)
            if command is None:
                continue
            count += 1
            place = f"{tree.name(page)}:{content.count(chr(10), 0, block.start()) + 1}"
            expected = next((int(m[5:]) for m in marks if m.startswith("exit=")), 0)
            try:
                done = subprocess.run(command, cwd=folder, env=environment(program), capture_output=True,
                                      text=True, timeout=SECONDS, stdin=subprocess.DEVNULL)
            except subprocess.TimeoutExpired:
                complaints.append(f"{place}: still running after {SECONDS} s")
                continue
            if done.returncode != expected:
                complaints.append(f"{place}: exit {done.returncode}, expected {expected}\n{done.stderr}")
            if following is None or following["info"].split() != ["text", "output"]:
                continue
            if update:
                edits.append((following.start("body"), following.end("body"),
                              abridged(done.stdout, following["body"])))
            elif not agrees(done.stdout, following["body"]):
                complaints.append(f"{place}: prints something else than the page shows:\n{done.stdout}")
        written[tree.name(page)] = written_in(folder)
    if edits:
        for start, end, printed in reversed(edits):
            content = content[:start] + printed + content[end:]
        page.write_text(content, encoding="utf-8")
    return count, complaints


def shown_files(page, update):
    """Number of blocks that show a file, complaints."""
    content = tree.text(page)
    blocks = [(block, block["info"].split("file=", 1)[1]) for block in BLOCK.finditer(content)
              if block["info"].startswith("cpp file=")]
    complaints = []
    for block, file in reversed(blocks):
        shown = "".join(tree.text(tree.ROOT / file).splitlines(keepends=True)[1:])
        if block["body"] == shown:
            continue
        place = f"{tree.name(page)}:{content.count(chr(10), 0, block.start()) + 1}"
        complaints += [] if update else [f"{place}: is not {file}; build the target update-docs"]
        content = content[:block.start("body")] + shown + content[block.end("body"):]
    if update:
        page.write_text(content, encoding="utf-8")
    return len(blocks), complaints


def generated_pages(program, update):
    """Number of pages compared, complaints."""
    listed = [line.split(": ", 1) for line in tree.text(tree.ROOT / "tests/house/generated_pages.txt").splitlines()
              if line and not line.startswith("#")]
    complaints = []
    for page, command in listed:
        done = subprocess.run(command, shell=True, cwd=tree.ROOT, env=environment(program), capture_output=True,
                              text=True, timeout=SECONDS)
        path = tree.ROOT / page
        if done.returncode:
            complaints.append(f"{page}: '{command}' exits with {done.returncode}\n{done.stderr}")
        elif update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(done.stdout, encoding="utf-8")
        elif not path.is_file() or tree.text(path) != done.stdout:
            complaints.append(f"{page}: is not what '{command}' prints; build the target update-docs")
    return len(listed), complaints


if __name__ == "__main__":
    twum = pathlib.Path(sys.argv[1]).resolve()
    counts, found = generated_pages(twum, "--update" in sys.argv)
    names = {}
    for markdown in tree.files("README.md", "CONTRIBUTING.md", "docs", "examples", suffixes={".md"}):
        for ran, wrong in (shown_files(markdown, "--update" in sys.argv),
                           run_page(markdown, twum, "--update" in sys.argv, names)):
            counts += ran
            found += wrong
    tree.finish(found + shared_names(names), counts)
