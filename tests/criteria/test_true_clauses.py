"""Not only the cause in the feedback is true: an end is named first, and messages really "kept arriving" on topics."""

import re
from dataclasses import replace
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.criteria.any_recording import ROOT, right
from workbook.criteria.runner import CriterionResult, run_criteria
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import stems
from workbook.recording.recording import Recording

STEMS = stems(ROOT / "solutions")
FIRST_THIRTEEN = STEMS[:13]
MOMENTS = (0.05, 0.2, 0.4, 0.6, 0.8, 0.95)
ERROR = "ValueError: out of patience"
LOG = f'Traceback (most recent call last):\n  File "answer.py", line 30, in on_timer\n{ERROR}\n'
ENDS = {
    "exit": {"exit": 0},
    "error": {"exit": 1, "log": LOG},
    "crash": {"exit": None, "signal": "SIGSEGV"},
}
WENT_ON = re.compile(r"while messages kept arriving on ([^;]+)")
NOTHING_EITHER = re.compile(r"; ([^;]+) carried no messages after that, either")
ALL_STOPPED = re.compile(r"the last message on (.+?) arrived at ([\d.]+) s")


def ended(recording: Recording, moment: float, how: dict[str, object]) -> Recording:
    """Return the recording as if the program had ended at this time (s, simulated)."""
    came = [one for topic in recording.topics.values() for one in topic.arrivals]
    events = [*came, *recording.calls, *recording.published]
    wall = max((one.wall for one in events if one.t <= moment), default=0.3) + 0.01
    topics = {
        name: replace(
            topic,
            arrivals=tuple(one for one in topic.arrivals if one.t <= moment),
            publishers=tuple(replace(one, last_seen=moment) for one in topic.publishers),
        )
        for name, topic in recording.topics.items()
    }
    calls = tuple(
        call
        if call.answered_t is not None and call.answered_t <= moment
        else replace(call, response=None, answered_t=None, answered_wall=None)
        for call in recording.calls
        if call.t <= moment or call.by == "judge"
    )
    process = replace(recording.process, ended_by="itself", ended_at=wall, end_log="", **how)
    return replace(recording, topics=topics, calls=calls, process=process)


def lost(stem: str, recording: Recording) -> list[CriterionResult]:
    results = run_criteria(load_exercise(stem, ROOT).criteria, recording)
    return [one for one in results if one.status in ("failed", "partial")]


@pytest.mark.parametrize("how", ENDS)
@pytest.mark.parametrize("stem", FIRST_THIRTEEN)
def test_the_end_of_a_program_is_named_before_its_consequences(stem: str, how: str) -> None:
    whole = right(stem)
    for share in MOMENTS:
        points_lost = lost(stem, ended(whole, share * whole.watched_s, ENDS[how]))
        if points_lost:
            first = points_lost[0]
            assert "ended" in f"{first.cause} {first.saw}" or ERROR in first.saw, (share, first)


def stopped(recording: Recording, random: Random) -> Recording:
    """Return the recording as if each topic had never begun, had stopped at a random time, or had gone on."""
    topics = {}
    for name, topic in recording.topics.items():
        until = random.choice((0.0, random.uniform(0.0, recording.watched_s), recording.watched_s))
        topics[name] = replace(topic, arrivals=tuple(one for one in topic.arrivals if one.t <= until))
    until = random.uniform(0.0, recording.watched_s)
    calls = tuple(call for call in recording.calls if call.by == "judge" or call.t <= until)
    return replace(recording, topics=topics, calls=calls)


def names(text: str) -> list[str]:
    return re.findall(r"/[\w/]+", text)


@pytest.mark.parametrize("stem", STEMS)
@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=15)
def test_what_went_on_or_stopped_as_well_did_so(stem: str, seed: int) -> None:
    recording = stopped(right(stem), Random(seed))
    for result in lost(stem, recording):
        for name in (name for found in WENT_ON.findall(result.saw) for name in names(found)):
            times = [one.t for one in recording.topic(name).arrivals]
            pauses = [after - before for before, after in zip(times, times[1:], strict=False)]
            silence = re.search(r"a gap of ([\d.]+) s starting at ([\d.]+) s", result.saw)
            if silence is None:
                assert recording.watched_s - times[-1] <= 2.5 * max(pauses) + 0.3, result.saw
            else:
                begin = float(silence[2])
                assert any(begin < t < begin + float(silence[1]) for t in times), result.saw
        last = re.search(r"arrived at ([\d.]+) s, then nothing", result.saw)
        for found in NOTHING_EITHER.findall(result.saw):
            late = [one.t for name in names(found) for one in recording.topic(name).arrivals]
            assert last is None or not any(t > float(last[1]) + 0.051 for t in late), result.saw
        for found, at in ALL_STOPPED.findall(result.saw):
            late = [one.t for name in names(found) for one in recording.topic(name).arrivals]
            assert max(late) <= float(at) + 0.051, result.saw
