"""Use JupyterLab as a person does: menus, cells, the keyboard. Wait for changes on the page, never for a fixed time."""

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import quote

from playwright.sync_api import Locator, Page, expect

from tests.browser.student_lab import ROOT, StudentLab
from workbook.lab.work_folder import first_lesson

QUICK_MS = 120_000
CELL_MS = 180_000
LESSON_MS = 600_000
LOOK_EVERY_MS = 1500  # at every frame, polling would keep the browser drawing
ASK_EVERY_MS = 200
ROBOT = "a humanoid robot with twelve joints"
_PANEL = ".jp-NotebookPanel:not(.lm-mod-hidden)"
NOTEBOOK = f"{_PANEL} .jp-Notebook"
_TABS = "#jp-main-dock-panel .lm-TabBar-tab"

# Either every code cell has its number, or a cell failed that was not meant to. When a cell raises as it is meant to,
# JupyterLab removes the asterisks from the waiting cells, so a missing asterisk proves nothing. JupyterLab also adds
# cells to the page gradually: on a busy machine, the first cells have run before the last ones are there.
_ALL_RAN = """
([panel, mayRaise]) => {
    const cells = [...document.querySelectorAll(panel + ' .jp-CodeCell')];
    if (cells.length < mayRaise.length) return false;
    const error = '[data-mime-type="application/vnd.jupyter.stderr"] .ansi-red-fg';
    const ran = (cell) => /\\d/.test(cell.querySelector('.jp-InputPrompt').textContent);
    if (cells.some((cell, index) => cell.querySelector(error) && ran(cell) && !mayRaise[index])) return true;
    return cells.every(ran);
}
"""

# The number alone proves nothing: a saved notebook may show the same number from an earlier kernel. But in between, the
# prompt changes to an asterisk.
CHANGED = "data-changed"
_NOTE_CHANGE = f"""
(prompt) => {{
    prompt.removeAttribute("{CHANGED}");
    const observer = new MutationObserver(() => {{
        prompt.setAttribute("{CHANGED}", "yes");
        observer.disconnect();
    }});
    observer.observe(prompt, {{childList: true, characterData: true, subtree: true}});
}}
"""

# The moments (ms) at which the robot in a cell moved.
_COUNT_FRAMES = """
(name) => {
    const moments = [];
    let last = null;
    const look = () => {
        const body = document.querySelector(`.workbook-cell-robot svg[aria-label^="${name}"] > g`);
        if (body && body.getAttribute('transform') !== last) {
            last = body.getAttribute('transform');
            moments.push(performance.now());
        }
    };
    new MutationObserver(look).observe(document.body, {subtree: true, childList: true, attributes: true});
    window.robotMoments = moments;
}
"""

# Contrast between each text in an element and its background, by WCAG's formula.
_CONTRASTS = """
(card) => {
    const parse = (text) => (text.match(/[\\d.]+/g) || []).map(Number);
    const light = ([r, g, b]) => {
        const [x, y, z] = [r, g, b].map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
        return 0.2126 * x + 0.7152 * y + 0.0722 * z;
    };
    const behind = (element) => {
        const tints = [];
        let ground = [255, 255, 255];
        for (let one = element; one; one = one.parentElement) {
            const color = parse(getComputedStyle(one).backgroundColor);
            if (color.length === 3 || color[3] > 0.99) {
                ground = color.slice(0, 3);
                break;
            }
            if (color[3] > 0) tints.unshift(color);
        }
        const over = (below, [r, g, b, share]) => [r, g, b].map((part, i) => below[i] * (1 - share) + part * share);
        return tints.reduce(over, ground);
    };
    const found = [];
    const walker = document.createTreeWalker(card, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement;
        if (!node.textContent.trim() || !element.checkVisibility() || element.closest('progress')) continue;
        const [one, other] = [parse(getComputedStyle(element).color), behind(element)].map(light);
        const ratio = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
        found.push({text: node.textContent.trim().slice(0, 60), ratio: Math.round(ratio * 100) / 100});
    }
    return found;
}
"""


def _kind(path: str) -> str:
    """Return the front end's name for this kind of notebook."""
    return "exercise" if path.startswith("exercises/") else "lesson"


def _is_idle(session: dict[str, Any], path: str) -> bool:
    """Return whether this is that notebook's session and its kernel is idle."""
    kernel = session["kernel"]
    return session["path"] == path and kernel["connections"] > 0 and kernel["execution_state"] == "idle"


class LabPage:
    """A browser page that shows JupyterLab."""

    def __init__(self, page: Page, lab: StudentLab) -> None:
        self.page = page
        self.lab = lab
        self.failures: list[str] = []
        page.set_default_timeout(QUICK_MS)
        expect.set_options(timeout=QUICK_MS)
        page.on("pageerror", lambda error: self.failures.append(str(error)))

    # --- opening and closing ---------------------------------------------------------------------------------

    def open_first(self) -> None:
        """Follow the address that `workbook lab` prints."""
        self.page.goto(self.lab.url)
        self._wait_until_loaded(first_lesson(ROOT) or "")

    def open(self, path: str) -> None:
        """Open a notebook of the student's copy:

        by its address on an empty page, otherwise with File > Open from Path.
        """
        if self.page.locator("#jp-main-dock-panel").count():
            self.menu("File", re.compile("^Open from Path"))
            dialog = self.page.locator(".jp-Dialog")
            dialog.locator("input").fill(path)
            dialog.locator("button.jp-mod-accept").click()
            expect(dialog).to_have_count(0)
        else:
            where = f"{self.lab.address}/lab/workspaces/{quote(Path(path).stem)}/tree/{quote(path)}"
            self.page.goto(f"{where}?reset&token={self.lab.token}")
        self._wait_until_loaded(path)

    def _wait_until_loaded(self, path: str) -> None:
        """Wait until the notebook `path` is in front and its kernel is idle."""
        is_front = self.page.locator(f"{_TABS}[data-workbook={_kind(path)}].lm-mod-current")
        expect(is_front.filter(has_text=Path(path).name)).to_be_visible()
        expect(self.panel.locator(".jp-Cell").first).to_be_visible()
        expect(self.page.locator("#jupyterlab-splash")).to_have_count(0)
        self.await_server("api/sessions", lambda sessions: any(_is_idle(one, path) for one in sessions))
        expect(self.page.locator("#jp-main-statusbar")).to_contain_text("rclpy workbook | Idle")

    def await_server(self, path: str, is_so: Callable[[Any], bool]) -> None:
        """Request `path` from JupyterLab's server until `is_so` accepts the response."""
        deadline = time.monotonic() + QUICK_MS / 1000
        address = f"{self.lab.address}/{path}?token={self.lab.token}"
        while not is_so(answer := self.page.request.get(address).json()):
            assert time.monotonic() < deadline, f"{path}: {answer}"
            self.page.wait_for_timeout(ASK_EVERY_MS)

    @property
    def panel(self) -> Locator:
        return self.page.locator(_PANEL)

    def pop_ups(self) -> Locator:
        """Return dialogs and notifications."""
        return self.page.locator(".jp-Dialog, .Toastify__toast")

    def notebook_tabs(self) -> Locator:
        """Return the tabs of the open notebooks, no matter which one is in front."""
        return self.page.locator(f"{_TABS}[data-workbook]")

    def close_notebook(self) -> None:
        """File > Close and Shut Down Notebook, without saving: the notebook in front, or else the first one."""
        tabs = self.notebook_tabs()
        before = tabs.count()
        front = self.page.locator(f"{_TABS}[data-workbook].lm-mod-current")
        (
            front if front.count() else tabs
        ).first.click()  # after another notebook was closed, the one in front has no focus
        self.menu("File", re.compile("Close and Shut Down"))
        self.page.locator(".jp-Dialog button.jp-mod-warn").click()
        expect(tabs).to_have_count(before - 1)

    # --- menus and keys --------------------------------------------------------------------------------------

    def menu(self, *path: str | re.Pattern[str]) -> None:
        """Choose an entry, such as menu("Run", "Run All Cells")."""
        top, *rest = path
        self.page.locator(".lm-MenuBar-item", has_text=top).click()
        for depth, label in enumerate(rest):
            text = re.compile(f"^{re.escape(label)}$") if isinstance(label, str) else label
            entry = self.page.locator(".lm-Menu-item:not(.lm-mod-disabled)").filter(
                has=self.page.locator(".lm-Menu-itemLabel", has_text=text)
            )
            entry.hover() if depth < len(rest) - 1 else entry.click()

    def choose_theme(self, theme: str) -> None:
        """Choose the theme in the Settings menu. `theme`: light or dark."""
        is_light = "true" if theme == "light" else "false"
        if self.page.locator("body").get_attribute("data-jp-theme-light") != is_light:
            self.menu("Settings", "Theme", f"JupyterLab {theme.title()}")
        expect(self.page.locator("body")).to_have_attribute("data-jp-theme-light", is_light)
        expect(self.page.locator("#jupyterlab-splash")).to_have_count(0)

    def themes(self) -> tuple[str, str]:
        """Return both themes, the current one first."""
        is_light = self.page.locator("body").get_attribute("data-jp-theme-light") == "true"
        return ("light", "dark") if is_light else ("dark", "light")

    def save(self, path: str) -> dict[str, Any]:
        """Press Ctrl+S. Wait until the notebook has been saved, and return it as it is on disk."""

        def is_save(request: Any) -> bool:
            return request.method == "PUT" and f"/api/contents/{path}" in request.url

        with self.page.expect_request(is_save) as asked:
            self.page.keyboard.press("Control+s")
        saved = asked.value.response()
        assert saved is not None and saved.ok, saved and saved.status_text
        return self.lab.notebook(path)

    # --- cells -----------------------------------------------------------------------------------------------

    def run_all(self, path: str) -> None:
        """Clear all outputs, run all cells of the notebook `path`, and wait until the last one has ended."""
        self.menu("Edit", "Clear Outputs of All Cells")
        expect(self.panel.locator(".jp-OutputArea-output")).to_have_count(0)
        self.menu("Run", "Run All Cells")
        self.page.wait_for_function(
            _ALL_RAN, arg=[_PANEL, self._may_raise(path)], timeout=LESSON_MS, polling=LOOK_EVERY_MS
        )

    def _may_raise(self, path: str) -> list[bool]:
        """Return for each code cell whether it is marked as raising an error."""
        code = [cell for cell in self.lab.notebook(path)["cells"] if cell["cell_type"] == "code"]
        return ["raises-exception" in cell["metadata"].get("tags", []) for cell in code]

    def cell(self, text: str) -> Locator:
        """Return the first code cell that contains this text."""
        return (
            self.panel.locator(".jp-CodeCell")
            .filter(has=self.page.locator(".cm-content", has_text=text))
            .first
        )

    def write(self, cell: Locator, text: str) -> None:
        """Replace a cell's content, as a person does by selecting all and pasting."""
        cell.locator(".cm-content").click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(text)

    def run(self, cell: Locator) -> None:
        """Press Ctrl+Enter in a cell, and wait until it has ended."""
        prompt = cell.locator(".jp-InputPrompt")
        prompt.evaluate(_NOTE_CHANGE)
        cell.locator(".cm-content").click()
        self.page.keyboard.press("Control+Enter")
        expect(prompt).to_have_attribute(CHANGED, "yes")
        expect(prompt).to_have_text(re.compile(r"\[\d+\]"), timeout=CELL_MS)

    # --- visible results -------------------------------------------------------------------------------------

    def count_frames(self) -> None:
        """From now on, record the moment of each move of the robot in a cell."""
        self.page.evaluate(_COUNT_FRAMES, ROBOT)

    def frames(self) -> list[float]:
        """Return the times (s, page clock) at which the robot in a cell moved."""
        return [moment / 1000 for moment in self.page.evaluate("() => window.robotMoments")]

    @staticmethod
    def contrasts(element: Locator) -> dict[str, float]:
        """Return each text in an element with its contrast to its background (1 to 21)."""
        return {one["text"]: one["ratio"] for one in element.evaluate(_CONTRASTS)}
