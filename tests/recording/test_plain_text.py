"""A program's text: nothing in it is a command or invisible, but words and names stay readable."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.recording.plain_text import without_commands

INVISIBLE = {
    "Arabic letter mark": "\u061c",
    "zero width space": "\u200b",
    "byte order mark": "\ufeff",
    "line separator": "\u2028",
    "paragraph separator": "\u2029",
    "tags": "\U000e0041\U000e007f",
    "language tag": "\U000e0001",
    "soft hyphen": "\xad",
    "word joiner": "\u2060",
    "invisible times": "\u2062",
    "right-to-left override": "\u202e",
    "isolate": "\u2067",
    "private use": "\ue000\U000f0000",
    "half a character": "\ud800",
    "no character": "\uffff",
    "interlinear annotation": "\ufff9",
    "combining grapheme joiner": "\u034f",
    "Hangul fillers": "\u115f\u1160\u3164\uffa0",
    "blank Braille": "\u2800",
    "variation selectors": "\ufe00\U000e0100\U000e01ef",
    "emoji presentation of a letter": "\ufe0f",
    "joiners of letters without joined forms": "\u200c\u200d",
    "control characters": "\x00\x08\x0b\r\x1b\x7f\x85\x9b",
    "escapes": "\x1b[2J\x1b]0;title\x07",
}


@pytest.mark.parametrize("kind", INVISIBLE)
def test_what_nobody_sees_goes(kind: str) -> None:
    assert without_commands(f"a{INVISIBLE[kind]}b") == "ab"


@pytest.mark.parametrize(
    "text",
    [
        "two words\n\tand a line",
        "no\xa0break, \u3000wide",
        "نور الدین",
        "می\u200cخواهم",  # with a zero-width non-joiner, as in Persian
        "क्\u200dष",
        "👩\u200d🔬 👨\u200d👩\u200d👧 ❤\ufe0f 👩\u200d❤\ufe0f\u200d👨",
        "Zoë Ångström-Łukasz 李小龍 Ⅷ ½ €",
        "e\u0301",
        "✓ → 3.5 °C ± 1 µm",
        "\ufffd",
    ],
)
def test_what_people_read_stays(text: str) -> None:
    assert without_commands(text) == text


@given(st.text(st.one_of(st.characters(), st.sampled_from("a é👩\u200c\u200d\ufe0f\u200b\x1b[]m\ufe00"))))
def test_nothing_invisible_comes_through_and_nothing_new_is_made(text: str) -> None:
    shown = without_commands(text)
    categories = {unicodedata.category(one) for one in shown if one not in "\n\t\u200c\u200d"}
    assert not categories & {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
    assert without_commands(shown) == shown
