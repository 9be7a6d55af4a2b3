"""Every exercise proves itself: starter, solution, right answers and wrong answers go through the real judge."""

import os
import re
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from workbook.exercise.answers import Answer, read_answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judging import Judgement
from workbook.exercise.source import stems
from workbook.feedback.text import as_text
from workbook.grading.pool import Isolation, Job, judge_all
from workbook.grading.tries import counting, judge_until_sure
from workbook.observing.sandbox import sandbox_problem

ROOT = Path(__file__).resolve().parents[2]
# WORKBOOK_PROOFS=05_timers proves this exercise alone.
STEMS = tuple(stem for stem in stems(ROOT / "solutions") if os.environ.get("WORKBOOK_PROOFS", stem) == stem)
SLOTS = 3 * (os.cpu_count() or 1)
HEADER = re.compile(r"^#\s*(loses|skips|says|thorough):\s*(.+)$")


@dataclass(frozen=True)
class Expectation:
    """What a wrong answer says of itself in its first lines.

    `thorough`: it must live its real seconds to be found out. The others are judged without them: they prove nothing
    there, and take as much time again.
    """

    loses: frozenset[str]
    skips: frozenset[str] | None
    says: tuple[str, ...]
    thorough: bool


def expectation_of(path: Path) -> Expectation:
    fields: dict[str, list[str]] = {"loses": [], "skips": [], "says": [], "thorough": []}
    for line in path.read_text(encoding="utf-8").splitlines():
        found = HEADER.match(line)
        if not found:
            break
        fields[found[1]].append(found[2].strip())
    names = {
        key: [name.strip() for text in fields[key] for name in text.split(",")] for key in ("loses", "skips")
    }
    assert names["loses"], f"{path} has no `# loses:` line"
    assert fields["says"], f"{path} has no `# says:` line"
    return Expectation(
        frozenset(names["loses"]),
        frozenset(names["skips"]) if names["skips"] else None,
        tuple(fields["says"]),
        fields["thorough"] == ["yes"],
    )


def answers(kind: str, stem: str) -> list[Path]:
    return sorted((ROOT / "tests" / f"{kind}_answers" / stem).glob("*.py"))


CASES = {
    kind: [(stem, path) for stem in STEMS for path in answers(kind, stem)] for kind in ("right", "wrong")
}
Key = tuple[str, str]


@pytest.fixture(scope="session")
def judgements() -> dict[Key, Judgement]:
    """All answers of all exercises, judged side by side as an instructor's run judges them."""
    return dict(_judge_everything())


def _judge_everything() -> Iterator[tuple[Key, Judgement]]:
    quick: list[Job[Key]] = []
    thorough: list[Job[Key]] = []
    for stem in STEMS:
        source = load_exercise(stem, ROOT).source
        thorough.append(Job((stem, "solution"), stem, Answer(source.solution_code)))
        thorough.append(Job((stem, "starter"), stem, Answer(source.starter_code)))
        for path in answers("right", stem):
            thorough.append(Job((stem, f"right/{path.name}"), stem, read_answer(path, stem)))
        for path in answers("wrong", stem):
            jobs = thorough if expectation_of(path).thorough else quick
            jobs.append(Job((stem, f"wrong/{path.name}"), stem, read_answer(path, stem)))
    isolation: Isolation = "limits" if sandbox_problem() else "sandbox"

    def judged(jobs: Sequence[Job[Key]], thorough: bool) -> list[tuple[Key, Judgement]]:
        def judge(some: Sequence[Job[Key]]) -> Iterator[tuple[Job[Key], Judgement]]:
            return judge_all(some, SLOTS // 2, thorough=thorough, isolation=isolation)

        return [(job.key, counting(tries)) for job, tries in judge_until_sure(jobs, judge)]

    with ThreadPoolExecutor(2) as both:
        halves = [both.submit(judged, quick, False), both.submit(judged, thorough, True)]
    for half in halves:
        yield from half.result()


def explained(judgement: Judgement) -> str:
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{as_text(judgement)}\n{log}"


def lost(judgement: Judgement) -> set[str]:
    return {result.id for result in judgement.criteria if result.status in ("failed", "partial")}


@pytest.mark.parametrize("stem", STEMS)
def test_solution_gets_full_marks(stem: str, judgements: dict[Key, Judgement]) -> None:
    judgement = judgements[stem, "solution"]
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize("stem", STEMS)
def test_points_add_up_to_ten(stem: str) -> None:
    exercise = load_exercise(stem, ROOT)
    assert exercise.max_points == 10
    assert sum(criterion.points > 0 for criterion in exercise.criteria) >= 4


@pytest.mark.parametrize("stem", STEMS)
def test_starter_does_not_pass_and_says_what_is_missing(stem: str, judgements: dict[Key, Judgement]) -> None:
    judgement = judgements[stem, "starter"]
    assert judgement.status == "graded", judgement.reason
    assert not judgement.full_marks
    for result in judgement.criteria:
        if result.status == "failed":
            assert result.saw and result.expected and result.because and result.try_this, result


@pytest.mark.parametrize(("stem", "path"), CASES["right"], ids=lambda value: getattr(value, "stem", value))
def test_right_answer_gets_full_marks(stem: str, path: Path, judgements: dict[Key, Judgement]) -> None:
    judgement = judgements[stem, f"right/{path.name}"]
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize(("stem", "path"), CASES["wrong"], ids=lambda value: getattr(value, "stem", value))
def test_wrong_answer_loses_what_it_must(stem: str, path: Path, judgements: dict[Key, Judgement]) -> None:
    expected = expectation_of(path)
    judgement = judgements[stem, f"wrong/{path.name}"]
    assert judgement.status == "graded", judgement.reason
    assert lost(judgement) == expected.loses, explained(judgement)
    skipped = {result.id for result in judgement.criteria if result.status == "skipped"}
    if expected.skips is not None:
        assert skipped == expected.skips, explained(judgement)
    first = next(result for result in judgement.criteria if result.status in ("failed", "partial"))
    told = " ".join((first.saw, first.expected, first.because, first.try_this))
    for words in expected.says:
        assert words in told, f"{words!r} is not in: {told}\n{explained(judgement)}"
    for result in judgement.criteria:
        if result.status in ("failed", "partial"):
            assert result.saw and result.expected and result.because and result.try_this, result
