"""Whether a program is at rest, at work, or asleep on its own, and how long simulated time waits for it."""

import time
from contextlib import closing

import pytest

from tests.programs.support import talking_program, wait_until
from workbook.watching.rest import BUDGET_S, SLEEP_WAITS, WORK_WAITS, RestDetector, State

READS = "import sys; print('up', flush=True); sys.stdin.read()"
SLEEPS = "import time; print('up', flush=True); time.sleep(60)"
POLLS = """
import asyncio
async def turns():
    while True:
        await asyncio.sleep(0.01)
print('up', flush=True)
asyncio.run(turns())
"""
WAITS_FOR_EVENTS = "import select; print('up', flush=True); select.epoll().poll()"
WORKS = "print('up', flush=True)\nwhile True: pass"
THREAD_SLEEPS = """
import sys, threading, time
threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
print('up', flush=True)
sys.stdin.read()
"""
WORKS_WHEN_ASKED = """
import sys, time
print('up', flush=True)
while sys.stdin.readline():
    end = time.monotonic() + 0.05
    while time.monotonic() < end: pass
    print('done', flush=True)
"""
SLEEPS_WHEN_ASKED = """
import sys, time
print('up', flush=True)
while sys.stdin.readline():
    time.sleep(1.0)
    print('done', flush=True)
"""
BEGINS_THREADS = """
import sys, threading, time
print('up', flush=True)
while sys.stdin.readline():
    threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
    print('done', flush=True)
"""
CHILD_WORKS = f"import subprocess, sys; subprocess.run([sys.executable, '-I', '-c', {WORKS!r}])"
WORKS_A_MOMENT = """
import sys, time
print('up', flush=True)
sys.stdin.readline()
end = time.monotonic() + 0.1
while time.monotonic() < end: pass
time.sleep(60)
"""


@pytest.mark.parametrize("code", [READS, WAITS_FOR_EVENTS])
def test_a_program_that_waits_for_input_is_at_rest(code: str) -> None:
    with talking_program(code) as process, closing(RestDetector(process.pid)) as rest:
        assert rest.works
        wait_until(lambda: rest.state() is State.AT_REST)
        assert rest.wait_for_rest() is State.AT_REST


def test_an_event_loop_that_wakes_by_itself_is_not_at_rest() -> None:
    with talking_program(POLLS) as process, closing(RestDetector(process.pid)) as rest:
        wait_until(lambda: rest.state() is State.SLEEPING)
        while rest.works:
            assert rest.wait_for_rest() is not State.AT_REST


@pytest.mark.parametrize("code", [SLEEPS, THREAD_SLEEPS])
def test_a_thread_that_sleeps_by_itself_is_not_at_rest(code: str) -> None:
    with talking_program(code) as process, closing(RestDetector(process.pid)) as rest:
        wait_until(lambda: rest.state() is State.SLEEPING)
        seen = []
        while rest.works:
            seen.append(rest.wait_for_rest())
        assert State.AT_REST not in seen
        # On a busy machine, the main thread may not have reached its wait yet.
        assert seen.count(State.SLEEPING) == SLEEP_WAITS or seen.count(State.AT_WORK) == WORK_WAITS


def test_a_program_that_never_rests_is_given_up() -> None:
    with talking_program(WORKS) as process, closing(RestDetector(process.pid)) as rest:
        for _ in range(WORK_WAITS):
            assert rest.works
            assert rest.wait_for_rest() is State.AT_WORK
        assert not rest.works


def test_it_waits_for_work_to_be_done() -> None:
    with talking_program(WORKS_WHEN_ASKED) as process, closing(RestDetector(process.pid)) as rest:
        assert process.stdin is not None
        assert process.stdout is not None
        wait_until(lambda: rest.state() is State.AT_REST)
        for _ in range(5):
            process.stdin.write("go\n")
            process.stdin.flush()
            deadline = time.monotonic() + 10.0
            while rest.wait_for_rest() is not State.AT_REST:
                assert time.monotonic() < deadline
            assert process.stdout.readline() == "done\n"


def test_it_sees_each_time_that_the_same_thread_sleeps() -> None:
    with talking_program(SLEEPS_WHEN_ASKED) as process, closing(RestDetector(process.pid)) as rest:
        assert process.stdin is not None
        assert process.stdout is not None
        for _ in range(2):
            wait_until(lambda: rest.state() is State.AT_REST)
            process.stdin.write("go\n")
            process.stdin.flush()
            wait_until(lambda: rest.state() is State.SLEEPING)
            assert process.stdout.readline() == "done\n"


def test_a_thread_that_has_just_begun_is_seen_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.watching.rest.LISTED_EVERY_S", 3600.0)
    with talking_program(BEGINS_THREADS) as process, closing(RestDetector(process.pid)) as rest:
        assert process.stdin is not None
        assert process.stdout is not None
        wait_until(lambda: rest.state() is State.AT_REST)
        process.stdin.write("go\n")
        process.stdin.flush()
        assert process.stdout.readline() == "done\n"
        wait_until(lambda: rest.state() is State.SLEEPING)


def test_a_program_that_has_ended_holds_nobody_up() -> None:
    with talking_program(READS) as process:
        pass
    with closing(RestDetector(process.pid)) as rest:
        assert not rest.works


def test_a_program_that_sleeps_is_quiet() -> None:
    with talking_program(SLEEPS) as process, closing(RestDetector(process.pid)) as rest:
        assert rest.wait_until_quiet()
        assert rest.is_quiet()


def test_a_program_that_works_is_waited_for_until_it_sleeps() -> None:
    with talking_program(WORKS_A_MOMENT) as process, closing(RestDetector(process.pid)) as rest:
        assert rest.wait_until_quiet()
        assert process.stdin is not None
        process.stdin.write("go\n")
        process.stdin.flush()
        deadline = time.monotonic() + 10.0
        while rest.is_quiet():
            assert time.monotonic() < deadline, "it was never seen at work"
        while not rest.wait_until_quiet():
            assert time.monotonic() < deadline, "it never became quiet again"


def test_a_child_at_work_counts() -> None:
    with talking_program(CHILD_WORKS) as process, closing(RestDetector(process.pid)) as rest:
        assert not rest.wait_until_quiet()


def test_a_program_that_is_never_quiet_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    with talking_program(WORKS) as process, closing(RestDetector(process.pid)) as rest:
        began = time.monotonic()
        waits = [rest.wait_until_quiet() for _ in range(200)]
        assert not any(waits)
        assert time.monotonic() - began >= BUDGET_S
        monkeypatch.setattr("workbook.watching.rest.time.sleep", lambda _: pytest.fail("it waited again"))
        assert not rest.wait_until_quiet()


def test_a_program_that_has_ended_is_quiet() -> None:
    with talking_program(WORKS) as process, closing(RestDetector(process.pid)) as rest:
        assert not rest.is_quiet()
        process.kill()
        process.wait()
        assert rest.wait_until_quiet()
