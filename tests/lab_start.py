"""How long a student waits: from `workbook lab` to a page to use, and from the first key to the first answer.

For `make bench` (tests/bench.py): a real JupyterLab and a Chromium that is running already.
"""

import tempfile
import time
from pathlib import Path

from browser.lab_page import LabPage
from browser.student_lab import StudentLab
from playwright.sync_api import Browser, expect, sync_playwright

from workbook.lab.health import chromium

LESSON = "notebooks/00_start_here.ipynb"


def missing() -> str | None:
    """What is missing to measure it; None when all is there."""
    return None if chromium() is not None else "no Chromium"


def measured_starts(times: int) -> tuple[list[float], list[float]]:
    """Seconds of so many later starts, and of the first cell in each, once its kernel is idle."""
    starts, answers = [], []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", "--disable-dev-shm-usage"]
        )
        StudentLab(Path(folder)).close()  # the first start, which copies the lessons
        for _ in range(times):
            start, answer = one_start(browser, Path(folder))
            starts.append(start)
            answers.append(answer)
        browser.close()
    return starts, answers


def one_start(browser: Browser, folder: Path) -> tuple[float, float]:
    """One later start, in a browser without anything kept from the one before."""
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
