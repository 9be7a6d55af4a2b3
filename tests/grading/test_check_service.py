"""The service that judges a whole class: which answer is next, and what happens to it."""

import itertools
import json
import os
import socket
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as some

from tests.grading.test_scheduler import LONG_S, FakeJudge, FakeSlot, judgement
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job
from workbook.grading.slots import pool, scheduler
from workbook.grading.slots.protocol import JudgingOrder, Progress, line_of
from workbook.grading.slots.service import (
    MOST_WAITING,
    CheckService,
    FairQueue,
    TooMany,
    judge_there,
    read_order,
    user_of,
)

STEM = "03_publishers_and_messages"


def test_owners_take_turns() -> None:
    queue: FairQueue[str] = FairQueue()
    for item in ("a1", "a2", "a3", "b1", "b2", "c1"):
        queue.put(item[0], item)
    expected = ["a1", "b1", "c1", "a2", "b2", "a3"]
    assert queue.in_order() == expected
    assert [queue.take() for _ in expected] == expected


@given(some.lists(some.sampled_from("abcde"), max_size=20))
def test_the_order_that_is_told_is_the_order_that_comes(owners: str) -> None:
    queue: FairQueue[int] = FairQueue(most=99)
    for number, owner in enumerate(owners):
        queue.put(owner, number)
    told = queue.in_order()
    assert [queue.take() for _ in owners] == told


@given(some.lists(some.sampled_from("abcde"), max_size=20))
def test_nobody_waits_for_more_than_one_answer_of_each_other_person(owners: str) -> None:
    queue: FairQueue[tuple[str, int]] = FairQueue(most=99)
    for number, owner in enumerate(owners):
        queue.put(owner, (owner, number))
    queue.put("late", ("late", 0))
    before = list(itertools.takewhile(lambda item: item[0] != "late", queue.in_order()))
    assert len(before) == len({owner for owner, _ in before})


def test_too_many_answers_of_one_person_are_refused() -> None:
    queue: FairQueue[int] = FairQueue()
    for number in range(MOST_WAITING):
        queue.put("a", number)
    with pytest.raises(TooMany, match="of your answers are waiting"):
        queue.put("a", 99)
    queue.put("b", 0)


@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"no message\n",
        b"{}\n",
        json.dumps({"exercise": "../../tmp/mine", "answer": ""}).encode() + b"\n",
        json.dumps({"exercise": STEM, "answer": "x" * 2_000_000}).encode() + b"\n",
    ],
    ids=["nothing", "noise", "empty", "foreign criteria", "too long"],
)
def test_what_is_no_order_is_refused(line: bytes) -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        sender = threading.Thread(target=_send, args=[theirs, line])
        sender.start()
        with pytest.raises((EOFError, KeyError, ValueError)):
            read_order(ours)
        ours.close()
        sender.join()


def _send(connection: socket.socket, line: bytes) -> None:
    try:
        connection.sendall(line)
        connection.shutdown(socket.SHUT_WR)
    except OSError:
        pass


def test_an_order_is_read() -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        theirs.sendall(line_of(JudgingOrder(STEM, "pass", soak=False)))
        assert read_order(ours) == JudgingOrder(STEM, "pass", soak=True, progress=True)
        assert user_of(ours) == os.getuid()


@pytest.fixture
def service(tmp_path: Path) -> Iterator[CheckService]:
    made = CheckService(tmp_path, 1, "limits", owner_of=lambda connection: connection.fileno())
    thread = threading.Thread(target=made.serve)
    thread.start()
    yield made
    made.close()
    thread.join()


def test_answers_are_judged_one_after_another_and_see_their_place(service: CheckService) -> None:
    right = load_exercise(STEM).source.solution_code
    wrong = "import rclpy\nrclpy.init()\nrclpy.shutdown()\n"
    places: dict[str, list[int]] = {"right": [], "wrong": []}
    got: dict[str, Judgement] = {}

    def ask(name: str, program: str) -> None:
        def note(progress: Progress) -> None:
            places[name].append(progress.place)

        got[name] = judge_there(str(service.path), STEM, Answer(program), lambda _: None, note)

    threads = [threading.Thread(target=ask, args=pair) for pair in (("right", right), ("wrong", wrong))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {one.status for one in got.values()} == {"graded"}
    lost = {name: sum(one.max_points - one.points for one in got[name].criteria) for name in got}
    assert lost["right"] == 0 < lost["wrong"]
    assert max(places["right"] + places["wrong"]) >= 1  # one of the two waited


def test_an_answer_that_is_only_watched_gives_its_place_to_the_next(
    service: CheckService, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The service has one slot. Each answer ends only when both have a card."""
    monkeypatch.setattr(scheduler, "available_memory_bytes", lambda: 10**12)
    judge = FakeJudge(most=2)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    programs = [Answer(f"robot = {number}\n") for number in range(2)]

    def ask(program: Answer) -> str:
        return judge_there(str(service.path), STEM, program, lambda _: None).status

    with ThreadPoolExecutor(2) as both:
        assert [*both.map(ask, programs)] == ["graded", "graded"]
    assert judge.most_under_way == 2


def test_a_stopped_check_leaves_the_queue(service: CheckService, monkeypatch: pytest.MonkeyPatch) -> None:
    """The service has one slot, which is busy until the second of three checks has been stopped."""
    begun, stopped, go_on = threading.Event(), threading.Event(), threading.Event()
    judged: list[str] = []

    def judge(
        _pool: object, slot: FakeSlot | None, _kind: object, job: Job[Any], **_: object
    ) -> tuple[FakeSlot, Judgement]:
        judged.append(job.answer.text)
        begun.set()
        assert go_on.wait(LONG_S)
        return slot or FakeSlot(), judgement(job)

    monkeypatch.setattr(pool, "judge_with_retry", judge)

    def ask(program: str, stop: Callable[[], bool] = lambda: False) -> Judgement:
        note = lambda _: stopped.set()  # noqa: E731 - the place in the queue
        return judge_there(str(service.path), STEM, Answer(program), lambda _: None, note, stop)

    with ThreadPoolExecutor(1) as other:
        first = other.submit(ask, "a = 1\n")
        assert begun.wait(LONG_S)
        assert ask("b = 2\n", stopped.is_set).reason == "the check was stopped"
        go_on.set()
        assert first.result().status == "graded"
    assert ask("c = 3\n").status == "graded"
    assert judged == ["a = 1\n", "c = 3\n"]


def test_a_check_that_is_stopped_after_its_card_returns_the_judgment(
    service: CheckService, monkeypatch: pytest.MonkeyPatch
) -> None:
    judge = FakeJudge(most=2)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    stopped = threading.Event()
    found = judge_there(
        str(service.path), STEM, Answer("a = 1\n"), lambda _: stopped.set(), stop=stopped.is_set
    )
    assert found.status == "graded"
    assert judge.under_way == 1, "the program is still being watched"
    assert judge_there(str(service.path), STEM, Answer("b = 2\n"), lambda _: None).status == "graded"


def test_without_a_service_the_card_says_so(tmp_path: Path) -> None:
    judgement = judge_there(str(tmp_path / "none"), STEM, Answer("pass"), lambda _: None)
    assert judgement.status == "infra_error"
    assert "check service" in judgement.reason
