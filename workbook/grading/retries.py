"""A second try for answers whose judgement is inconclusive. Both tries are kept, and nobody loses by it."""

from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

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

    An answer whose judgement is inconclusive is tried once more after all others, when the machine is calmer. If the
    run is stopped before its second try, it is not yielded: the next run judges it anew.
    """
    firsts: list[tuple[Job[Key], Judgement]] = []
    for job, judgement in judge(jobs):
        if judgement.doubt:
            firsts.append((job, judgement))
        else:
            yield job, (judgement,)
    if not firsts:
        return
    first_of = {id(job): first for job, first in firsts}
    for job, second in judge([job for job, _ in firsts]):
        yield job, (first_of[id(job)], second)


def until_sure(judge: Callable[[], Judgement], report: Report) -> Judgement:
    """Judge one answer, and again as long as that is in doubt, three times at most.

    `report` gets each doubtful one that is tried again, as provisional.
    """
    tries = [judge()]
    while tries[-1].doubt and len(tries) < MOST_TRIES:
        report(judgement_as_provisional(tries[-1]))
        tries.append(judge())
    return counting(tries)


def counting(tries: Sequence[Judgement]) -> Judgement:
    """The try that counts: the one with most points; of equal ones one without a doubt, and else the last."""

    def worth(number: int) -> tuple[float, bool, int]:
        one = tries[number]
        return (-1.0 if one.score is None else one.score, not one.doubt, number)

    return tries[max(range(len(tries)), key=worth)]
