"""The figure as data: turned by its joints, it matches Python's drawing."""

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbook.pictures import humanoid
from workbook.pictures.joints import JOINT_NAMES, NEUTRAL, SWAY, WAVE, checked, skeleton, touching
from workbook.pictures.rig import FACES, description

FIGURE = json.loads(description())


def turned(joints: tuple[str, ...], angles: tuple[float, ...], point: Any) -> Any:
    """Move a point (px) of the figure at rest by the joints, as rig.js does."""
    for joint in reversed(joints):
        index, factor, x, y = FIGURE["turns"][joint]
        angle = factor * angles[int(index)]
        turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        point = np.array([x, y]) + turn @ (np.array(point) - [x, y])
    return point


@settings(max_examples=100, deadline=None)
@given(st.lists(st.floats(-math.pi, math.pi), min_size=12, max_size=12))
def test_the_turned_figure_is_the_drawn_one(numbers: list[float]) -> None:
    angles = checked(numbers)
    placed = [(turned(tuple(one["joints"]), angles, one["at"]), one["reach"]) for one in FIGURE["touching"]]
    up = FIGURE["ground"] - max(point[1] + reach for point, reach in placed)
    shift = np.array([FIGURE["sway"] * math.sin(angles[1]), up])
    for (point, _), (_, drawn, _) in zip(placed, touching(skeleton(angles)), strict=True):
        assert point + shift == pytest.approx(humanoid.on_picture(drawn), abs=0.1)


def test_the_joints_are_those_of_a_message() -> None:
    indices = {name: turn[0] for name, turn in FIGURE["turns"].items() if name in JOINT_NAMES}
    assert indices == {name: index for index, name in enumerate(JOINT_NAMES)}
    assert FIGURE["sway"] == SWAY and FIGURE["neutral"] == list(NEUTRAL)
    assert all(joint in FIGURE["turns"] for part in FIGURE["parts"] for joint in part["joints"])


def test_each_face_has_eyes_a_mouth_and_a_lamp_of_its_own() -> None:
    own = {face: [one for one in FIGURE["parts"] if face in one.get("faces", ())] for face in FACES}
    assert {face: len(parts) for face, parts in own.items()} == {
        "awake": 4,  # lamp, antenna, eyes, mouth; another face may share some
        "operational": 4,
        "error": 4,
        "asleep": 5,  # and the letters while it sleeps
    }
    signs = [one["sign"] for one in FIGURE["parts"] if "sign" in one]
    assert signs == ["heart", "battery", "level", "alarm", "thought"]


def test_all_shapes_are_there(monkeypatch: pytest.MonkeyPatch) -> None:
    shapes = [shape for part in FIGURE["parts"] for shape in part["shapes"]]
    assert {shape["tag"] for shape in shapes} == {"path", "polyline", "ellipse", "rect", "text"}
    assert not [shape for shape in shapes if "nan" in json.dumps(shape).lower()]
    assert len(description()) < 40_000


def test_a_still_is_drawn_by_the_same_parts() -> None:
    names = [part.name for part in humanoid.parts(skeleton(WAVE), None)]
    assert names.count("shin") == names.count("forearm") == 2
    assert names.index("hips") < names.index("chest") < names.index("head") < names.index("eyes")
