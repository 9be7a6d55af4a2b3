"""An exercise's trained model can be imported even if files are hidden, but nothing else of the course can."""

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from workbook.inside.landlock import landlock_abi
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.host_files import interpreter_folders
from workbook.isolation.landlock import ConfinedProgram
from workbook.isolation.sandbox import Sandbox
from workbook.programs.tier import Confinement, Order
from workbook.recording.limits import ANSWER_LIMITS
from workbook.ros.environment import child_environment

PATIENCE_S = 120.0
IMPORTS = """
import subprocess
import sys

import numpy as np


def labels():
    from workbook.models import LABELS, DeskDetector

    DeskDetector()(np.zeros((120, 160, 3), np.uint8))
    return ", ".join(LABELS)


if len(sys.argv) > 1:
    print("in a process of its own:", labels(), flush=True)
else:
    print("here:", labels(), flush=True)
    subprocess.run([sys.executable, __file__, "again"], check=True)
    try:
        import workbook.criteria
    except ImportError:
        print("no criteria", flush=True)
"""
FINDS = ["here: ball, brick, cup, plate", "in a process of its own: ball, brick, cup, plate"]


def said(confinement: Confinement, tmp_path: Path) -> Sequence[str]:
    """Return the lines that the program prints in a confinement."""
    program = tmp_path / "answer.py"
    program.write_text(IMPORTS, encoding="utf-8")
    path = confinement.bring(program, program.name)
    read_fd, write_fd = os.pipe()
    options = confinement.host_options(ANSWER_LIMITS)
    order = Order([*options, path], child_environment(1), ANSWER_LIMITS, write_fd)
    child = confinement.start(order).child
    os.close(write_fd)
    try:
        with os.fdopen(read_fd, encoding="utf-8") as output:
            lines = output.read().splitlines()
        assert child.wait(PATIENCE_S) == 0, "\n".join(lines)
    except subprocess.TimeoutExpired:
        pytest.fail(f"it does not end: {lines}")
    finally:
        confinement.remove()
    return [line for line in lines if line.startswith(("here", "in a process", "no criteria"))]


@pytest.mark.sandbox
def test_a_program_in_a_sandbox_imports_it_and_no_criteria(tmp_path: Path) -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    assert said(Sandbox(tmp_path, interpreter_folders()), tmp_path) == [*FINDS, "no criteria"]


def test_a_program_in_landlock_imports_it_and_no_criteria(tmp_path: Path) -> None:
    if landlock_abi() == 0:
        pytest.skip("this kernel has no Landlock")
    files, scratch = tmp_path / "files", tmp_path / "scratch"
    files.mkdir()
    scratch.mkdir()
    assert said(ConfinedProgram(scratch, files), tmp_path) == [*FINDS, "no criteria"]
