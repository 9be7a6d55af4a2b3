"""The pages of a class and of its students, in both themes. They need a Chromium, but no JupyterLab."""

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.axe import violations
from tests.browser.student_lab import ROOT
from workbook.authoring.site.generated_class import SIZE, STEM, generated_class
from workbook.exercise.definition import load_exercise
from workbook.grading.gradebook import GradebookOptions, write_gradebook
from workbook.grading.pages import CLASS, PAGES, page_name

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
THEMES = ("light", "dark")
WIDTHS = (400, 800, 1280)
BESIDE = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
KINDS_OF_PAGES = {
    "full marks": "Ada Lovelace",
    "wrong rate": "Grace Hopper",
    "skipped": "Katherine Johnson",
    "tried twice": "Joan Clarke",
    "crashed": "Evelyn Boyd Granville",
    "not judged": "Katherine Johnson 2",
}
both_themes = pytest.mark.parametrize("theme", THEMES)


@pytest.fixture(scope="module")
def books(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Generate the pages of a class."""
    out = tmp_path_factory.mktemp("class")
    exercise = load_exercise(STEM, ROOT)
    results = {result.key: result for result in generated_class(exercise, out)}
    assert len(results) == SIZE
    write_gradebook(out, exercise, results, GradebookOptions(("html",)))
    return out / PAGES


@pytest.fixture
def themed(browser: Browser, theme: str) -> Iterator[BrowserContext]:
    """Open a browser in a theme and without a network: requests to anything but the page itself are refused."""
    context = browser.new_context(color_scheme=theme, viewport={"width": 1280, "height": 900})  # type: ignore[arg-type]
    context.route(re.compile("^(?!file:)"), lambda route: route.abort())
    try:
        yield context
    finally:
        context.close()


def opened(context: BrowserContext, path: Path) -> Page:
    page = context.new_page()
    page.goto(path.as_uri())
    return page


@both_themes
def test_the_page_of_a_class_is_for_everybody(
    books: Path, themed: BrowserContext, theme: str, artifacts: Path
) -> None:
    page = opened(themed, books / CLASS)
    assert violations(page) == []
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate(BESIDE) == 0, f"something stands out at {width} px"
        page.screenshot(path=artifacts / f"class_{width}_{theme}.png", full_page=True)


@both_themes
@pytest.mark.parametrize("kind", KINDS_OF_PAGES)
def test_the_page_of_a_student_is_for_everybody(
    books: Path, themed: BrowserContext, theme: str, kind: str, artifacts: Path
) -> None:
    page = opened(themed, books / page_name(KINDS_OF_PAGES[kind], STEM))
    assert violations(page) == []
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate(BESIDE) == 0, f"something stands out at {width} px"
    page.screenshot(path=artifacts / f"student_{kind}_{theme}.png")


def names(page: Page) -> list[str]:
    return [name.strip() for name in page.locator("#students tbody tr:visible th").all_inner_texts()]


@pytest.mark.parametrize("theme", ["light"])
def test_the_map_of_a_class_can_be_sorted_and_filtered(books: Path, themed: BrowserContext) -> None:
    page = opened(themed, books / CLASS)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    everybody = names(page)
    assert len(everybody) == SIZE
    points = [cell for cell in page.locator("#students tbody .number").all_inner_texts() if cell != "–"]
    assert points == sorted(points, key=float)

    heads = page.locator("#students thead th")
    heads.first.locator("button").click()
    expect(heads.first).to_have_attribute("aria-sort", "ascending")
    assert names(page) != everybody
    assert sorted(names(page)) == sorted(everybody)
    first_to_last = names(page)
    heads.first.locator("button").press("Enter")
    expect(heads.first).to_have_attribute("aria-sort", "descending")
    assert names(page) == first_to_last[::-1]

    rate = heads.filter(has_text="The joint positions are published at 0.5 Hz")
    rate.locator("button").click()
    expect(page.locator("[aria-sort]")).to_have_count(1)
    column = int(rate.locator("b").inner_text())
    states = [
        cell.get_attribute("class") or ""
        for cell in page.locator(f"#students tbody tr td:nth-child({column + 2})").all()
    ]
    assert states == sorted(states, key=["failed", "partial", "skipped", "passed", ""].index)

    page.get_by_label("Student", exact=True).fill("hopper")
    assert names(page) and all("Hopper" in name for name in names(page))
    expect(page.locator("output")).to_have_text(f"{len(names(page))} of {SIZE} students")
    page.get_by_label("Student", exact=True).fill("")
    page.get_by_label("Show").select_option("missing")
    assert set(page.locator("#students tbody tr:visible .number").all_inner_texts()) == {"–"}

    cause = page.locator("[data-show^=cause]").first
    count = int(re.findall(r"\d+", cause.inner_text())[0])
    cause.click()
    expect(page.locator("output")).to_have_text(f"{count} of {SIZE} students")
    assert len(names(page)) == count
    assert not errors


@pytest.mark.parametrize("theme", ["light"])
def test_every_cell_of_the_map_leads_to_the_line_it_stands_for(books: Path, themed: BrowserContext) -> None:
    page = opened(themed, books / CLASS)
    links = page.eval_on_selector_all("#students td a", "links => links.map(link => link.href)")
    assert len(links) > 5 * SIZE
    ids = {path.name: set(re.findall(r'\bid="([^"]+)"', path.read_text())) for path in books.glob("*.html")}
    for link in links:
        address = urlsplit(link)
        assert unquote(address.fragment) in {"", *ids[Path(unquote(address.path)).name]}, link
    assert sum("#" in link for link in links) > 5 * SIZE
    page.locator("#students td.failed a").first.click()
    expect(page.locator("tr:target")).to_contain_text("✗ not yet")
    page.go_back()
    page.locator("#students td a", has_text="timeline").last.click()
    expect(page.locator(":target img")).to_have_attribute("alt", re.compile("Hz"))
