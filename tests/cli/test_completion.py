"""`workbook completion`: what Tab offers, tested in each installed shell (bash is always installed)."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from workbook.cli.main import build_parser
from workbook.exercise.source import stems

SHELLS = ("bash", "zsh", "fish")
HERE = [shell for shell in SHELLS if shutil.which(shell)]
ASK = {
    "bash": """
source {script}
COMP_LINE='{line}' COMP_POINT={length} COMP_TYPE=9
_python_argcomplete workbook
printf '%s\\n' "${{COMPREPLY[@]}}"
""",
    # Without zsh's completion system: the two functions that the script calls print their arguments.
    "zsh": """
compdef() {{ : }}
_describe() {{ print -l -- ${{(P)2}} }}
source {script}
BUFFER='{line}' CURSOR={length}
words=({words})
_python_argcomplete workbook
""",
    "fish": """
source {script}
complete -C '{line}'
""",
}


def offered(shell: str, path: Path, line: str) -> set[str]:
    """Return what Tab offers after a line, without descriptions."""
    program = path.with_name("ask")
    program.write_text(ASK[shell].format(script=path, line=line, length=len(line), words=line))
    options = {"bash": ["--norc"], "zsh": ["-f"], "fish": ["-N"]}[shell]
    environ = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(
        [shell, *options, str(program)], capture_output=True, text=True, cwd=path.parent, env=environ
    )
    assert not done.stderr
    lines = (one.split("\t")[0].split(":")[0].strip() for one in done.stdout.splitlines())
    return {one for one in lines if one}


@pytest.mark.parametrize("shell", HERE)
def test_tab_offers_what_fits(shell: str, tmp_path: Path, typed: Type) -> None:
    said = typed("completion", shell)
    assert (said.code, said.err) == (0, "")
    path = tmp_path / f"completion.{shell}"
    path.write_text(said.out)
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
    assert after("workbook topic echo --count ") == set()
    assert after("workbook grade --isolation ui") == {"uid"}
    assert after("workbook grade --exercise 09") == {"09_joint_positions"}
    assert after("workbook grade --out mi") == {"mine.py"}
    assert after("workbook new le") == {"lesson"}
    assert after("workbook completion ") == set(SHELLS)
    assert after("workbook doctor ") == set()
    assert "/driver/" not in "".join(after("workbook topic echo /"))


@pytest.mark.parametrize("shell", SHELLS)
def test_each_shell_has_its_script(shell: str, typed: Type) -> None:
    said = typed("completion", shell)
    assert (said.code, said.err) == (0, "")
    assert "workbook" in said.out


def test_an_unknown_shell_is_refused(typed: Type) -> None:
    said = typed("completion", "powershell")
    assert said.code == 2
    assert "There is: bash, zsh, fish." in said.err
