"""A prediction in JupyterLab: buttons instead of the options, one key to choose, and the outcome after the run."""

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, ViewportSize, expect

from tests.browser.axe import violations
from tests.browser.lab_page import NOTEBOOK, LabPage

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
LESSON = "notebooks/05_timers.ipynb"
ENOUGH_CONTRAST = 4.5
WIDE = ViewportSize(width=1280, height=1000)
WIDTHS = (800, 1280, 1600)


def widths_of(buttons: Locator) -> set[int]:
    return {round(box["width"]) for one in buttons.all() if (box := one.bounding_box())}


def check_looks(page: LabPage, ask: Locator, outcome: Locator, artifacts: Path) -> None:
    """Check that the prediction is readable in both themes.

    In each window, the buttons have one width, and no text is cut.
    """
    buttons = ask.locator(".wb-option")
    for theme in page.themes():
        page.choose_theme(theme)
        for place in (ask, outcome):
            place.scroll_into_view_if_needed()
            low = {text: ratio for text, ratio in page.contrasts(place).items() if ratio < ENOUGH_CONTRAST}
            assert not low, f"{theme}: {low}"
        assert violations(page.page, NOTEBOOK) == []
        for width in WIDTHS:
            page.page.set_viewport_size({"width": width, "height": 1000})
            ask.scroll_into_view_if_needed()
            assert len(widths_of(buttons)) == 1
            for button in buttons.all():
                assert button.evaluate("one => one.scrollWidth <= one.clientWidth")
            page.page.screenshot(path=artifacts / f"prediction_{width}_{theme}.png")
    page.page.set_viewport_size(WIDE)


def walk_to(page: LabPage, ask: Locator) -> Page:
    """Select the question's text, and go down one cell with the keyboard."""
    ask.locator("xpath=preceding-sibling::div[1]").locator("p").last.click()
    page.page.keyboard.press("ArrowDown")
    return page.page


def test_a_prediction_is_chosen_by_one_key_and_revealed_after_the_run(page: LabPage, artifacts: Path) -> None:
    page.open(LESSON)
    expect(page.panel.locator(".jp-OutputArea-output")).to_have_count(0)  # a new copy has no outputs
    first = page.cell('predict("loop-and-timer")')
    ask, reveals = page.cell('predict("half-a-hertz")'), page.cell('reveal("half-a-hertz"')
    question = ask.locator("xpath=preceding-sibling::div[1]")
    buttons = ask.locator(".wb-option")
    expect(buttons).to_have_count(3)
    expect(question.locator("li").first).to_be_hidden()  # the buttons replace the list
    expect(ask.locator(".cm-content")).to_be_hidden()
    expect(ask.locator("[role=status]")).to_have_text("Choose a, b or c: click it, or press its key.")

    page.run(reveals)  # before any prediction, and without the hidden line that imports `reveal`
    waiting = reveals.locator(".jp-OutputArea-output").last
    expect(waiting).to_contain_text("Your prediction comes first")
    expect(reveals).not_to_contain_text("The outcome is")

    cells = page.panel.locator(".jp-Cell").count()
    keyboard = walk_to(page, ask).keyboard
    expect(buttons.first).to_be_focused()
    keyboard.press("b")
    expect(ask.locator("[role=status]")).to_contain_text("Your prediction: b. The outcome is shown below")
    expect(buttons.nth(1)).to_have_attribute("aria-pressed", "true")
    expect(buttons.nth(1)).to_be_focused()
    page.page.screenshot(path=artifacts / "prediction_focus.png")
    assert page.panel.locator(".jp-Cell").count() == cells, "the key did something to the notebook as well"

    outcome = reveals.locator(".jp-RenderedHTMLCommon").last
    expect(outcome).to_contain_text("You predicted b. The outcome is c.")
    expect(outcome.locator("tbody")).to_have_count(3)
    expect(outcome.locator("details:not([open])")).to_have_count(1)  # neither predicted nor true
    expect(buttons.nth(2)).to_contain_text("✓ outcome")
    expect(buttons.nth(1)).to_contain_text("your prediction")
    keyboard.press("c")
    expect(ask.locator("[role=status]")).to_contain_text("change it anymore")
    expect(buttons.nth(1)).to_have_attribute("aria-pressed", "true")
    check_looks(page, ask, outcome, artifacts)

    check_fold(page, first, artifacts)
    page.save(LESSON)
    page.close_notebook()
    check_opened_again(page, artifacts)


def check_fold(page: LabPage, ask: Locator, artifacts: Path) -> None:
    """Check that *Look inside* unfolds once the preceding question's outcome is known."""
    heading = page.panel.locator(".jp-MarkdownCell", has=page.page.locator("h2", has_text="Look inside"))
    note, text = heading.locator(".wb-fold-note"), heading.locator("h2 ~ p").first
    expect(note).to_be_visible()
    expect(text).to_be_hidden()
    note.scroll_into_view_if_needed()
    assert violations(page.page, ".wb-fold-note") == []
    page.page.screenshot(path=artifacts / "prediction_folded.png")
    for run in ("loop_moments", "class TiltReader", 'reveal("loop-and-timer"'):
        page.run(page.cell(run))
    expect(text).to_be_hidden()  # the cells have run, but there is no prediction
    ask.locator(".wb-option").first.click()
    expect(text).to_be_visible()
    expect(note).to_have_count(0)
    expect(ask.locator(".wb-outcome")).to_contain_text("b")


def check_opened_again(page: LabPage, artifacts: Path) -> None:
    """Reopen a lesson that was run and saved. It shows the choice, although no cell has run."""
    page.open(LESSON)
    ask = page.cell('predict("half-a-hertz")')
    buttons = ask.locator(".wb-option")
    expect(buttons.nth(1)).to_have_attribute("aria-pressed", "true")
    expect(buttons.nth(2)).to_contain_text("✓ outcome")
    expect(page.panel.locator(".wb-fold-note")).to_have_count(0)
    expect(page.panel).not_to_contain_text("Error displaying widget")
    expect(page.cell('reveal("half-a-hertz"')).to_contain_text("You predicted b. The outcome is c.")
    expect(page.notebook_tabs()).to_have_count(1)
    expect(page.page.locator(".lm-TabBar-tab.jp-mod-dirty")).to_have_count(0)
    ask.scroll_into_view_if_needed()
    page.page.screenshot(path=artifacts / "prediction_opened_again.png")


def test_the_page_shows_no_key_before_the_choice(page: LabPage) -> None:
    """Search the page, and all that it may request from the server, for anything that reveals the outcome."""
    page.open("notebooks/04_subscriptions_and_callbacks.ipynb")
    expect(page.panel.locator(".wb-option").first).to_be_visible()
    address = f"{page.lab.address}/workbook/predictions?lesson=04_subscriptions_and_callbacks"
    told = page.page.request.get(f"{address}&token={page.lab.token}").json()
    assert told == {"choices": {}, "outcomes": {}}
    assert page.panel.locator(".wb-outcome").count() == 0
