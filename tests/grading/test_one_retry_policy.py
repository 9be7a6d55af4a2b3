"""The same tries of an answer give the same result in all five ways to judge it, because they share one policy."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from workbook.cli import check
from workbook.cli.main import main
from workbook.exercise import early_start, judging
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.grading import farm
from workbook.grading.judges import Job
from workbook.grading.results_file import last_results
from workbook.grading.slots import scheduler
from workbook.magics import checking
from workbook.recording.recording import Recording
from workbook.watching import observer

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
REASON = "this machine was busy"
RECORDING = Recording.load(ROOT / "tests" / "recordings" / STEM / "solution.json")
FULL = judge_recording(load_exercise(STEM, ROOT), "a" * 64, RECORDING)
RATE, END = "joint_rate", "alive_at_end"
Points = dict[str, float]


def lost(*names: str, inconclusive_reason: str = "", end_only: bool = False) -> Judgement:
    """Make a judgment in which some criteria failed. The criterion about the end is marked as such."""
    criteria = tuple(
        replace(
            one,
            about_end=one.id == END,
            points=0.0 if one.id in names else one.points,
            status="failed" if one.id in names else one.status,
        )
        for one in FULL.criteria
    )
    return replace(FULL, criteria=criteria, inconclusive_reason=inconclusive_reason, end_only=end_only)


HIGH, LOW = lost(), lost(RATE)
CRASHED, LOW_CRASHED = (
    lost(END, *names, inconclusive_reason="it crashed at its end", end_only=True) for names in ((), (RATE,))
)
DISTURBED, WORSE = (
    lost(RATE, inconclusive_reason=REASON),
    lost(RATE, "status_kept", inconclusive_reason=REASON),
)
NOT_JUDGED = replace(FULL, status="infra_error", reason="the slot is gone", criteria=(), recording=None)


class Prepared:
    """Returns one prepared judgment after another, in place of whatever a way uses for judging."""

    is_running = True

    def __init__(self, tries: Sequence[Judgement]) -> None:
        self._tries = list(tries)
        self.used = 0

    def judge(self, *_: object, **__: object) -> Judgement:
        self.used += 1
        return self._tries[self.used - 1]

    def judge_all(self, jobs: Sequence[Job[Any]], *_: Any, **__: Any) -> Iterator[tuple[Job[Any], Judgement]]:
        for job in jobs:
            yield job, replace(self.judge(), answer_sha256=job.answer.sha256)


class Surroundings:
    """Replaces a program that was started early, an observer, and a farm with its workers."""

    machines = places = 1
    isolation = "limits"
    lease = None

    def __init__(self, *_: object) -> None:
        pass

    def __enter__(self) -> "Surroundings":
        return self

    def __exit__(self, *_: object) -> None:
        pass


def points(judgement: Judgement | None) -> Points | None:
    """Return the points by criterion; None if no try counts."""
    if judgement is None or judgement.status != "graded":
        return None
    return {one.id: one.points for one in judgement.criteria}


def by_grade(judge: Prepared, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Points | None:
    """Use `workbook grade` with this machine's slots."""
    monkeypatch.setattr(scheduler, "judge_all", judge.judge_all)
    return _graded(folder, "--isolation", "limits")


def by_farm(judge: Prepared, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Points | None:
    """Use `workbook grade --farm`."""

    class Workers(Surroundings):
        judge_all = staticmethod(judge.judge_all)

    monkeypatch.setattr(farm, "Farm", Workers)
    return _graded(folder, "--isolation", "limits", "--farm", "tcp://127.0.0.1:8786")


def _graded(folder: Path, *options: str) -> Points | None:
    out = folder / "out"
    main(["grade", str(_answer(folder)), "--exercise", STEM, "--out", str(out), *options])
    [result] = last_results(out / "results.jsonl").values()
    return None if result.score is None else {one.id: one.points for one in result.criteria}


def _answer(folder: Path) -> Path:
    answer = folder / f"{STEM}.py"
    answer.write_text("print('hello')\n")
    return answer


def by_check(judge: Prepared, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Points | None:
    """Use `workbook check`."""
    shown: list[Judgement] = []
    monkeypatch.setattr(early_start, "StartedAnswer", Surroundings)
    monkeypatch.setattr(observer, "Observer", Surroundings)
    monkeypatch.setattr(judging, "Judge", lambda _: judge)
    monkeypatch.setattr(check, "verdict_text", lambda judgement, *_: shown.append(judgement))
    main(["check", STEM, str(_answer(folder))])
    return points(shown[-1])


def by_magic(judge: Prepared, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Points | None:
    """Use `%check`."""
    pool = SimpleNamespace(take=lambda _: judge, give=lambda *_: None)
    monkeypatch.setattr(checking, "warm_slots", pool)
    return points(checking.judge(STEM, Answer("print('hello')\n"), lambda _: None))


def by_pytest(judge: Prepared, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Points | None:
    """Use `pytest exercises/criteria/NN.py --answer FILE`, which reports passes but no points."""
    monkeypatch.setattr(observer, "Observer", Surroundings)
    monkeypatch.setattr(judging, "Judge", lambda _: judge)
    errors: dict[str, str] = {}

    def note(item: pytest.Item, call: "pytest.CallInfo[None]") -> None:
        if call.when == "call":
            errors[item.name] = "" if call.excinfo is None else call.excinfo.typename

    criteria = ROOT / "exercises" / "criteria" / f"{STEM}.py"
    pytest.main(
        [str(criteria), "--answer", str(_answer(folder)), "-q", "-p", "no:cacheprovider", "-p", "no:xdist"],
        plugins=[SimpleNamespace(pytest_runtest_makereport=note)],
    )
    if "RuntimeError" in errors.values():
        return None
    return {one.id: 0.0 if errors[one.id] == "CriterionFailed" else one.max_points for one in FULL.criteria}


GRADERS, AUTHORS = (by_grade, by_farm, by_pytest), (by_check, by_magic)


@pytest.mark.parametrize("way", [*GRADERS, *AUTHORS], ids=lambda way: way.__name__)
@pytest.mark.parametrize(
    ("tries", "counts"),
    [
        ((HIGH,), HIGH),
        ((LOW,), LOW),
        ((NOT_JUDGED,), None),
        ((DISTURBED, HIGH), HIGH),
        ((DISTURBED, LOW), LOW),
        ((DISTURBED, NOT_JUDGED, LOW), LOW),
        ((LOW_CRASHED, HIGH), LOW_CRASHED),
        ((CRASHED, LOW), LOW),
        ((CRASHED, HIGH), HIGH),
        ((CRASHED, DISTURBED, CRASHED), CRASHED),
        ((DISTURBED, LOW_CRASHED, HIGH), LOW_CRASHED),
        ((WORSE, WORSE, WORSE), WORSE),
        ((WORSE, DISTURBED, DISTURBED), None),
        ((WORSE, DISTURBED, NOT_JUDGED), None),
    ],
)
def test_every_way_to_a_judgement_counts_the_same_try(
    tries: tuple[Judgement, ...],
    counts: Judgement | None,
    way: Callable[[Prepared, Path, pytest.MonkeyPatch], Points | None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """If no try counts, grading gives no points, and the others show the last try that was judged."""
    if counts is None and way in AUTHORS:
        counts = next((one for one in reversed(tries) if one.status == "graded"), None)
    judge = Prepared((*tries, HIGH))
    assert way(judge, tmp_path, monkeypatch) == points(counts)
    assert judge.used == len(tries)
