"""Convert judgments to JSON and back.

Slots (the warm processes that judge) send judgments to the process that started them, and the machines of a farm send
judgments to each other.
"""

from typing import Any, NoReturn

from workbook.exercise.judgement import Judgement
from workbook.recording.codec import Malformed, decode, encode


def judgement_to_json(judgement: Judgement) -> dict[str, Any]:
    """Convert a judgment to plain data for `json`."""
    data: dict[str, Any] = encode(judgement)
    return data


def judgement_from_json(data: object) -> Judgement:
    """Convert `judgement_to_json`'s output back to a judgment. Raises Malformed (a ValueError) for other data."""
    return decode(Judgement, data)


def judgement_from_afar(data: object, stem: str, answer_sha256: str) -> Judgement:
    """Return another machine's final judgment of this answer, after checking each part.

    Raises ValueError if the judgment is damaged, or belongs to another answer.
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
    """Reject NaN and Infinity in `json.loads(parse_constant=...)`, because they aren't JSON. Raises ValueError."""
    raise ValueError(f"{name} is not a JSON number")
