"""The robot on a check's card: it moves while the judge watches, and replays the recording after full marks."""

import json
import re
from pathlib import Path
from statistics import median
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.axe import violations
from tests.browser.lab_page import CELL_MS, LabPage
from tests.browser.stage_frames import MOST_SCRIPT_MS
from tests.browser.student_lab import ROOT, StudentLab
from tests.browser.test_browser_exercise import CHANGES, COUNT_MOVES, FRONT_END, REST_MS
from tests.browser.test_browser_rig import COUNTED
from workbook.authoring.tree import Tree
from workbook.exercise.definition import load_exercise
from workbook.magics.live_card import CHECK

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
NOTEBOOK = "exercises/05_timers.ipynb"
SLOW = Tree(ROOT).right_answers / "05_timers" / "thread_that_keeps_the_plan.py"
FULL_MARKS = "Full marks: 10 of 10 points."
ON_CARD = ".workbook-check .workbook-figure"
# Record the height of the figure on the card and the distance from the top to the link, from the first moment on.
WATCH_ROOM = """
() => {
    window.rooms = new Set();
    const look = () => document.querySelectorAll('.jp-OutputArea-output a[href*="notebooks/"]').forEach(link => {
        const card = link.closest('.jp-OutputArea-output');
        const figure = card.querySelector('.workbook-figure');
        const top = card.getBoundingClientRect().top;
        window.rooms.add(JSON.stringify([
            figure.getBoundingClientRect().height, Math.round(link.getBoundingClientRect().top - top),
        ]));
    });
    new MutationObserver(look).observe(document.body, {subtree: true, childList: true, attributes: true});
}
"""
# A card on a page without JupyterLab. `robot` is either an error that says why there is none, or a robot that stores
# its updates.
BARE = """
async ([code, check, robot, events = []]) => {
    const {defineCheckRobot} = await import(URL.createObjectURL(new Blob([code], {type: 'text/javascript'})));
    class Widget {
        constructor() { this.node = document.createElement('div'); }
        addClass() {}
    }
    const renderer = () => {
        const node = document.createElement('div');
        return {node, renderModel: async model => { node.innerHTML = model.data['text/html']; }, dispose: () => {}};
    };
    const node = document.createElement('i');
    const make = {
        late: () => new Promise(() => {}),
        broken: () => Promise.reject(new Error('no figure')),
        there: async () => ({node, moments: ['nod'], reset: () => {}, take: news => { window.taken = news; }}),
    }[robot];
    const card = new (defineCheckRobot(Widget, {createRenderer: renderer}, make))({});
    document.body.replaceChildren(card.node);
    const html = '<b>Full marks</b><div class="workbook-figure"><i>still</i></div>';
    const shown = card.renderModel({data: {'text/html': html, [check]: {replay: {events, glide: 70}}}});
    card.onAfterAttach();
    await Promise.race([shown, new Promise(setTimeout)]);
}
"""


def begin(page: LabPage, cell: Locator) -> None:
    """Press Ctrl+Enter, without waiting for the end."""
    cell.locator(".cm-content").click()
    page.page.keyboard.press("Control+Enter")


def script_ms(page: LabPage) -> dict[str, float]:
    spent: list[float] = page.page.evaluate("() => window.frames_ms.splice(0)")
    # The median, because on a busy machine a single frame may include the time slice of another process.
    return {"frames": len(spent), "median_ms": median(spent), "longest_ms": max(spent)}


def pictures(page: LabPage, output: Locator, path: Path) -> None:
    """Take screenshots in both themes, and check the card with axe."""
    for theme in page.themes():
        page.choose_theme(theme)
        output.scroll_into_view_if_needed()
        output.screenshot(path=path.with_name(f"{path.name}_{theme}.png"))
        assert violations(page.page, ".workbook-check") == []


def shown_on_card(saved: dict[str, Any]) -> dict[str, Any]:
    outputs = [one for cell in saved["cells"] for one in cell.get("outputs", [])]
    return next(one["data"] for one in outputs if CHECK in one.get("data", {}))


@pytest.mark.parametrize("robot", ["late", "broken"])
def test_a_card_waits_for_no_robot(browser_page: Page, robot: str) -> None:
    errors: list[str] = []
    browser_page.on("pageerror", lambda error: errors.append(str(error)))
    browser_page.evaluate(BARE, [(FRONT_END / "card.js").read_text(encoding="utf-8"), CHECK, robot])
    expect(browser_page.locator("body")).to_have_text("Full marksstill", timeout=5000)
    assert not errors


def test_without_motion_the_robot_shows_what_lasts(browser_page: Page) -> None:
    browser_page.emulate_media(reduced_motion="reduce")
    events = [[0, {"awake": True, "nod": 1}], [500, {"battery": 80.0, "nod": 1}]]
    code = (FRONT_END / "card.js").read_text(encoding="utf-8")
    browser_page.evaluate(BARE, [code, CHECK, "there", events])
    browser_page.wait_for_function("() => window.taken")
    assert browser_page.evaluate("() => window.taken") == {"awake": True, "battery": 80.0}


def test_the_robot_moves_while_a_slow_program_is_watched(page: LabPage, artifacts: Path) -> None:
    page.open(NOTEBOOK)
    page.page.emulate_media(reduced_motion="no-preference")
    page.choose_theme("dark")
    answer, check = page.cell("%%answer"), page.cell("%check")
    page.write(answer, f"%%answer 05\n{SLOW.read_text(encoding='utf-8')}")
    page.page.evaluate(COUNTED)
    begin(page, check)
    robot, waiting = check.locator(f"{ON_CARD} svg"), check.locator(".workbook-check")
    expect(robot).to_have_attribute("data-face", "awake")
    expect(waiting).to_contain_text("Watching one minute of your robot's life, in fast motion")
    expect(waiting).to_contain_text(re.compile(r"[1-9]\d* on /robot/heartbeat"))
    robot.evaluate(COUNT_MOVES)
    page.page.evaluate("() => window.frames_ms.splice(0)")
    page.page.wait_for_function("() => window.robotMoves > 10")
    page.page.screenshot(path=artifacts / "card_waiting.png")
    measured = script_ms(page)
    expect(check.locator(".jp-OutputArea")).to_contain_text(FULL_MARKS, timeout=CELL_MS)
    expect(robot).to_have_count(1)
    expect(check.get_by_role("button", name="Replay")).to_be_visible()
    assert measured["median_ms"] < MOST_SCRIPT_MS
    (artifacts / "card_waiting.json").write_text(json.dumps(measured, indent=1))
    page.page.emulate_media(reduced_motion="reduce")


def test_full_marks_replay_what_the_student_wrote(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    page.open(NOTEBOOK)
    answer, check = page.cell("%%answer"), page.cell("%check")
    page.write(answer, f"%%answer 05\n{load_exercise('05_timers', ROOT).source.solution_code}")
    page.page.evaluate(COUNTED)
    page.page.evaluate(WATCH_ROOM)
    page.run(check)
    card = check.locator(".workbook-check")
    robot, again = check.locator(f"{ON_CARD} svg"), check.get_by_role("button", name="Replay")
    expect(card).to_contain_text("Full marks", timeout=CELL_MS)
    expect(card).to_contain_text("Then it started the program again", timeout=CELL_MS)
    expect(again).to_be_visible()
    expect(card.locator(".workbook-words")).to_contain_text(re.compile(r"battery: \d+ %"))
    assert len(page.page.evaluate("() => [...window.rooms]")) == 1, "the card jumps when the robot comes"
    assert robot.evaluate(CHANGES, REST_MS) == 0, "it moves for a reader who wants no motion"
    pictures(page, card, artifacts / "card_success")

    page.page.emulate_media(reduced_motion="no-preference")
    robot.evaluate(COUNT_MOVES)
    page.page.evaluate("() => window.frames_ms.splice(0)")
    again.click()
    page.page.wait_for_function("() => window.robotMoves > 60")
    card.screenshot(path=artifacts / "card_replay.png")
    measured = script_ms(page)
    assert measured["median_ms"] < MOST_SCRIPT_MS
    (artifacts / "card_replay.json").write_text(json.dumps(measured, indent=1))
    page.page.emulate_media(reduced_motion="reduce")

    shown = shown_on_card(page.save(NOTEBOOK))
    effects = {effect for _, news in shown[CHECK]["replay"]["events"] for effect in news}
    assert {"beat", "tilt", "battery"} <= effects
    assert "data:image/png;base64," in "".join(shown["text/html"]), "a still for other readers"
    card.get_by_role("link", name=re.compile("^Next: 06")).click()
    expect(page.page.locator(".lm-TabBar-tab", has_text="06_spinning.ipynb")).to_be_visible()
