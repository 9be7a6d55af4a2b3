"""Open every lesson in JupyterLab and run it from top to bottom: it shows the committed outputs and looks right.

nbval compares the outputs of the run, as strictly as `tests/notebooks` does for the exercises and the deeper pages.
Predictions are skipped here; `test_browser_predictions` tests them.
"""

import json
import os
import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from statistics import median

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.axe import violations
from tests.browser.conftest import OpenPage, running_lab
from tests.browser.lab_page import NOTEBOOK, ROBOT, LabPage
from tests.browser.student_lab import ROOT, StudentLab
from tests.calm import MOST_TAKEN, TRIES, await_calm, taken_s
from workbook.authoring.comparing import compare_run
from workbook.authoring.nbval_glue import MOST_PICTURES
from workbook.authoring.tree import Tree
from workbook.lesson.predictions import UNATTENDED

pytestmark = [pytest.mark.browser, pytest.mark.slow]
LESSONS = sorted(path.stem for path in (ROOT / "notebooks").glob("[0-9]*.ipynb"))
ROBOT_LESSON = "09_joint_positions"
SHORT_LESSON = "02_nodes"
"""The only lesson that `make test` opens in the browser."""
SEVERAL_FRAMES = 4
"""A robot that jumps to its last pose draws one frame.

`frames.json` records the number, which is small on a busy machine.
"""
IS_WHOLE = "async image => { await image.decode().catch(() => {}); return image.complete && image.naturalWidth > 0; }"
# Changing the theme of a long notebook costs seconds of CPU time, so the lessons alternate between the two themes.
# WORKBOOK_THEMES=both shows each in both.
BOTH_THEMES = os.environ.get("WORKBOOK_THEMES") == "both"
PICTURES_PER_SECOND = "4"
"""Enough to show that something moves. Drawing more would take CPU time from the other tests."""


@pytest.fixture(scope="module")
def lab(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudentLab]:
    """Run a server whose lessons skip the predictions, as the builder does."""
    environ = {UNATTENDED: "1", MOST_PICTURES: PICTURES_PER_SECOND}
    with running_lab(tmp_path_factory.mktemp("lessons"), environ) as started:
        yield started


@pytest.fixture(scope="module")
def open_page(browser: Browser, lab: StudentLab) -> Iterator[OpenPage]:
    one = OpenPage(browser, lab)
    yield one
    one.close()


def themes_of(stem: str, page: LabPage) -> tuple[str, ...]:
    """Return the themes in which a lesson is shown. (The lessons of one theme share a browser.)"""
    return page.themes() if BOTH_THEMES else (("light", "dark")[int(stem[:2]) % 2],)


def unexpected_errors(notebook: dict[str, list[dict[str, object]]]) -> list[str]:
    """Return the errors in cells that aren't marked as raising one, and the marked cells without one."""
    found = []
    for cell in notebook["cells"]:
        outputs = cell.get("outputs", [])
        assert isinstance(outputs, list)
        errors = [output for output in outputs if output["output_type"] == "error"]
        metadata = cell["metadata"]
        assert isinstance(metadata, dict)
        may_raise = "raises-exception" in metadata.get("tags", [])
        if errors and not may_raise:
            found.append(f"{cell['id']}: {errors[0]['ename']}: {errors[0]['evalue']}")
        if may_raise and not errors:
            found.append(f"{cell['id']}: no error, and one was expected")
    return found


def load_cells(lab: StudentLab, stem: str) -> list[str]:
    kept = json.loads((lab.work / "answers" / ".progress.json").read_text(encoding="utf-8"))
    cells: list[str] = kept[stem]["cells"]
    return cells


def check_robot(page: LabPage, moments: list[float], artifacts: Path) -> None:
    """Check that the robot moved while the cell ran, is next to the cell, and looks right in both themes."""
    assert len(moments) >= SEVERAL_FRAMES, "the robot hardly moved"
    page.cell("from lesson_nodes import joint_position_publisher").locator(".cm-content").click()
    robot = page.panel.locator(".workbook-cell-robot").get_by_role("img", name=ROBOT).first
    expect(robot).to_be_in_viewport(ratio=0.1)
    for theme in page.themes():
        page.choose_theme(theme)
        page.page.screenshot(path=artifacts / f"robot_{theme}.png")
    between = [later - earlier for earlier, later in pairwise(moments)]
    measured = {
        "moves": len(moments),
        "seconds": round(moments[-1] - moments[0], 2),
        "per_second_typical": round(1 / median(between), 1),
        "load_average": round(os.getloadavg()[0], 1),
    }
    (artifacts / "frames.json").write_text(json.dumps(measured) + "\n", encoding="utf-8")


@pytest.mark.parametrize(
    "stem",
    [pytest.param(stem, marks=() if stem == SHORT_LESSON else pytest.mark.whole) for stem in LESSONS],
)
def test_a_lesson_runs_from_top_to_bottom(
    stem: str, page: LabPage, lab: StudentLab, artifacts: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """Differences prove nothing while the host gives the CPUs to others, so such a lesson runs again."""
    path = f"notebooks/{stem}.ipynb"
    for _ in range(TRIES):
        began, before = time.monotonic(), taken_s()
        page.open(path)
        page.choose_theme(themes_of(stem, page)[0])
        if stem == ROBOT_LESSON:
            page.count_frames()
        page.run_all(path)
        moments = page.frames() if stem == ROBOT_LESSON else []
        notebook = page.save(path)
        failed = compare_run(Tree(ROOT), stem, lab.work / path)
        output = capfd.readouterr().out
        if not failed or taken_s() - before < MOST_TAKEN * (time.monotonic() - began):
            break
        await_calm()
        page.close_notebook()
    assert not failed, output
    assert not unexpected_errors(notebook)
    unrun = [
        cell["id"]
        for cell in notebook["cells"]
        if cell["cell_type"] == "code" and "".join(cell["source"]).strip() and cell["execution_count"] is None
    ]
    assert not unrun, "cells that did not run"
    code = {cell["id"] for cell in notebook["cells"] if cell["cell_type"] == "code"}
    assert set(load_cells(lab, stem)) == code, "what %progress knows of this lesson"
    for number, picture in enumerate(page.panel.locator(".jp-OutputArea img").all()):
        assert picture.evaluate(IS_WHOLE), f"picture {number} is broken"
        assert (picture.get_attribute("alt") or "").strip(), (
            f"picture {number} has no text for those who cannot see it"
        )
    expect(page.pop_ups()).to_have_count(0)
    if stem == ROBOT_LESSON:
        check_robot(page, moments, artifacts)
    pictures = page.panel.locator(".jp-OutputArea img")
    for theme in themes_of(stem, page):
        page.choose_theme(theme)
        if pictures.count():
            pictures.first.scroll_into_view_if_needed()
        page.page.screenshot(path=artifacts / f"lesson_{stem}_{theme}.png")
        assert violations(page.page, NOTEBOOK) == []
