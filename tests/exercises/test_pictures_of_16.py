"""The pictures that exercise 16 is judged by: the given model is right in each of them, and raises in glare alone."""

from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from workbook.criteria import camera_image
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.models import DeskDetector
from workbook.models.slow import SlowDetector

STEM = "16_ai_model"
EVERY = 3
"""Of thirty pictures a second, ten are enough."""


@cache
def judge() -> dict[str, Any]:
    """The names of the criteria file."""
    return load_exercise(STEM, course_folder()).criteria[-1].judge.__globals__


def pixels(place: int) -> npt.NDArray[np.uint8]:
    """A picture as the camera sends it: BGR."""
    fields = camera_image(judge()["VIEWS"][place])
    return np.frombuffer(fields["data"], np.uint8).reshape(fields["height"], fields["width"], 3)


def wrong(in_rgb: bool) -> list[int]:
    """The pictures in which the model is wrong, among those without glare."""
    model, names = DeskDetector(), judge()
    found = []
    for place in range(0, names["PICTURES"], EVERY):
        if place in names["IN_GLARE"]:
            continue
        seen = model(pixels(place)[:, :, ::-1] if in_rgb else pixels(place))
        toys = tuple(names["Toy"](one.label, one.u, one.v) for one in seen)
        if not names["is_right"](place, names["Answered"](place, (), toys, 0.0)):
            found.append(place)
    return found


def test_the_model_is_right_in_every_picture() -> None:
    assert wrong(in_rgb=True) == []


def test_with_red_and_blue_exchanged_it_is_wrong_in_every_picture() -> None:
    assert len(wrong(in_rgb=False)) == len(range(0, judge()["PICTURES"], EVERY)) - len(
        [place for place in judge()["IN_GLARE"] if place % EVERY == 0]
    )


def test_it_raises_in_glare_and_in_no_other_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(SlowDetector, "LOADING_S", 0.0)
    monkeypatch.setattr(SlowDetector, "SECONDS", 0.0)
    model, names = SlowDetector(), judge()
    for place in range(0, names["PICTURES"], EVERY):
        if place not in names["IN_GLARE"]:
            model(pixels(place)[:, :, ::-1])
            continue
        with pytest.raises(RuntimeError, match=r"^glare: "):
            model(pixels(place)[:, :, ::-1])


def test_a_fall_is_the_tenth_tilted_sample_in_a_row_and_no_jolt_is_one() -> None:
    names = judge()
    in_a_row = 0
    for number, (_, sample) in enumerate(names["SAMPLES"]):
        up = sample["linear_acceleration"]
        tilt = np.degrees(np.arctan2(np.hypot(up["x"], up["y"]), up["z"]))
        in_a_row = in_a_row + 1 if tilt > names["TILT_DEG"] else 0
        if in_a_row >= names["TILTED_SAMPLES"]:
            assert number == names["FALL_SAMPLE"]
            return
    pytest.fail("it never falls")
