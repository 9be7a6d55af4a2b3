"""Judgements as JSON, so that a slot can hand them to whoever asked."""

from collections.abc import Mapping, Sequence
from typing import Any

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judging import Judgement
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
