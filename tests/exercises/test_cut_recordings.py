"""Exercises 14 to 16 on shortened recordings of right answers: the program ends early, or the watch does."""

from dataclasses import replace

import pytest

from tests.criteria.any_recording import ROOT, right
from workbook.criteria.runner import CriterionResult, run_criteria
from workbook.exercise.definition import load_exercise
from workbook.exercise.inconclusive import find_inconclusive_reason
from workbook.recording.recording import Recording

STEMS = ("14_arrays_and_filters", "15_camera", "16_ai_model")
ENDED = "ended"


def cut(recording: Recording, share: float) -> Recording:
    """Return the recording as if the watch had ended after this share of its script."""
    until = share * recording.published[-1].t
    topics = {
        name: replace(
            topic,
            arrivals=tuple(one for one in topic.arrivals if one.t < until),
            window=None if topic.window is None else (topic.window[0], until),
        )
        for name, topic in recording.topics.items()
    }
    return replace(
        recording,
        topics=topics,
        published=tuple(one for one in recording.published if one.t < until),
        unpublished=tuple(one for one in recording.published if one.t >= until),
        watched_s=until,
    )


def ended(recording: Recording, share: float) -> Recording:
    """Return the process as if the program had ended by itself, with exit code 0."""
    seen = cut(recording, share)
    end = max(arrival.wall for topic in seen.topics.values() for arrival in topic.arrivals) + 0.05
    topics = {
        name: replace(topic, publishers=tuple(replace(one, last_seen=end) for one in topic.publishers))
        for name, topic in seen.topics.items()
    }
    process = replace(seen.process, ended_by="itself", exit=0, ended_at=end, end_log="")
    return replace(seen, topics=topics, process=process)


def judged(stem: str, recording: Recording) -> list[CriterionResult]:
    return list(run_criteria(load_exercise(stem, ROOT).criteria, recording))


@pytest.mark.parametrize("share", [0.15, 0.3, 0.5, 0.7])
@pytest.mark.parametrize("stem", STEMS)
def test_the_end_of_a_program_is_named_before_its_consequences(stem: str, share: float) -> None:
    lost = [one for one in judged(stem, ended(right(stem), share)) if one.status == "failed"]
    assert lost
    told = {one.id: (one.cause, one.saw) for one in lost if ENDED not in one.saw}
    assert told == {}


@pytest.mark.parametrize("share", [0.3, 0.6, 0.9])
@pytest.mark.parametrize("stem", STEMS)
def test_full_marks_from_a_watch_that_was_cut_short_are_not_final(stem: str, share: float) -> None:
    exercise, seen = load_exercise(stem, ROOT), cut(right(stem), share)
    results = judged(stem, seen)
    full = all(one.status == "passed" for one in results)
    assert not full or find_inconclusive_reason(results, seen, exercise.plan, exercise.periods).reason
