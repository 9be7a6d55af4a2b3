"""Start JupyterLab as a student does, and a Chromium that displays it."""

import contextlib
import os
from collections.abc import Generator, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType

import psutil
import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from tests.browser.lab_page import LabPage
from tests.browser.student_lab import ROOT, StudentLab, await_end, descendants
from workbook.lab.health import chromium

KERNEL_END_S = 60.0
GIVES_WAY = 5
"""Nice value of the browser: an image may come later, but the measurements in a lesson must not be disturbed."""
_failed = pytest.StashKey[bool]()


@pytest.fixture(scope="package")
def artifacts() -> Path:
    """Create the folder for screenshots and measurements (not in git)."""
    folder = ROOT / "artifacts" / "browser"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.fixture(scope="package")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    path = chromium()
    if path is None:
        pytest.skip("no Chromium for the tests in a real browser (apt: chromium)")
    others = descendants(os.getpid())
    # While a Playwright is open, an event loop runs in this thread, so no other test could run one.
    with sync_playwright() as playwright:
        # A container may have neither user namespaces nor enough room in /dev/shm.
        opened = playwright.chromium.launch(
            executable_path=path,
            args=["--no-sandbox", "--disable-dev-shm-usage"],
            env={"PATH": os.environ["PATH"], "HOME": str(tmp_path_factory.mktemp("browser"))},
        )
        for process in descendants(os.getpid()) - others:
            with contextlib.suppress(psutil.NoSuchProcess):
                process.nice(GIVES_WAY)
        yield opened
        opened.close()


@contextlib.contextmanager
def running_lab(folder: Path, environ: Mapping[str, str] = MappingProxyType({})) -> Iterator[StudentLab]:
    """Run a server with a new student's copy. After the server ends, nothing may be left of it."""
    started = StudentLab(folder, environ)
    left: dict[int, str] = {}
    try:
        yield started
    finally:
        left = started.close()
    assert not left, f"still running after JupyterLab was stopped: {left}"


@pytest.fixture(scope="package")
def lab(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudentLab]:
    """Run one server per worker, for all tests that don't request an unused student's copy."""
    with running_lab(tmp_path_factory.mktemp("student")) as started:
        yield started


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if report.failed:
        item.stash[_failed] = True
    return report


class OpenPage:
    """A worker's browser page. JupyterLab stays open in it from test to test, as on a student's afternoon.

    Loading JupyterLab costs several seconds of CPU time. After a failed test, the page is not used again.
    """

    def __init__(self, browser: Browser, lab: StudentLab) -> None:
        self._browser = browser
        self._lab = lab
        self._kept: LabPage | None = None

    def take(self) -> LabPage:
        if self._kept is None:
            context = self._browser.new_context(
                viewport={"width": 1280, "height": 1000}, reduced_motion="reduce"
            )
            return LabPage(context.new_page(), self._lab)
        kept, self._kept = self._kept, None
        return kept

    def keep(self, page: LabPage) -> None:
        self._kept = page

    def close(self) -> None:
        if self._kept is not None:
            self._kept.page.context.close()


@pytest.fixture(scope="package")
def open_page(browser: Browser, lab: StudentLab) -> Iterator[OpenPage]:
    one = OpenPage(browser, lab)
    yield one
    one.close()


@pytest.fixture
def page(open_page: OpenPage, lab: StudentLab, request: pytest.FixtureRequest) -> Iterator[LabPage]:
    """Provide JupyterLab without an open notebook. At the end, stop the test's kernels and all that they started."""
    one = open_page.take()
    in_order = False
    try:
        yield one
        started = lab.processes()
        while one.notebook_tabs().count():
            one.close_notebook()
        left = await_end(started, KERNEL_END_S)
        assert not left, f"still running after the notebook was shut down: {left}"
        assert not one.failures, f"errors in the page: {one.failures}"
        in_order = not request.node.stash.get(_failed, False)
    finally:
        if in_order:
            open_page.keep(one)
        else:
            one.page.context.close()


@pytest.fixture
def browser_page(browser: Browser) -> Iterator[Page]:
    """Provide an empty page, without JupyterLab."""
    context = browser.new_context(viewport={"width": 900, "height": 700})
    try:
        yield context.new_page()
    finally:
        context.close()
