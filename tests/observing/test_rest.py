"""Robot time waits for a program that has work to do, but not for ever."""

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager

import pytest

from workbook.observing.rest import BUDGET_S, Rest

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


@contextmanager
def program(code: str) -> Iterator[subprocess.Popen[str]]:
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


def test_a_program_that_sleeps_is_at_rest() -> None:
    with program(SLEEPS) as process, closing(Rest(process.pid)) as rest:
        assert rest.wait()
        assert rest.now()


def test_a_program_that_works_is_waited_for_until_it_sleeps() -> None:
    with program(WORKS_A_MOMENT) as process, closing(Rest(process.pid)) as rest:
        assert rest.wait()
        assert process.stdin is not None
        process.stdin.write("go\n")
        process.stdin.flush()
        deadline = time.monotonic() + 10.0
        while rest.now():
            assert time.monotonic() < deadline, "it was never seen at work"
        while not rest.wait():
            assert time.monotonic() < deadline, "it was never seen at rest again"


def test_a_child_at_work_counts() -> None:
    with program(CHILD_WORKS) as process, closing(Rest(process.pid)) as rest:
        assert not rest.wait()


def test_a_program_that_never_rests_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    with program(WORKS) as process, closing(Rest(process.pid)) as rest:
        began = time.monotonic()
        waits = [rest.wait() for _ in range(200)]
        assert not any(waits)
        assert time.monotonic() - began >= BUDGET_S
        monkeypatch.setattr("workbook.observing.rest.time.sleep", lambda _: pytest.fail("it waited again"))
        assert not rest.wait()


def test_a_program_that_has_ended_is_at_rest() -> None:
    with program(WORKS) as process, closing(Rest(process.pid)) as rest:
        assert not rest.now()
        process.kill()
        process.wait()
        assert rest.wait()
