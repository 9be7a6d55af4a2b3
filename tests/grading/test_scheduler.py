"""Many answers on this machine: an answer that only waits frees its place, and memory limits how many wait."""

import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job
from workbook.grading.slots import pool, scheduler
from workbook.grading.slots.client import Slot, slot_environment
from workbook.grading.slots.pool import Kind, SlotPool
from workbook.grading.slots.scheduler import WorkPermits, judge_all
from workbook.isolation.tiers import Isolation

STEM = "09_joint_positions"
LONG_S = 30.0
"""How long a test waits. Only a broken program makes it wait this long."""


class FakeSlot:
    """The parts of a slot that a pool uses."""

    is_running = True

    def __init__(self) -> None:
        self.closed = False
        self.environ = slot_environment(None)

    def close(self) -> None:
        self.closed = True

    kill = close  # the pool closes while a slot is still being given back


def judgement(job: Job[Any], *, provisional: bool = False) -> Judgement:
    return Judgement(job.stem, job.answer.sha256, "graded", None, (), None, provisional)


class FakeJudge:
    """Replaces `pool.judge_with_retry`: reports once, then waits until `most` answers wait at the same time."""

    def __init__(self, most: int, *, provisional: bool = False) -> None:
        self._most = most
        self._provisional = provisional
        self._changed = threading.Condition()
        self.reported = 0
        self.under_way = 0
        self.most_under_way = 0
        self.slots: set[FakeSlot] = set()

    def __call__(
        self,
        _pool: SlotPool,
        slot: FakeSlot | None,
        _kind: Kind,
        job: Job[Any],
        *,
        soak: bool,
        report: Callable[[Judgement], None],
        progress: object,
    ) -> tuple[FakeSlot, Judgement]:
        slot = slot or FakeSlot()
        with self._changed:
            self.slots.add(slot)
            self.under_way += 1
            self.most_under_way = max(self.most_under_way, self.under_way)
        report(judgement(job, provisional=self._provisional))
        with self._changed:
            self.reported += 1
            self._changed.notify_all()
            assert self._changed.wait_for(lambda: self.reported >= self._most, LONG_S)
            self.under_way -= 1
        return slot, judgement(job)


def jobs(number: int) -> list[Job[int]]:
    return [Job(one, STEM, Answer(f"robot = {one}\n")) for one in range(number)]


@pytest.fixture
def plenty(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(scheduler, "available_memory_bytes", lambda: 10**12)
    return


@pytest.mark.usefixtures("plenty")
def test_who_only_waits_gives_the_place_to_the_next(monkeypatch: pytest.MonkeyPatch) -> None:
    judge = FakeJudge(most=5)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    found = {job.key for job, _ in judge_all(jobs(10), 1)}
    assert found == set(range(10)) and judge.most_under_way >= 5
    assert len(judge.slots) >= 5 and all(slot.closed for slot in judge.slots)


@pytest.mark.usefixtures("plenty")
def test_for_a_few_answers_no_slots_are_added(monkeypatch: pytest.MonkeyPatch) -> None:
    judge = FakeJudge(most=0)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(3), 2))) == 3
    assert len(judge.slots) <= 2


@pytest.mark.usefixtures("plenty")
def test_a_provisional_judgement_frees_no_place(monkeypatch: pytest.MonkeyPatch) -> None:
    judge = FakeJudge(most=0, provisional=True)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(6), 2))) == 6
    assert judge.most_under_way <= 2


@pytest.mark.usefixtures("plenty")
def test_slots_that_are_free_are_used_again(monkeypatch: pytest.MonkeyPatch) -> None:
    judge = FakeJudge(most=0)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(40), 1))) == 40
    assert len(judge.slots) <= 1 + scheduler.WAITING_PER_SLOT


def test_little_memory_no_slot_beside_the_places(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scheduler, "available_memory_bytes", lambda: scheduler.KEPT_FREE_BYTES)
    judge = FakeJudge(most=0)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(10), 2))) == 10
    assert len(judge.slots) <= 2


@pytest.mark.usefixtures("plenty")
@pytest.mark.parametrize("isolation", ["uid", "landlock"])
def test_where_answers_meet_on_the_network_one_is_judged_after_another(
    isolation: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    judge = FakeJudge(most=0)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(6), 3, isolation=isolation))) == 6
    assert judge.most_under_way == 1


def test_a_broken_slot_makes_room_for_a_new_one() -> None:
    kept: Any = FakeSlot()
    warm: list[Slot] = []
    permits = WorkPermits(1, lambda: warm.pop() if warm else None, room=lambda _: False)
    broken = permits.take()
    assert broken.slot is None
    permits.change(slots=-1)
    broken.end()
    good = permits.take()
    assert good.slot is None
    warm.append(kept)
    good.end()
    assert permits.take().slot is kept


@pytest.mark.usefixtures("plenty")
def test_more_are_at_work_while_the_processors_are_idle(monkeypatch: pytest.MonkeyPatch) -> None:
    """Up to three answers share each place, although no report frees one. With a requested number, no more run."""
    monkeypatch.setattr(scheduler, "IdleProcessors", lambda: lambda: True)
    monkeypatch.setattr(pool, "slot_server", lambda *_: None)
    monkeypatch.setattr(scheduler, "LOOK_S", 0.01)
    for fills, most in ((True, 6), (False, 2)):
        judge = FakeJudge(most=most, provisional=True)
        monkeypatch.setattr(pool, "judge_with_retry", judge)
        assert len(list(judge_all(jobs(20), 2, soak=False, fills=fills))) == 20
        assert judge.most_under_way == len(judge.slots) == most


@pytest.mark.usefixtures("plenty")
def test_on_busy_processors_no_more_are_at_work_than_there_are_places(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(scheduler, "IdleProcessors", lambda: lambda: False)
    monkeypatch.setattr(scheduler, "LOOK_S", 0.01)
    judge = FakeJudge(most=2, provisional=True)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(20), 2, soak=False, fills=True))) == 20
    assert judge.most_under_way == 2


@pytest.mark.usefixtures("plenty")
def test_while_all_wait_for_the_server_of_the_slots_no_more_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    class Untried:
        is_tried = False

        def close(self) -> None:
            pass

    monkeypatch.setattr(scheduler, "IdleProcessors", lambda: lambda: True)
    monkeypatch.setattr(pool, "slot_server", lambda *_: Untried())
    monkeypatch.setattr(scheduler, "LOOK_S", 0.01)
    judge = FakeJudge(most=2, provisional=True)
    monkeypatch.setattr(pool, "judge_with_retry", judge)
    assert len(list(judge_all(jobs(20), 2, soak=False, fills=True))) == 20
    assert judge.most_under_way == 2


def test_one_that_waits_begins_as_soon_as_processors_are_idle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scheduler, "LOOK_S", 0.01)
    idle = threading.Event()
    permits = WorkPermits(1, lambda: None, room=lambda _: True, spare=idle.is_set)
    assert permits.take().slot is None
    began = threading.Event()

    def waits() -> None:
        permits.take()
        began.set()

    waiting = threading.Thread(target=waits)
    waiting.start()
    assert not began.wait(0.1)
    idle.set()
    assert began.wait(LONG_S), "nobody has given up a permit"
    waiting.join()


def test_processors_are_looked_at_from_one_look_to_the_next(monkeypatch: pytest.MonkeyPatch) -> None:
    now, seconds = 0.0, (0.0, 0.0)
    monkeypatch.setattr(scheduler.time, "monotonic", lambda: now)
    monkeypatch.setattr(scheduler, "idle_and_all_s", lambda: seconds)
    has_spare = scheduler.IdleProcessors()
    assert not has_spare(), "it begins with the first look"
    seen = []
    for later, idle, passed in (
        (0.1, 0.2, 0.2),  # too soon after the last measurement
        (0.6, 0.3, 1.2),  # idle for a quarter of the time
        (1.2, 0.5, 2.4),  # idle for a sixth of the time
        (1.8, 1.5, 3.6),  # idle for nearly all of the time
        (2.4, 1.5, 3.6),  # no new measurement
    ):
        now, seconds = later, (idle, passed)
        seen.append(has_spare())
    assert seen == [False, True, False, True, False]


def test_stopped_it_judges_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    stopped = threading.Event()

    def judged(
        _pool: SlotPool, _slot: Slot | None, _kind: Kind, job: Job[Any], **_: object
    ) -> tuple[None, Judgement]:
        stopped.set()
        return None, judgement(job)

    monkeypatch.setattr(pool, "judge_with_retry", judged)
    assert len(list(judge_all(jobs(20), 1, stop=stopped.is_set))) == 1
