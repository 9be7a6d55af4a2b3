"""The panel next to the notebook: what it shows, what it costs, and that it is invisible in the ROS graph."""

import contextlib
import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import psutil
import pytest
from playwright.sync_api import Locator, expect

from tests.browser.axe import violations
from tests.browser.lab_page import LabPage
from tests.browser.panel_notebook import QUIET, SAYS, TURNS, WAVES, write_notebook
from tests.browser.student_lab import StudentLab, await_end, running

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
WIDTHS = (800, 1280, 1600)
IDLE_S = 20.0
MOST_OF_A_CORE = 0.05
OBSERVER = "workbook.lab.panel.observer"
SHOWN = ".workbook-panel:not(.lm-mod-hidden)"
FRAMES = """
robot => {
    window.panelFrames = 0;
    const look = () => window.panelFrames++;
    new MutationObserver(look).observe(robot.querySelector('g'), {attributes: true, attributeFilter: ['transform']});
}
"""
GRAPH_NAMES = """
graph => [...graph.querySelectorAll('g')].map(one => {
    const [box, ...lines] = [one.querySelector('rect'), ...one.querySelectorAll('text')];
    const fits = lines.every(line => {
        const [inner, outer] = [line.getBoundingClientRect(), box.getBoundingClientRect()];
        return inner.left >= outer.left && inner.right <= outer.right
            && inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;
    });
    return [lines.map(line => line.textContent).join(''), one.querySelector('title').textContent, fits];
})
"""
CUT = "panel => panel.scrollWidth - panel.clientWidth"


def observers(lab: StudentLab) -> set[psutil.Process]:
    processes = lab.processes()
    alive = running(processes)  # other processes may be about to end
    return {one for one in processes if OBSERVER in alive.get(one.pid, "")}


def toggle(page: LabPage) -> None:
    page.panel.get_by_role("button", name="Robot", exact=True).click()


def by_palette(page: LabPage) -> None:
    page.page.keyboard.press("Control+Shift+c")
    page.page.locator(".lm-CommandPalette-input").fill("robot panel")
    expect(page.page.locator(".lm-CommandPalette-item").first).to_contain_text("Robot panel")
    page.page.keyboard.press("Enter")


def rate(panel: Locator, topic: str) -> Locator:
    return panel.locator("tbody", has_text=topic).locator("td").first


def processor_seconds(lab: StudentLab, seconds: float) -> dict[str, float]:
    """Return the CPU seconds of the server, kernels, observer, and browser during this time, by process."""

    def taken() -> dict[psutil.Process, float]:
        found = {}
        for process in {*lab.processes(), lab.itself, *psutil.Process().children(recursive=True)}:
            with contextlib.suppress(psutil.NoSuchProcess):
                times = process.cpu_times()
                found[process] = times.user + times.system
        return found

    before = taken()
    time.sleep(seconds)  # the interval that is measured
    return {f"{one.pid} {one.name()}": spent - before[one] for one, spent in taken().items() if one in before}


def check_every_width(page: LabPage, panel: Locator, look: Callable[[str], None]) -> None:
    for width in WIDTHS:
        page.page.set_viewport_size({"width": width, "height": 1000})
        toggle(page)
        expect(panel).to_have_count(0)
        toggle(page)
        expect(rate(panel, "/robot/joint_positions")).to_contain_text("Hz")
        assert panel.evaluate(CUT) <= 0, f"cut at {width} px"
        assert page.panel.evaluate("notebook => notebook.clientWidth") >= 400, (
            f"no room for the notebook at {width} px"
        )
        look(str(width))
    page.page.set_viewport_size({"width": 1280, "height": 1000})


def reload(page: LabPage) -> None:
    """Reload the page.

    Before that, wait until JupyterLab has saved its layout, which it does some time after a change.
    """
    page.page.reload()
    expect(page.page.locator("#jupyterlab-splash")).to_have_count(0)
    expect(page.panel.locator(".jp-Cell").first).to_be_visible()


def is_kept(is_open: bool) -> Callable[[dict[str, Any]], bool]:
    """Return whether the workspace on the server contains the open right column with the panel in it."""

    def kept(workspace: dict[str, Any]) -> bool:
        right = workspace["data"].get("layout-restorer:data", {}).get("right", {})
        return bool(right) and right.get("collapsed") is not is_open

    return kept


def check_reload(page: LabPage, panel: Locator) -> None:
    """Reload the page, and check the panel:

    open next to its notebook with the same topic as before, or still closed.
    """
    workspace = f"lab/api/workspaces/{Path(urlsplit(page.page.url).path).parts[3]}"
    page.run(page.cell("Knob"))
    page.save("quiet.ipynb")
    page.await_server(workspace, is_kept(True))
    reload(page)
    expect(panel.locator("h2")).to_have_text("quiet")
    expect(panel.get_by_role("button", name="/words")).to_have_attribute("aria-pressed", "true")
    expect(panel.locator("pre")).to_have_text("waiting for the next message …")
    page.run(page.cell("subscriptions"))
    expect(panel.locator("pre")).to_contain_text("data: two\n---\ndata: three")
    expect(page.panel.get_by_role("slider", name="loudness")).to_be_visible()  # it works: its kernel lives

    toggle(page)
    page.await_server(workspace, is_kept(False))
    reload(page)
    expect(page.panel.get_by_role("button", name="Robot", exact=True)).to_be_visible()
    expect(panel).to_have_count(0)
    toggle(page)
    expect(panel.locator("tbody", has_text="/words")).to_be_visible()


def test_the_panel(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    waves = write_notebook(lab.work, "waves.ipynb", WAVES, "stop()", "await asyncio.sleep(0)")
    quiet = write_notebook(lab.work, "quiet.ipynb", QUIET, SAYS, TURNS)
    panel = page.page.locator(SHOWN)
    page.open(waves)
    expect(panel).to_have_count(0)
    toggle(page)
    page.run(page.cell("joint_position_publisher"))
    robot = panel.get_by_role("img", name="a humanoid robot with twelve joints, posed by")
    expect(robot).to_be_visible()
    expect(rate(panel, "/robot/joint_positions")).to_contain_text("Hz")
    expect(panel.locator(".workbook-graph svg")).to_have_attribute(
        "aria-label", "Graph: /joint_position_publisher publishes /robot/joint_positions"
    )
    names = ("/joint_position_publisher", "/robot/joint_positions")
    drawn = panel.locator(".workbook-graph svg").evaluate(GRAPH_NAMES)
    assert drawn == [[name, name, True] for name in names], "a name is cut"
    robot.evaluate(FRAMES)
    page.page.wait_for_function("() => window.panelFrames > 9")
    panel.get_by_role("button", name="/robot/joint_positions").click()
    expect(panel.locator("pre")).to_contain_text("data: [")
    for theme in page.themes():
        page.choose_theme(theme)
        check_every_width(
            page,
            panel,
            lambda at, theme=theme: page.page.screenshot(path=artifacts / f"panel_{at}_{theme}.png"),
        )
        assert violations(page.page, SHOWN) == []

    page.open(quiet)
    expect(panel.locator("h2")).to_have_text("quiet")
    expect(panel.get_by_role("status")).to_contain_text("ROS domain")
    page.run(page.cell("lonely"))
    expect(panel.locator(".workbook-graph svg")).to_have_attribute(
        "aria-label", "Graph: /lonely publishes /words"
    )
    said = page.cell("subscriptions")
    page.run(said)
    expect(said.locator(".jp-OutputArea-output")).to_contain_text("subscriptions: 0 nodes: /lonely")
    expect(panel.locator("tbody", has_text="/words")).to_contain_text("three")
    panel.get_by_role("button", name="/words").press("Enter")
    expect(panel.locator("pre")).to_have_text("data: one\n---\ndata: two\n---\ndata: three")
    page.page.screenshot(path=artifacts / "panel_quiet.png")
    check_reload(page, panel)
    opened = processor_seconds(lab, IDLE_S)
    watching = observers(lab)
    assert watching
    by_palette(page)
    expect(panel).to_have_count(0)
    assert not await_end(watching, 10.0), "the observer outlives its panel"
    closed = processor_seconds(lab, IDLE_S)
    cost = (sum(opened.values()) - sum(closed.values())) / IDLE_S
    (artifacts / "panel_cost.json").write_text(json.dumps([cost, opened, closed], indent=1))
    assert cost < MOST_OF_A_CORE
    by_palette(page)
    expect(panel.locator(".workbook-graph svg")).to_be_visible()
    page.close_notebook()
    page.page.locator("#jp-main-dock-panel .lm-TabBar-tab", has_text="waves.ipynb").click()
    expect(panel.locator("h2")).to_have_text("waves")
    page.run(page.cell("stop()"))
    expect(panel.get_by_role("img", name="a humanoid robot with twelve joints, asleep")).to_be_visible()
    expect(panel.get_by_text("No nodes on this domain.")).to_be_visible()
    watching = observers(lab)
    assert watching
    page.close_notebook()
    expect(panel.get_by_role("status")).to_have_text("Open a notebook to see its robot.")
    assert not await_end(watching, 10.0), "an observer without a notebook"
    by_palette(page)
    expect(panel).to_have_count(0)
