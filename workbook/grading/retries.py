"""A second try for answers whose judgement is inconclusive. All tries are kept, and nobody loses by it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TypeVar

from workbook.exercise.conclusiveness import EXCUSED_ENDS
from workbook.exercise.judgement import Judgement, Report, judgement_as_provisional
from workbook.grading.judges import Job

MOST_TRIES = 3
"""For a person who waits. A grader tries again when all others are done: twice is enough there."""
Key = TypeVar("Key")
JudgeAll = Callable[[Sequence[Job[Key]]], Iterator[tuple[Job[Key], Judgement]]]


def judge_until_sure(
    jobs: Sequence[Job[Key]], judge: JudgeAll[Key]
) -> Iterator[tuple[Job[Key], tuple[Judgement, ...]]]:
    """Judge all; yields each answer with its tries as soon as it is done.

    An answer whose judgement is inconclusive is tried once more after all others, when the machine is calmer, and a
    third time if both ends looked as if rclpy or Python had spoiled them. If the run is stopped before its last try, it
    is not yielded: the next run judges it anew.
    """
    waiting = list(jobs)
    before: dict[int, tuple[Judgement, ...]] = {}
    while waiting:
        again: list[tuple[Job[Key], tuple[Judgement, ...]]] = []
        for job, judgement in judge(waiting):
            tries = _with_last(before.get(id(job), ()), judgement)
            if judgement.doubt and (len(tries) == 1 or _is_excused_so_far(tries)):
                again.append((job, tries))
            else:
                yield job, tries
        waiting = [job for job, _ in again]
        before = {id(job): tries for job, tries in again}


def until_sure(judge: Callable[[], Judgement], report: Report) -> Judgement:
    """Judge one answer, and again as long as that is in doubt, three times at most.

    `report` gets each doubtful one that is tried again, as provisional.
    """
    tries = _with_last((), judge())
    while tries[-1].doubt and len(tries) < MOST_TRIES:
        report(judgement_as_provisional(tries[-1]))
        tries = _with_last(tries, judge())
    return counting(tries)


def _with_last(before: tuple[Judgement, ...], judgement: Judgement) -> tuple[Judgement, ...]:
    """The tries, with one more. That every end of an answer looks spoiled is no chance: it leaves no doubt."""
    tries = (*before, judgement)
    if len(tries) >= MOST_TRIES and all(map(_has_excuse, tries)):
        return (*before, replace(judgement, doubt=""))
    return tries


def _is_excused_so_far(tries: Sequence[Judgement]) -> bool:
    return len(tries) < MOST_TRIES and all(map(_has_excuse, tries))


def _has_excuse(judgement: Judgement) -> bool:
    """Whether the end of a program looked as if rclpy or Python had spoiled it, and this took points away."""
    return any(result.cause in EXCUSED_ENDS for result in judgement.criteria)


def counting(tries: Sequence[Judgement]) -> Judgement:
    """The try that counts: the one with most points; of equal ones one without a doubt, and else the last."""

    def worth(number: int) -> tuple[float, bool, int]:
        one = tries[number]
        return (-1.0 if one.score is None else one.score, not one.doubt, number)

    return tries[max(range(len(tries)), key=worth)]
