"""Readability in both themes and in a narrow window.

This covers code, tracebacks, timelines, and films, which can be stopped.
"""

import shutil
from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.browser.axe import violations
from tests.browser.lab_page import NOTEBOOK, LabPage
from tests.browser.panel_notebook import write_notebook
from tests.browser.student_lab import ROOT, StudentLab

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
ENOUGH = 4.5
CODE = '''\
# A comment, a decorator, and each kind of word that has a color.
from dataclasses import dataclass


@dataclass(frozen=True)
class Arm:
    """A string over a line."""

    name: str = "left"
    angles: tuple[float, ...] = (0.5, -1e3)

    def lift(self, by: float = 0.1) -> "Arm":
        if by is None or not isinstance(by, float):
            raise TypeError(f"by must be a number, not {by!r}\\n")
        return Arm(self.name, tuple(angle + by for angle in self.angles))


print(len(Arm().angles) ** 2 != 3 and True)'''
FAILS = "Arm().lift(None)"
COLORS = """\
import sys
print(*(f"\\x1b[{code}mcolor {code}\\x1b[0m" for code in (30, 31, 32, 33, 34, 35, 36, 37, 91, 92, 93, 94)))
print("on stderr", file=sys.stderr)"""
TIMES = """\
from workbook.pictures import show
from workbook.pictures.timeline import strip
ticks = {"/robot/status": [0.5 * n for n in range(9)], "/robot/battery": [0, 1, 4]}
show(strip(ticks, periods={"/robot/battery": 1.0}), "a timeline with a gap")"""
SLIDER = """\
from workbook.lesson.knobs import Knob
Knob("period_s", 1.0, (0.5, 2.0)).show()"""
OVER = """
image => {
    const place = image.getBoundingClientRect();
    const room = image.closest('.jp-Cell').getBoundingClientRect();
    return Math.max(place.right - room.right, room.left - place.left);
}
"""
BRIGHTNESS = "image => getComputedStyle(image).filter"


def check_names_of_cells(page: LabPage) -> None:
    """Check that a screen reader announces the right cell for an editor, even after a cell was inserted above it."""
    editors = page.panel.locator(".jp-Cell .cm-content")

    def names() -> list[str]:
        return [f"Code cell {number + 1}" for number in range(editors.count())]

    expect(page.panel.get_by_label("Code cell 2", exact=True)).to_contain_text(FAILS)
    page.cell(FAILS).locator(".jp-InputPrompt").click()
    page.page.keyboard.press("a")
    expect(page.panel.get_by_label("Code cell 3", exact=True)).to_contain_text(FAILS)
    assert [one.get_attribute("aria-label") for one in editors.all()] == names()
    page.page.keyboard.press("d")
    page.page.keyboard.press("d")
    expect(page.panel.get_by_label("Code cell 2", exact=True)).to_contain_text(FAILS)
    assert [one.get_attribute("aria-label") for one in editors.all()] == names()


def test_code_tracebacks_and_timelines_can_be_read(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    path = write_notebook(lab.work, "colors.ipynb", CODE, FAILS, COLORS, TIMES, SLIDER)
    page.open(path)
    for text in ("dataclass", "lift(None)", "on stderr", "timeline", "Knob"):
        page.run(page.cell(text))
    expect(page.panel.get_by_role("slider", name="period_s")).to_be_visible()
    check_names_of_cells(page)
    picture = page.panel.get_by_alt_text("a timeline with a gap")
    expect(page.panel.locator(".jp-OutputArea-output", has_text="TypeError")).to_be_visible()
    for theme in page.themes():
        page.choose_theme(theme)
        assert picture.evaluate(BRIGHTNESS) == ("none" if theme == "light" else "brightness(1.3)")
        for width in (1280, 800):
            page.page.set_viewport_size({"width": width, "height": 1400})
            assert picture.evaluate(OVER) <= 0, f"the picture is cut at {width} px"
            page.page.screenshot(path=artifacts / f"readable_{width}_{theme}.png")
        page.page.set_viewport_size({"width": 1280, "height": 1000})
        seen = page.contrasts(page.panel.locator(".jp-Notebook"))
        assert len(seen) > 30
        assert not {text: ratio for text, ratio in seen.items() if ratio < ENOUGH}
        assert violations(page.page, NOTEBOOK) == []


def first_film(page: LabPage, lab: StudentLab, stem: str) -> tuple[Locator, Locator]:
    """Open a committed lesson with its outputs. Return the slider and the button of its first film."""
    shutil.copy(ROOT / "notebooks" / f"{stem}.ipynb", lab.work / "films.ipynb")
    page.open("films.ipynb")
    film = page.panel.locator(".wb-film").first
    film.scroll_into_view_if_needed()
    slider = film.get_by_label("Position in the film")
    expect(slider).to_be_visible()
    return slider, film.get_by_role("button")


def test_a_film_waits_for_a_reader_who_wants_no_motion(page: LabPage, lab: StudentLab) -> None:
    slider, button = first_film(page, lab, "07_typed_nodes")
    expect(button).to_have_text("↻ Replay")
    assert slider.input_value() == slider.get_attribute("max")
    expect(page.panel.locator(".wb-film").get_by_role("img").first).to_have_js_property("tagName", "CANVAS")
    button.click()
    expect(button).to_have_text("Pause")
    expect(slider).not_to_have_value("0")


def test_a_film_plays_once_when_it_is_seen(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    page.page.emulate_media(reduced_motion="no-preference")
    slider, button = first_film(page, lab, "05_timers")
    expect(button).to_have_text("Pause")
    expect(slider).not_to_have_value("0")
    button.click()
    expect(button).to_have_text("Play")
    cell = page.panel.locator(".jp-Cell.jp-mod-selected")
    selected = cell.get_attribute("data-windowed-list-index")
    slider.press("End")
    slider.press("ArrowLeft")
    expect(slider).to_have_value(str(int(slider.get_attribute("max") or 0) - 1))
    button.press("Enter")
    expect(button).to_have_text("↻ Replay")
    assert slider.input_value() == slider.get_attribute("max")
    assert cell.get_attribute("data-windowed-list-index") == selected, "the keys were the notebook's"
    for theme in page.themes():
        page.choose_theme(theme)
        page.page.screenshot(path=artifacts / f"film_{theme}.png")
        assert violations(page.page, ".jp-OutputArea-output:has(.wb-film)") == []
    page.page.emulate_media(reduced_motion="reduce")
