"""A sandbox whose owner was killed at the wrong moment must end by itself, because it is tied to no process.

bubblewrap asks the kernel to end the sandbox with its owner. An owner that is killed just before that leaves a sandbox
behind.
"""

import os
import subprocess
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.programs.support import write
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.host_files import interpreter_folders
from workbook.isolation.sandbox import Sandbox, sandbox_environment
from workbook.programs.unconfined import host_command
from workbook.ros.environment import child_environment

pytestmark = pytest.mark.sandbox
ENDS_S = 60.0
SPEAKS_AND_STAYS = """
import contextlib, time
with contextlib.suppress(OSError):
    print("ready", flush=True)
time.sleep(600)
"""
Command = Callable[[Sandbox, Path], Sequence[str]]


def with_a_program(sandbox: Sandbox, answer: Path) -> Sequence[str]:
    path = sandbox.bring(answer, answer.name)
    return sandbox.command(host_command("--attended", path), sandbox_environment(child_environment(1)))


def without_a_program(sandbox: Sandbox, answer: Path) -> Sequence[str]:
    sandbox.bring(answer, answer.name)
    return sandbox.empty()


COMMANDS = pytest.mark.parametrize("command", [with_a_program, without_a_program])


@contextmanager
def started(command: Command, folder: Path, output: int) -> Iterator["subprocess.Popen[bytes]"]:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    sandbox = Sandbox(folder, interpreter_folders())
    process = subprocess.Popen(
        command(sandbox, write(folder, SPEAKS_AND_STAYS)),
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=output,
        pass_fds=sandbox.descriptors,
    )
    sandbox.remove()
    os.close(output)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@COMMANDS
def test_a_sandbox_that_nobody_hears_ends(command: Command, tmp_path: Path) -> None:
    read_fd, write_fd = os.pipe()
    os.close(read_fd)
    with started(command, tmp_path, write_fd) as process:
        assert process.wait(ENDS_S) != 0


@COMMANDS
def test_a_sandbox_that_somebody_hears_stays(command: Command, tmp_path: Path) -> None:
    read_fd, write_fd = os.pipe()
    with os.fdopen(read_fd, "rb") as heard, started(command, tmp_path, write_fd) as process:
        assert heard.readline() == b"ready\n"
        assert process.poll() is None
