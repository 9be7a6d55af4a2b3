"""Judge the answers that prove the exercises: in parallel, and each at most three times."""

import os
import time
import zlib
from collections.abc import Callable, Collection
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from tests.calm import await_calm
from tests.exercises import stored_proofs
from tests.exercises.few_wrong_answers import few_that_break_all
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import WrongAnswer, read_header, read_wrong_answer
from workbook.cli.grade_options import SLOTS_PER_CORE
from workbook.exercise.answers import Answer, read_answer
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import MOST_TRIES
from workbook.exercise.source import stems
from workbook.grading.judges import Job
from workbook.grading.slots.scheduler import judge_all
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.tiers import Isolation

ROOT = course_folder()
# WORKBOOK_PROOFS=05_timers proves only this exercise.
STEMS = tuple(stem for stem in stems(ROOT / "solutions") if os.environ.get("WORKBOOK_PROOFS", stem) == stem)
CORES = os.cpu_count() or 1
ARTIFACTS = ROOT / "artifacts"
MACHINE = {
    False: ARTIFACTS / "proofs_on_the_wall_clock.tsv",
    True: ARTIFACTS / "proofs_in_simulated_time.tsv",
}
"""One line per judgment: when it was ready (s), how busy the machine was, how long (s) its recording took, and how
many tries there were by then.
"""
COLUMNS = (
    "at exercise answer points held_up stood_still taken in_line clock watched tries inconclusive".split()
)
SOLUTION, STARTER = "solution", "starter"
FEW = 3
SEEDS = 20
"""How many different seeds the proofs use for scripts. tests/exercises/test_drawn_scripts.py checks each of them."""
CALM_S = 0.25
IN_LINE_SHARE = 0.02
TAKEN_SHARE = 0.03
Key = tuple[str, str]
"""Exercise and answer, such as ("05_timers", "wrong/too_fast.py")."""


def read(path: Path) -> WrongAnswer:
    """Read one of the course's wrong answers."""
    return read_wrong_answer(Tree(ROOT), path)


def answers(kind: str, stem: str) -> list[Path]:
    """Return the files of an exercise's "right" or "wrong" answers."""
    return sorted((ROOT / "tests" / f"{kind}_answers" / stem).glob("*.py"))


CASES = {
    kind: [(stem, path) for stem in STEMS for path in answers(kind, stem)] for kind in ("right", "wrong")
}
FEW_WRONG = frozenset(
    path
    for stem in STEMS
    for path in few_that_break_all({path: read_header(path).loses for path in answers("wrong", stem)})
)


def answer_of(key: Key) -> tuple[Answer, bool]:
    """Return an answer's text, and whether to judge it with a soak. Raises FileNotFoundError if there is none."""
    stem, name = key
    kind, _, file = name.partition("/")
    if kind in (SOLUTION, STARTER):
        source = load_exercise(stem, ROOT).source
        return Answer(source.solution_code if kind == SOLUTION else source.starter_code), True
    path = ROOT / "tests" / f"{kind}_answers" / stem / file
    if kind == "right":
        return read_answer(path, stem), True
    wrong = read(path)
    return wrong.answer, wrong.header.soak


def seed_of(name: str) -> int:
    """Return the seed for this answer's script: the same in each test run, but different for most other answers."""
    return zlib.crc32(name.encode()) % SEEDS


@dataclass(frozen=True)
class Pool:
    """Answers that are judged in the same way, on separate slots."""

    on_simulated_time: bool
    soak: bool

    @property
    def slots(self) -> int:
        """Return the number of slots, as in grading. While CPUs are idle, up to three times as many answers run."""
        return CORES * SLOTS_PER_CORE["simulated" if self.on_simulated_time else "wall"]


class Proofs:
    """All chosen answers, judged in parallel as in grading. Answers with the same clock are judged together."""

    def __init__(self, chosen: Collection[Key]) -> None:
        ARTIFACTS.mkdir(exist_ok=True)
        self._began_at = time.monotonic()
        self._few = len(chosen) <= FEW
        self._isolation: Isolation = "limits" if sandbox_problem() else "sandbox"
        self._jobs: dict[Pool, dict[Key, Job[Key]]] = {}
        self._pools: dict[Key, Pool] = {}
        for key in sorted(chosen, reverse=True):  # first those that take the longest: 14 to 16
            answer, soak = answer_of(key)
            pool = Pool(load_exercise(key[0], ROOT).source.clock == "simulated", soak)
            self._pools[key] = pool
            self._jobs.setdefault(pool, {})[key] = Job(key, key[0], answer, seed=seed_of(key[1]))
        self._judgements: dict[Key, Judgement] = {}
        self._tries: dict[Key, int] = {}

    def judgement(self, key: Key, as_expected: Callable[[Judgement], bool]) -> Judgement:
        """Return the judgment that counts for an answer, after at most three tries, as for a student.

        An unexpected judgment is repeated, with nothing else running. But a wrong answer with full marks is repeated
        only if the machine was so busy that the judge made allowances.
        """
        if key not in self._judgements:
            if self._few:
                self._judge_alone(key)
            else:
                self._judge_all_like(self._pools[key].on_simulated_time)
        while not as_expected(self._judgements[key]) and self._may_try_again(key):
            await_calm()
            self._judge_alone(key)
        judgement = self._judgements[key]
        if stored_proofs.is_wanted() and as_expected(judgement):
            stored_proofs.store(key, judgement)
        return judgement

    def again(self, stem: str) -> tuple[int, list[str]]:
        """Return how many answers of an exercise were judged, and which of them needed more than one try."""
        tries = {name: number for (one, name), number in self._tries.items() if one == stem}
        return len(tries), sorted(name for name, number in tries.items() if number > 1)

    def _may_try_again(self, key: Key) -> bool:
        judgement = self._judgements[key]
        return self._tries[key] < MOST_TRIES and (not judgement.full_marks or was_busy(judgement))

    def _judge_all_like(self, on_simulated_time: bool) -> None:
        """Judge all answers on this clock, in parallel."""
        MACHINE[on_simulated_time].write_text("\t".join(COLUMNS) + "\n", encoding="utf-8")
        pools = [pool for pool in self._jobs if pool.on_simulated_time == on_simulated_time]
        with ThreadPoolExecutor(max(1, len(pools))) as threads:
            list(threads.map(self._judge_pool, pools))

    def _judge_pool(self, pool: Pool) -> None:
        """Judge each answer once. Later tries come alone, because here they would compete with the same answers."""
        jobs = self._jobs[pool].values()
        for job, judgement in judge_all(
            jobs, pool.slots, soak=pool.soak, isolation=self._isolation, fills=True
        ):
            self._note(job.key, judgement, 1)

    def _judge_alone(self, key: Key) -> None:
        pool = self._pools[key]
        [(_, judgement)] = judge_all([self._jobs[pool][key]], 1, soak=pool.soak, isolation=self._isolation)
        self._note(key, judgement, self._tries.get(key, 0) + 1)

    def _note(self, key: Key, judgement: Judgement, tries: int) -> None:
        """Store a judgment, and log how busy the machine was (s)."""
        self._judgements[key], self._tries[key] = judgement, tries
        seen = judgement.recording
        waits = (
            ("",) * 6
            if seen is None
            else (seen.held_up_s, seen.stood_still_s, seen.taken_s, seen.in_line_s, seen.clock, seen.wall_s)
        )
        with MACHINE[self._pools[key].on_simulated_time].open("a", encoding="utf-8") as file:
            print(
                f"{time.monotonic() - self._began_at:.1f}",
                *key,
                judgement.score,
                *waits,
                tries,
                judgement.inconclusive_reason,
                sep="\t",
                file=file,
            )


def was_busy(judgement: Judgement) -> bool:
    """Return whether the judge or the program had to wait for the machine.

    Of 477 judgments in a run of all tests on two CPUs, the judge had to wait longer in five.
    """
    seen = judgement.recording
    if judgement.inconclusive_reason or seen is None:
        return bool(judgement.inconclusive_reason)
    longest = max(seen.held_up_s, seen.stood_still_s)
    return (
        longest > CALM_S
        or seen.in_line_s > IN_LINE_SHARE * seen.watched_s
        or seen.taken_s > TAKEN_SHARE * seen.watched_s
    )
