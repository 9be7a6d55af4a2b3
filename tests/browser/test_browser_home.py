"""The first screen, the tour, the home page, and the tabs: JupyterLab before and between the lessons."""

import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from playwright.sync_api import Browser, Locator, TimeoutError, ViewportSize, expect

from tests.browser.axe import violations
from tests.browser.conftest import OpenPage, running_lab
from tests.browser.lab_page import ROBOT, LabPage
from tests.browser.student_lab import ROOT, StudentLab
from workbook.lab.work_folder import first_lesson

pytestmark = [pytest.mark.browser, pytest.mark.slow]
FIRST = first_lesson(ROOT) or ""
EXERCISE = "exercises/05_timers.ipynb"
USUAL, TALL = ViewportSize(width=1280, height=800), ViewportSize(width=1280, height=1000)
WIDTHS = (800, 1280, 1600)
SCREENS = 2.0
"""The largest height of the home page, in screens of the usual size."""
NARROW = (1000, 800)
LEAST_CONTRAST = 4.5
WIDEST_PROSE = 95
"""Characters per line: about ninety on average, but a line of many narrow characters holds a few more."""
TABS = "#jp-main-dock-panel .lm-TabBar-tab"

# Names in the file browser that don't fit and so end in an ellipsis.
_CUT_NAMES = """
() => [...document.querySelectorAll('.jp-DirListing-itemName')]
    .filter(one => [one, ...one.querySelectorAll('*')].some(part => part.scrollWidth > part.clientWidth + 1
        && getComputedStyle(part).display !== 'inline'))
    .map(one => one.innerText)
"""
_LEFT_IS_AT_MOST = "width => document.querySelector('#jp-left-stack').clientWidth <= width"
# The largest number of characters in a line of a lesson's paragraphs.
_WIDEST_LINE = """
panel => {
    let most = 0;
    const shown = [...panel.querySelectorAll('.jp-RenderedMarkdown > p')].filter(one => one.offsetHeight);
    for (const paragraph of shown.slice(0, 20)) {
        const lines = {};
        const walker = document.createTreeWalker(paragraph, NodeFilter.SHOW_TEXT);
        for (let node = walker.nextNode(); node; node = walker.nextNode()) {
            for (let place = 0; place < node.length; place++) {
                const range = new Range();
                range.setStart(node, place);
                range.setEnd(node, place + 1);
                const top = Math.round(range.getBoundingClientRect().bottom / 8);
                lines[top] = (lines[top] || 0) + 1;
            }
        }
        most = Math.max(most, ...Object.values(lines));
    }
    return most;
}
"""
# Parts of the home page that are wider than their box, so they would cover their neighbors.
_STANDS_OUT = """
home => [...home.querySelectorAll('.wb-lessons > li > *, .wb-sums > *')]
    .filter(one => one.scrollWidth > one.clientWidth + 1)
    .map(one => one.innerText)
"""
# For each quiz question (px): the gap between it and its first option, and the gap between the previous options and it.
_GAPS = """
panel => [...panel.querySelectorAll('details + p:has(+ details)')].map(one => [
    one.nextElementSibling.getBoundingClientRect().top - one.getBoundingClientRect().bottom,
    one.getBoundingClientRect().top - one.previousElementSibling.getBoundingClientRect().bottom,
])
"""


@pytest.fixture(scope="module")
def lab(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudentLab]:
    """Run a separate server, because these tests need a first start, before any lesson has run."""
    with running_lab(tmp_path_factory.mktemp("student")) as started:
        yield started


@pytest.fixture(scope="module")
def open_page(browser: Browser, lab: StudentLab) -> Iterator[OpenPage]:
    one = OpenPage(browser, lab)
    yield one
    one.close()


# From now on, record at each frame how far the list of lesson 05 is below its title (px), and the robot's appearance.
_WATCH_GREETING = """
() => {
    [window.rooms, window.looks] = [new Set(), new Set()];
    const look = () => {
        const title = [...document.querySelectorAll('h1')].find(one => one.innerText.startsWith('05'));
        const list = title?.parentElement.querySelector(':scope > h1 ~ ul');
        if (list) {
            window.rooms.add(Math.round(list.getBoundingClientRect().top - title.getBoundingClientRect().top));
        }
        document.querySelectorAll('.wb-greeter svg').forEach(robot => window.looks.add(robot.outerHTML));
        requestAnimationFrame(look);
    };
    look();
}
"""


def is_empty(workspace: dict[str, Any]) -> bool:
    """Return whether a later start will restore no notebook. JupyterLab saves that some time after a tab is closed."""
    return not any(key.startswith("notebook:") for key in workspace["data"])


def tab(page: LabPage, name: str) -> Locator:
    return page.page.locator(TABS, has_text=name)


def close_tab(page: LabPage, name: str) -> None:
    """Close a tab by clicking its cross."""
    tab(page, name).locator(".lm-TabBar-tabCloseIcon").click()


def check_tour(page: LabPage, artifacts: Path) -> None:
    """Go from step to step with the keyboard.

    Check that each step frames its subject, and that Escape ends the tour.
    """
    tour, frame = page.page.locator(".wb-tour"), page.page.locator(".wb-tour-frame")
    expect(tour).to_contain_text("Run a cell")
    titles = []
    while True:
        titles.append(tour.locator("h2").inner_text())
        expect(frame).to_be_visible()
        onward = tour.locator(".wb-tour-next")
        if onward.inner_text() == "Done":
            break
        onward.focus()
        page.page.keyboard.press("Enter")
    assert titles == ["Run a cell", "Stop a cell", "Restart", "A terminal", "The robot panel", "Home"]
    for theme in page.themes():
        page.choose_theme(theme)
        assert violations(page.page, ".wb-tour") == []
        assert min(page.contrasts(tour).values()) >= LEAST_CONTRAST
        page.page.screenshot(path=artifacts / f"tour_{theme}.png")
    tour.locator(".wb-tour-next").focus()
    page.page.keyboard.press("Escape")
    expect(tour).to_have_count(0)
    expect(frame).to_have_count(0)


def check_that_the_tour_follows(page: LabPage, cell: Locator) -> None:
    """Start the tour from the Help menu. Check that it goes on once the reader has run a cell, without taking focus."""
    tour = page.page.locator(".wb-tour")
    page.menu("Help", "One-Minute Tour")
    expect(tour.locator("h2")).to_have_text("Run a cell")
    page.run(cell)
    expect(tour.locator("h2")).to_have_text("Stop a cell")
    assert page.panel.evaluate("notebook => notebook.contains(document.activeElement)")
    tour.locator(".wb-tour-skip").click()
    expect(tour).to_have_count(0)


def check_names_of_files(page: LabPage, artifacts: Path) -> None:
    """Check that each name is shown completely, even in a narrow window, where the column is as narrow as possible."""
    column = page.page.locator("#jp-left-stack")
    expect(column).to_be_hidden()  # the column is hidden to make room for the lesson
    page.page.keyboard.press("Control+b")
    expect(column).to_be_visible()
    names = page.page.locator(".jp-DirListing-itemName")
    wanted = {path.name for path in (ROOT / "notebooks").glob("[0-9]*.ipynb")}
    assert wanted <= {name.replace("\u200b", "").strip() for name in names.all_text_contents()}
    assert page.page.evaluate(_CUT_NAMES) == []
    shown = [name.replace("\u200b", "").strip() for name in names.all_text_contents()]
    assert shown.index("01_the_context.ipynb") + 1 == shown.index("01_the_context_deeper.ipynb")
    for width in NARROW:
        page.page.set_viewport_size({"width": width, "height": 800})
        page.page.wait_for_function(_LEFT_IS_AT_MOST, arg=width / 3)
        try:
            page.page.wait_for_function(f"() => ({_CUT_NAMES.strip()})().length === 0")
        except TimeoutError as error:
            page.page.screenshot(path=artifacts / f"names_{width}.png")
            raise AssertionError(f"cut at {width} px: {page.page.evaluate(_CUT_NAMES)}") from error
        page.page.screenshot(path=artifacts / f"names_{width}.png")
    check_a_row_with_another_name(page)
    page.page.keyboard.press("Control+b")
    page.page.set_viewport_size(USUAL)


def check_a_row_with_another_name(page: LabPage) -> None:
    """Rename the last file so that it comes first.

    All names then move one row down, into elements with another name.
    """
    names = page.page.locator(".jp-DirListing-itemName")
    refresh = page.page.locator('[data-command="filebrowser:refresh"]').first
    file = page.lab.work / "notebooks" / "zz_last.txt"
    file.touch()
    refresh.click()
    expect(names.filter(has_text="zz_\u200blast.txt")).to_have_count(1)
    file = file.rename(file.with_name("00_a_file_with_a_long_name_that_comes_before_all_others.txt"))
    refresh.click()
    expect(names.filter(has_text="before_\u200ball_\u200bothers")).to_have_count(1)
    page.page.wait_for_function(f"() => ({_CUT_NAMES.strip()})().length === 0")
    file.unlink()


def check_layout(page: LabPage, artifacts: Path) -> None:
    """Check the file names, the width of prose, the spacing of questions, the headings, and the browser's theme."""
    check_names_of_files(page, artifacts)
    root = page.page.locator(":root")
    for width in WIDTHS:
        page.page.set_viewport_size({"width": width, "height": 800})
        widest = page.panel.evaluate(_WIDEST_LINE)
        assert widest <= WIDEST_PROSE, f"{widest} characters in a line at {width} px"
    page.page.set_viewport_size(USUAL)
    gaps = page.panel.evaluate(_GAPS)
    assert gaps and all(to_options < to_the_last for to_options, to_the_last in gaps), gaps
    for theme in page.themes():
        page.choose_theme(theme)
        expect(root).to_have_css("color-scheme", theme)


def check_traceback(page: LabPage, cell: Locator, artifacts: Path) -> None:
    """Check an error inside rclpy: the student's own lines are visible, and one click unfolds rclpy's lines."""
    page.write(cell, "import json\n\n\ndef read(text):\n    return json.loads(text)\n\n\nread('{')")
    page.run(cell)
    outputs = cell.locator(".jp-OutputArea")
    expect(outputs).to_contain_text("JSONDecodeError: Expecting property name")
    fold = outputs.locator("details")
    expect(fold.locator("summary")).to_have_text(re.compile("more frames?, inside json"))
    expect(outputs.locator("pre", has_text="raw_decode").first).to_be_hidden()
    fold.locator("summary").click()
    expect(fold.locator("pre").last).to_be_visible()
    cell.scroll_into_view_if_needed()
    page.page.screenshot(path=artifacts / "traceback.png")


def check_prompt(page: LabPage, artifacts: Path) -> None:
    """Check *Talk it through*: one click, or one key, copies the prompt."""
    page.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    prompt = page.panel.locator(".wb-prompt")
    button = prompt.get_by_role("button", name="Copy the prompt")
    for theme in page.themes():
        page.choose_theme(theme)
        prompt.scroll_into_view_if_needed()
        assert violations(page.page, ".wb-prompt") == []
        assert min(page.contrasts(prompt).values()) >= LEAST_CONTRAST
        page.page.screenshot(path=artifacts / f"prompt_{theme}.png")
    button.focus()
    page.page.keyboard.press("Enter")
    expect(prompt.locator("button")).to_have_text("Copied")
    copied = page.page.evaluate("navigator.clipboard.readText()")
    assert copied.startswith("I'm programming a robot with ROS 2 Jazzy")
    assert copied.endswith("exists in Jazzy.")
    expect(button).to_have_text("Copy")


@pytest.mark.whole
def test_the_first_start(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    page.page.set_viewport_size(USUAL)
    page.open_first()
    expect(page.page.locator(f"{TABS} .lm-TabBar-tabLabel")).to_have_text([Path(FIRST).name])
    expect(page.pop_ups()).to_have_count(0)
    assert lab.work.is_dir()
    check_tour(page, artifacts)
    assert (lab.work / ".state" / "tour_seen").is_file(), "it comes by itself once only"
    expect(page.page.locator(f"{TABS}.jp-mod-dirty")).to_have_count(
        0
    )  # merely opening a lesson doesn't modify it
    page.page.screenshot(path=artifacts / "first_start.png")

    cell = page.cell("await watch_robot")
    cell.locator(".cm-content").click()
    page.page.keyboard.press("Shift+Enter")
    expect(cell.locator(".jp-InputPrompt")).to_have_text("[1]:")
    expect(cell.get_by_role("img", name=ROBOT).first).to_be_in_viewport(ratio=0.99)
    page.page.screenshot(path=artifacts / "first_robot.png")
    check_that_the_tour_follows(page, page.panel.locator(".jp-CodeCell").nth(1))
    check_layout(page, artifacts)
    check_prompt(page, artifacts)
    check_traceback(page, page.panel.locator(".jp-CodeCell").nth(1), artifacts)

    close_tab(page, Path(FIRST).name)  # closed by mistake: JupyterLab asks, and the student's text is saved
    dialog = page.page.locator(".jp-Dialog")
    expect(dialog).to_contain_text("Save changes")
    dialog.locator("button", has_text="Save").click()
    expect(tab(page, Path(FIRST).name)).to_have_count(0)
    assert "json.loads(text)" in (lab.work / FIRST).read_text(encoding="utf-8")
    expect_no_kernels(page)
    page.await_server("lab/api/workspaces/default", is_empty)
    page.page.set_viewport_size(TALL)


def expect_no_kernels(page: LabPage) -> None:
    """Wait until the server lists no kernels, because ending takes a kernel a moment."""
    page.await_server("api/kernels", lambda kernels: kernels == [])


def work_done(lab: StudentLab) -> str:
    """Mark lesson 05 as partly read, and store an answer that differs from the best one. Return the next cell."""
    cells = [one for one in lab.notebook("notebooks/05_timers.ipynb")["cells"] if one["cell_type"] == "code"]
    answers = lab.work / "answers"
    (answers / ".best").mkdir(parents=True, exist_ok=True)
    (answers / ".best" / "05_timers.py").write_text("best = 1\n", encoding="utf-8")
    (answers / "05_timers.py").write_text("worse = 1\n", encoding="utf-8")
    file = answers / ".progress.json"
    kept = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    kept["05_timers"] = {"tries": 2, "best": 8.0, "read": [one["id"] for one in cells[:9]], "touched": 9e9}
    partial = file.with_suffix(".new")
    partial.write_text(json.dumps(kept), encoding="utf-8")
    partial.replace(file)
    return str(cells[9]["source"][0] if isinstance(cells[9]["source"], list) else cells[9]["source"])


def test_home_shows_the_way_and_goes_on(page: LabPage, lab: StudentLab, artifacts: Path) -> None:
    page.page.goto(f"{lab.address}/lab?token={lab.token}")  # later starts open this page
    home = page.page.locator(".wb-home")
    expect(home.locator("h1")).to_be_visible()
    expect(page.page.locator("#jupyterlab-splash")).to_have_count(0)
    expect(home.locator("[data-restore]")).to_have_count(0)
    next_cell = work_done(lab)
    expect(home.locator("[data-key=next]")).to_contain_text(
        "Continue at"
    )  # the page follows the progress by itself
    expect(home.locator("#wb-05_timers")).to_contain_text("8 of 10 points")
    check_home(page, home, artifacts)

    restore = home.locator("[data-restore='05_timers']")
    restore.focus()
    page.page.keyboard.press("Enter")
    expect(home.locator("[role=status]")).to_contain_text("is your best version again")
    expect(restore).to_have_count(0)
    assert (lab.work / "answers" / "05_timers.py").read_text(encoding="utf-8") == "best = 1\n"

    onward = home.locator("[data-key=next]")
    onward.focus()
    page.page.keyboard.press("Enter")
    active = page.panel.locator(".jp-Cell.jp-mod-active")
    expect(active).to_be_in_viewport(ratio=0.5)
    expect(active.locator(".cm-content")).to_contain_text(next_cell.splitlines()[0])
    page.page.screenshot(path=artifacts / "went_on.png")
    check_tabs(page, artifacts)


def test_a_robot_waves_where_a_lesson_opens(page: LabPage, artifacts: Path) -> None:
    page.open("notebooks/00_start_here.ipynb")
    expect(page.panel.get_by_role("heading", name="00")).to_be_visible()
    expect(page.panel.locator(".wb-greeter")).to_have_count(0)
    page.page.emulate_media(reduced_motion="no-preference")
    page.page.evaluate(_WATCH_GREETING)
    page.open("notebooks/05_timers.ipynb")
    robot = page.panel.get_by_role("img", name="a robot that waves to you")
    expect(robot).to_be_in_viewport(ratio=0.99)
    page.page.wait_for_function("() => window.looks.size > 20")
    assert len(page.page.evaluate("() => [...window.rooms]")) == 1, "the list jumps when the robot comes"
    for theme in page.themes():
        page.choose_theme(theme)
        page.page.screenshot(path=artifacts / f"greeting_{theme}.png")
        assert violations(page.page, ".wb-greeter") == []
    page.page.emulate_media(reduced_motion="reduce")


def check_home(page: LabPage, home: Locator, artifacts: Path) -> None:
    """Check that everyone can use the home page: in both themes, in narrow and wide windows."""
    assert home.evaluate("one => Boolean(one.closest('main, [role=main]'))")
    robot = home.get_by_role("img", name=ROBOT)
    expect(robot).to_have_attribute("aria-label", re.compile("you've completed 0 % of the course"))
    page.page.set_viewport_size(USUAL)
    assert home.evaluate("one => one.scrollHeight / one.clientHeight") <= SCREENS
    for theme in page.themes():
        page.choose_theme(theme)
        for width in WIDTHS:
            page.page.set_viewport_size({"width": width, "height": 900})
            expect(robot).to_be_in_viewport(ratio=0.99)
            assert home.evaluate("one => one.scrollWidth - one.clientWidth") == 0, f"cut at {width} px"
            assert home.evaluate(_STANDS_OUT) == [], f"one over the other at {width} px"
            page.page.screenshot(path=artifacts / f"home_{width}_{theme}.png")
        assert violations(page.page, ".wb-home") == []
        check_bars(home)
        low = {text: ratio for text, ratio in page.contrasts(home).items() if ratio < LEAST_CONTRAST}
        assert not low, f"{theme}: {low}"
    page.page.set_viewport_size(TALL)


def check_bars(home: Locator) -> None:
    """Check that a progress bar's empty part looks like the page behind it, and that its filled part stands out."""
    for name, is_begun in (("points", True), ("lessons read", False)):
        bar = home.get_by_role("progressbar", name=name)
        with Image.open(io.BytesIO(bar.screenshot())) as image:
            pixels = image.convert("RGB")
        left, right = (pixels.getpixel((x, pixels.height // 2)) for x in (4, pixels.width - 5))
        bright, dark = sorted((luminance(left), luminance(right)), reverse=True)
        ratio = (bright + 0.05) / (dark + 0.05)
        assert ratio >= 3 if is_begun else ratio < 1.1, f"{name}: {left}, {right}"


def luminance(color: Any) -> float:
    """Return a color's relative luminance by WCAG's formula."""
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4
        for part in (one / 255 for one in color)
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def check_tabs(page: LabPage, artifacts: Path) -> None:
    """Check a lesson and its exercise side by side.

    Their tabs can be told apart, opening them modifies nothing, and closing them leaves nothing behind.
    """
    page.open(EXERCISE)
    exercise = page.page.locator(f"{TABS}[data-workbook=exercise]")
    expect(exercise).to_have_class(re.compile("lm-mod-current"))
    words = page.page.locator(TABS, has_text="05_timers").evaluate_all(
        "all => all.map(one => getComputedStyle(one, '::after').content)"
    )
    assert sorted(words) == ['"05 ✎"', '"05"']
    expect(exercise).to_have_attribute("title", re.compile(r"^Exercise 05: Three rates in one robot\nName: "))
    lesson = page.page.locator(f"{TABS}[data-workbook=lesson]")
    expect(lesson).to_have_attribute("title", re.compile(r"^Lesson 05: Timers\nName: "))
    expect(page.page.locator(f"{TABS}.jp-mod-dirty")).to_have_count(0)
    page.page.screenshot(path=artifacts / "tabs.png")
    page.await_server("api/kernels", lambda kernels: len(kernels) == 2)
    exercise.locator(".lm-TabBar-tabCloseIcon").click()
    expect(exercise).to_have_count(0)
    close_tab(page, "05_timers.ipynb")
    expect(tab(page, "05_timers.ipynb")).to_have_count(0)
    close_tab(page, "Home")
    expect_no_kernels(page)
