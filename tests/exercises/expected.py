"""What a wrong answer must lose, as its header says, compared with a judgement."""

from workbook.authoring.wrong_answers import Header
from workbook.criteria.runner import CriterionResult
from workbook.exercise.judgement import Judgement
from workbook.feedback.text import as_text

TAKES_POINTS = ("failed", "partial")


def lost(judgement: Judgement) -> set[str]:
    """The criteria that took points away."""
    return {result.id for result in judgement.criteria if result.status in TAKES_POINTS}


def first_lost(judgement: Judgement, expected: Header) -> CriterionResult:
    """The first lost criterion, of those that the mistake costs on any machine."""
    costs = (one for one in judgement.criteria if one.id not in expected.also)
    return next(result for result in costs if result.status in TAKES_POINTS)


def told(judgement: Judgement, expected: Header) -> str:
    """What that criterion says."""
    first = first_lost(judgement, expected)
    return " ".join((first.saw, first.expected, first.because, first.try_this))


def differences(judgement: Judgement, expected: Header) -> list[str]:
    """What is not as the header says, in a line each. Empty if all is."""
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
    said = told(judgement, expected)
    found += [f"{words!r} is not in: {said}" for words in expected.says if words not in said]
    cause = first_lost(judgement, expected).cause
    if cause not in expected.causes:
        found.append(f"the cause is {cause}, and not {' or '.join(sorted(expected.causes))}")
    return found + silent(judgement)


def silent(judgement: Judgement) -> list[str]:
    """Criteria that took points and leave a part of the feedback out."""
    return [
        f"{one.id} leaves out a part of its feedback: {one}"
        for one in judgement.criteria
        if one.status in TAKES_POINTS and not (one.saw and one.expected and one.because and one.try_this)
    ]


def explained(judgement: Judgement) -> str:
    """The feedback and what the program printed, for the message of a test."""
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{as_text(judgement)}\n{log}"
