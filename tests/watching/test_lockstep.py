"""Whether a program is at rest, at work, or asleep on its own."""

import time
from contextlib import closing

import pytest

from tests.programs.support import talking_program, wait_until
from workbook.watching.lockstep import SLEEP_WAITS, WORK_WAITS, LockStep, State

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


@pytest.mark.parametrize("code", [READS, WAITS_FOR_EVENTS])
def test_a_program_that_waits_for_input_is_at_rest(code: str) -> None:
    with talking_program(code) as process, closing(LockStep(process.pid)) as lock:
        assert lock.works
        wait_until(lambda: lock.state() is State.AT_REST)
        assert lock.wait() is State.AT_REST


def test_an_event_loop_that_wakes_by_itself_is_not_at_rest() -> None:
    with talking_program(POLLS) as process, closing(LockStep(process.pid)) as lock:
        wait_until(lambda: lock.state() is State.SLEEPING)
        while lock.works:
            assert lock.wait() is not State.AT_REST


@pytest.mark.parametrize("code", [SLEEPS, THREAD_SLEEPS])
def test_a_thread_that_sleeps_by_itself_is_not_at_rest(code: str) -> None:
    with talking_program(code) as process, closing(LockStep(process.pid)) as lock:
        wait_until(lambda: lock.state() is State.SLEEPING)
        seen = []
        while lock.works:
            seen.append(lock.wait())
        assert State.AT_REST not in seen
        # On a busy machine, the main thread may not have reached its wait yet.
        assert seen.count(State.SLEEPING) == SLEEP_WAITS or seen.count(State.AT_WORK) == WORK_WAITS


def test_a_program_that_never_rests_is_given_up() -> None:
    with talking_program(WORKS) as process, closing(LockStep(process.pid)) as lock:
        for _ in range(WORK_WAITS):
            assert lock.works
            assert lock.wait() is State.AT_WORK
        assert not lock.works


def test_it_waits_for_work_to_be_done() -> None:
    with talking_program(WORKS_WHEN_ASKED) as process, closing(LockStep(process.pid)) as lock:
        assert process.stdin is not None
        assert process.stdout is not None
        wait_until(lambda: lock.state() is State.AT_REST)
        for _ in range(5):
            process.stdin.write("go\n")
            process.stdin.flush()
            deadline = time.monotonic() + 10.0
            while lock.wait() is not State.AT_REST:
                assert time.monotonic() < deadline
            assert process.stdout.readline() == "done\n"


def test_it_sees_each_time_that_the_same_thread_sleeps() -> None:
    with talking_program(SLEEPS_WHEN_ASKED) as process, closing(LockStep(process.pid)) as lock:
        assert process.stdin is not None
        assert process.stdout is not None
        for _ in range(2):
            wait_until(lambda: lock.state() is State.AT_REST)
            process.stdin.write("go\n")
            process.stdin.flush()
            wait_until(lambda: lock.state() is State.SLEEPING)
            assert process.stdout.readline() == "done\n"


def test_a_thread_that_has_just_begun_is_seen_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.watching.lockstep.LISTED_EVERY_S", 3600.0)
    with talking_program(BEGINS_THREADS) as process, closing(LockStep(process.pid)) as lock:
        assert process.stdin is not None
        assert process.stdout is not None
        wait_until(lambda: lock.state() is State.AT_REST)
        process.stdin.write("go\n")
        process.stdin.flush()
        assert process.stdout.readline() == "done\n"
        wait_until(lambda: lock.state() is State.SLEEPING)


def test_a_program_that_has_ended_holds_nobody_up() -> None:
    with talking_program(READS) as process:
        pass
    with closing(LockStep(process.pid)) as lock:
        assert not lock.works
