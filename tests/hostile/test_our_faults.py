"""Faults that are no student's: criteria that crash, slots that die. They are named, and cost nobody a point."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import CLIMB
from workbook.exercise.answers import Answer
from workbook.grading import pool
from workbook.grading.judges import Job
from workbook.grading.local import judge_all
from workbook.grading.pool import Slot
from workbook.isolation.bubblewrap import NoSandbox

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
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
    assert "2 not judged through a fault of the grader" in done.stdout
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
    """Whatever ends a slot: here the answer does it, which it can do only where it is not sandboxed."""
    killer = f"{CLIMB}os.kill(judge(), signal.SIGKILL)\n"
    jobs = [Job("killer", STEM, Answer(killer)), Job("next", STEM, Answer("robot = = 1\n"))]
    found = {job.key: judgement for job, judgement in judge_all(jobs, 1)}
    assert (found["killer"].status, found["killer"].score) == ("infra_error", None)
    assert "2 times with this answer" in (found["killer"].reason or "")
    assert found["next"].status == "graded"


def test_a_slot_that_cannot_be_started_is_no_zero_and_ends_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> Slot:
        raise NoSandbox("bubblewrap is not installed (apt install bubblewrap)")

    monkeypatch.setattr(pool, "Slot", fails)
    [(job, judgement)] = judge_all([Job("s1", STEM, Answer("x = 1\n"))], 2, isolation="sandbox")
    assert (job.key, judgement.status, judgement.score) == ("s1", "infra_error", None)
    assert "bubblewrap is not installed" in (judgement.reason or "")


@pytest.mark.sandbox
def test_a_slot_that_is_killed_in_the_sandbox_is_replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is killed when it has said that it is ready: before that, its sandbox may not yet end with it."""
    started: list[Slot] = []

    class KilledAtWork(Slot):
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            started.append(self)

        def _read_line(self, deadline: float) -> dict[str, Any]:
            message = super()._read_line(deadline)
            if self is started[0] and "ready" in message:
                os.kill(self._process.pid, signal.SIGKILL)
            return message

    monkeypatch.setattr(pool, "Slot", KilledAtWork)
    answer = Answer("import threading\nthreading.Event().wait(2)\n")  # not judged before the slot is dead
    [(_, judgement)] = judge_all([Job("s1", STEM, answer)], 1, isolation="sandbox")
    assert len(started) == 2
    assert judgement.status == "graded"
