"""The path of a robot that follows commands, and the drawing of the layers."""

import math
from typing import Any

import pytest

from workbook.pictures import path
from workbook.pictures.figures import render
from workbook.pictures.layers import LAYERS, layers
from workbook.pictures.path import path_of, show_path


def twist(forward_mps: float, turn_radps: float) -> dict[str, dict[str, float]]:
    return {"linear": {"x": forward_mps}, "angular": {"z": turn_radps}}


def test_straight_on_is_along_x() -> None:
    xs, ys = path_of([twist(0.5, 0.0)] * 10)
    assert ys == pytest.approx([0.0] * 11)
    assert xs[-1] == pytest.approx(0.5)


def test_x_points_up_the_page_and_y_to_the_left(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[Any] = []
    monkeypatch.setattr(path, "show", lambda fig, description: shown.append(fig))
    show_path(([0.0, 1.0], [0.0, 0.5]), "half a meter to the left, and one forward")
    [axes] = shown[0].axes
    start, end = axes.transData.transform([(0.0, 0.0), (0.5, 1.0)])
    assert end[0] < start[0]
    assert end[1] > start[1]
    assert axes.get_ylabel().startswith("x, forward")


def test_a_turn_to_the_left_is_a_circle_as_wide_as_speed_and_turning_say() -> None:
    _, ys = path_of([twist(0.4, 0.5)] * round(10 * 2 * math.pi / 0.5))
    assert max(ys) - min(ys) == pytest.approx(2 * 0.4 / 0.5, rel=0.02)
    assert max(ys) > 1.0 > -0.3 < min(ys)


def test_the_drawing_names_each_layer_on_both_sides() -> None:
    fig = layers()
    texts = [text.get_text() for text in fig.axes[0].texts]
    for left, right, what in LAYERS:
        assert left in texts
        assert right in texts
        assert what in texts
    assert render(fig)
