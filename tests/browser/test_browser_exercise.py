"""The exercise notebook as a student works in it: a wrong answer, the card, the right answer, the card turned."""

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.criteria.runner import CriterionResult
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.feedback.card import Card, Extras
from workbook.feedback.timeline import judged_timeline
from workbook.feedback.wording import SIGNS, WORDS
from workbook.recording.recording import Recording

from .lab_page import CELL_MS, LabPage
from .student_lab import ROOT, StudentLab, running

pytestmark = [pytest.mark.browser, pytest.mark.slow]
STEM = "09_joint_positions"
NOTEBOOK = f"exercises/{STEM}.ipynb"
WRONG = Tree(ROOT).wrong_answers / STEM / "period_for_frequency.py"
RECORDED = ROOT / "tests" / "recordings" / STEM / "period_for_frequency.json"
FULL_MARKS = "Full marks: 10 of 10 points."
LEAST_CONTRAST = 3.0


@pytest.fixture(scope="module")
def exercise() -> Exercise:
    return load_exercise(STEM, ROOT)


def headline_of(card: Locator) -> Locator:
    return card.locator("p b").first


def check_legibility(page: LabPage, card: Locator) -> None:
    """Every text of the card stands out from what is behind it, and the card itself paints nothing behind it."""
    styles = card.evaluate(
        "card => [card, ...card.querySelectorAll('[style]')].map(e => e.getAttribute('style') || '')"
    )
    assert styles
    assert not [style for style in styles if "background" in style]
    contrasts = page.contrasts(card)
    assert any(text in headline_of(card).inner_text() for text in contrasts)
    assert {text: ratio for text, ratio in contrasts.items() if ratio < LEAST_CONTRAST} == {}


def check_picture(card: Locator) -> None:
    picture = card.locator("img")
    expect(picture).to_have_attribute("alt", re.compile("/robot/joint_positions"))
    expect(picture).to_have_js_property("complete", True)
    expect(picture).not_to_have_js_property("naturalWidth", 0)


def screenshot(outputs: Locator, path: Path) -> None:
    """Of the outputs of a cell: a card in them may be replaced at any time, and they stay."""
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
    expect(card).to_contain_text("Fix first: The joint positions come at 0.5 Hz")
    expect(card).not_to_contain_text("Provisional", timeout=CELL_MS)
    expect(headline_of(card)).to_contain_text("8 of 10 points.")
    check_picture(card)
    for theme in in_both_themes(page):
        screenshot(check.locator(".jp-OutputArea"), artifacts / f"card_wrong_{theme}.png")
        check_legibility(page, card)

    page.write(answer, f"%%answer {STEM}\n{exercise.source.solution_code}")
    page.run(answer)
    assert written.read_text(encoding="utf-8").strip() == exercise.source.solution_code.strip()
    page.run(check)
    expect(headline_of(card)).to_contain_text(FULL_MARKS, timeout=CELL_MS)
    expect(card).not_to_contain_text("Fix first")
    expect(card).to_contain_text(f"Hand in this file: answers/{STEM}.py")
    expect(card).to_contain_text("real seconds had passed", timeout=CELL_MS)
    for theme in in_both_themes(page):
        screenshot(check.locator(".jp-OutputArea"), artifacts / f"card_right_{theme}.png")
        page.page.screenshot(path=artifacts / f"exercise_{theme}.png")
    for fold in card.locator("summary").all():
        fold.click()
    expect(card.locator("pre").last).to_contain_text("THE TASK")
    for theme in in_both_themes(page):
        check_legibility(page, card)
        page.page.screenshot(path=artifacts / f"exercise_unfolded_{theme}.png")
    expect(page.pop_ups()).to_have_count(0)


def test_start_shows_the_own_node_and_stop_ends_it(page: LabPage, exercise: Exercise) -> None:
    page.open(NOTEBOOK)
    answer, start, stop = page.cell("%%answer"), page.cell("%start"), page.cell("%stop")
    page.write(answer, f"%%answer {STEM}\n{exercise.source.solution_code}")
    page.run(answer)
    page.run(start)
    expect(start.locator(".jp-OutputArea")).to_contain_text("Running: node")
    assert any(f"{STEM}.py" in line for line in running(page.lab.processes()).values())
    page.run(stop)
    expect(stop.locator(".jp-OutputArea")).to_contain_text(f"Stopped {STEM}.")
    assert not any(f"answers/{STEM}.py" in line for line in running(page.lab.processes()).values())


@pytest.fixture
def card_html(exercise: Exercise) -> str:
    """The card of a stored recording: too fast, with the timeline picture."""
    recording = Recording.from_json(json.loads(RECORDED.read_text(encoding="utf-8")))
    judgement = judge_recording(exercise, "0" * 64, recording)
    timeline, text = judged_timeline(exercise, recording)
    return Card(
        judgement, Extras(file=f"answers/{STEM}.py", timeline=timeline, timeline_text=text)
    )._repr_html_()


def visible_criteria(exercise: Exercise) -> list[CriterionResult]:
    recording = Recording.from_json(json.loads(RECORDED.read_text(encoding="utf-8")))
    return [one for one in judge_recording(exercise, "0" * 64, recording).criteria if one.max_points]


def says_everything(card: Locator, exercise: Exercise) -> None:
    """Headline, advice, and sign, word, points and title of each criterion can be read."""
    expect(card).to_contain_text("8 of 10 points.")
    expect(card).to_contain_text("Fix first: The joint positions come at 0.5 Hz")
    expect(card).to_contain_text("Likely reason")
    rows = card.locator("table").last.locator("tbody tr")
    results = visible_criteria(exercise)
    expect(rows).to_have_count(len(results))
    for row, result in zip(rows.all(), results, strict=True):
        expect(row).to_be_visible()
        expect(row).to_contain_text(f"{SIGNS[result.status]} {WORDS[result.status]}")
        expect(row).to_contain_text(f"{result.points:g} of {result.max_points:g}")
        expect(row).to_contain_text(result.title)


def untrusted_notebook(html: str) -> str:
    """A notebook as it comes by mail: nobody has run it here, so JupyterLab does not trust its outputs."""
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


def test_a_card_without_any_styles(
    browser_page: Page, exercise: Exercise, card_html: str, artifacts: Path
) -> None:
    bare = re.sub(r' style="[^"]*"', "", card_html)
    assert "style" not in bare
    browser_page.set_content(f"<!doctype html><meta charset='utf-8'><body>{bare}</body>")
    says_everything(browser_page.locator("body"), exercise)
    browser_page.screenshot(path=artifacts / "card_without_styles.png", full_page=True)
