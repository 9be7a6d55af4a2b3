"""Every exercise proves itself: starter, solution, right answers and wrong answers go through the real judge."""

import os
import re
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.calm import await_calm
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
SLOTS = os.cpu_count() or 1
GIVES_WAY = 10
"""Nice value of what is judged on robot time: it loses nothing by waiting, and whoever lives on the wall clock does."""
MACHINE = ROOT / "artifacts" / "proofs.tsv"
"""How busy the machine was in each judgement. An answer that was judged again has several lines."""
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
MORE_TRIES = 8
CALM_S = 0.25
IN_LINE_SHARE = 0.05
TAKEN_SHARE = 0.1


@dataclass(frozen=True)
class Pool:
    """Answers that are judged alike, on slots of their own."""

    on_robot_time: bool
    thorough: bool


class Proofs:
    """All answers of all exercises, judged side by side as an instructor's run judges them."""

    def __init__(self) -> None:
        self._jobs: dict[Pool, dict[Key, Job[Key]]] = {}
        self._pools: dict[Key, Pool] = {}
        self._isolation: Isolation = "limits" if sandbox_problem() else "sandbox"
        for stem in STEMS:
            source = load_exercise(stem, ROOT).source
            self._add(stem, "solution", Answer(source.solution_code))
            self._add(stem, "starter", Answer(source.starter_code))
            for path in answers("right", stem):
                self._add(stem, f"right/{path.name}", read_answer(path, stem))
            for path in answers("wrong", stem):
                self._add(
                    stem,
                    f"wrong/{path.name}",
                    read_answer(path, stem),
                    thorough=expectation_of(path).thorough,
                )
        with ThreadPoolExecutor(len(self._jobs)) as side_by_side:
            judged = side_by_side.map(self._judge_pool, self._jobs)
            self._judgements = {key: judgement for pool in judged for key, judgement in pool.items()}
        MACHINE.parent.mkdir(exist_ok=True)
        MACHINE.write_text(
            "exercise\tanswer\tpoints\theld up\tstood still\ttaken\tin line\tdoubt\n", encoding="utf-8"
        )
        for key in self._judgements:
            self._note(key)

    def _add(self, stem: str, name: str, answer: Answer, *, thorough: bool = True) -> None:
        on_robot_time = load_exercise(stem, ROOT).source.clock == "simulated"
        pool = Pool(on_robot_time, thorough)
        self._pools[stem, name] = pool
        self._jobs.setdefault(pool, {})[stem, name] = Job((stem, name), stem, answer)

    def _note(self, key: Key) -> None:
        """Keep how the machine was when this answer was judged (s)."""
        judgement = self._judgements[key]
        seen = judgement.recording
        waits = () if seen is None else (seen.held_up_s, seen.stood_still_s, seen.taken_s, seen.in_line_s)
        with MACHINE.open("a", encoding="utf-8") as file:
            print(*key, judgement.score, *waits, judgement.doubt, sep="\t", file=file)

    def _judge_pool(self, pool: Pool) -> dict[Key, Judgement]:
        if pool.on_robot_time:
            os.nice(GIVES_WAY)  # this thread, and all that it starts

        def judge(some: Sequence[Job[Key]]) -> Iterator[tuple[Job[Key], Judgement]]:
            return judge_all(some, SLOTS, thorough=pool.thorough, isolation=self._isolation)

        jobs = [*self._jobs[pool].values()]
        return {job.key: counting(tries) for job, tries in judge_until_sure(jobs, judge)}

    def judgement(
        self, stem: str, name: str, as_expected: Callable[[Judgement], bool] = lambda _: True
    ) -> Judgement:
        """What counts for an answer.

        A judgement on a machine that was too busy proves nothing: to doubt itself is all that it can do, or to make
        allowances that a wrong answer gets as well. If it is not as expected, the answer is judged alone.
        """
        key = (stem, name)
        for _ in range(MORE_TRIES):
            judgement = self._judgements[key]
            if not was_busy(judgement) or as_expected(judgement):
                break
            pool = self._pools[key]
            await_calm()
            [(_, self._judgements[key])] = judge_all(
                [self._jobs[pool][key]], 1, thorough=pool.thorough, isolation=self._isolation
            )
            self._note(key)
        return self._judgements[key]


@pytest.fixture(scope="session")
def proofs() -> Proofs:
    return Proofs()


def was_busy(judgement: Judgement) -> bool:
    """Whether the machine kept the judge or the program waiting for long.

    Of 477 judgements in a run of all tests on two processors, the judge had to wait for more in five.
    """
    seen = judgement.recording
    if judgement.doubt or seen is None:
        return bool(judgement.doubt)
    longest = max(seen.held_up_s, seen.stood_still_s)
    return (
        longest > CALM_S
        or seen.in_line_s > IN_LINE_SHARE * seen.robot_s
        or seen.taken_s > TAKEN_SHARE * seen.robot_s
    )


def explained(judgement: Judgement) -> str:
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{as_text(judgement)}\n{log}"


def lost(judgement: Judgement) -> set[str]:
    return {result.id for result in judgement.criteria if result.status in ("failed", "partial")}


def told(judgement: Judgement) -> str:
    """What the first lost criterion says."""
    first = next(result for result in judgement.criteria if result.status in ("failed", "partial"))
    return " ".join((first.saw, first.expected, first.because, first.try_this))


@pytest.mark.parametrize("stem", STEMS)
def test_solution_gets_full_marks(stem: str, proofs: Proofs) -> None:
    judgement = proofs.judgement(stem, "solution", lambda one: one.full_marks)
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize("stem", STEMS)
def test_points_add_up_to_ten(stem: str) -> None:
    exercise = load_exercise(stem, ROOT)
    assert exercise.max_points == 10
    assert sum(criterion.points > 0 for criterion in exercise.criteria) >= 4


@pytest.mark.parametrize("stem", STEMS)
def test_starter_does_not_pass_and_says_what_is_missing(stem: str, proofs: Proofs) -> None:
    judgement = proofs.judgement(stem, "starter")
    assert judgement.status == "graded", judgement.reason
    assert not judgement.full_marks
    for result in judgement.criteria:
        if result.status == "failed":
            assert result.saw and result.expected and result.because and result.try_this, result


@pytest.mark.parametrize(("stem", "path"), CASES["right"], ids=lambda value: getattr(value, "stem", value))
def test_right_answer_gets_full_marks(stem: str, path: Path, proofs: Proofs) -> None:
    judgement = proofs.judgement(stem, f"right/{path.name}", lambda one: one.full_marks)
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize(("stem", "path"), CASES["wrong"], ids=lambda value: getattr(value, "stem", value))
def test_wrong_answer_loses_what_it_must(stem: str, path: Path, proofs: Proofs) -> None:
    expected = expectation_of(path)
    judgement = proofs.judgement(
        stem,
        f"wrong/{path.name}",
        lambda one: lost(one) == expected.loses and all(words in told(one) for words in expected.says),
    )
    assert judgement.status == "graded", judgement.reason
    assert lost(judgement) == expected.loses, explained(judgement)
    skipped = {result.id for result in judgement.criteria if result.status == "skipped"}
    if expected.skips is not None:
        assert skipped == expected.skips, explained(judgement)
    for words in expected.says:
        assert words in told(judgement), f"{words!r} is not in: {told(judgement)}\n{explained(judgement)}"
    for result in judgement.criteria:
        if result.status in ("failed", "partial"):
            assert result.saw and result.expected and result.because and result.try_this, result
