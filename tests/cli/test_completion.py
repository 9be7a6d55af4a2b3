"""`workbook completion`: what Tab offers, tried in each shell that is here (bash always is)."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from tests.cli.test_help import all_parsers
from workbook.cli.main import build_parser
from workbook.exercise.source import stems

SHELLS = ("bash", "zsh", "fish")
HERE = [shell for shell in SHELLS if shutil.which(shell)]
ASK = {
    "bash": """
source {script}
COMP_WORDS=({words} "{last}")
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_workbook
printf '%s\\n' "${{COMPREPLY[@]}}"
""",
    # Without its completion system: the two functions of it that the script calls print what they are given.
    "zsh": """
compdef() {{ : }}
_describe() {{ print -l -- ${{(M)${{(P)4}}:#{last}*}} }}
_files() {{ print -l -- {last}*(N) }}
source {script}
words=({words} "{last}")
CURRENT=$#words
_workbook
""",
    "fish": """
source {script}
complete -C '{words} {last}'
""",
}


def script(shell: str, folder: Path, typed: Type) -> Path:
    said = typed("completion", shell)
    assert (said.code, said.err) == (0, "")
    path = folder / f"completion.{shell}"
    path.write_text(said.out)
    return path


def offered(shell: str, path: Path, line: str) -> set[str]:
    """What Tab offers after a line, without descriptions."""
    words, _, last = line.rpartition(" ")
    program = path.with_name("ask")
    program.write_text(ASK[shell].format(script=path, words=words, last=last))
    options = {"bash": ["--norc"], "zsh": ["-f"], "fish": ["-N"]}[shell]
    done = subprocess.run([shell, *options, str(program)], capture_output=True, text=True, cwd=path.parent)
    assert not done.stderr
    return {one.split("\t")[0].split(":")[0] for one in done.stdout.splitlines() if one}


@pytest.mark.parametrize("shell", HERE)
def test_tab_offers_what_fits(shell: str, tmp_path: Path, typed: Type) -> None:
    path = script(shell, tmp_path, typed)
    (tmp_path / "mine.py").touch()

    def after(line: str) -> set[str]:
        return offered(shell, path, line)

    assert after("workbook ") == set(build_parser().below)
    assert after("workbook che") == {"check"}
    assert after("workbook check ") == set(stems(ROOT / "solutions"))
    assert after("workbook check 09") == {"09_joint_positions"}
    assert after("workbook check --watch 09") == {"09_joint_positions"}
    assert after("workbook check 09 mi") == {"mine.py"}
    assert after("workbook check --wa") == {"--watch"}
    assert after("workbook hint 1") >= {"10_slow_callbacks"}
    assert after("workbook topic e") == {"echo"}
    assert after("workbook topic echo /robot/stat") == {"/robot/status"}
    assert after("workbook topic echo --count 3 /robot/bat") == {"/robot/battery"}
    assert after("workbook topic echo --count ") == set()
    assert after("workbook grade --isolation ui") == {"uid"}
    assert after("workbook grade --exercise 09") == {"09_joint_positions"}
    assert after("workbook grade --out mi") == {"mine.py"}
    assert after("workbook new le") == {"lesson"}
    assert after("workbook completion ") == set(SHELLS)
    assert after("workbook doctor ") == set()


@pytest.mark.parametrize("shell", SHELLS)
def test_each_command_exercise_and_topic_is_in_the_script(shell: str, tmp_path: Path, typed: Type) -> None:
    text = script(shell, tmp_path, typed).read_text()
    for parser in all_parsers(build_parser()):
        assert parser.prog.removeprefix("workbook ") in text
    for word in (*stems(ROOT / "solutions"), "/robot/joint_positions", "/robot/touch"):
        assert word in text
    assert "@" not in text.replace("@files", "").replace('"$@"', "").replace("[@]", ""), (
        "a part was not filled in"
    )
    assert "/driver/" not in text


def test_an_unknown_shell_is_refused(typed: Type) -> None:
    said = typed("completion", "powershell")
    assert said.code == 2
    assert "There is: bash, zsh, fish." in said.err
