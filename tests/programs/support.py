"""Small programs for the judge to run, and ways to find out what became of them."""

import os
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

PATIENCE_S = 120.0
CLIMB = """\
import os, signal, sys, time

def line_of_ancestors():
    pid = os.getppid()
    while pid > 1:
        with open(f"/proc/{pid}/cmdline", "rb") as file:
            yield pid, file.read()
        with open(f"/proc/{pid}/stat") as file:
            pid = int(file.read().rsplit(")", 1)[1].split()[1])

def judge():
    return next(pid for pid, command in line_of_ancestors() if b"workbook.grading.slots" in command)
"""
"""For an answer without a sandbox: finds the process that started it, and the slot that judges it."""


def write(folder: Path, text: str, name: str = "answer.py") -> Path:
    """Write a program to a file, without the indentation that it has in the test."""
    path = folder / name
    path.write_text(textwrap.dedent(text).lstrip("\n"), encoding="utf-8")
    return path


def wait_until(
    condition: Callable[[], object],
    what: str = "a condition",
    instead: Callable[[], object] = lambda: "nothing",
) -> None:
    """Wait until a condition is true. Fail if that takes more than two minutes.

    The failure names `what` was waited for, and the state `instead`. Polling without pauses would take CPU time from
    the awaited process, so each pause is four times as long as the last poll.
    """
    deadline = time.monotonic() + PATIENCE_S
    while True:
        began = time.monotonic()
        if condition():
            return
        now = time.monotonic()
        assert now < deadline, f"waited {PATIENCE_S:.0f} s in vain: {what}; seen: {instead()}"
        time.sleep(min(1.0, max(0.01, 4 * (now - began))))


def is_gone(pid: int) -> bool:
    """Return whether a process has ended (a zombie that isn't ours to reap counts as ended)."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return True
    return state in "ZX"


def children_of_this_process() -> set[int]:
    found: set[int] = set()
    for task in os.listdir("/proc/self/task"):
        try:
            found |= set(map(int, Path(f"/proc/self/task/{task}/children").read_text().split()))
        except OSError:
            continue
    return found


@contextmanager
def talking_program(code: str) -> Iterator[subprocess.Popen[str]]:
    """Start a program that has printed "up" and reads its input. At the end, kill it and its children."""
    process = subprocess.Popen(
        [sys.executable, "-I", "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    with process:
        assert process.stdout is not None
        assert process.stdout.readline() == "up\n"
        try:
            yield process
        finally:
            subprocess.run(["pkill", "-KILL", "-P", str(process.pid)], check=False)
            process.kill()
