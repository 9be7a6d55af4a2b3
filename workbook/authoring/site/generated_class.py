"""Generate grading results for a class of forty students from stored recordings, some of which are modified."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import cycle
from pathlib import Path

from workbook.exercise.course import course_folder
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import judge_recording
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.results import Result
from workbook.recording.recording import Recording, TopicRecording

STEM = "09_joint_positions"
SIZE = 40
JOINTS, STATUS = "/robot/joint_positions", "/robot/status"
REASON = "this machine was so busy that the judge itself had to wait for 0.80 s"
NAMES = (
    "Ada Lovelace", "Grace Hopper", "Katherine Johnson", "Emmy Noether", "Hedy Lamarr", "Joan Clarke",
    "Radia Perlman", "Mary Jackson", "Annie Easley", "Evelyn Boyd Granville", "نور الهاشمي", "王小明", "<b>Bobby</b>",
    "Maximiliana-Theodora von Hohenfels-Schwarzenberg",
)  # fmt: skip
Change = Callable[[Recording], Recording]


def _with_topic(name: str, change: Callable[[TopicRecording], TopicRecording]) -> Change:
    def changed(recording: Recording) -> Recording:
        topics = dict(recording.topics)
        topics[name] = change(topics[name])
        return replace(recording, topics=topics)

    return changed


def _faster(name: str, times: int) -> Change:
    """Return a change that multiplies a topic's messages by `times` in the same time span."""

    def change(topic: TopicRecording) -> TopicRecording:
        arrivals = [
            replace(one, t=one.t + part * 2.0 / times, wall=one.wall + part * 0.1 / times)
            for one in topic.arrivals
            for part in range(times)
        ]
        return replace(topic, arrivals=tuple(arrivals))

    return _with_topic(name, change)


def _silent_after(name: str, seconds: float) -> Change:
    return _with_topic(
        name, lambda topic: replace(topic, arrivals=tuple(one for one in topic.arrivals if one.t < seconds))
    )


KINDS: tuple[tuple[str, Change], ...] = (
    ("solution", lambda recording: recording),
    ("period_for_frequency", lambda recording: recording),
    ("wrong_name", lambda recording: recording),
    ("solution", lambda recording: recording),
    ("solution", _faster(JOINTS, 4)),
    ("eleven_values", lambda recording: recording),
    ("solution", lambda recording: recording),
    ("starter", lambda recording: recording),
    ("solution", _silent_after(STATUS, 5.0)),
    ("raises_at_once", lambda recording: recording),
    ("eleven_values", _faster(JOINTS, 198)),
    ("solution", lambda recording: recording),
    ("solution", _silent_after(JOINTS, 8.0)),
)


def generated_class(exercise: Exercise, out: Path) -> Iterator[Result]:
    """Yield forty results and store their recordings under `out`.

    Three answers weren't graded; two were judged twice.
    """
    by = GradedBy(exercise, "sandbox", out)
    for number, name, (recording, change) in zip(range(SIZE - 1), cycle(NAMES), cycle(KINDS), strict=False):
        student = name if number < len(NAMES) else f"{name} {number // len(NAMES) + 1}"
        submission = Submission(student, f"answers/{number}.py", "a" * 64, "2026-03-01T10:00:00Z")
        if number % 17 == 16:
            yield ungradable_result(submission, "line 3: SyntaxError: '(' was never closed", by)
            continue
        stored = change(Recording.load(course_folder() / "tests" / "recordings" / STEM / f"{recording}.json"))
        judgement = judge_recording(exercise, "a" * 64, stored)
        tries = [judgement]
        if number % 20 == 5:
            inconclusive = replace(judgement, inconclusive_reason=REASON)
            tries = [inconclusive, inconclusive]
        yield graded_result(submission, tries, by)
    yield ungradable_result(Submission("Zuse", "answers/zuse.py", ""), "the file is empty", by)
