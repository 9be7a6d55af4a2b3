"""The inputs for exercise 16, in each of twenty runs.

The given model is right about every image, and raises only in glare. The robot jolts, leans, and falls as the task
says.
"""

from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from tests.exercises.proofs import SEEDS
from workbook.criteria import camera_image
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.models import DeskDetector
from workbook.models.slow import SlowDetector

STEM = "16_ai_model"
EVERY = 10
"""Check only every tenth image. Three per second are enough, because the runs differ."""


@cache
def judge() -> dict[str, Any]:
    """Return the names that the criteria file defines."""
    return load_exercise(STEM, course_folder()).criteria[-1].judge.__globals__


@pytest.fixture(scope="module")
def model() -> DeskDetector:
    return DeskDetector()


@pytest.fixture(params=range(SEEDS))
def run(request: pytest.FixtureRequest) -> Any:
    """Return what a program receives in one run."""
    return judge()["drawn"](request.param)


def pixels(run: Any, place: int) -> npt.NDArray[np.uint8]:
    """Return an image's pixels as the camera sends them: BGR."""
    fields = camera_image(run.views[place])
    return np.frombuffer(fields["data"], np.uint8).reshape(fields["height"], fields["width"], 3)


def without_glare(run: Any) -> list[int]:
    return [place for place in range(0, len(run.views), EVERY) if place not in run.in_glare]


def is_right(run: Any, place: int, found: list[Any]) -> bool:
    names = judge()
    toys = [names["Toy"](one.label, one.u, one.v) for one in found]
    right: bool = names["Message"](run, place, toys).is_right
    return right


def test_the_model_is_right_in_every_picture(run: Any, model: DeskDetector) -> None:
    wrong = [p for p in without_glare(run) if not is_right(run, p, model(pixels(run, p)[:, :, ::-1]))]
    assert wrong == []


def test_with_red_and_blue_exchanged_it_is_wrong_in_every_picture(run: Any, model: DeskDetector) -> None:
    assert [p for p in without_glare(run) if is_right(run, p, model(pixels(run, p)))] == []


def test_it_raises_in_glare_and_in_no_other_picture(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(SlowDetector, "LOADING_S", 0.0)
    monkeypatch.setattr(SlowDetector, "SECONDS", 0.0)
    slow = SlowDetector()
    edges = [place for glare in run.glare_s for at in glare for place in [round(30 * at)]]
    for place in sorted({*edges, *(edge - 1 for edge in edges), *without_glare(run)[::3]}):
        if place not in run.in_glare:
            slow(pixels(run, place)[:, :, ::-1])
            continue
        with pytest.raises(RuntimeError, match=r"^glare: "):
            slow(pixels(run, place)[:, :, ::-1])
    assert len(run.in_glare) == 36  # the task says: for 1.2 s


def tilts(run: Any) -> list[float]:
    """Return how far the robot is tilted (°) according to each sample."""
    ups = [sample["linear_acceleration"] for _, sample in run.samples]
    return [float(np.degrees(np.arctan2(np.hypot(up["x"], up["y"]), up["z"]))) for up in ups]


def test_a_fall_is_the_tenth_tilted_sample_in_a_row_and_no_jolt_is_one(run: Any) -> None:
    names, in_a_row, most = judge(), 0, 0
    for number, tilt in enumerate(tilts(run)):
        in_a_row = in_a_row + 1 if tilt > names["TILT_DEG"] else 0
        if in_a_row >= names["TILTED_SAMPLES"]:
            assert number == run.fall_sample
            break
        most = max(most, in_a_row)
    assert in_a_row == names["TILTED_SAMPLES"] and most == names["TILTED_SAMPLES"] - 1


def test_what_happens_is_far_enough_apart_to_tell_mistakes_from_each_other(run: Any) -> None:
    what, names = run, judge()
    (first, first_end), (second, second_end) = what.glare_s
    leans, fall = what.leaning.first / 50, what.fall.first / 50
    jolted = max(jolt.end for jolt in what.jolts if jolt.end < what.leaning.first) / 50
    assert jolted < first and first_end + 0.3 < leans and what.leaning.end / 50 + 0.35 < second
    assert fall - second_end > 0.85 and 2.5 < second - first < 4.7
    assert second_end + names["PAUSE_S"] + 1.2 < names["IMU_SECONDS"]
    assert names["IMU_SECONDS"] - fall > 2.2
    alone = tilts(run)[what.leaning.first : what.jolts[2].first]
    assert len(alone) > names["TILTED_SAMPLES"] and max(alone) < names["TILT_DEG"]
    ups = [sample["linear_acceleration"] for _, sample in run.samples[what.fall.first : what.fall.end]]
    forward = np.degrees([np.arctan2(abs(up["x"]), up["z"]) for up in ups])
    left = np.degrees([np.arctan2(abs(up["y"]), up["z"]) for up in ups])
    for one_axis in forward, left:
        assert not any(np.all(one_axis[n : n + 10] > 60.0) for n in range(len(one_axis) - 9))


def test_no_moment_suits_the_fall_of_many_runs() -> None:
    falls = [judge()["drawn"](seed).fall for seed in range(SEEDS)]
    spans = [(one.first / 50, (one.first + 9) / 50 + judge()["FALL_WITHIN_S"]) for one in falls]
    assert max(sum(begin <= at <= end for begin, end in spans) for at, _ in spans) <= SEEDS * 0.4


def test_the_glare_the_lean_and_the_jolts_are_those_that_the_task_and_the_feedback_tell(run: Any) -> None:
    assert sum(end - begin for begin, end in run.glare_s) == pytest.approx(1.2)
    assert (run.leaning.deg, run.fall.deg) == (55.0, 65.0)
    first, second = run.jolts[-2:]
    assert (second.count, second.first - first.end) == (9, 6)
