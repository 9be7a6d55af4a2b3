"""Exercises 10 and 11 tell the tolerances that they apply: the numbers of the criteria stand in the task."""

from types import ModuleType

from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.recording.script import Publishes

ROOT = course_folder()


def task_of(stem: str) -> str:
    """The text of the task, as one line."""
    text = (ROOT / "solutions" / f"{stem}.py").read_text(encoding="utf-8").split("# %% [answer]")[0]
    return " ".join(text.replace("\n# ", " ").split())


def constants_of(stem: str) -> ModuleType:
    """The module of the criteria."""
    exercise = load_exercise(stem, ROOT)
    module = ModuleType(stem)
    module.__dict__.update(exercise.criteria[-1].judge.__globals__)
    return module


def lines_of(stem: str) -> int:
    """How many messages the judge sends."""
    [part] = load_exercise(stem, ROOT).plan.script.parts
    assert isinstance(part, Publishes)
    return len(part.lines)


def test_10_tells_its_tolerances() -> None:
    task, judged = task_of("10_slow_callbacks"), constants_of("10_slow_callbacks")
    low, high = judged.TYPICALLY_S
    for told in (
        f"{judged.LEAST_SHARE * 100:.0f} % to {judged.MOST_SHARE * 100:.0f} % of the heartbeats come",
        f"typically there are {low} to {high} s between two",
        f"never more than {judged.LONGEST_SILENCE_S} s without a heartbeat",
        f"to {judged.TOLERANCE_RAD:.6f} rad",
        f"comes {judged.SOONEST_S} s after its request, or later",
    ):
        assert told in task
    words = {5: "the mean over five", 7: "seven requests", 9.0: "nine real seconds"}
    for number in (judged.AVERAGED, lines_of("10_slow_callbacks"), judged.WATCH_S):
        assert words[number] in task


def test_11_tells_its_tolerances() -> None:
    task, judged = task_of("11_polling_against_callbacks"), constants_of("11_polling_against_callbacks")
    for told in (
        f"are reported within {judged.ALONE_MS:g} ms",
        f"half within {judged.TOGETHER_MS:g} ms",
        f"less than {judged.PROCESSOR_SHARE * 100:g} % of a processor",
        f"publishes {lines_of('11_polling_against_callbacks')} touches",
    ):
        assert told in task
    assert {0.75: "three in four"}[judged.ALONE_SHARE] in task
    assert {9.0: "for nine seconds"}[judged.WATCH.wall_seconds] in task
