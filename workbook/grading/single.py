"""Grading what one student handed in, at once and by itself: for systems that start a grader for each submission."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from workbook.exercise.answers import Ungradable, read_answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judging import Judgement
from workbook.grading.hand_ins import HandIn
from workbook.grading.pool import Isolation, Job, judge_all
from workbook.grading.results import Result, graded_result, ungradable_result
from workbook.grading.tier_check import tier_problem
from workbook.grading.tries import counting, judge_until_sure
from workbook.observing.sandbox import NoSandbox
from workbook.observing.tiers import BEST_FIRST, named_tier

TIERS = {
    "sandbox": "shut in by bubblewrap, with a network of its own",
    "uid": "as a user of its own",
    "landlock": "kept by the kernel from files that are not its own",
    "limits": "with limits on time, memory and processes, and with nothing else between it and this machine",
}
"""How an answer is kept from doing harm, in words for whoever reads a result."""


def best_isolation() -> Isolation:
    """The best tier that works on this machine."""
    return next((tier for tier in BEST_FIRST if tier_problem(tier) is None), "limits")


def choose_isolation(wanted: str) -> Isolation:
    """The tier to use: with "auto" the best that works, else the one that is wanted.

    Raises NoSandbox when the wanted one does not work here.
    """
    if wanted == "auto":
        return best_isolation()
    isolation = named_tier(wanted)
    problem = tier_problem(isolation)
    if problem is not None:
        raise NoSandbox(f"programs cannot be shut in on this machine: {problem}")
    return isolation


def grade_one(exercise: Exercise, hand_in: HandIn, out: Path, isolation: Isolation) -> Result:
    """Grade one hand-in; recordings go below `out`. What cannot be judged gives a result, too, and no exception."""
    try:
        if hand_in.problem is not None:
            raise Ungradable(hand_in.problem)
        answer = read_answer(hand_in.path, exercise.stem)
    except (Ungradable, OSError) as error:
        return _refused(exercise, hand_in, str(error), isolation)
    job = Job(hand_in, exercise.stem, answer)
    judge = _judge(isolation)
    for _, tries in judge_until_sure([job], judge):
        return graded_result(
            out,
            counting(tries),
            student=hand_in.student,
            answer=hand_in.label,
            submitted_at=None,
            attempt=1,
            isolation=isolation,
            criteria_sha256=exercise.criteria_sha256,
            max_score=exercise.max_points,
            tries=tries,
        )
    raise RuntimeError("the grader gave no judgement")


def _judge(
    isolation: Isolation,
) -> Callable[[Sequence[Job[HandIn]]], Iterator[tuple[Job[HandIn], Judgement]]]:
    return lambda jobs: judge_all(jobs, 1, isolation=isolation)


def _refused(exercise: Exercise, hand_in: HandIn, reason: str, isolation: Isolation) -> Result:
    return ungradable_result(
        student=hand_in.student,
        answer=hand_in.label,
        answer_sha256="",
        submitted_at=None,
        exercise=exercise.stem,
        attempt=1,
        reason=reason,
        isolation=isolation,
        criteria_sha256=exercise.criteria_sha256,
        max_score=exercise.max_points,
    )
