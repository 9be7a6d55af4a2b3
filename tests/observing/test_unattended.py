"""A box whose owner was killed at the wrong moment: nothing ties it to anybody, so it must end by itself.

bubblewrap asks the kernel to end the box with its owner. Who is killed just before that question leaves a box behind.
"""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.observing.programs import write
from workbook.observing.process import HOST
from workbook.observing.sandbox import Cage, sandbox_problem
from workbook.ros.environment import child_environment

pytestmark = pytest.mark.sandbox
ENDS_S = 60.0
SPEAKS_AND_STAYS = """
import contextlib, time
with contextlib.suppress(OSError):
    print("ready", flush=True)
time.sleep(600)
"""
Command = Callable[[Path, int], Sequence[str]]


def box_with_a_program(answer: Path, info_fd: int) -> Sequence[str]:
    command = [sys.executable, "-P", str(HOST), "--attended", f"/answer/{answer.name}"]
    return Cage().command(command, {answer.name: answer}, child_environment(1), info_fd)


def empty_box(answer: Path, info_fd: int) -> Sequence[str]:
    return Cage().empty_box({answer.name: answer}, info_fd)


BOXES = pytest.mark.parametrize("box", [box_with_a_program, empty_box])


@contextmanager
def started(box: Command, folder: Path, output: int) -> Iterator["subprocess.Popen[bytes]"]:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be shut in: {problem}")
    answer = write(folder, SPEAKS_AND_STAYS)
    info_fd = os.memfd_create("info")
    process = subprocess.Popen(
        box(answer, info_fd), stdin=subprocess.DEVNULL, stdout=output, stderr=output, pass_fds=[info_fd]
    )
    os.close(info_fd)
    os.close(output)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@BOXES
def test_a_box_that_nobody_hears_ends(box: Command, tmp_path: Path) -> None:
    read_fd, write_fd = os.pipe()
    os.close(read_fd)
    with started(box, tmp_path, write_fd) as process:
        assert process.wait(ENDS_S) != 0


@BOXES
def test_a_box_that_somebody_hears_stays(box: Command, tmp_path: Path) -> None:
    read_fd, write_fd = os.pipe()
    with os.fdopen(read_fd, "rb") as heard, started(box, tmp_path, write_fd) as process:
        assert heard.readline() == b"ready\n"
        assert process.poll() is None
