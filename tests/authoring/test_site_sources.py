"""The sources of the site: its links, recordings, error pages, and predictions."""

import json
import re
import sys
from pathlib import Path

import pytest

from workbook.authoring.site.errors import ErrorPage, ErrorPages, extras_by_symptom
from workbook.authoring.site.guides import Guides
from workbook.authoring.site.links import Links
from workbook.authoring.site.notebooks import NotebookPage, Pictures, robot_figure
from workbook.authoring.site.recordings import FOLDER, recording_file, site_robots
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_header
from workbook.lesson.programs import run_program
from workbook.lesson.sealed_predictions import all_predictions

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
LINKS = Links("docs/judge.md", frozenset({"docs/exercises.md", "index.md"}), {"README.md": "index.md"})
PROGRAMS = {symptom: extra for symptom, extra in extras_by_symptom().items() if extra.program}
ABORT = "terminate called without an active exception (SIGABRT) when the program ends"
if sys.version_info >= (
    3,
    14,
):  # from 3.14 on, Python stops a thread that still runs at the end without an abort
    del PROGRAMS[ABORT]
RUNS = {ABORT: 4}
"""How many times to run a program whose error depends on timing: one run in eighty ended before the thread woke up."""
MOST_LINES = 22
"""The largest length of a minimal program."""
PARTLY_WORDS = {
    "AssertionError without a message, in the line that creates a QoSProfile": "AssertionError",
    ABORT: "terminate called without an active exception",
    "cv2.error: The function is not implemented": "The function is not implemented",
}
"""Titles of pages that contain more than the program's output."""


@pytest.mark.parametrize(
    ("written", "on_the_site"),
    [
        ("see [exercises](exercises.md#size)", "see [exercises](exercises.md#size)"),
        ("see [the start](../README.md)", "see [the start](../index.md)"),
        ("see [the code](../workbook/cli/main.py)", "see the code"),
        ("see [elsewhere](https://docs.ros.org/)", "see [elsewhere](https://docs.ros.org/)"),
        ("write `[text](../missing.md)`", "write `[text](../missing.md)`"),
    ],
)
def test_a_link_leads_to_a_page_of_the_site_or_is_plain_text(written: str, on_the_site: str) -> None:
    assert LINKS.in_page(written) == on_the_site


def test_each_robot_has_its_recordings_and_each_recording_its_robot() -> None:
    names = {name for robot in site_robots() for name in robot.names}
    assert {path.stem for path in FOLDER.glob("*.json")} == names
    for name in names:
        recording = json.loads(recording_file(name).read_text(encoding="utf-8"))
        times = [event[0] for event in recording["events"]]
        assert times == sorted(times)
        assert 0 <= times[0] <= times[-1] <= recording["seconds"]


def test_each_lesson_has_a_robot() -> None:
    assert {robot.lesson for robot in site_robots()} == set(TREE.lesson_stems())


def test_a_caption_shows_names_as_code() -> None:
    [walking] = (robot for robot in site_robots() if robot.lesson == "03_publishers_and_messages")
    assert "commands on <code>/robot/cmd_vel</code>." in robot_figure(walking)


def test_each_robot_stands_below_a_cell_that_exists() -> None:
    for robot in site_robots():
        cells = json.loads((TREE.notebooks / f"{robot.lesson}.ipynb").read_text(encoding="utf-8"))["cells"]
        assert robot.cell in {"", *(cell["id"] for cell in cells)}
        assert bool(robot.about) is not bool(robot.cell)
        assert not robot.slider or robot.value in robot.values


def test_what_is_added_to_an_error_belongs_to_an_exhibit() -> None:
    assert set(extras_by_symptom()) <= {page.title for page in ErrorPages(TREE).pages}


@pytest.mark.parametrize(
    "page", [one for one in ErrorPages(TREE).pages if one.printed], ids=lambda one: one.name
)
def test_a_page_shows_the_smallest_program_and_prints_the_text_of_its_title(page: ErrorPage) -> None:
    assert page.extra is not None
    assert 0 < len(page.extra.program.strip().splitlines()) <= MOST_LINES
    text = PARTLY_WORDS.get(page.title, page.title)
    pattern = ".*".join(map(re.escape, re.split(r"…|\.\.\.", text)))
    assert re.search(pattern, page.extra.shows)


def test_a_misconception_has_its_likely_cause_and_the_number_of_its_wrong_answers() -> None:
    cause = "rate.period-for-frequency"
    headers = [
        read_header(path)
        for stem in TREE.exercise_stems()
        for path in (TREE.wrong_answers / stem).glob("*.py")
    ]
    text = dict(Guides(TREE).texts())["instructors/misconceptions.md"]
    [row] = [line for line in text.splitlines() if f"`{cause}`" in line]
    likely, number, *_ = (cell.strip() for cell in row.strip("|").split("|"))
    assert likely.startswith("Period and frequency are swapped")
    assert int(number) == sum(cause in header.causes for header in headers) > 0


def test_a_prediction_can_be_clicked_and_its_outcome_is_encoded(tmp_path: Path) -> None:
    stem = "05_timers"
    links = Links(f"notebooks/{stem}.ipynb", frozenset(), {})
    page = NotebookPage(stem, links, Pictures(tmp_path, "pictures"), all_predictions())
    text = page.convert(TREE.notebooks / f"{stem}.ipynb")
    assert 'data-prediction=\\"loop-and-timer\\"' in text
    assert "data-sealed" in text
    assert "The outcome is" not in text
    assert "base64," not in text
    assert list(tmp_path.iterdir())


@pytest.mark.slow
@pytest.mark.whole
@pytest.mark.parametrize("symptom", PROGRAMS)
def test_the_smallest_program_prints_the_error(symptom: str) -> None:
    printed = []
    for _ in range(RUNS.get(symptom, 1)):
        ended = run_program(PROGRAMS[symptom].program)
        printed.append(ended.log + ended.end_log)
        if PROGRAMS[symptom].shows in printed[-1]:
            return
    pytest.fail("\n".join(printed))
