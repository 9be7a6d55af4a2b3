"""Exercises whose node works with other nodes, as a student sees them: 04's gauge and alarm, and 15's camera."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from statistics import mean
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, WebSocket, expect

from tests.browser.axe import violations
from tests.browser.lab_page import ROBOT, LabPage
from tests.browser.stage_frames import VIEW, script_ms
from tests.browser.student_lab import ROOT, running
from tests.browser.test_browser_exercise import COUNT_MOVES
from workbook.exercise.source import load

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
PANEL = ".workbook-panel:not(.lm-mod-hidden)"
REST_MS = 3000
SETTLING_MS, MOST_SETTLING = 500, 20
"""A robot is asleep before its last movement has ended, which takes longer on a busy machine."""
# Count the animation frames that scripts in the page request. JupyterLab's own elements, which request one each time an
# attribute changes, don't count.
FRAMES = """
ms => new Promise(done => {
    const asked = window.requestAnimationFrame;
    let count = 0;
    window.requestAnimationFrame = move => {
        const caller = new Error().stack.split('\\n')[2];
        count += !caller.includes('/static/lab/');
        return asked.call(window, move);
    };
    setTimeout(() => {
        window.requestAnimationFrame = asked;
        done(count);
    }, ms);
})
"""
COUNT_IMAGES = """
image => {
    window.imagesShown = 0;
    const shown = () => window.imagesShown++;
    new MutationObserver(shown).observe(image, {attributes: true, attributeFilter: ['href']});
}
"""
STANDS_STILL = "() => Object.values(window.stage._robots).every(robot => robot._frame === null)"


def start(page: LabPage, stem: str) -> tuple[Locator, Locator]:
    """Run the solution of an exercise. Return the cell and the panel, which the first start opens."""
    source = load(ROOT / "solutions" / f"{stem}.py")
    page.open(f"exercises/{stem}.ipynb")
    page.page.evaluate("() => sessionStorage.removeItem('rclpy-workbook:offer-robot-panel')")
    page.write(page.cell("%%answer"), f"%%answer {stem}\n{source.solution_code}")
    cell, panel = page.cell("%start"), page.page.locator(PANEL)
    expect(cell.locator(".cm-content")).to_contain_text("%start")
    page.write(cell, "%start")
    page.run(cell)
    expect(cell.locator(".jp-OutputArea")).to_contain_text("The rest of the robot runs with it: node /")
    expect(panel.locator(".workbook-stage .workbook-robot svg")).to_be_visible()
    return cell, panel


def look(page: LabPage, cell: Locator, name: str, artifacts: Path) -> None:
    """Take a screenshot in each theme, and check both stages."""
    for theme in page.themes():
        page.choose_theme(theme)
        cell.scroll_into_view_if_needed()
        page.page.screenshot(path=artifacts / f"partners_{name}_{theme}.png")
        assert violations(page.page, ".workbook-cell-robot") == []
        assert violations(page.page, PANEL) == []


def stop(page: LabPage, stem: str, cell: Locator, panel: Locator) -> None:
    """Stop the program. When the robots sleep, nothing is drawn or sent."""
    page.run(page.cell("%stop"))
    assert not [line for line in running(page.lab.processes()).values() if f"{stem}.py" in line]
    expect(panel.get_by_role("img", name=f"{ROBOT}, asleep")).to_be_visible()
    expect(panel).to_contain_text("No nodes on this domain.")
    expect(cell.locator(".workbook-robot svg").last).to_have_attribute("data-face", "asleep")
    expect(page.page.locator(".workbook-camera:visible")).to_have_count(0)
    for _ in range(MOST_SETTLING):
        if page.page.evaluate(FRAMES, SETTLING_MS) == 0:
            break
    assert page.page.evaluate(FRAMES, REST_MS) == 0


def test_the_gauge_and_the_alarm_of_04(page: LabPage, artifacts: Path) -> None:
    stem = "04_subscriptions_and_callbacks"
    heard: list[Any] = []

    def listen(socket: WebSocket) -> None:
        if "/workbook/panel" in socket.url:
            socket.on("framereceived", lambda frame: heard.append(frame))

    page.page.on("websocket", listen)
    cell, panel = start(page, stem)
    robots = (cell.locator(".workbook-robot svg"), panel.locator(".workbook-robot svg"))
    for robot in robots:
        expect(robot).to_have_attribute("data-face", "error")  # for a short time after each alarm
    expect(cell.locator(".workbook-words")).to_contain_text("alarm: bad reading: ")
    expect(cell.locator(".workbook-words")).to_contain_text(re.compile(r"battery: \d\d %"))
    for robot in robots:
        expect(robot).to_have_attribute("data-face", "awake")
    charges = panel.locator("tbody", has_text="/monitor/battery").locator(".workbook-spark")
    expect(charges).to_have_attribute("aria-label", re.compile(r"the last \d+ values, from \d+.* to \d+"))
    expect(panel.locator(".workbook-graph svg")).to_have_attribute(
        "aria-label", re.compile("/battery_sensor publishes /robot/battery")
    )
    look(page, cell, "04", artifacts)
    stop(page, stem, cell, panel)
    before = len(heard)
    assert before, "the panel has heard something before"
    page.page.wait_for_timeout(REST_MS)  # the interval that is measured
    assert len(heard) == before


def test_the_camera_and_the_head_of_15(page: LabPage, artifacts: Path) -> None:
    stem = "15_camera"
    cell, panel = start(page, stem)
    for stage in (cell, panel):
        camera = stage.get_by_role("img", name="the camera's image")
        expect(camera.locator("image")).to_have_attribute("href", re.compile("^data:image/jpeg;base64,"))
    camera.locator("image").evaluate(COUNT_IMAGES)
    page.page.wait_for_function("() => window.imagesShown > 9")
    page.page.emulate_media(reduced_motion="no-preference")
    cell.locator(".workbook-robot svg").evaluate(COUNT_MOVES)
    page.page.wait_for_function(
        "() => window.robotMoves > 40"
    )  # the head follows the ball, and the other joints rest
    page.page.emulate_media(reduced_motion="reduce")
    expect(panel.locator("tbody", has_text="/camera/image").first).to_contain_text("160 × 120 pixels, rgb8")
    look(page, cell, "15", artifacts)
    stop(page, stem, cell, panel)


@pytest.fixture
def moving_page(browser: Browser) -> Iterator[Page]:
    context = browser.new_context(viewport=VIEW, reduced_motion="no-preference")
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    yield page
    context.close()
    assert not errors


def test_a_full_stage_moves_and_then_rests(moving_page: Page, artifacts: Path) -> None:
    measured = script_ms(moving_page)
    costs = {name: {"mean_ms": mean(spent), "longest_ms": max(spent)} for name, spent in measured.items()}
    (artifacts / "stage.json").write_text(json.dumps(costs, indent=1))
    moving_page.screenshot(path=artifacts / "stage.png")
    assert all(len(spent) > 40 for spent in measured.values()), (
        "frames in two seconds, also on a busy machine"
    )
    moving_page.wait_for_function(STANDS_STILL, polling=20)
    assert moving_page.evaluate(FRAMES, REST_MS) == 0
    expect(
        moving_page.get_by_role("img", name="the camera's image, with boxes around: ball, cup")
    ).to_be_visible()
    expect(moving_page.get_by_role("img", name="the last 60 values, from")).to_have_count(4)
    expect(moving_page.get_by_role("img", name=f"{ROBOT}, as its encoders measure it")).to_be_visible()
