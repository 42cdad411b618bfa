# SPDX-License-Identifier: Apache-2.0
"""Man page and shell completions, from what `twum --help` and `twum COMMAND --help` say.

    make_manual.py TWUM FOLDER     writes twum.1, twum.bash, _twum and twum.fish
"""
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass, field


@dataclass
class Option:
    names: list  # "-o", "--output"
    value: str  # "FILE", "" for a flag
    choices: list
    text: str


@dataclass
class Command:
    name: str
    text: str = ""
    usage: str = ""
    positionals: list = field(default_factory=list)  # Option, its names being what stands for it
    options: list = field(default_factory=list)
    subcommands: list = field(default_factory=list)  # (name, text)
    notes: list = field(default_factory=list)  # lines after the tables


TABLES = {"Positionals:": "positionals", "Options:": "options", "Subcommands:": "subcommands"}


def rows(lines):
    """(what stands left, its text) of a table; a text may begin on the next line."""
    found = []
    for line in lines:
        if re.match(r"  \S", line):
            left, _, text = line.strip().partition("  ")
            found.append([left, text.strip()])
        else:
            found[-1][1] = (found[-1][1] + " " + line.strip()).strip()
    return found


def entry(left, text):
    words = re.sub(r"\bREQUIRED\b|\.\.\.", "", left).split()
    value = words[1] if len(words) > 1 else ""
    choices = value.split("|") if re.fullmatch(r"[a-z]+(\|[a-z]+)+", value) else []
    return Option(words[0].split(","), value, choices, text)


def parse(name, help_text):
    command = Command(name)
    table, tables = None, {}
    for line in help_text.splitlines():
        if line in TABLES:
            table = tables.setdefault(TABLES[line], [])
        elif line.startswith("Usage: "):
            command.usage = line.removeprefix("Usage: ")
        elif not command.usage:
            command.text = line.strip()
        elif table is not None and line.startswith("  "):
            table.append(line)
        elif line.strip() or command.notes:
            table = None
            command.notes.append(line)
        else:
            table = None
    if name:
        command.positionals = [entry(*row) for row in rows(tables.get("positionals", []))]
    command.options = [entry(*row) for row in rows(tables.get("options", []))]
    command.subcommands = [tuple(row) for row in rows(tables.get("subcommands", []))]
    while command.notes and not command.notes[-1].strip():
        command.notes.pop()
    return command


# --- man page

def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def man_options(command):
    text = ""
    for option in command.positionals + command.options:
        names = ", ".join(rf"\fB{roff(name)}\fR" for name in option.names)
        value = "|".join(option.choices) or option.value
        text += f".TP\n{names}" + (rf" \fI{roff(value)}\fR" if value and option.value else "") + f"\n{roff(option.text)}\n"
    return text


def man_notes(notes):
    return ".PP\n.nf\n" + "".join(roff(line) + "\n" for line in notes) + ".fi\n" if notes else ""


def man_page(main, commands, version):
    """Every command has --help: it is said once."""
    page = (f'.TH TWUM 1 "" "twum {version}" "User Commands"\n.SH NAME\n{roff(main.text)}\n'
            f".SH SYNOPSIS\n\\fBtwum\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH OPTIONS\n{man_options(main)}.SH COMMANDS\n")
    for command in commands:
        page += f".SS {roff(command.usage.split(' [')[0])}{roff(command.usage.partition(']')[2])}\n{roff(command.text)}\n"
        command.options = [option for option in command.options if "--help" not in option.names]
        page += man_options(command) + man_notes(command.notes)
    return page + f".SH NOTES\n{man_notes(main.notes)}"


# --- completions

def file_like(option):
    return option.value in ("FILE", "DIR", "DIRECTORY", "STUDY", "MOTOR") or option.value.startswith("FILE")


def bash_completion(main, commands, parameters):
    cases, values = "", ""
    for command in commands:
        words = [name for option in command.options for name in option.names]
        words += [choice for positional in command.positionals for choice in positional.choices]
        cases += f"    {command.name}) words={' '.join(words)!r} ;;\n"
    seen = {}
    for command in commands:
        for option in (o for o in command.options if o.choices):
            for name in option.names:
                seen.setdefault(name, {}).setdefault(" ".join(option.choices), []).append(command.name)
    for name, choices in sorted(seen.items()):
        for words, where in choices.items():
            values += "".join(f"    {one}:{name}) words='{words}' ;;\n" for one in where)
    top = " ".join([command.name for command in commands] + [n for o in main.options for n in o.names])
    return f"""# SPDX-License-Identifier: Apache-2.0
# Completion of twum for bash; generated from its help.
_twum() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=''
  local command=${{COMP_WORDS[1]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{top}' -- "$current")
    return
  fi
  if [[ $previous == --set ]]; then
    compopt -o nospace
    mapfile -t COMPREPLY < <(compgen -S = -W '{' '.join(parameters)}' -- "$current")
    return
  fi
  case $command:$previous in
{values}  esac
  if [[ -z $words && $current != -* ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
  [[ -n $words ]] || case $command in
{cases}  esac
  [[ $current == -* || -n $words ]] && mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -F _twum twum
"""


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def zsh_argument(option, parameters):
    text = re.sub(r"[\[\]:]", " ", option.text)
    if option.names[-1] == "--set":
        action = f":setting:({' '.join(name + '=' for name in parameters)})"
    elif option.choices:
        action = f":{option.value or 'word'}:({' '.join(option.choices)})"
    elif option.value:
        action = f":{option.value}:" + ("_files" if file_like(option) else "")
    else:
        action = ""
    again = "*" if option.names[-1] == "--set" else ""
    return "\n".join(f"        {quoted(f'{again}{name}[{text}]{action}')} \\" for name in option.names)


def zsh_completion(commands, parameters):
    described = "\n".join(f"    {quoted(c.name + ':' + c.text.replace(':', ' '))}" for c in commands)
    cases = ""
    for command in commands:
        arguments = "\n".join(zsh_argument(option, parameters) for option in command.options)
        choices = " ".join(c for p in command.positionals for c in p.choices)
        rest = f"'*:what:({choices})'" if choices else "'*:file:_files'"
        cases += f"    {command.name})\n      _arguments \\\n{arguments}\n        {rest} ;;\n"
    return f"""#compdef twum
# SPDX-License-Identifier: Apache-2.0
# Completion of twum for zsh; generated from its help.
_twum() {{
  local -a commands
  commands=(
{described}
  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{cases}  esac
}}
_twum "$@"
"""


def fish_completion(commands, parameters):
    lines = ["# SPDX-License-Identifier: Apache-2.0", "# Completion of twum for fish; generated from its help."]
    lines += [f"complete -c twum -n __fish_use_subcommand -f -a {c.name} -d {quoted(c.text)}" for c in commands]
    for command in commands:
        begin = f"complete -c twum -n '__fish_seen_subcommand_from {command.name}'"
        choices = " ".join(c for p in command.positionals for c in p.choices)
        if choices:
            lines.append(f"{begin} -f -a {quoted(choices)}")
        for option in command.options:
            names = " ".join(f"-l {n[2:]}" if n.startswith("--") else f"-s {n[1:]}" for n in option.names)
            values = option.choices or ([p + "=" for p in parameters] if option.names[-1] == "--set" else [])
            given = f" -x -a {quoted(' '.join(values))}" if values else (
                " -r" if file_like(option) else " -x" if option.value else "")
            lines.append(f"{begin} {names}{given} -d {quoted(option.text)}")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])

    def said(*arguments):
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout

    main = parse("", said("--help"))
    commands = [parse(name, said(name, "--help")) for name, _ in main.subcommands]
    parameters = [line.split(",")[0] for line in said("parameters", "--format", "csv").splitlines()[1:]]
    version = said("--version").split()[1]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "twum.bash").write_text(bash_completion(main, commands, parameters))
    (folder / "_twum").write_text(zsh_completion(commands, parameters))
    (folder / "twum.fish").write_text(fish_completion(commands, parameters))
    (folder / "twum.1").write_text(man_page(main, commands, version))
