"""Turns: in a tier in which answers could meet, this user's processes judge one answer at a time."""

import queue
import select
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from workbook.grading.slots.pool import turn
from workbook.isolation.tiers import Isolation

LONG_S = 60.0
"""How long a test waits. Only a broken program makes it wait this long."""
TAKES_A_TURN = """
import sys
from workbook.grading.slots.pool import turn
print("waits", flush=True)
with turn("landlock"):
    print("has it", flush=True)
    sys.stdin.read()
"""


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def grader() -> "subprocess.Popen[str]":
    pipe = subprocess.PIPE
    return subprocess.Popen([sys.executable, "-c", TAKES_A_TURN], stdin=pipe, stdout=pipe, text=True)


def said_by(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    return process.stdout.readline().strip()


def taken_by(isolation: Isolation) -> tuple[threading.Thread, threading.Event]:
    """Start a thread that takes a turn. Return it with an event that says when it has the turn."""
    has_it = threading.Event()

    def take() -> None:
        with turn(isolation):
            has_it.set()

    thread = threading.Thread(target=take)
    thread.start()
    return thread, has_it


def test_two_graders_of_one_user_take_turns() -> None:
    with grader() as other:
        assert [said_by(other), said_by(other)] == ["waits", "has it"]
        thread, has_it = taken_by("uid")
        assert not has_it.wait(0.2)
        other.kill()
        assert has_it.wait(LONG_S), "a turn ends with its process"
        thread.join()
    with turn("uid"), grader() as other:
        assert said_by(other) == "waits"
        assert not select.select([other.stdout], [], [], 0.2)[0]
        other.kill()


@pytest.mark.parametrize("isolation", ["sandbox", "limits"])
def test_other_tiers_do_not_wait(isolation: Isolation) -> None:
    with turn("uid"), turn(isolation):
        pass


def test_without_a_cache_the_turns_of_one_process_remain(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    with turn("uid"):
        thread, has_it = taken_by("uid")
        assert not has_it.wait(0.2)
    assert has_it.wait(LONG_S)
    thread.join()


def test_whoever_waits_hears_how_many_come_first() -> None:
    heard: queue.SimpleQueue[tuple[int, int]] = queue.SimpleQueue()
    may_end = threading.Event()

    def take(number: int) -> None:
        with turn("uid", lambda place: heard.put((number, place))):
            assert may_end.wait(LONG_S)

    threads = [threading.Thread(target=take, args=(number,)) for number in (1, 2)]
    with turn("uid"):
        for number, thread in enumerate(threads, start=1):
            thread.start()
            assert heard.get(timeout=LONG_S) == (number, number)
    assert {heard.get(timeout=LONG_S) for _ in threads} == {(1, 0), (2, 1)}
    may_end.set()
    assert heard.get(timeout=LONG_S) == (2, 0)
    for thread in threads:
        thread.join()


def test_another_grader_counts_as_one_that_comes_first() -> None:
    places: list[int] = []
    waits = threading.Event()

    def take() -> None:
        def note(place: int) -> None:
            places.append(place)
            waits.set()

        with turn("uid", note):
            pass

    with grader() as other:
        assert [said_by(other), said_by(other)] == ["waits", "has it"]
        thread = threading.Thread(target=take)
        thread.start()
        assert waits.wait(LONG_S)
        assert places == [1]
        other.kill()
    thread.join()
    assert places == [1, 0]
