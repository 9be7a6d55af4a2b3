"""Varying numbers are marked and have a range.

A reader's line is distinguished from a blank that isn't filled in yet.
"""

import math

import numpy as np
import pytest

from workbook.lesson import about, yours


@pytest.mark.parametrize(
    ("value", "unit", "between", "text"),
    [
        (23.1, "ms", (5, 60), "≈ 23 ms"),
        (5, "ms", (5, 60), "≈ 5.0 ms"),
        (9.97, "Hz", (8, 12), "≈ 10 Hz"),
        (0.0231, "s", (0, 1), "≈ 0.023 s"),
        (0.00997, "s", (0, 1), "≈ 0.010 s"),
        (1234.0, "bytes", (1, 9999), "≈ 1,200 bytes"),
        (-3.14, "°", (-5, 5), "≈ -3.1°"),
        (0.0, "", (0, 1), "≈ 0"),
        (np.float32(2.5), "px", (0, 9), "≈ 2.5 px"),
        (81.0, "ms", (5, 60), "≈ 81 ms (unusual on this machine)"),
        (4.9, "ms", (5, 60), "≈ 4.9 ms (unusual on this machine)"),
        (math.nan, "ms", (5, 60), "≈ nan ms (unusual on this machine)"),
        (math.inf, "ms", (5, 60), "≈ inf ms (unusual on this machine)"),
    ],
)
def test_a_number_is_rounded_and_marked(
    value: float, unit: str, between: tuple[float, float], text: str
) -> None:
    assert about(value, unit, between=between) == text


def test_more_digits_on_demand() -> None:
    assert about(29.968, "Hz", between=(20, 40), digits=3) == "≈ 30.0 Hz"


def test_an_empty_range_is_refused() -> None:
    with pytest.raises(ValueError, match="from a smaller number to a larger one, not from 60 to 5"):
        about(23.1, "ms", between=(60, 5))


@pytest.mark.parametrize(
    ("got", "wanted"),
    [
        ((480, 1920), (480, 1920)),
        (-0.05 + 1e-12, -0.05),
        (np.float64(0.25), 0.25),
        ([0.1 + 0.2, 1], [0.3, 1]),
        ("rgb8", "rgb8"),
        (np.array([0.1 + 0.2, 1.0]), [0.3, 1.0]),
    ],
)
def test_a_right_line_is_praised(got: object, wanted: object, capsys: pytest.CaptureFixture[str]) -> None:
    yours(got, wanted)
    assert capsys.readouterr().out.startswith("✓ Correct: ")


@pytest.mark.parametrize("got", [..., (0.0, ...), {"rgb8": 41, "bgr8": ...}, {...: 1}, [[...]]])
def test_a_blank_gets_a_reminder(got: object, capsys: pytest.CaptureFixture[str]) -> None:
    yours(got, 1.0, "never shown")
    assert capsys.readouterr().out == "Replace each ... with your code, then run this cell again.\n"


@pytest.mark.parametrize(
    ("got", "wanted", "shown"),
    [
        ((480, 1952), (480, 1920), "(480, 1952); expected: (480, 1920)"),
        (0.05, -0.05, "0.05; expected: -0.05"),
        (None, -0.05, "None; expected: -0.05"),
        ("bgr8", "rgb8", "'bgr8'; expected: 'rgb8'"),
        (5, (5,), "5; expected: (5,)"),
        (np.zeros(2), 0, "[0. 0.]; expected: 0"),
    ],
)
def test_a_wrong_line_is_told_with_its_hint(
    got: object, wanted: object, shown: str, capsys: pytest.CaptureFixture[str]
) -> None:
    yours(got, wanted, "count the bytes.")
    assert capsys.readouterr().out == f"Not yet. Your line gives {shown}.\nTry: count the bytes.\n"
