"""Compare a judgment with the losses that a wrong answer's header declares."""

from workbook.authoring.wrong_answers import Header
from workbook.criteria.runner import CriterionResult
from workbook.exercise.judgement import Judgement
from workbook.feedback.text import as_text

TAKES_POINTS = ("failed", "partial")


def lost(judgement: Judgement) -> set[str]:
    """Return the criteria that took points away."""
    return {result.id for result in judgement.criteria if result.status in TAKES_POINTS}


def first_lost(judgement: Judgement, expected: Header) -> CriterionResult:
    """Return the first lost criterion, except those that the mistake loses only on some machines."""
    costs = (one for one in judgement.criteria if one.id not in expected.also)
    return next(result for result in costs if result.status in TAKES_POINTS)


def feedback_of_first_lost(judgement: Judgement, expected: Header) -> str:
    """Return that criterion's feedback."""
    first = first_lost(judgement, expected)
    return " ".join((first.saw, first.expected, first.because, first.try_this))


def differences(judgement: Judgement, expected: Header) -> list[str]:
    """Return each difference from the header, as one line. Empty if there is none."""
    if judgement.status != "graded":
        return [f"{judgement.status}: {judgement.reason}"]
    if judgement.full_marks:
        return [f"full marks for a wrong answer: {expected.about}"]
    costs = lost(judgement) - expected.also
    if costs != expected.loses:
        return [f"it loses {', '.join(sorted(costs))}, and not {', '.join(sorted(expected.loses))}"]
    found = []
    skipped = {result.id for result in judgement.criteria if result.status == "skipped"}
    if expected.skips is not None and skipped != expected.skips:
        found.append(f"it skips {', '.join(sorted(skipped))}, and not {', '.join(sorted(expected.skips))}")
    said = feedback_of_first_lost(judgement, expected)
    found += [f"{words!r} is not in: {said}" for words in expected.says if words not in said]
    cause = first_lost(judgement, expected).cause
    if cause not in expected.causes:
        found.append(f"the cause is {cause}, and not {' or '.join(sorted(expected.causes))}")
    return found + silent(judgement)


def silent(judgement: Judgement) -> list[str]:
    """Return the criteria that took points away but leave out a part of the feedback."""
    return [
        f"{one.id} leaves out a part of its feedback: {one}"
        for one in judgement.criteria
        if one.status in TAKES_POINTS and not (one.saw and one.expected and one.because and one.try_this)
    ]


def explained(judgement: Judgement) -> str:
    """Return the feedback and the program's log, for a test's failure message."""
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{as_text(judgement)}\n{log}"
