"""Judgements as JSON, so that a slot can hand them to whoever asked, and another machine, too."""

from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judging import Judgement
from workbook.exercise.shape import check_shape
from workbook.observing.recording import Recording


def _criterion(data: Mapping[str, Any]) -> CriterionResult:
    fields = dict(data)
    fields["try_this"] = fields.pop("try")
    return CriterionResult(**fields)


def criteria_from_json(items: Sequence[Mapping[str, Any]]) -> tuple[CriterionResult, ...]:
    """The judged criteria of a result or a judgement."""
    return tuple(map(_criterion, items))


def judgement_to_json(judgement: Judgement) -> dict[str, Any]:
    """Plain data for `json`."""
    return {
        "stem": judgement.stem,
        "answer_sha256": judgement.answer_sha256,
        "status": judgement.status,
        "reason": judgement.reason,
        "criteria": [
            {**result.to_json(), "about_time": result.about_time, "garbled": result.garbled}
            for result in judgement.criteria
        ],
        "recording": None if judgement.recording is None else judgement.recording.to_json(),
        "provisional": judgement.provisional,
        "watched_real_life": judgement.watched_real_life,
        "doubt": judgement.doubt,
    }


def judgement_from_json(data: Mapping[str, Any]) -> Judgement:
    """The reverse of `judgement_to_json`."""
    recording = data["recording"]
    return Judgement(
        stem=data["stem"],
        answer_sha256=data["answer_sha256"],
        status=data["status"],
        reason=data["reason"],
        criteria=criteria_from_json(data["criteria"]),
        recording=None if recording is None else Recording.from_json(recording),
        provisional=data["provisional"],
        watched_real_life=data["watched_real_life"],
        doubt=data["doubt"],
    )


def judgement_from_afar(data: object, stem: str, answer_sha256: str) -> Judgement:
    """A final judgement of this answer that came from another machine. Every part of it is looked at before it is used.

    Raises ValueError when it is damaged, or is of another answer.
    """
    try:
        judgement = judgement_from_json(data)  # type: ignore[arg-type]
    except (LookupError, TypeError, AttributeError) as error:
        raise ValueError(f"this is no judgement: {error!r:.200}") from error
    check_shape(judgement, Judgement, "judgement")
    if (judgement.stem, judgement.answer_sha256) != (stem, answer_sha256):
        raise ValueError("this is the judgement of another answer")
    if judgement.provisional:
        raise ValueError("this judgement is not final")
    if judgement.status == "graded" and not (judgement.criteria and judgement.recording):
        raise ValueError("a graded answer has criteria and a recording")
    for one in judgement.criteria:
        if not 0.0 <= one.points <= one.max_points:
            raise ValueError(f"{one.id}: {one.points} of {one.max_points} points")
    return judgement


def no_constant(name: str) -> NoReturn:
    """For `json.loads(parse_constant=...)`: NaN and Infinity are no JSON. Raises ValueError."""
    raise ValueError(f"{name} is no number of JSON")
