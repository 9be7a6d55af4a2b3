"""The site: it builds without warnings, its links lead somewhere, and it is interactive without a kernel."""

import fcntl
import gzip
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, Route, expect

from tests.browser.axe import violations
from tests.browser.student_lab import ROOT
from workbook.authoring.site.errors import ErrorPages
from workbook.authoring.tree import Tree
from workbook.lesson.sealed_predictions import all_predictions

pytestmark = [
    pytest.mark.slow,
    pytest.mark.whole,
    pytest.mark.skipif(find_spec("myst_nb") is None, reason="no Sphinx: run `make env EXTRAS=site`"),
]
BUILT = "WORKBOOK_BUILT_SITE"
"""Environment variable: the folder of a site that was built before. It saves time when you rerun one of these tests."""
HOST = "http://localhost"
"""The host of the pages in the browser, which considers it as secure as https."""
BASE = "/rclpy-workbook/"
"""On GitHub, a project's pages are below its name, so no link may begin at the root of the host."""
MOST_BYTES = 300_000
"""The largest size of a page's first view, as gzip sends it, without images."""
WIDTHS = (400, 800, 1280)
# The load event doesn't wait for fonts, or for what a script requests when it starts.
SETTLED = "async () => { await document.fonts.ready; await new Promise(done => requestIdleCallback(done)); }"
KINDS = (
    "index.html",
    "start.html",
    "notebooks/00_start_here.html",
    "notebooks/05_timers.html",
    "exercises/09_joint_positions.html",
    "errors/index.html",
    "errors/symptoms.html",
    "errors/runtimeerror-context-init-must-only-be-called-once.html",
    "instructors/09_joint_positions.html",
    "instructors/class.html",
    "instructors/misconceptions.html",
    "authors/index.html",
    "docs/vocabulary.html",
)
TYPES = {
    ".html": "text/html",
    ".js": "text/javascript",
    ".css": "text/css",
    ".json": "application/json",
    ".png": "image/png",
    ".webp": "image/webp",
    ".svg": "image/svg+xml",
}
PICTURES = (".png", ".webp", ".svg")
SEARCHED = {
    # Error messages in the wording of people's questions, by the place where they asked.
    "ros2/rclpy#1081": (
        "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context, "
        "at ./src/rcl/init.c:241",
        "RCLError: failed to shutdown: rcl_shutdown already called on the given context",
    ),
    "usnistgov/ARIAC#306": (
        "AssertionError: The 'x' field must be of type 'float'",
        "AssertionError: The 'data' field must be of type 'float'",
    ),
    "RobotWebTools/rosbridge_suite#1022": (
        "[rosbridge_websocket]: New publisher discovered on topic '/tf', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: RELIABILITY",
        "New publisher discovered on topic '/robot/heartbeat', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: RELIABILITY",
    ),
    "ros2/rclpy#117": (
        "AttributeError: type object 'type' has no attribute '_TYPE_SUPPORT' This might be a ROS 1 message type but "
        "it should be a ROS 2 message type. Make sure to source your ROS 2 workspace after your ROS 1 workspace.",
        "AttributeError: type object 'str' has no attribute '_TYPE_SUPPORT' "
        "This might be a ROS 1 message type but it should be a ROS 2 message type.",
    ),
    "ros2/launch#636": ("ValueError: generator already executing", "ValueError: generator already executing"),
    "FurqanHabibi/joystick_ros2#4": (
        "TypeError: create_publisher() missing 1 required positional argument: 'qos_profile'",
        "TypeError: Node.create_publisher() missing 1 required positional argument: 'qos_profile'",
    ),
    "ros2/rclpy#1142": (
        "<class 'rclpy._rclpy_pybind11.InvalidHandle'> cannot use Destroyable because destruction was requested",
        "InvalidHandle: cannot use Destroyable because destruction was requested",
    ),
    "ros2/launch_ros#407": (
        "RuntimeError: Context.init() must only be called once",
        "RuntimeError: Context.init() must only be called once",
    ),
    "ros2/demos#808": (
        "TypeError: 'NoneType' object does not support the context manager protocol",
        "TypeError: 'NoneType' object does not support the context manager protocol",
    ),
    "ms-iot/ROSOnWindows#245": (
        "[WARN] [rcl.logging_rosout]: Publisher already registered for provided node name. If this is due to "
        "multiple nodes with the same name then all logs for that logger name will go out over the existing publisher.",
        "[WARN] [rcl.logging_rosout]: Publisher already registered for node name: 'camera'.",
    ),
}
SYMPTOMS = {
    "my callback never runs": "Messages are sent and received, but the callback is never called",
    "ros2 topic echo shows nothing": (
        "Publisher and subscription are both listed, but no messages arrive, and there's no warning."
    ),
}


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """Build the site once for all workers."""
    if os.environ.get(BUILT):
        return Path(os.environ[BUILT]).resolve()
    base = tmp_path_factory.getbasetemp()
    folder = (base if worker_id == "master" else base.parent) / "site"
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "index.html").is_file():
            command = [sys.executable, "-m", "workbook.authoring", "site", "--out", str(folder)]
            done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
            assert done.returncode == 0, done.stdout + done.stderr
    return folder


@cache
def links_and_names(path: Path) -> tuple[frozenset[str], frozenset[str]]:
    """Return what a page links to or loads, and the names within it that others can link to."""
    from bs4 import BeautifulSoup

    soup = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
    links = {
        str(node[name])
        for name in ("href", "src", "data-still")
        for node in soup.find_all(attrs={name: True})
    }
    return frozenset(links), frozenset(str(node["id"]) for node in soup.find_all(id=True))


def test_each_link_leads_somewhere(site: Path) -> None:
    pages = sorted(site.rglob("*.html"))
    assert len(pages) > 200
    lost = []
    for page in pages:
        for link in links_and_names(page)[0]:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
            target = target / "index.html" if target.is_dir() else target
            if not target.is_file():
                lost.append(f"{page.relative_to(site)}: {link}")
            elif parts.fragment and target.suffix == ".html" and parts.path + parts.fragment != "":
                if unquote(parts.fragment) not in links_and_names(target)[1]:
                    lost.append(f"{page.relative_to(site)}: {link}, no such name")
    assert not lost, "\n".join(lost[:40])


def test_each_error_has_a_page_with_its_text_as_title(site: Path) -> None:
    from bs4 import BeautifulSoup

    def letters(text: str) -> str:
        return re.sub(r"\W+", "", text)

    for page in ErrorPages(Tree(ROOT)).pages:
        soup = BeautifulSoup(
            (site / "errors" / f"{page.name}.html").read_text(encoding="utf-8"), "html.parser"
        )
        assert soup.h1 is not None
        assert letters(soup.h1.get_text()) == letters(page.title)


def test_no_page_tells_the_outcome_of_a_prediction_in_plain_text(site: Path) -> None:
    asked = 0
    for page in sorted((site / "notebooks").glob("[0-9]*.html")):
        text = page.read_text(encoding="utf-8")
        asked += text.count('class="wb-predict"')
        assert "The outcome is" not in text
        assert not re.search(r"[✓✗] [a-e]\b", text)
    assert asked == len(all_predictions())


@pytest.fixture
def context(browser: Browser, site: Path, request: pytest.FixtureRequest) -> Iterator[BrowserContext]:
    """Create a browser context that serves only the site's files, below BASE. The site uses no other host."""
    opened = browser.new_context(
        **{"viewport": {"width": 1280, "height": 900}, **getattr(request, "param", {})}
    )
    elsewhere: list[str] = []
    errors: list[str] = []

    def answer(route: Route) -> None:
        parts = urlsplit(route.request.url)
        path = site / unquote(parts.path).removeprefix(BASE)
        if f"{parts.scheme}://{parts.netloc}" != HOST or not parts.path.startswith(BASE):
            elsewhere.append(route.request.url)
            route.abort()
        elif path.is_file():
            route.fulfill(body=path.read_bytes(), content_type=TYPES.get(path.suffix, "text/plain"))
        else:
            errors.append(f"missing: {path}")
            route.fulfill(status=404)

    opened.route(re.compile("^https?:"), answer)
    opened.on("weberror", lambda error: errors.append(str(error.error)))
    yield opened
    opened.close()
    assert not elsewhere
    assert not errors


def opened(context: BrowserContext, name: str) -> Page:
    page = context.new_page()
    page.goto(f"{HOST}{BASE}{name}")
    return page


@pytest.mark.browser
@pytest.mark.parametrize("name", KINDS)
def test_the_first_view_is_small(context: BrowserContext, site: Path, artifacts: Path, name: str) -> None:
    page = context.new_page()
    loaded: list[str] = []
    page.on("request", lambda request: loaded.append(unquote(urlsplit(request.url).path).removeprefix(BASE)))
    page.goto(f"{HOST}{BASE}{name}")
    page.evaluate(SETTLED)
    files = {one for one in loaded if not one.endswith(PICTURES) and (site / one).is_file()}
    size = sum(len(gzip.compress((site / one).read_bytes())) for one in files)
    (artifacts / f"site_{name.replace('/', '_')}.json").write_text(json.dumps({"gzip_bytes": size}))
    assert name in files
    assert size < MOST_BYTES


@pytest.mark.browser
@pytest.mark.parametrize("context", [{"color_scheme": "light"}, {"color_scheme": "dark"}], indirect=True)
@pytest.mark.parametrize("name", KINDS)
def test_a_page_can_be_read_by_everyone(context: BrowserContext, name: str) -> None:
    page = opened(context, name)
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        beside = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        assert beside <= 0, width
        assert violations(page) == [], width


def found(context: BrowserContext, words: str) -> list[str]:
    """Return the addresses of the search results, best first."""
    page = opened(context, f"search.html?q={quote(words)}")
    page.wait_for_selector("#search-results ul.search li a")
    links = page.locator("#search-results ul.search li > a")
    return [str(link.get_attribute("href")).partition("?")[0].partition("#")[0] for link in links.all()]


def address(title: str) -> str:
    return next(f"errors/{page.name}.html" for page in ErrorPages(Tree(ROOT)).pages if page.title == title)


@pytest.mark.browser
@pytest.mark.parametrize("asked", SEARCHED)
def test_an_error_text_from_a_public_question_is_found(context: BrowserContext, asked: str) -> None:
    words, title = SEARCHED[asked]
    assert address(title) in found(context, words)[:3]


@pytest.mark.browser
@pytest.mark.parametrize("words", SYMPTOMS)
def test_a_symptom_in_a_persons_own_words_is_found(context: BrowserContext, words: str) -> None:
    assert address(SYMPTOMS[words]) in found(context, words)[:5]


@pytest.mark.browser
def test_a_click_on_a_prediction_shows_the_recorded_outcome(context: BrowserContext) -> None:
    page = opened(context, "notebooks/05_timers.html")
    outcome = page.locator('.wb-outcome[data-prediction="loop-and-timer"]')
    expect(outcome).to_contain_text("Your prediction comes first")
    printed = page.locator(".output pre", has_text="the loop took")
    expect(printed).to_be_hidden()
    question = page.locator('.wb-predict[data-prediction="loop-and-timer"]')
    question.locator('button[data-letter="a"]').click()
    expect(outcome).to_contain_text("You predicted a, but b happened.")
    expect(outcome).to_contain_text("The outcome is b.")
    expect(printed).to_be_visible()
    page.reload()
    expect(outcome).to_contain_text("You predicted a, but b happened.")


@pytest.mark.browser
@pytest.mark.parametrize("context", [{"reduced_motion": "no-preference"}], indirect=True)
def test_the_robot_plays_the_recording_and_the_slider_chooses_another(context: BrowserContext) -> None:
    page = opened(context, "notebooks/05_timers.html")
    robot = page.locator(".wb-robot:has(input)")
    with page.expect_response(re.compile(r"05_timers-intro-5-1\.json")):
        robot.scroll_into_view_if_needed()
    expect(robot.locator("svg")).to_have_attribute("aria-label", re.compile("moved by a recording"))
    arm = robot.locator("svg > g > g").first
    before = arm.get_attribute("transform")
    page.wait_for_function(
        "([node, before]) => node.parentNode.innerHTML !== before", arg=[arm.element_handle(), before]
    )
    with page.expect_response(re.compile(r"05_timers-intro-5-0\.05\.json")):
        robot.locator("input").focus()
        page.keyboard.press("Home")
    expect(robot.locator("output")).to_have_text("0.05")
    robot.get_by_role("button", name="Pause").click()
    expect(robot.get_by_role("button", name="Play")).to_be_visible()


@pytest.mark.browser
@pytest.mark.parametrize("context", [{"reduced_motion": "reduce"}], indirect=True)
def test_a_reader_who_wants_no_motion_starts_the_robot(context: BrowserContext) -> None:
    page = opened(context, "index.html")
    expect(page.locator(".wb-robot img")).to_be_visible()
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".wb-robot svg")).to_be_visible()


@pytest.mark.browser
@pytest.mark.parametrize("context", [{"reduced_motion": "no-preference"}], indirect=True)
def test_a_film_has_controls(context: BrowserContext) -> None:
    page = opened(context, "notebooks/07_typed_nodes.html")
    page.locator("img.wb-film").first.scroll_into_view_if_needed()
    slider = page.get_by_label("Position in the film").first
    expect(slider).not_to_have_value("0")
    expect(page.locator("canvas.wb-film").first).to_be_visible()
    controls = page.locator(".wb-controls", has=slider)
    controls.get_by_role("button", name="Pause").click()
    expect(controls.get_by_role("button", name="Play")).to_be_visible()
    slider.press("End")
    expect(controls.get_by_role("button", name="Replay")).to_be_visible()


@pytest.mark.browser
@pytest.mark.parametrize("context", [{"reduced_motion": "reduce"}], indirect=True)
def test_a_film_can_be_stopped_in_a_browser_that_cannot_take_it_apart(context: BrowserContext) -> None:
    context.add_init_script("delete window.ImageDecoder")
    page = opened(context, "notebooks/07_typed_nodes.html")
    film = page.locator("img.wb-film").first
    moving = str(film.get_attribute("src"))
    film.scroll_into_view_if_needed()
    button = page.locator("img.wb-film + .wb-controls button").first
    expect(button).to_have_text("Play")
    expect(film).not_to_have_attribute("src", moving)
    button.click()
    expect(button).to_have_text("Stop")
    expect(film).to_have_attribute("src", re.compile(re.escape(moving.rpartition("/")[2])))
