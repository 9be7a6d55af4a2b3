"""Only the text on the screen is judged: `%check` and `%start` use the current text of the answer cell."""

import json
import os
import re
from pathlib import Path

import pytest

from tests.magics.conftest import Kernel
from workbook.exercise.definition import load_exercise
from workbook.lab.jupyter_files import FRONT_END
from workbook.lesson.progress import load_progress
from workbook.lesson.robot_in_cell import ROBOT
from workbook.magics.live_card import CHECK
from workbook.magics.screen import (
    ANSWER_PAYLOAD,
    STARTED_PAYLOAD,
    answer_on_screen,
    answers_on_screen,
    version_that_ran,
)

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
STARTER = load_exercise(STEM, ROOT).source.starter_code
LINE = f"%%answer {STEM}\n"
BROKEN = "speed = = 3\n"


def answer_file(kernel: Kernel) -> Path:
    return kernel.folder / "answers" / f"{STEM}.py"


# --- in a kernel ----------------------------------------------------------------------------------------------------


def test_a_check_and_a_start_take_the_cell_as_it_is_now(kernel: Kernel) -> None:
    kernel.good(f"{LINE}robot = 1\n")
    shown = kernel.good("%check", on_screen=[LINE + BROKEN])
    assert shown.text == f"Saved the current answer cell as answers/{STEM}.py.\n"
    assert answer_file(kernel).read_text() == BROKEN
    assert "SyntaxError" in shown.html[0] or "invalid syntax" in shown.html[0]
    assert "version you ran" not in shown.html[0]
    started = kernel.good("%start", on_screen=["%%answer 09\nspeed = = 4\n"])
    assert "line 1: speed = = 4" in started.text
    assert answer_file(kernel).read_text() == "speed = = 4\n"


def test_a_starter_on_the_screen_is_not_judged_in_place_of_work(kernel: Kernel) -> None:
    kernel.good(f"{LINE}{BROKEN}")
    for magic in ("%check", "%start"):
        shown = kernel.good(f"{magic} {STEM}", on_screen=[LINE + STARTER])
        assert shown.text.startswith(
            f"Your answer stays in answers/{STEM}.py: the answer cell contains the starter"
        )
        assert shown.displays == []
    assert answer_file(kernel).read_text() == BROKEN


def test_an_emptied_cell_takes_nothing_away(kernel: Kernel) -> None:
    kernel.good(f"{LINE}{BROKEN}")
    for magic in ("%check", "%start"):
        shown = kernel.good(f"{magic} {STEM}", on_screen=[LINE])
        assert shown.text.startswith("The answer cell is empty,")
    assert answer_file(kernel).read_text() == BROKEN


def test_what_was_not_run_is_kept_when_something_else_takes_its_place(kernel: Kernel) -> None:
    kernel.good(f"{LINE}{BROKEN}")
    kernel.good(f"%reset {STEM}", on_screen=[f"{LINE}speed = 5\n"])
    previous = [one.read_text() for one in (answer_file(kernel).parent / ".previous").iterdir()]
    assert sorted(previous) == sorted([BROKEN, "speed = 5\n"])
    assert answer_file(kernel).read_text().strip() == STARTER.strip()


def test_without_such_a_front_end_the_version_that_ran_is_named(kernel: Kernel) -> None:
    kernel.good(f"{LINE}{BROKEN}")
    [html] = kernel.good("%check").html
    assert re.search(r"This card judges the version you ran at \d\d:\d\d\.", html)
    assert re.match(r"Starting the version you ran at \d\d:\d\d\.\n", kernel.good("%start").text)


def test_an_answer_cell_may_check_when_it_runs(kernel: Kernel) -> None:
    shown = kernel.good(f"%%answer 09 --check\n{BROKEN}")
    assert shown.text.startswith(f"Saved as answers/{STEM}.py.")
    assert shown.displays[0].startswith("0 of 10 points.")
    assert "version you ran" not in shown.html[0]


def test_the_best_version_and_the_starter_come_back_onto_the_screen(kernel: Kernel) -> None:
    assert "No version of 09_joint_positions has earned points yet" in kernel.good("%restore 09").text
    kernel.good(f"{LINE}{BROKEN}")
    best = answer_file(kernel).parent / ".best" / f"{STEM}.py"
    best.parent.mkdir()
    best.write_text("robot = 'best'\n")
    shown = kernel.good(
        "%restore 09", on_screen=["%%answer 09 --check\n" + BROKEN, "%%answer 05_timers\nx = 1"]
    )
    assert shown.text.startswith(
        f"answers/{STEM}.py is your best version again.\nThe previous version is kept as "
    )
    assert answer_file(kernel).read_text() == "robot = 'best'\n"
    assert shown.payloads == [{"source": "workbook_answer", "exercises": ["09"], "text": "robot = 'best'"}]
    again = kernel.good("%restore 09", on_screen=["%%answer 09 --check\nrobot = 'best'"])
    assert again.text == f"answers/{STEM}.py already is your best version.\n"
    assert again.payloads == []
    [elsewhere] = kernel.good("%reset").payloads
    assert elsewhere["source"] == "set_next_input", "another front end: a new cell"
    assert elsewhere["text"] == f"{LINE}{STARTER.rstrip()}"


# --- messages, and what is saved --------------------------------------------------------------------------------------


def request_with(answers: object) -> dict[str, object]:
    return {"metadata": {"workbook": {"answers": answers}}}


def test_the_last_answer_cell_of_an_exercise_counts() -> None:
    request = request_with(
        ["%%answer 9\none", "\n%%answer joint_positions --check\ntwo", "%%answer 05_timers\nthree", 7]
    )
    assert answer_on_screen(request, STEM) == "two"
    assert answer_on_screen(request, "05_timers") == "three"
    assert answer_on_screen(request, "06_spinning") is None


def test_both_sides_use_the_same_names() -> None:
    script = (FRONT_END / "answers.js").read_text(encoding="utf-8")
    for payload in (ANSWER_PAYLOAD, STARTED_PAYLOAD):
        assert f"payload.source === '{payload}'" in script
    assert "{answers}" in script and "robot: " in script and "{...metadata, workbook}" in script
    for name, file, kind in (("TYPE", "cell.js", ROBOT), ("CHECK", "card.js", CHECK)):
        assert f"{name} = '{kind}'" in (FRONT_END / "panel" / file).read_text(encoding="utf-8")


@pytest.mark.parametrize(("robot", "drawn"), [("True", True), ("False", False), ("None", False)])
def test_where_the_page_draws_robots_the_kernel_sends_poses(kernel: Kernel, robot: str, drawn: bool) -> None:
    kernel.good("from workbook.lesson import watch_robot")
    told = f"get_ipython().get_parent()['metadata']['workbook'] = {{'robot': {robot}}}\n"
    shown = kernel.good(f"{told}await watch_robot(seconds=0.3)")
    assert len(shown.displays) == 1
    assert bool(shown.html[0]) is not drawn, "a picture, and a pose in its place"


@pytest.mark.parametrize(
    "request_",
    [
        {},
        {"metadata": {}},
        {"metadata": {"workbook": 3}},
        request_with("%%answer 9"),
        request_with(None),
        None,
    ],
)
def test_a_front_end_that_does_not_tell(request_: object) -> None:
    assert answers_on_screen(request_) is None
    assert answer_on_screen(request_, STEM) is None


@pytest.fixture
def saved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a notebook that was saved after its answer had run."""
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path))
    (tmp_path / f"{STEM}.py").write_text("robot = 1\n")
    os.utime(tmp_path / f"{STEM}.py", (1000, 1000))
    notebook = tmp_path / f"{STEM}.ipynb"
    monkeypatch.setenv("JPY_SESSION_NAME", str(notebook))
    return notebook


def write(notebook: Path, program: str, at: float = 2000) -> None:
    cell = {"cell_type": "code", "source": LINE + program}
    notebook.write_text(json.dumps({"cells": [cell]}))
    os.utime(notebook, (at, at))


def test_a_notebook_saved_later_with_another_answer_differs(saved: Path) -> None:
    write(saved, "robot = 2")
    version = version_that_ran(STEM, {})
    assert version.differs
    assert version.line("Judging").startswith("Judging the version you ran on 1970-01-01 at ")
    assert "The saved notebook contains a different version" in version.line("Judging")
    write(saved, "robot = 1")
    assert not version_that_ran(STEM, {}).differs
    write(saved, "robot = 2", at=500)
    assert not version_that_ran(STEM, {}).differs, "saved before the answer ran: it says nothing"


def test_vs_code_says_which_notebook_it_is(saved: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("JPY_SESSION_NAME")
    write(saved, "robot = 2")
    assert not version_that_ran(STEM, {}).differs
    assert version_that_ran(STEM, {"__vsc_ipynb_file__": str(saved)}).differs


def test_a_notebook_that_is_gone_or_broken_says_nothing(saved: Path) -> None:
    assert not version_that_ran(STEM, {}).differs
    saved.write_text("{")
    assert not version_that_ran(STEM, {}).differs


def test_to_run_the_same_text_again_makes_it_the_version_of_now(kernel: Kernel) -> None:
    kernel.good(f"{LINE}robot = 1\n")
    os.utime(answer_file(kernel), (1000, 1000))
    kernel.good(f"{LINE}robot = 1\n")
    assert answer_file(kernel).stat().st_mtime > 2000


def test_a_check_of_the_answer_cell_counts_as_one_try(
    kernel: Kernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    kernel.good(f"%%answer 09 --check\n{BROKEN}")
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(kernel.folder / "answers"))
    assert load_progress(STEM).tries == 1
