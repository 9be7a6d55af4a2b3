"""A line in a lesson becomes the box that shows plain rclpy code for the lesson's helpers."""

import pytest

from workbook import lesson
from workbook.authoring.plain_helpers import PLAIN, TITLE, with_plain_helpers
from workbook.authoring.tree import AuthoringError


def test_the_line_becomes_one_box_with_the_texts_in_order() -> None:
    made = with_plain_helpers("Before.\n\n[the same without helpers: init, run]\n\nAfter.", "lesson")
    assert made.startswith(f"Before.\n\n<details><summary>{TITLE}</summary>\n\n`init()`")
    assert made.endswith("```\n\n</details>\n\nAfter.") and made.count("<details>") == 1
    assert made.index(PLAIN["init"]) < made.index(PLAIN["run"])


def test_other_text_stays() -> None:
    text = "[a link](page.md), and [the same without helpers: init] within a line"
    assert with_plain_helpers(text, "lesson") == text


def test_an_unknown_helper_is_named_with_its_place() -> None:
    with pytest.raises(AuthoringError, match="03, cell 2: there is no plain text for the helper 'sing'"):
        with_plain_helpers("[the same without helpers: sing]", "03, cell 2")


@pytest.mark.parametrize("name", PLAIN)
def test_each_text_is_about_a_helper_of_lessons(name: str) -> None:
    assert name in lesson.__all__ and f"{name}(" in PLAIN[name]
