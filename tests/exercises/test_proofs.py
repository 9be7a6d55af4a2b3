"""Every exercise proves itself: starter, solution, right answers and wrong answers go through the real judge.

What is judged on the wall clock goes first, then what is judged on robot time. Nothing else runs meanwhile (see
`tests/conftest.py`).
"""

import os
import zlib
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.calm import await_calm
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import Header, WrongAnswer, read_header, read_wrong_answer
from workbook.cli.grade_options import SLOTS_PER_CORE
from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer, read_answer
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.source import stems
from workbook.feedback.text import as_text
from workbook.grading.judges import Job
from workbook.grading.local import judge_all
from workbook.grading.retries import counting, judge_until_sure
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.tiers import Isolation

ROOT = course_folder()
# WORKBOOK_PROOFS=05_timers proves this exercise alone.
STEMS = tuple(stem for stem in stems(ROOT / "solutions") if os.environ.get("WORKBOOK_PROOFS", stem) == stem)
CORES = os.cpu_count() or 1
ARTIFACTS = ROOT / "artifacts"
MACHINE = {False: ARTIFACTS / "proofs_on_the_wall_clock.tsv", True: ARTIFACTS / "proofs_on_robot_time.tsv"}
"""How busy the machine was in each judgement, and how long (s) its recording took. An answer that was judged again has
several lines."""
NOT_STEADY = {kind: path.with_stem(f"not_steady_{path.stem}") for kind, path in MACHINE.items()}
"""Wrong answers that lost something else beside others, and were judged once more, alone: points, and what was lost."""


def read(path: Path) -> WrongAnswer:
    return read_wrong_answer(Tree(ROOT), path)


def answers(kind: str, stem: str) -> list[Path]:
    return sorted((ROOT / "tests" / f"{kind}_answers" / stem).glob("*.py"))


CASES = {
    kind: [(stem, path) for stem in STEMS for path in answers(kind, stem)] for kind in ("right", "wrong")
}
Key = tuple[str, str]
FEW = 3
MORE_TRIES = 8
SEEDS = 20
"""From so many seeds scripts are drawn here; tests/exercises/test_drawn_scripts.py looks at each of them."""
CALM_S = 0.25
IN_LINE_SHARE = 0.02
TAKEN_SHARE = 0.03


@dataclass(frozen=True)
class Pool:
    """Answers that are judged alike, on slots of their own."""

    on_robot_time: bool
    thorough: bool

    @property
    def slots(self) -> int:
        """How many of them are at work at once.

        On the wall clock twice as many as in an instructor's run: with three quarters of them the processors were idle
        for a third of the time. Of the wrong answers that begin on robot time, many go on to the wall clock, and wait
        there most of the time. Right ones are at work as long as they have a slot: half as many are enough.
        """
        if not self.on_robot_time:
            return CORES * SLOTS_PER_CORE["wall"]  # in each of two lanes
        return CORES * (1 if self.thorough else SLOTS_PER_CORE["simulated"])


Share = tuple[Pool, list[Key]]
"""Some of the answers of a pool."""


def lanes(pools: dict[Pool, list[Key]]) -> list[list[Share]]:
    """What is judged side by side, each lane one share after the other.

    On robot time, a lane for each pool. On the wall clock all answers take about as long, whatever they are: two lanes
    with equally many, so that neither stands empty while the other is at work.
    """
    if any(pool.on_robot_time for pool in pools):
        return [[(pool, keys)] for pool, keys in pools.items()]
    all_of_them = [(pool, key) for pool, keys in pools.items() for key in keys]
    half = -(-len(all_of_them) // 2)
    found = []
    for part in (all_of_them[:half], all_of_them[half:]):
        shares: dict[Pool, list[Key]] = {}
        for pool, key in part:
            shares.setdefault(pool, []).append(key)
        found.append([*shares.items()])
    return [lane for lane in found if lane]


def seed_of(name: str) -> int:
    """What the script for this answer is drawn from: the same in each run of the tests, another one for most others."""
    return zlib.crc32(name.encode()) % SEEDS


class Proofs:
    """All answers of all exercises, judged side by side as an instructor's run judges them; a `few` one by one."""

    def __init__(self, *, few: bool) -> None:
        ARTIFACTS.mkdir(exist_ok=True)
        self._few = few
        self._jobs: dict[Pool, dict[Key, Job[Key]]] = {}
        self._pools: dict[Key, Pool] = {}
        self._isolation: Isolation = "limits" if sandbox_problem() else "sandbox"
        for stem in reversed(STEMS):  # first those that take long: 14 to 16
            source = load_exercise(stem, ROOT).source
            self._add(stem, "solution", Answer(source.solution_code))
            self._add(stem, "starter", Answer(source.starter_code))
            for path in answers("right", stem):
                self._add(stem, f"right/{path.name}", read_answer(path, stem))
            for path in answers("wrong", stem):
                wrong = read(path)
                self._add(stem, f"wrong/{path.name}", wrong.answer, thorough=wrong.header.thorough)
        self._judgements: dict[Key, Judgement] = {}

    def _judge_all_like(self, key: Key) -> None:
        """Judge what has the clock of this answer, all of it side by side."""
        on_robot_time = self._pools[key].on_robot_time
        side_by_side = lanes(
            {pool: [*jobs] for pool, jobs in self._jobs.items() if pool.on_robot_time == on_robot_time}
        )
        NOT_STEADY[on_robot_time].unlink(missing_ok=True)
        MACHINE[on_robot_time].write_text(
            "exercise\tanswer\tpoints\theld up\tstood still\ttaken\tin line\tclock\twatched\tdoubt\n",
            encoding="utf-8",
        )

        with ThreadPoolExecutor(len(side_by_side)) as threads:
            for judged in threads.map(self._judge_lane, side_by_side):
                self._judgements |= judged
                for one in judged:
                    self._note(one)

    def _judge_lane(self, lane: list[Share]) -> dict[Key, Judgement]:
        judged: dict[Key, Judgement] = {}
        for pool, keys in lane:
            judged |= self._judge_share(pool, keys)
        return judged

    def _add(self, stem: str, name: str, answer: Answer, *, thorough: bool = True) -> None:
        on_robot_time = load_exercise(stem, ROOT).source.clock == "simulated"
        pool = Pool(on_robot_time, thorough)
        self._pools[stem, name] = pool
        self._jobs.setdefault(pool, {})[stem, name] = Job((stem, name), stem, answer, seed=seed_of(name))

    def _note(self, key: Key) -> None:
        """Keep how the machine was when this answer was judged (s)."""
        judgement = self._judgements[key]
        seen = judgement.recording
        waits = (
            ("",) * 6
            if seen is None
            else (seen.held_up_s, seen.stood_still_s, seen.taken_s, seen.in_line_s, seen.clock, seen.wall_s)
        )
        with MACHINE[self._pools[key].on_robot_time].open("a", encoding="utf-8") as file:
            print(*key, judgement.score, *waits, judgement.doubt, sep="\t", file=file)

    def _judge_share(self, pool: Pool, keys: Sequence[Key]) -> dict[Key, Judgement]:
        def judge(some: Sequence[Job[Key]]) -> Iterator[tuple[Job[Key], Judgement]]:
            return judge_all(some, pool.slots, thorough=pool.thorough, isolation=self._isolation, fills=True)

        jobs = [self._jobs[pool][key] for key in keys]
        return {job.key: counting(tries) for job, tries in judge_until_sure(jobs, judge)}

    def judgement(
        self,
        stem: str,
        name: str,
        as_expected: Callable[[Judgement], bool] = lambda _: True,
        *,
        once_more: bool = False,
    ) -> Judgement:
        """What counts for an answer.

        A judgement on a machine that was too busy proves nothing: to doubt itself is all that it can do, or to make
        allowances that a wrong answer gets as well. If it is not as expected, the answer is judged alone. With
        `once_more` an answer without full marks is, however busy the machine was: what a wrong program does beside
        forty others may cost it more than its mistake does, and NOT_STEADY names it.
        """
        key = (stem, name)
        if key not in self._judgements:
            if self._few:
                self._judge_alone(key)
            else:
                self._judge_all_like(key)
        for _ in range(MORE_TRIES):
            judgement = self._judgements[key]
            if as_expected(judgement):
                break
            if not was_busy(judgement):
                if not once_more or judgement.full_marks:
                    break
                once_more = False
                with NOT_STEADY[self._pools[key].on_robot_time].open("a", encoding="utf-8") as file:
                    print(*key, judgement.score, *sorted(lost(judgement)), sep="\t", file=file)
            await_calm()
            self._judge_alone(key)
        return self._judgements[key]

    def _judge_alone(self, key: Key) -> None:
        pool = self._pools[key]

        [(_, self._judgements[key])] = judge_all(
            [self._jobs[pool][key]], 1, thorough=pool.thorough, isolation=self._isolation
        )
        self._note(key)


@pytest.fixture(scope="session")
def proofs(request: pytest.FixtureRequest) -> Proofs:
    chosen = [item for item in request.session.items if item.path == Path(__file__)]
    return Proofs(few=len(chosen) <= FEW)


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


def first_lost(judgement: Judgement, expected: Header) -> CriterionResult:
    """The first lost criterion, of those that the mistake costs on any machine."""
    costs = (one for one in judgement.criteria if one.id not in expected.also)
    return next(result for result in costs if result.status in ("failed", "partial"))


def told(judgement: Judgement, expected: Header) -> str:
    """What that criterion says."""
    first = first_lost(judgement, expected)
    return " ".join((first.saw, first.expected, first.because, first.try_this))


def as_expected(judgement: Judgement, expected: Header) -> bool:
    return (
        lost(judgement) - expected.also == expected.loses
        and all(words in told(judgement, expected) for words in expected.says)
        and first_lost(judgement, expected).cause in expected.causes
    )


@pytest.mark.parametrize("stem", STEMS)
def test_solution_gets_full_marks(stem: str, proofs: Proofs) -> None:
    judgement = proofs.judgement(stem, "solution", lambda one: one.full_marks)
    assert judgement.full_marks, explained(judgement)


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
    expected = read_header(path)
    judgement = proofs.judgement(
        stem, f"wrong/{path.name}", lambda one: as_expected(one, expected), once_more=True
    )
    assert not judgement.full_marks, f"full marks for a wrong answer: {expected.about}"
    assert judgement.status == "graded", judgement.reason
    assert lost(judgement) - expected.also == expected.loses, explained(judgement)
    skipped = {result.id for result in judgement.criteria if result.status == "skipped"}
    if expected.skips is not None:
        assert skipped == expected.skips, explained(judgement)
    for words in expected.says:
        assert words in told(judgement, expected), (
            f"{words!r} is not in: {told(judgement, expected)}\n{explained(judgement)}"
        )
    assert first_lost(judgement, expected).cause in expected.causes, explained(judgement)
    for result in judgement.criteria:
        if result.status in ("failed", "partial"):
            assert result.saw and result.expected and result.because and result.try_this, result
