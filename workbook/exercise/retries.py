"""Which try of an answer counts, and whether there is another one. Whoever judges answers asks here.

- A try without a doubt ends it. There are three tries at most.
- A try that the machine or the judge may have disturbed never counts.
- If the others differ in what the program published, the lowest counts. If they differ only in how the program ended,
  the best one does: a bug in rclpy or Python may have spoiled the other ends.
- If all were disturbed but gave the same, that is no chance, and the last one counts. If they differ, the answer has no
  score: a fault of ours is never a student's zero.

`%check` and `workbook check` differ from graders in one point: where no try counts, they show the last one that was
judged, and its doubt (`until_sure`).
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
    """What counts of some tries, and why as a sentence. `number`: of the try that it is, from 0; None for none of them.

    The sentence is empty for a single try.
    """

    judgement: Judgement
    number: int | None
    why: str = ""


def judge_until_sure(
    jobs: Sequence[Job], judge: JudgeAll[Job]
) -> Iterator[tuple[Job, tuple[Judgement, ...]]]:
    """Judge all; yields each answer with its tries as soon as it is done.

    An answer whose judgement is inconclusive is tried again after all others, when the machine is calmer. If the run is
    stopped before its last try, it is not yielded: the next run judges it from the start.
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


def tries_of(judge: Callable[[], Judgement], report: Report = lambda _: None) -> tuple[Judgement, ...]:
    """Judge one answer, and again as long as that is in doubt. Returns all tries.

    `report` gets each doubtful try that is followed by another one, as provisional.
    """
    tries: tuple[Judgement, ...] = (judge(),)
    while _needs_another(tries):
        report(judgement_as_provisional(tries[-1]))
        tries = (*tries, judge())
    return tries


def until_sure(judge: Callable[[], Judgement], report: Report) -> Judgement:
    """Judge an answer for its author until nothing is in doubt (see `tries_of`). Returns what counts.

    If nothing does, it returns the last try that was judged, with its doubt: students who check their own program want
    to know what was seen.
    """
    tries = tries_of(judge, report)
    found = what_counts(tries)
    if found.number is not None:
        return found.judgement
    return next((one for one in reversed(tries) if one.status == "graded"), tries[-1])


def counting(tries: Sequence[Judgement]) -> Judgement:
    """What counts of some tries."""
    return what_counts(tries).judgement


def what_counts(tries: Sequence[Judgement]) -> Counting:
    """What counts of some tries, and why."""
    if len(tries) == 1:
        return Counting(tries[0], 0)
    sound = [number for number, one in enumerate(tries) if one.status == "graded" and not one.is_disturbed]
    if not sound:
        return _of_disturbed(tries)
    lowest = min(_published(tries[number]) for number in sound)
    low = [number for number in sound if _published(tries[number]) == lowest]
    number = max(low, key=lambda one: (tries[one].score or 0.0, not tries[one].inconclusive_reason, one))
    counts = tries[number]
    if len(sound) == MOST_TRIES:
        counts = replace(counts, inconclusive_reason="", end_only=False)  # what every end shows is no chance
    name = NUMERALS[number]
    if any(_parts(tries[one], at_end=False) != _parts(counts, at_end=False) for one in sound):
        why = (
            f"The {name} one counts, the lowest: what the program did before its end was not always the same."
        )
    elif any(tries[one].score != counts.score for one in sound):
        why = f"The {name} one counts, the best: only the ends of the program differ."
    elif len(sound) < len(tries):
        why = f"The {name} one counts: something other than the program disturbed the rest."
    else:
        why = f"They agree, and the {name} one counts."
    return Counting(counts, number, why)


def _needs_another(tries: Sequence[Judgement]) -> bool:
    """Whether the last try decides nothing. A first one that was not judged at all was tried often enough."""
    failed_later = len(tries) > 1 and tries[-1].status == "infra_error"
    return len(tries) < MOST_TRIES and (bool(tries[-1].inconclusive_reason) or failed_later)


def _of_disturbed(tries: Sequence[Judgement]) -> Counting:
    """What counts where every try was disturbed."""
    last = tries[-1]
    judged = [one for one in tries if one.status == "graded"]
    if len(judged) == MOST_TRIES and len({_parts(one) for one in judged}) == 1:
        return Counting(
            last, len(tries) - 1, "All of them were disturbed, and all gave the same. The last one counts."
        )
    if last.status != "graded":
        return Counting(last, None, "None of them counts.")
    nothing = replace(
        last, status="infra_error", reason=f"inconclusive each time: {last.inconclusive_reason}", criteria=()
    )
    return Counting(
        nothing, None, "None of them counts: something other than the program disturbed each of them."
    )


def _published(judgement: Judgement) -> float:
    """The points for all but the program's end."""
    return round(sum(one.points for one in judgement.criteria if not one.about_end), 6)


def _parts(judgement: Judgement, *, at_end: bool = True) -> tuple[tuple[str, float], ...]:
    """The points by criterion; those about the program's end only where wanted."""
    return tuple((one.id, one.points) for one in judgement.criteria if at_end or not one.about_end)
