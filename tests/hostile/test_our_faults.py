"""Faults that aren't the student's:

criteria that crash, slots that die. They are named, and cost no student a point.
"""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import CLIMB
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.batch import Batch
from workbook.grading.hand_ins import HandIn
from workbook.grading.judges import Job
from workbook.grading.slots import client, pool
from workbook.grading.slots import health as slot_health
from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.health import SlotHealth
from workbook.grading.slots.scheduler import judge_all
from workbook.isolation.bubblewrap import NoSandbox
from workbook.isolation.tiers import Isolation

pytestmark = [pytest.mark.slow, pytest.mark.whole]

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
PATIENCE_S = 120.0
KILLER = f"{CLIMB}os.kill(judge(), signal.SIGKILL)\n"
HOLDER = f"{CLIMB}os.kill(judge(), signal.SIGSTOP)\n"
BROKEN = """
from workbook.criteria import Recording, Verdict, criterion, passed


@criterion(points=1, title="Looks at the log")
def careless(recording: Recording) -> Verdict:
    if "first" in recording.process.log:
        return {}["nothing"]
    if "second" in recording.process.log:
        raise SystemExit(0)
    return passed("fine")
"""


def results(out: Path) -> dict[str, dict[str, Any]]:
    lines = (out / "results.jsonl").read_text(encoding="utf-8").splitlines()
    return {one["student"]: one for one in map(json.loads, lines)}


def test_criteria_that_crash_are_our_fault_and_stop_nobody(tmp_path: Path) -> None:
    answers, own, out = tmp_path / "class", tmp_path / "own", tmp_path / "out"
    for folder in (answers, own):
        folder.mkdir()
    (own / f"{STEM}.py").write_text(BROKEN)
    for student in ("first", "second", "third"):
        (answers / f"{student}.py").write_text(f"print({student!r})\n")
    command = [
        *(sys.executable, "-m", "workbook.cli.main", "grade", answers, "--exercise", STEM, "--out", out),
        *("--slots", "1", "--criteria", own, "--isolation", "limits"),
    ]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 1, done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    assert "2 not judged because of an error in the judge" in done.stdout
    found = results(out)
    assert {student: (one["status"], one["score"]) for student, one in found.items()} == {
        "first": ("infra_error", None),
        "second": ("infra_error", None),
        "third": ("graded", 1.0),
    }
    assert "careless" in found["first"]["reason"] and "careless" in found["second"]["reason"]
    (own / f"{STEM}.py").write_text(
        BROKEN.replace('{}["nothing"]', 'passed("now")').replace("SystemExit(0)", "OSError")
    )
    subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    again = results(out)
    assert [again[student]["status"] for student in ("first", "second", "third")] == [
        "graded",
        "infra_error",
        "graded",
    ]


def test_a_slot_that_dies_again_and_again_is_named_with_its_answer() -> None:
    """The answer ends the slot here, which it can do only without a sandbox.

    Other causes are treated in the same way.
    """
    jobs = [Job("killer", STEM, Answer(KILLER)), Job("next", STEM, Answer("robot = = 1\n"))]
    found = {job.key: judgement for job, judgement in judge_all(jobs, 1)}
    assert (found["killer"].status, found["killer"].score) == ("ungradable", None)
    reason = found["killer"].reason or ""
    assert reason.startswith("stopped_judge: the slot ended with code -9, 2 times with this answer")
    assert found["next"].status == "graded"


def judged_alone(job: Job[str]) -> tuple[Slot | None, Judgement]:
    return pool.judge_with_retry(pool.warm_slots, None, pool.Kind(), job, soak=False)


def test_an_answer_that_keeps_the_judge_from_coming_to_an_end_is_ungradable(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Impatient(Slot):
        def judge(self, stem: str, answer: Answer, **options: Any) -> Judgement:
            monkeypatch.setattr(client, "ANSWER_DEADLINE_S", 5.0 if answer.text == HOLDER else PATIENCE_S)
            return super().judge(stem, answer, **options)

    monkeypatch.setattr(pool, "Slot", Impatient)
    slot, judgement = judged_alone(Job("holder", STEM, Answer(HOLDER)))
    assert (judgement.status, judgement.score) == ("ungradable", None)
    assert "stopped_judge: the slot did not answer in time, 2 times" in (judgement.reason or "")
    assert slot is not None and slot.is_running, "the slot that has judged a right answer goes on"
    slot.close()


def test_a_busy_machine_is_no_reason_to_give_an_answer_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """The deadline applies only to a slot that always gets a CPU."""
    right = load_exercise(STEM, ROOT).source.solution_code
    with Slot() as slot:
        monkeypatch.setattr(SlotHealth, "slowed_by", lambda _: PATIENCE_S / 0.2)
        monkeypatch.setattr(client, "ANSWER_DEADLINE_S", 0.2)
        assert slot.judge(STEM, Answer(right), soak=False).full_marks
        monkeypatch.undo()
        monkeypatch.setattr(client, "ANSWER_DEADLINE_S", 0.2)
        with pytest.raises(SlotBroken, match="did not answer in time"):
            slot.judge(STEM, Answer(right + "\n"), soak=False)


def test_how_much_a_slot_was_slowed_down_is_seen_from_outside(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two processes that never wait share one CPU, so each takes twice as long."""
    code = "import os\nos.sched_setaffinity(0, {min(os.sched_getaffinity(0))})\nwhile True: pass"
    with contextlib.ExitStack() as stack:
        alike = [subprocess.Popen([sys.executable, "-c", code], start_new_session=True) for _ in range(2)]
        for process in alike:
            stack.callback(process.wait)
            stack.callback(process.kill)
        health = SlotHealth(alike[0].pid, ("-c",))
        health.begin()
        deadline = time.monotonic() + PATIENCE_S
        while health.slowed_by() < 1.5 and time.monotonic() < deadline:
            time.sleep(0.05)
        assert health.slowed_by() >= 1.5
        monkeypatch.setattr(slot_health, "MOST_SLOWED", 1.2)
        assert health.slowed_by() == 1.2
        health.begin()
        assert health.slowed_by() <= 1.2


def test_where_no_right_answer_can_be_judged_either_the_fault_is_ours(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    judged: list[str] = []

    class Broken(Slot):
        def judge(self, stem: str, answer: Answer, **_: Any) -> Judgement:
            judged.append(answer.text)
            raise SlotBroken("the slot did not answer in time")

    monkeypatch.setattr(pool, "Slot", Broken)
    slot, judgement = judged_alone(Job("any", STEM, Answer("x = 1\n")))
    assert slot is None
    assert (judgement.status, judgement.score) == ("infra_error", None)
    assert judged == ["x = 1\n", "x = 1\n", load_exercise(STEM, ROOT).source.solution_code]

    def no_solution(_: str) -> Exercise:
        raise FileNotFoundError("the instructor has it")

    monkeypatch.setattr(pool, "load_exercise", no_solution)
    _, judgement = judged_alone(Job("any", STEM, Answer("x = 1\n")))
    assert judgement.status == "infra_error"


def test_an_answer_that_stops_the_judge_is_not_run_again_by_the_next_command(tmp_path: Path) -> None:
    answers, out = tmp_path / "class", tmp_path / "out"
    answers.mkdir()
    (answers / "killer.py").write_text(KILLER)
    command = [
        *(sys.executable, "-m", "workbook.cli.main", "grade", answers, "--exercise", STEM, "--out", out),
        *("--slots", "1", "--isolation", "limits"),
    ]
    for _ in range(2):
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        assert "1 ungradable" in done.stdout
    [line] = (out / "results.jsonl").read_text(encoding="utf-8").splitlines()
    result = json.loads(line)
    assert (result["status"], result["score"], result["attempt"]) == ("ungradable", None, 1)
    assert result["reason"].startswith("stopped_judge")


class _JudgesAll:
    """Gives all answers the same judgment, and notes which ones it judged."""

    isolation: Isolation = "limits"

    def __init__(self, reason: str | None) -> None:
        self._reason = reason
        self.judged: list[str] = []

    def judge_all(self, jobs: Iterable[Job[HandIn]], **_: object) -> Iterator[tuple[Job[HandIn], Judgement]]:
        for job in jobs:
            self.judged.append(job.key.student)
            yield job, Judgement(job.stem, job.answer.sha256, "ungradable", self._reason, (), None)


def test_an_answer_that_stopped_the_judge_is_judged_again_when_asked_and_no_other(tmp_path: Path) -> None:
    answers, out = tmp_path / "class", tmp_path / "out"
    answers.mkdir()
    exercise = load_exercise(STEM, ROOT)

    def judged(reason: str, retry_stopped: bool) -> list[str]:
        judges = _JudgesAll(reason)
        Batch(exercise, out, judges, retry_stopped=retry_stopped).run([answers])
        return judges.judged

    (answers / "other.py").write_text("x = 1\n")
    assert judged("it said so", False) == ["other"]
    (answers / "stopper.py").write_text("x = 2\n")
    assert judged(f"{pool.STOPPED_JUDGE}: twice", False) == ["stopper"]
    assert judged("never asked", False) == []
    assert judged("now it can be judged", True) == ["stopper"]
    assert judged("never asked", True) == [], "it has not stopped the judge the last time"
    last = results(out)
    assert (last["stopper"]["attempt"], last["other"]["attempt"]) == (2, 1)


def test_a_slot_that_cannot_be_started_is_no_zero_and_ends_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object, **__: object) -> Slot:
        raise NoSandbox("bubblewrap is not installed (apt install bubblewrap)")

    monkeypatch.setattr(pool, "Slot", fails)
    [(job, judgement)] = judge_all([Job("s1", STEM, Answer("x = 1\n"))], 2, isolation="sandbox")
    assert (job.key, judgement.status, judgement.score) == ("s1", "infra_error", None)
    assert "bubblewrap is not installed" in (judgement.reason or "")


@pytest.mark.sandbox
def test_a_slot_that_is_killed_in_the_sandbox_is_replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is killed after it has reported that it is ready. Before that, its sandbox might outlive it."""
    started: list[Slot] = []

    class KilledAtWork(Slot):
        def __init__(self, *arguments: Any, **more: Any) -> None:
            super().__init__(*arguments, **more)
            started.append(self)

        def _read_line(self, began: float, timeout_s: float) -> dict[str, Any]:
            message = super()._read_line(began, timeout_s)
            if self is started[0] and "ready" in message:
                os.kill(self._process.pid, signal.SIGKILL)
            return message

    monkeypatch.setattr(pool, "Slot", KilledAtWork)
    answer = Answer("import threading\nthreading.Event().wait(2)\n")  # still running when the slot dies
    [(_, judgement)] = judge_all([Job("s1", STEM, answer)], 1, isolation="sandbox")
    assert len(started) == 2
    assert judgement.status == "graded"
