"""Simulated time waits for a program that has work to do, but not forever."""

import time
from contextlib import closing

import pytest

from tests.programs.support import talking_program
from workbook.watching.quiescence import BUDGET_S, Quiescence

SLEEPS = "import time; print('up', flush=True); time.sleep(60)"
WORKS = "print('up', flush=True)\nwhile True: pass"
CHILD_WORKS = f"import subprocess, sys; subprocess.run([sys.executable, '-I', '-c', {WORKS!r}])"
WORKS_A_MOMENT = """
import sys, time
print('up', flush=True)
sys.stdin.readline()
end = time.monotonic() + 0.1
while time.monotonic() < end: pass
time.sleep(60)
"""


def test_a_program_that_sleeps_is_quiet() -> None:
    with talking_program(SLEEPS) as process, closing(Quiescence(process.pid)) as quiescence:
        assert quiescence.wait()
        assert quiescence.is_quiet()


def test_a_program_that_works_is_waited_for_until_it_sleeps() -> None:
    with talking_program(WORKS_A_MOMENT) as process, closing(Quiescence(process.pid)) as quiescence:
        assert quiescence.wait()
        assert process.stdin is not None
        process.stdin.write("go\n")
        process.stdin.flush()
        deadline = time.monotonic() + 10.0
        while quiescence.is_quiet():
            assert time.monotonic() < deadline, "it was never seen at work"
        while not quiescence.wait():
            assert time.monotonic() < deadline, "it was never seen at rest again"


def test_a_child_at_work_counts() -> None:
    with talking_program(CHILD_WORKS) as process, closing(Quiescence(process.pid)) as quiescence:
        assert not quiescence.wait()


def test_a_program_that_never_rests_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    with talking_program(WORKS) as process, closing(Quiescence(process.pid)) as quiescence:
        began = time.monotonic()
        waits = [quiescence.wait() for _ in range(200)]
        assert not any(waits)
        assert time.monotonic() - began >= BUDGET_S
        monkeypatch.setattr(
            "workbook.watching.quiescence.time.sleep", lambda _: pytest.fail("it waited again")
        )
        assert not quiescence.wait()


def test_a_program_that_has_ended_is_quiet() -> None:
    with talking_program(WORKS) as process, closing(Quiescence(process.pid)) as quiescence:
        assert not quiescence.is_quiet()
        process.kill()
        process.wait()
        assert quiescence.wait()
