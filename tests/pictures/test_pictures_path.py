"""The way of a robot that obeys commands, and the drawing of the layers."""

import math

import pytest

from workbook.pictures.figures import render
from workbook.pictures.layers import LAYERS, layers
from workbook.pictures.path import path_of


def twist(forward_mps: float, turn_radps: float) -> dict[str, dict[str, float]]:
    return {"linear": {"x": forward_mps}, "angular": {"z": turn_radps}}


def test_straight_on_is_up_the_page() -> None:
    xs, ys = path_of([twist(0.5, 0.0)] * 10)
    assert xs == pytest.approx([0.0] * 11)
    assert ys[-1] == pytest.approx(0.5)


def test_a_turn_to_the_left_is_a_circle_as_wide_as_speed_and_turning_say() -> None:
    xs, _ = path_of([twist(0.4, 0.5)] * round(10 * 2 * math.pi / 0.5))
    assert max(xs) - min(xs) == pytest.approx(2 * 0.4 / 0.5, rel=0.02)
    assert min(xs) < -1.0 < max(xs) < 0.3


def test_the_drawing_names_each_layer_on_both_sides() -> None:
    fig = layers()
    texts = [text.get_text() for text in fig.axes[0].texts]
    for left, right, what in LAYERS:
        assert left in texts
        assert right in texts
        assert what in texts
    assert render(fig)
