"""The exercise notebook as a student uses it: a wrong answer, its card, the right answer, and the updated card."""

import json
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.axe import violations
from tests.browser.lab_page import CELL_MS, ROBOT, LabPage
from tests.browser.student_lab import ROOT, StudentLab, await_end, running
from tests.browser.test_browser_panel import observers
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.feedback.card import Card, Extras
from workbook.feedback.timeline import judged_timeline
from workbook.feedback.wording import SIGNS, WORDS, earned, worst_first
from workbook.lesson.robot_in_cell import ROBOT as LIVE
from workbook.pictures.joints import CHEER, SQUAT
from workbook.recording.recording import Recording

pytestmark = [pytest.mark.browser, pytest.mark.slow]
STEM = "09_joint_positions"
NOTEBOOK = f"exercises/{STEM}.ipynb"
WRONG = Tree(ROOT).wrong_answers / STEM / "period_for_frequency.py"
RECORDED = ROOT / "tests" / "recordings" / STEM / "period_for_frequency.json"
FULL_MARKS = "Full marks: 10 of 10 points."
LEAST_CONTRAST = 4.5
NARROW = {"width": 800, "height": 900}
CARD = ".jp-OutputArea-output:has(div[style*=border-left])"
# How far content overflows an element (px). A timeline is exempt, because it scrolls inside its own box.
STANDS_OUT = """
card => Math.max(...[card, ...card.querySelectorAll(':not([aria-label=Timeline] > img)')].map(one => {
    const right = one.getBoundingClientRect().right - card.getBoundingClientRect().right;
    const fits = one.matches('progress, [aria-label=Timeline]');
    return Math.max(right, fits ? 0 : one.scrollWidth - one.clientWidth * (one.clientWidth > 0));
}))
"""
# Words in a card's tables that the browser broke inside, although names may wrap only after a / or _ (and hyphens).
BROKEN_WORDS = r"""
card => [...card.querySelectorAll('td')].flatMap(cell => {
    const broken = [];
    const walker = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        for (const word of node.data.matchAll(/[^\s-]+/g)) {
            const range = new Range();
            range.setStart(node, word.index);
            range.setEnd(node, word.index + word[0].length);
            if (new Set([...range.getClientRects()].map(one => Math.round(one.top))).size > 1) {
                broken.push(word[0]);
            }
        }
    }
    return broken;
})
"""
WATCHED = "from workbook.lesson import watch_robot\n\n%start\nawait watch_robot(seconds=1)"
FRONT_END = ROOT / "workbook/lab/front_end/panel"
POSED = f"{ROBOT}, posed by the last message on /robot/joint_positions"
_PARTS = "svg => [...svg.querySelectorAll('g')].map(part => part.getAttribute('transform'))"
HELD = f"([svg, parts]) => String(({_PARTS})(svg)) === String(parts)"
DRAWN = f"""
async ([code, figure, pose]) => {{
    const {{Robot}} = await import(URL.createObjectURL(new Blob([code], {{type: 'text/javascript'}})));
    const robot = new Robot(figure);
    robot.take({{awake: true, pose}});
    while (robot._frame !== null) await new Promise(requestAnimationFrame);
    return ({_PARTS})(robot.node);
}}
"""
TIMELINE_PX = 560
REST_MS = 2000
CHANGES = """
(svg, ms) => new Promise(done => {
    let changes = 0;
    new MutationObserver(records => changes += records.length).observe(svg, {attributes: true, subtree: true});
    setTimeout(() => done(changes), ms);
})
"""
COUNT_MOVES = """
svg => {
    window.robotMoves = 0;
    const moved = () => window.robotMoves++;
    new MutationObserver(moved).observe(svg.querySelector('g'), {attributes: true, attributeFilter: ['transform']});
}
"""
# Scroll without waiting: Playwright's own scrolling waits until the card stands still, but a card may be replaced at
# any time.
SCROLL_TO = "card => card.scrollIntoView({block: 'nearest'})"


@pytest.fixture(scope="module")
def exercise() -> Exercise:
    return load_exercise(STEM, ROOT)


def headline_of(card: Locator) -> Locator:
    return card.locator("p b").first


def check_legibility(page: LabPage, card: Locator) -> None:
    """Check that every text of the card stands out from its background, and that axe finds nothing."""
    contrasts = page.contrasts(card)
    assert any(text in headline_of(card).inner_text() for text in contrasts)
    assert {text: ratio for text, ratio in contrasts.items() if ratio < LEAST_CONTRAST} == {}
    assert violations(page.page, CARD) == []


def check_that_nothing_is_cut(page: LabPage, card: Locator, path: Path) -> None:
    """Check that even a narrow window shows the whole card without scrolling sideways."""
    wide = page.page.viewport_size
    assert wide is not None
    page.page.set_viewport_size(NARROW)
    card.evaluate(SCROLL_TO)
    page.page.screenshot(path=path)
    assert card.evaluate(STANDS_OUT) <= 1
    page.page.set_viewport_size(wide)


def check_next_to_the_panel(page: LabPage, card: Locator, path: Path) -> None:
    """Check a narrow window with the panel open: names stay readable, and the table scrolls and shows that it does."""
    wide = page.page.viewport_size
    assert wide is not None
    page.page.set_viewport_size(NARROW)
    robot = page.panel.get_by_role("button", name="Robot", exact=True)
    robot.click()
    expect(page.page.locator(".workbook-panel:not(.lm-mod-hidden)")).to_be_visible()
    card.evaluate(SCROLL_TO)
    page.page.screenshot(path=path)
    assert card.evaluate(BROKEN_WORDS) == []
    table = card.get_by_role("group", name="Criteria")
    assert table.evaluate("one => one.scrollWidth - one.clientWidth") > 0
    expect(table).to_have_css("background-image", re.compile("linear-gradient"))
    table.focus()
    page.page.keyboard.press("ArrowRight")
    page.page.wait_for_function("one => one.scrollLeft > 0", arg=table.element_handle())
    assert violations(page.page, CARD) == []
    robot.click()
    page.page.set_viewport_size(wide)


def check_timeline(card: Locator) -> None:
    """Check that the timeline's words stay readable in a narrow window, and that it scrolls."""
    timeline = card.locator("img")
    assert timeline.evaluate("image => image.clientWidth") == TIMELINE_PX
    assert timeline.evaluate("image => image.parentElement.clientWidth") < TIMELINE_PX
    timeline.evaluate("image => image.parentElement.scrollBy(1000, 0)")
    assert timeline.evaluate("image => image.parentElement.scrollLeft") > 0


def check_picture(card: Locator) -> None:
    picture = card.locator("img")
    expect(picture).to_have_attribute("alt", re.compile("/robot/joint_positions"))
    expect(picture).to_have_js_property("complete", True)
    expect(picture).not_to_have_js_property("naturalWidth", 0)


def screenshot(outputs: Locator, path: Path) -> None:
    """Save a screenshot of a cell's outputs. The card in them may be replaced at any time, but the outputs stay."""
    outputs.scroll_into_view_if_needed()
    outputs.screenshot(path=path)


def in_both_themes(page: LabPage) -> Iterator[str]:
    for theme in page.themes():
        page.choose_theme(theme)
        yield theme


def test_a_wrong_answer_then_the_right_one(
    page: LabPage, lab: StudentLab, exercise: Exercise, artifacts: Path
) -> None:
    page.open(NOTEBOOK)
    answer, check = page.cell("%%answer"), page.cell("%check")
    written = lab.work / "answers" / f"{STEM}.py"
    card = check.locator(".jp-OutputArea-output div[style*=border-left]")

    wrong = read_wrong_answer(Tree(ROOT), WRONG).answer.text
    page.write(answer, f"%%answer {STEM}\n{wrong}")
    page.run(answer)
    expect(answer.locator(".jp-OutputArea")).to_contain_text(f"Saved as answers/{STEM}.py.")
    assert written.read_text(encoding="utf-8").strip() == wrong.strip()
    page.run(check)
    expect(card).to_have_count(1)
    expect(card).to_contain_text("Start with this criterion: The joint positions are published at 0.5 Hz")
    expect(card).not_to_contain_text("Provisional", timeout=CELL_MS)
    expect(headline_of(card)).to_contain_text("8 of 10 points.")
    check_picture(card)
    for theme in in_both_themes(page):
        screenshot(check.locator(".jp-OutputArea"), artifacts / f"card_wrong_{theme}.png")
        check_legibility(page, card)
    check_that_nothing_is_cut(page, card, artifacts / "card_wrong_narrow.png")
    check_next_to_the_panel(page, card, artifacts / "card_wrong_panel.png")

    # The answer cell was changed but not run. The judge still gets the text on the screen.
    page.write(answer, f"%%answer 09 --check\n{exercise.source.solution_code}")
    page.run(check)
    expect(headline_of(card)).to_contain_text(FULL_MARKS, timeout=CELL_MS)
    expect(check.locator(".jp-OutputArea")).to_contain_text("Saved the current answer cell")
    assert written.read_text(encoding="utf-8").strip() == exercise.source.solution_code.strip()
    expect(card).not_to_contain_text("Start with this criterion")
    expect(card).to_contain_text(re.compile(rf"Hand in this file: answers/{STEM}\.py.*Next: 10", re.DOTALL))
    expect(card).to_contain_text("2 more points than before.")
    expect(card).to_contain_text("Then it started the program again", timeout=CELL_MS)
    expect(card.get_by_role("img", name="A replay")).to_be_visible()
    for theme in in_both_themes(page):
        screenshot(check.locator(".jp-OutputArea"), artifacts / f"card_right_{theme}.png")
        page.page.screenshot(path=artifacts / f"exercise_{theme}.png")
    for fold in card.locator("summary").all():
        fold.click()
    expect(card.locator("pre").last).to_contain_text("THE TASK")
    for theme in in_both_themes(page):
        check_legibility(page, card)
        page.page.screenshot(path=artifacts / f"exercise_unfolded_{theme}.png")

    # A later wrong version doesn't replace the best one. The student restores the best one to the cell and the file.
    page.write(answer, f"%%answer {STEM}\n{wrong}")
    page.write(check, "%restore")
    restore = page.cell("%restore")
    page.run(restore)
    expect(restore.locator(".jp-OutputArea")).to_contain_text("is your best version")
    content = answer.locator(".cm-content")
    expect(content).to_contain_text(f"%%answer {STEM}")
    expect(content).to_contain_text(exercise.source.solution_code.strip().splitlines()[-1].strip())
    cells = page.save(NOTEBOOK)["cells"]
    shown = next("".join(one["source"]) for one in cells if "".join(one["source"]).startswith("%%answer"))
    assert shown.partition("\n")[2].strip() == exercise.source.solution_code.strip()
    assert not [one for one in cells if "workbook" in one["metadata"]], (
        "what is told to the kernel stays out of the file"
    )
    expect(page.pop_ups()).to_have_count(0)


def holds(pose: Sequence[float]) -> str:
    """Return an answer whose robot holds this pose."""
    return f"""\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray
rclpy.init()
node = Node("holder")
poses = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
node.create_timer(0.1, lambda: poses.publish(Float32MultiArray(data={list(pose)})))
rclpy.spin(node)
"""


def drawn_by_the_rig(page: Page, pose: Sequence[float]) -> list[str]:
    """Return the positions of the figure's parts in this pose, once it has come to rest."""
    code = (FRONT_END / "rig.js").read_text(encoding="utf-8")
    figure = json.loads((FRONT_END / "figure.json").read_text(encoding="utf-8"))
    rounded = [float(np.float32(angle)) for angle in pose]  # rounded to float32, as in the message
    return list(page.evaluate(DRAWN, [code, figure, rounded]))


@pytest.mark.whole
def test_start_shows_the_robot_in_the_cell_and_stop_lets_it_rest(
    page: LabPage, exercise: Exercise, artifacts: Path
) -> None:
    page.open(NOTEBOOK)
    page.page.evaluate("() => sessionStorage.removeItem('rclpy-workbook:offer-robot-panel')")
    answer, start, stop = page.cell("%%answer"), page.cell("%start"), page.cell("%stop")
    page.write(start, "%start")
    cell = start.locator(".workbook-cell-robot svg")
    panel = page.page.locator(".workbook-panel:not(.lm-mod-hidden)")
    for pose in (CHEER, SQUAT):
        page.write(answer, f"%%answer {STEM}\n{holds(pose)}")
        page.run(start)
        expect(cell).to_have_count(1)
        expect(start.locator("img")).to_have_count(0)
        page.page.wait_for_function(HELD, arg=[cell.element_handle(), drawn_by_the_rig(page.page, pose)])
        if (
            pose == CHEER
        ):  # the first start opens the panel; the student closes it, and later starts leave it closed
            expect(panel.get_by_role("img", name=POSED)).to_be_visible()
            page.panel.get_by_role("button", name="Robot", exact=True).click()
        expect(panel).to_have_count(0)
    assert cell.evaluate(CHANGES, REST_MS) == 0, "messages that hold the pose cost frames"

    page.write(answer, f"%%answer {STEM}\n{exercise.source.solution_code}")
    page.write(start, WATCHED)
    page.run(start)
    expect(start.locator(".jp-OutputArea")).to_contain_text("Running: node")
    expect(cell).to_have_count(1)
    expect(start.locator("img")).to_have_count(0)
    assert any(f"{STEM}.py" in line for line in running(page.lab.processes()).values())
    expect(cell).to_have_attribute("aria-label", POSED)
    expect(cell).to_have_attribute("data-face", "operational")
    expect(start.locator(".workbook-words")).to_contain_text("status: operational")
    cell.evaluate(COUNT_MOVES)
    page.page.emulate_media(reduced_motion="no-preference")
    page.page.wait_for_function(
        "() => window.robotMoves > 40"
    )  # at the screen's rate, although messages arrive only every 2 s
    page.page.emulate_media(reduced_motion="reduce")
    for theme in in_both_themes(page):
        cell.scroll_into_view_if_needed()
        page.page.screenshot(path=artifacts / f"exercise_start_{theme}.png")
        assert violations(page.page, ".workbook-cell-robot") == []
    watching = observers(page.lab)
    page.panel.locator(".jp-Cell").first.scroll_into_view_if_needed()
    assert watching and not await_end(watching, 10.0), "a robot out of sight is still watched"
    cell.scroll_into_view_if_needed()
    cell.evaluate(COUNT_MOVES)
    page.page.wait_for_function("() => window.robotMoves > 1")
    page.panel.get_by_role("button", name="Robot", exact=True).click()
    expect(panel.get_by_role("img", name=POSED)).to_have_attribute("data-face", "operational")
    expect(panel.locator("tbody", has_text="/robot/joint_positions").locator("td").first).to_contain_text(
        "Hz"
    )
    page.page.screenshot(path=artifacts / "exercise_panel.png")
    watching = observers(page.lab)
    assert len(watching) == 1, "cell and panel share what they watch"

    page.run(stop)
    expect(stop.locator(".jp-OutputArea")).to_contain_text(f"Stopped {STEM}.")
    assert not any(f"answers/{STEM}.py" in line for line in running(page.lab.processes()).values())
    expect(cell).to_have_attribute("data-face", "asleep")
    expect(panel.get_by_role("img", name=f"{ROBOT}, asleep")).to_be_visible()
    page.panel.get_by_role("button", name="Robot", exact=True).click()
    expect(panel).to_have_count(0)
    assert not await_end(watching, 10.0), "a robot at rest is still watched"
    outputs = next(one for one in page.save(NOTEBOOK)["cells"] if "".join(one["source"]) == WATCHED)[
        "outputs"
    ]
    shown = next(one["data"] for one in outputs if "data" in one)
    assert shown[LIVE] == {"kernel": None} and {"image/png", "text/html", "text/plain"} < set(shown)


@pytest.fixture
def card_html(exercise: Exercise) -> str:
    """Return the card of a stored recording: too fast, with the timeline."""
    recording = Recording.from_json(json.loads(RECORDED.read_text(encoding="utf-8")))
    judgement = judge_recording(exercise, "0" * 64, recording)
    timeline, text = judged_timeline(exercise, recording)
    return Card(
        judgement, Extras(file=f"answers/{STEM}.py", timeline=timeline, timeline_text=text)
    )._repr_html_()


def stored_judgement(exercise: Exercise) -> Judgement:
    recording = Recording.from_json(json.loads(RECORDED.read_text(encoding="utf-8")))
    return judge_recording(exercise, "0" * 64, recording)


def says_everything(card: Locator, exercise: Exercise) -> None:
    """Check that the headline, the advice, and each criterion's sign, word, points, and title can be read."""
    expect(card).to_contain_text("8 of 10 points.")
    expect(card).to_contain_text("Start with this criterion: The joint positions are published at 0.5 Hz")
    expect(card).to_contain_text("Likely cause")
    expect(card).not_to_contain_text("data-jp-theme")
    rows = card.locator("table").last.locator("tbody tr")
    results = worst_first(stored_judgement(exercise))
    expect(rows).to_have_count(len(results))
    for row, result in zip(rows.all(), results, strict=True):
        expect(row).to_be_visible()
        expect(row).to_contain_text(f"{SIGNS[result.status]} {WORDS[result.status]}")
        expect(row).to_contain_text(earned(result))
        expect(row).to_contain_text(result.title)


def untrusted_notebook(html: str) -> str:
    """Write a notebook as if it came by mail:

    JupyterLab doesn't trust its outputs, because they weren't produced here.
    """
    output = {
        "output_type": "display_data",
        "metadata": {},
        "data": {"text/html": html, "text/plain": "a card"},
    }
    script = {
        "output_type": "display_data",
        "metadata": {},
        "data": {"text/html": "<p id='probe'>unchanged</p><script>probe.textContent = 'trusted'</script>"},
    }
    cell = {
        "cell_type": "code",
        "id": "card",
        "metadata": {},
        "source": "%check",
        "execution_count": 1,
        "outputs": [output, script],
    }
    metadata = {
        "kernelspec": {"display_name": "rclpy workbook", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    return json.dumps({"cells": [cell], "metadata": metadata, "nbformat": 4, "nbformat_minor": 5})


@pytest.mark.whole
def test_a_card_in_an_untrusted_notebook(
    page: LabPage, lab: StudentLab, exercise: Exercise, card_html: str, artifacts: Path
) -> None:
    (lab.work / "exercises" / "from_a_friend.ipynb").write_text(
        untrusted_notebook(card_html), encoding="utf-8"
    )
    page.open("exercises/from_a_friend.ipynb")
    outputs = page.panel.locator(".jp-OutputArea-output")
    expect(outputs).to_have_count(2)
    expect(outputs.last).to_have_text("unchanged")
    card = outputs.first
    says_everything(card, exercise)
    check_picture(card)
    for theme in in_both_themes(page):
        check_legibility(page, card)
        screenshot(card, artifacts / f"card_untrusted_{theme}.png")
    page.page.set_viewport_size({"width": 560, "height": 1000})
    check_timeline(card)
    page.page.set_viewport_size({"width": 1280, "height": 1000})


def test_a_card_without_any_styles(
    browser_page: Page, exercise: Exercise, card_html: str, artifacts: Path
) -> None:
    bare = re.sub(r' style="[^"]*"|<style>.*?</style>', "", card_html)
    assert "style" not in bare
    browser_page.set_content(f"<!doctype html><meta charset='utf-8'><body>{bare}</body>")
    says_everything(browser_page.locator("body"), exercise)
    browser_page.screenshot(path=artifacts / "card_without_styles.png", full_page=True)
