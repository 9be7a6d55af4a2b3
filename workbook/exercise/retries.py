"""Decide which try of an answer counts, and whether to try again, for both `%check` and `workbook grade`.

- A conclusive try ends the series. There are at most three tries.
- An inconclusive try, in which the machine or the judge may have cost points, doesn't count.
- If the other tries differ in the points for what the program published, the lowest counts. If they differ only in the
  points for the program's exit, the best counts, because rclpy or Python may have spoiled the others.
- If all tries were inconclusive but gave the same result, that's no coincidence, so the last one counts. If they
  differ, the answer has no score, because our own fault must never become a student's zero.

`%check` and `workbook check` differ from `workbook grade` in one way. If no try counts, they show the last one that was
judged, and why it's inconclusive (`until_sure`).
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from workbook.exercise.judgement import Judgement, Report, judgement_as_provisional

MOST_TRIES = 3
NUMERALS = ("first", "second", "third")
Job = TypeVar("Job")
JudgeAll = Callable[[Sequence[Job]], Iterator[tuple[Job, Judgement]]]


@dataclass(frozen=True)
class Counting:
    """The judgment that counts among some tries, and why, as a sentence.

    `number`: the index of the try that counts (the first try has index 0), or None if no try counts. The sentence is
    empty for a single try.
    """

    judgement: Judgement
    number: int | None
    why: str = ""


def judge_until_sure(
    jobs: Sequence[Job], judge: JudgeAll[Job]
) -> Iterator[tuple[Job, tuple[Judgement, ...]]]:
    """Judge all answers. Yield each job with its tries as soon as no other try is needed.

    An answer whose judgment is inconclusive is tried again after all others, when the machine is less busy. If the
    instructor stops the run before an answer's last try, that answer isn't yielded, so the next run judges it from the
    start.
    """
    waiting = list(jobs)
    before: dict[int, tuple[Judgement, ...]] = {}
    while waiting:
        again: list[tuple[Job, tuple[Judgement, ...]]] = []
        for job, judgement in judge(waiting):
            tries = (*before.get(id(job), ()), judgement)
            if _needs_another(tries):
                again.append((job, tries))
            else:
                yield job, tries
        waiting = [job for job, _ in again]
        before = {id(job): tries for job, tries in again}


def tries_of(
    judge: Callable[[], Judgement],
    report: Report = lambda _: None,
    stop: Callable[[], bool] = lambda: False,
) -> tuple[Judgement, ...]:
    """Judge one answer, and judge it again while the judgment is inconclusive. Return all tries.

    If another try follows, `report` is called with the inconclusive judgment, marked as provisional. `stop` is called
    before each further try, and returns whether to give up.
    """
    tries: tuple[Judgement, ...] = (judge(),)
    while _needs_another(tries) and not stop():
        report(judgement_as_provisional(tries[-1]))
        tries = (*tries, judge())
    return tries


def until_sure(
    judge: Callable[[], Judgement], report: Report, stop: Callable[[], bool] = lambda: False
) -> Judgement:
    """Judge an answer for its author until a try is conclusive (see `tries_of`). Return the judgment that counts.

    If none counts, return the last try that was judged, so that students still see what their program did.
    """
    tries = tries_of(judge, report, stop)
    found = what_counts(tries)
    if found.number is not None:
        return found.judgement
    return next((one for one in reversed(tries) if one.status == "graded"), tries[-1])


def counting(tries: Sequence[Judgement]) -> Judgement:
    """Return the judgment that counts among some tries."""
    return what_counts(tries).judgement


def what_counts(tries: Sequence[Judgement]) -> Counting:
    """Return the judgment that counts among some tries, and why."""
    if len(tries) == 1:
        return Counting(tries[0], 0)
    sound = [number for number, one in enumerate(tries) if one.status == "graded" and not one.is_inconclusive]
    if not sound:
        return _of_inconclusive(tries)
    lowest = min(_published(tries[number]) for number in sound)
    low = [number for number in sound if _published(tries[number]) == lowest]
    number = max(low, key=lambda one: (tries[one].score or 0.0, not tries[one].inconclusive_reason, one))
    counts = tries[number]
    if len(sound) == MOST_TRIES:
        counts = replace(counts, inconclusive_reason="", end_only=False)  # what every try shows isn't chance
    name = NUMERALS[number]
    if any(_parts(tries[one], at_end=False) != _parts(counts, at_end=False) for one in sound):
        why = (
            f"The {name} one counts, because it is the lowest: before its end, the program didn't always behave in the "
            "same way."
        )
    elif any(tries[one].score != counts.score for one in sound):
        why = (
            f"The {name} one counts, because it is the best: the tries differ only in how the program ended."
        )
    elif len(sound) < len(tries):
        why = f"The {name} one counts: something other than the program disturbed the rest."
    else:
        why = f"They agree, and the {name} one counts."
    return Counting(counts, number, why)


def _needs_another(tries: Sequence[Judgement]) -> bool:
    """Return whether another try is needed, because the last one didn't decide anything.

    If the first try couldn't be judged at all, no other try follows, because the judge has already made enough
    attempts.
    """
    failed_later = len(tries) > 1 and tries[-1].status == "infra_error"
    return len(tries) < MOST_TRIES and (bool(tries[-1].inconclusive_reason) or failed_later)


def _of_inconclusive(tries: Sequence[Judgement]) -> Counting:
    """Return the judgment that counts if every try was inconclusive."""
    last = tries[-1]
    judged = [one for one in tries if one.status == "graded"]
    if len(judged) == MOST_TRIES and len({_parts(one) for one in judged}) == 1:
        return Counting(
            last,
            len(tries) - 1,
            "All of them were disturbed, but all gave the same result. The last one counts.",
        )
    if last.status != "graded":
        return Counting(last, None, "None of them counts.")
    nothing = replace(
        last, status="infra_error", reason=f"inconclusive each time: {last.inconclusive_reason}", criteria=()
    )
    return Counting(
        nothing, None, "None of them counts: something other than the program disturbed each try."
    )


def _published(judgement: Judgement) -> float:
    """Return the points, except those for how the program exits."""
    return round(sum(one.points for one in judgement.criteria if not one.about_end), 6)


def _parts(judgement: Judgement, *, at_end: bool = True) -> tuple[tuple[str, float], ...]:
    """Return the points by criterion. `at_end`: whether to include the criteria about the program's exit."""
    return tuple((one.id, one.points) for one in judgement.criteria if at_end or not one.about_end)
