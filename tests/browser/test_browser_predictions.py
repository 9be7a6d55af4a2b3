"""A prediction in JupyterLab: chosen with the keyboard alone, revealed after the run, readable in both themes."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Locator, ViewportSize, expect

from .axe import violations
from .lab_page import NOTEBOOK, LabPage

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
LESSON = "notebooks/05_timers.ipynb"
ENOUGH_CONTRAST = 4.5
WIDE, NARROW = ViewportSize(width=1280, height=1000), ViewportSize(width=800, height=1000)


def check_narrow(page: LabPage, cell: Locator, artifacts: Path) -> None:
    """That long options are not cut off in a narrow window."""
    page.page.set_viewport_size(NARROW)
    page.page.keyboard.press("Control+b")  # the file browser
    cell.scroll_into_view_if_needed()
    for button in cell.locator(".workbook-prediction button").all():
        assert button.evaluate(
            "one => one.scrollWidth <= one.clientWidth && one.scrollHeight <= one.clientHeight"
        )
    page.page.screenshot(path=artifacts / "prediction_narrow.png")
    page.page.keyboard.press("Control+b")
    page.page.set_viewport_size(WIDE)


def test_a_prediction_is_chosen_by_keyboard_and_revealed_after_the_run(
    page: LabPage, artifacts: Path
) -> None:
    page.open(LESSON)
    expect(page.panel.locator(".jp-OutputArea-output")).to_have_count(0)  # the copy arrives unsolved
    longest = page.cell("from workbook.lesson import predict, reveal")
    page.run(longest)
    check_narrow(page, longest, artifacts)
    ask = page.cell('predict("half-a-hertz")')
    reveals = page.cell('reveal("half-a-hertz"')
    page.run(ask)
    buttons = ask.locator(".workbook-prediction button")
    expect(buttons).to_have_count(3)

    page.run(reveals)
    waiting = reveals.locator(".jp-OutputArea-output").last
    expect(waiting).to_contain_text("Your prediction comes first")
    expect(reveals).not_to_contain_text("The outcome is")

    buttons.first.focus()
    page.page.keyboard.press("Tab")
    expect(buttons.nth(1)).to_be_focused()
    page.page.screenshot(path=artifacts / "prediction_focus.png")
    cells = page.panel.locator(".jp-Cell").count()
    page.page.keyboard.press("Enter")
    expect(ask.locator("[role=status]")).to_contain_text("Your prediction: b")
    expect(buttons.nth(1)).to_contain_text("● b)")
    assert page.panel.locator(".jp-Cell").count() == cells, "the key did something to the notebook as well"

    outcome = reveals.locator(".jp-RenderedHTMLCommon").last
    expect(outcome).to_contain_text("You predicted b. The outcome is c.")
    expect(outcome.locator("tbody")).to_have_count(3)
    buttons.nth(2).focus()
    page.page.keyboard.press("Space")
    expect(ask.locator("[role=status]")).to_contain_text("it stays")
    expect(buttons.nth(1)).to_contain_text(re.compile("^● b"))
    for theme in page.themes():
        page.choose_theme(theme)
        for place in (ask.locator(".workbook-prediction"), outcome):
            place.scroll_into_view_if_needed()
            low = {text: ratio for text, ratio in page.contrasts(place).items() if ratio < ENOUGH_CONTRAST}
            assert not low, f"{theme}: {low}"
        assert violations(page.page, NOTEBOOK) == []
        ask.scroll_into_view_if_needed()
        page.page.screenshot(path=artifacts / f"prediction_{theme}.png")

    page.save(LESSON)
    page.close_notebook()
    check_opened_again(page, artifacts)


def check_opened_again(page: LabPage, artifacts: Path) -> None:
    """A lesson that was run, saved and opened again is as it was saved: its kernel is new, and no button works."""
    page.open(LESSON)
    ask = page.cell('predict("half-a-hertz")')
    expect(ask.locator(".wb-widget-text")).to_have_text(
        re.compile("^Choose a, b or c, with a button or by hand")
    )
    expect(page.panel).not_to_contain_text("Error displaying widget")
    expect(page.cell('reveal("half-a-hertz"')).to_contain_text("You predicted b. The outcome is c.")
    expect(page.notebook_tabs()).to_have_count(1)
    expect(page.page.locator(".lm-TabBar-tab.jp-mod-dirty")).to_have_count(0)
    ask.scroll_into_view_if_needed()
    page.page.screenshot(path=artifacts / "prediction_opened_again.png")
    page.run(page.cell("from workbook.lesson import predict, reveal"))
    page.run(ask)
    expect(ask.locator(".workbook-prediction button").nth(1)).to_contain_text("● b)")
