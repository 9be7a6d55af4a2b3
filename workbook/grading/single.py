"""Grade a single hand-in, for systems that start a new judge for each submission."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from workbook.exercise.answers import Ungradable, read_answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import judge_until_sure
from workbook.grading.hand_ins import HandIn
from workbook.grading.judges import Job
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.results import Result
from workbook.grading.slots.scheduler import judge_all
from workbook.grading.tier_check import tier_problem
from workbook.isolation.bubblewrap import NoSandbox
from workbook.isolation.tiers import BEST_FIRST, Isolation, named_tier


def best_isolation() -> Isolation:
    """Return the strongest isolation tier that works on this machine."""
    return next((tier for tier in BEST_FIRST if tier_problem(tier) is None), "limits")


def choose_isolation(wanted: str) -> Isolation:
    """Return the isolation tier to use: for "auto", the strongest that works, or else the requested one.

    Raises NoSandbox if the requested tier doesn't work on this machine.
    """
    if wanted == "auto":
        return best_isolation()
    isolation = named_tier(wanted)
    problem = tier_problem(isolation)
    if problem is not None:
        raise NoSandbox(f"programs cannot be isolated like this on this machine: {problem}")
    return isolation


def grade_one(exercise: Exercise, hand_in: HandIn, out: Path, isolation: Isolation) -> Result:
    """Grade one hand-in, and store recordings under `out`. If it can't be judged, the result contains the reason."""
    by = GradedBy(exercise, isolation, out)
    try:
        if hand_in.problem is not None:
            raise Ungradable(hand_in.problem)
        answer = read_answer(hand_in.path, exercise.stem)
    except (Ungradable, OSError) as error:
        return ungradable_result(Submission(hand_in.student, hand_in.label, ""), str(error), by)

    def judge(jobs: Sequence[Job[HandIn]]) -> Iterator[tuple[Job[HandIn], Judgement]]:
        return judge_all(jobs, 1, isolation=isolation)

    for _, tries in judge_until_sure([Job(hand_in, exercise.stem, answer)], judge):
        return graded_result(
            Submission(hand_in.student, hand_in.label, answer.sha256, note=answer.note), tries, by
        )
    raise RuntimeError("the judge returned no judgment")
