"""Measure a student's waits: from `workbook lab` to a usable page, and from the first key to the first output.

`make bench` (tests/bench.py) uses this, with a real JupyterLab and a Chromium that is already running.
"""

import tempfile
import time
from pathlib import Path

from playwright.sync_api import Browser, expect, sync_playwright

from tests.browser.lab_page import LabPage
from tests.browser.student_lab import StudentLab
from workbook.lab.health import chromium

LESSON = "notebooks/00_start_here.ipynb"


def missing() -> str | None:
    """Return why the measurement is impossible here, or None."""
    return None if chromium() is not None else "no Chromium"


def measured_starts(times: int) -> tuple[list[float], list[float]]:
    """Return the seconds of `times` later starts, and those of the first cell after each start."""
    starts, answers = [], []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", "--disable-dev-shm-usage"]
        )
        StudentLab(Path(folder)).close()  # the first start copies the lessons
        for _ in range(times):
            start, answer = one_start(browser, Path(folder))
            starts.append(start)
            answers.append(answer)
        browser.close()
    return starts, answers


def one_start(browser: Browser, folder: Path) -> tuple[float, float]:
    """Measure one later start, in a browser that kept nothing from earlier ones."""
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    began = time.monotonic()
    lab = StudentLab(folder)
    try:
        page = LabPage(context.new_page(), lab)
        page.page.goto(lab.url)
        expect(page.page.locator(".wb-home [data-key=next]")).to_be_visible()
        expect(page.page.locator("#jupyterlab-splash")).to_have_count(0)
        start = time.monotonic() - began
        page.open(LESSON)
        cell = page.panel.locator(".jp-CodeCell").first
        cell.locator(".cm-content").click()
        began = time.monotonic()
        page.page.keyboard.press("Shift+Enter")
        expect(cell.locator(".jp-OutputArea-output").first).to_be_visible()
        return start, time.monotonic() - began
    finally:
        context.close()
        lab.close()
