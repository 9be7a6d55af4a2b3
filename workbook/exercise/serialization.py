"""Judgements as JSON: how a slot hands them to the grader, and a machine of the farm to another one."""

from typing import Any, NoReturn

from workbook.exercise.judgement import Judgement
from workbook.recording.codec import Malformed, decode, encode


def judgement_to_json(judgement: Judgement) -> dict[str, Any]:
    """Plain data for `json`."""
    data: dict[str, Any] = encode(judgement)
    return data


def judgement_from_json(data: object) -> Judgement:
    """The reverse of `judgement_to_json`. Raises Malformed, which is a ValueError."""
    return decode(Judgement, data)


def judgement_from_afar(data: object, stem: str, answer_sha256: str) -> Judgement:
    """A final judgement of this answer that came from another machine. Every part of it is looked at before it is used.

    Raises ValueError when it is damaged, or is of another answer.
    """
    try:
        judgement = judgement_from_json(data)
    except Malformed as error:
        raise ValueError(f"this is not a judgment: {error}") from error
    if (judgement.stem, judgement.answer_sha256) != (stem, answer_sha256):
        raise ValueError("this is the judgment of another answer")
    if judgement.provisional:
        raise ValueError("this judgment is not final")
    if judgement.status == "graded" and not (judgement.criteria and judgement.recording):
        raise ValueError("a graded answer has criteria and a recording")
    for one in judgement.criteria:
        if not 0.0 <= one.points <= one.max_points:
            raise ValueError(f"{one.id}: {one.points} of {one.max_points} points")
    return judgement


def no_constant(name: str) -> NoReturn:
    """For `json.loads(parse_constant=...)`: NaN and Infinity are not JSON. Raises ValueError."""
    raise ValueError(f"{name} is not a JSON number")
