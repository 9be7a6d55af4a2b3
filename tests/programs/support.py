"""Small programs for the judge to run, and ways to see what became of them."""

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
"""For an answer that is not sandboxed: who started it, and the slot that judges it (another process forked it)."""


def write(folder: Path, text: str, name: str = "answer.py") -> Path:
    """Store a program, without the indentation it has in the test."""
    path = folder / name
    path.write_text(textwrap.dedent(text).lstrip("\n"), encoding="utf-8")
    return path


def wait_until(
    condition: Callable[[], object],
    what: str = "a condition",
    instead: Callable[[], object] = lambda: "nothing",
) -> None:
    """Wait until a condition holds; fail when it does not within two minutes.

    It then says `what` was waited for, and what there is `instead`. Whoever looks without a pause takes the processor
    from what is waited for: between two looks passes four times what the last one took.
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
    """Whether a process has ended (a zombie that nobody of ours must reap counts as ended)."""
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
    """A program that has printed "up" and can be written to; killed in the end, with its children."""
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
