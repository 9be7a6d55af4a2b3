"""Text of cards and pages is readable in both themes: a contrast of at least 4.5:1, computed from the shipped CSS."""

import re
from itertools import product
from pathlib import Path

import pytest

from workbook.exercise.judgement import Judgement
from workbook.feedback.card import as_html
from workbook.feedback.colors import COLORS, ON_DARK, ON_LIGHT, TEXT, TINTS
from workbook.grading.pages import TEXT_COLORS
from workbook.templating import render

ROOT = Path(__file__).resolve().parents[2]
LEAST = 4.5
GROUNDS = {
    "light": ["#ffffff", "#f5f5f5", "#e1f5fe"],
    "dark": ["#111111", "#121212", "#1f1f1f", "#212121", "#1b3c4b"],
}
"""Backgrounds: JupyterLab's cell, every other table row, the row under the mouse; VS Code; a page."""
Color = tuple[float, float, float]


def parse(color: str) -> Color:
    return (int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16))


def luminance(color: Color) -> float:
    parts = [part / 255 for part in color]
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: Color, other: Color) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def tinted(ground: Color, tint: str) -> Color:
    *over, share = map(float, re.findall(r"[\d.]+", tint))
    red, green, blue = (
        below * (1 - share) + above * share for below, above in zip(ground, over, strict=True)
    )
    return red, green, blue


def variables(css: str) -> dict[str, str]:
    return dict(re.findall(r"(--workbook-\w+):(#[0-9a-f]{6})", css))


def themes_of_the_card() -> dict[str, dict[str, str]]:
    style = (
        as_html(Judgement("05_timers", "0" * 64, "graded", None, (), None))
        .partition("<style>")[2]
        .partition("</style>")[0]
    )
    rules = dict(re.findall(r"([^{}]+)\{([^}]*)\}", style))
    light = next(
        rules[selector] for selector in rules if '"true"' in selector and ".vscode-light" in selector
    )
    dark = next(rules[selector] for selector in rules if '"false"' in selector and ".vscode-dark" in selector)
    return {"light": variables(light), "dark": variables(dark)}


def themes_of_a_page() -> dict[str, dict[str, str]]:
    style = (
        render("grading/page", title="x", text_colors=TEXT_COLORS)
        .partition("<style>")[2]
        .partition("</style>")[0]
    )
    light, _, dark = style.partition("@media (prefers-color-scheme:dark)")
    assert re.search(r":root\{[^}]*color-scheme:light dark", light)
    return {"light": variables(light), "dark": variables(dark)}


@pytest.mark.parametrize("themes", [themes_of_the_card, themes_of_a_page])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_text_is_readable_on_every_ground_tinted_or_not(themes: object, theme: str) -> None:
    assert callable(themes)
    colors = themes()[theme]
    assert {f"var({name})" for name in colors} == set(TEXT.values())
    for (name, color), ground in product(colors.items(), map(parse, GROUNDS[theme])):
        behind = [ground, *(tinted(ground, tint) for tint in TINTS.values())]
        assert min(contrast(parse(color), one) for one in behind) >= LEAST, f"{name} on {ground}"


def test_the_labels_of_a_timeline_are_readable_in_both_themes() -> None:
    """The browser blends thin letters with the background, so they need more than the least contrast."""
    label = parse(ON_LIGHT["skipped"])
    assert ON_DARK["timeline"] == "invert(1) hue-rotate(180deg)"
    inverted = (255 - label[0], 255 - label[1], 255 - label[2])  # a gray has no hue to rotate
    for theme, color in (("light", label), ("dark", inverted)):
        assert min(contrast(color, parse(ground)) for ground in GROUNDS[theme][:-1]) >= 1.3 * LEAST
    rules = (ROOT / "workbook" / "lab" / "front_end" / "panel" / "contrast.css").read_text(encoding="utf-8")
    assert f"filter: {ON_DARK['timeline']}" in rules


def test_the_palette_alone_would_not_do_for_text() -> None:
    """If it did, the variants for text could be removed. (Shapes need 3:1.)"""
    grounds = [parse(grounds[0]) for grounds in GROUNDS.values()]
    worst = [min(contrast(parse(color), ground) for ground in grounds) for color in COLORS.values()]
    assert 3 < min(worst) <= max(worst) < LEAST
