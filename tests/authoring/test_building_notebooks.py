"""Build notebooks: the same text gives the same bytes, and only changed notebooks run again."""

import json
from pathlib import Path
from typing import Any

import nbformat
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.authoring import building, document
from workbook.authoring.building import build, build_exercise, build_lesson, select
from workbook.authoring.outputs import normalize, sanitized
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.source import load


def load_json(path: Path) -> dict[str, Any]:
    loaded: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return loaded


def test_two_builds_give_the_same_bytes(course: Tree, built_once: Tree) -> None:
    said: list[str] = []
    assert build(course, again=True, say=said.append) == 0
    assert said[0].startswith("built")
    for name in ("notebooks/21_beeps.ipynb", "exercises/21_beeps.ipynb", "build/solved/21_beeps.ipynb"):
        assert (course.root / name).read_bytes() == (built_once.root / name).read_bytes()


def test_the_notebook_holds_nothing_of_this_machine_or_moment(built_once: Tree) -> None:
    notebook = load_json(built_once.notebooks / "21_beeps.ipynb")
    assert set(notebook["metadata"]) == {"kernelspec", "language_info", "workbook"}
    assert notebook["metadata"]["language_info"]["codemirror_mode"]["version"] == 3
    assert "version" not in notebook["metadata"]["language_info"]
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in code] == list(range(1, len(code) + 1))
    assert all(set(cell["metadata"]) <= {"tags"} for cell in notebook["cells"])
    by_id = {cell["id"]: cell for cell in notebook["cells"]}
    assert by_id["no-period"]["outputs"][0]["ename"] == "ZeroDivisionError"
    assert by_id["from-a-worked-example-to-your-own-3"]["outputs"][0]["text"] == ["<object object at 0x…>\n"]
    run = by_id["run-it-2"]["outputs"]
    assert [output["output_type"] for output in run] == ["display_data", "stream"]
    assert run[1]["text"] == ["beep\n", "beep\n"]


def test_what_did_not_change_is_not_run(course: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(building, "run", lambda *_: pytest.fail("ran a lesson that had not changed"))
    assert build_lesson(course, "21_beeps").startswith("unchanged")
    assert build_exercise(course, "21_beeps").startswith("unchanged")


def test_new_words_between_the_code_keep_what_it_showed(
    course: Tree, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = course.notebooks / "21_beeps.ipynb"
    before = document.read(target)
    source = course.sources / "21_beeps.py"
    source.write_text(source.read_text(encoding="utf-8") + "# Some more words.\n", encoding="utf-8")
    monkeypatch.setattr(building, "run", lambda *_: pytest.fail("ran a lesson whose code had not changed"))
    assert build_lesson(course, "21_beeps").startswith("new words")
    after = document.read(target)
    assert "Some more words." in after.cells[-1].source
    shown = [[cell.outputs for cell in one.cells if cell.cell_type == "code"] for one in (before, after)]
    assert shown[0] == shown[1]
    assert build_lesson(course, "21_beeps").startswith("unchanged")


@pytest.mark.parametrize(
    "name", ["notebooks/sources/21_beeps.py", "lesson_nodes/beeper.py", "lesson_nodes/sound.py"]
)
def test_a_changed_text_or_node_makes_it_run_again(
    course: Tree, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    source = course.sources / "21_beeps.py"
    using = source.read_text(encoding="utf-8").replace(
        "print(1 / 2.0)", "from lesson_nodes import (beeper,\n    other)"
    )
    source.write_text(using, encoding="utf-8")
    node = course.lesson_nodes / "beeper.py"
    node.write_text("from lesson_nodes.sound import LOUD\n", encoding="utf-8")
    (course.lesson_nodes / "sound.py").write_text("LOUD = 1\n", encoding="utf-8")
    ran: list[str] = []

    def pretend(tree: Tree, stem: str, notebook: nbformat.NotebookNode) -> None:
        ran.append(stem)
        normalize(notebook)

    monkeypatch.setattr(building, "run", pretend)
    assert build_lesson(course, "21_beeps").startswith("built")
    assert build_lesson(course, "21_beeps").startswith("unchanged")
    changed = course.root / name
    more = "\n# %%\nprint('changed')\n" if changed == source else "# changed\n"
    changed.write_text(changed.read_text(encoding="utf-8") + more, encoding="utf-8")
    assert build_lesson(course, "21_beeps").startswith("built")
    assert ran == ["21_beeps", "21_beeps"]


def test_a_cell_that_fails_fails_the_build_and_leaves_the_notebook(course: Tree) -> None:
    before = (course.notebooks / "21_beeps.ipynb").read_bytes()
    source = course.sources / "21_beeps.py"
    text = source.read_text(encoding="utf-8").replace("print(1 / 2.0)", "legs = 2\nlegs.walk()")
    source.write_text(text, encoding="utf-8")
    said: list[str] = []
    assert build(course, ["21"], say=said.append) == 1
    assert "cell from-a-worked-example-to-your-own-2 failed" in said[0]
    assert "legs.walk()" in said[0]
    assert "AttributeError: 'int' object has no attribute 'walk'" in said[0]
    assert "\x1b" not in said[0]
    assert (course.notebooks / "21_beeps.ipynb").read_bytes() == before


def test_a_path_of_this_machine_in_an_output_fails_the_build(course: Tree) -> None:
    source = course.sources / "21_beeps.py"
    text = source.read_text(encoding="utf-8").replace("print(1 / 2.0)", "import os; print(os.getcwd())")
    source.write_text(text, encoding="utf-8")
    with pytest.raises(AuthoringError, match=r"names .*, a folder of this machine only"):
        build_lesson(course, "21_beeps")


def test_the_exercise_holds_the_starter_and_is_not_run(built_once: Tree) -> None:
    source = load(built_once.solutions / "21_beeps.py")
    notebook = load_json(built_once.exercises / "21_beeps.ipynb")
    cells = {cell["id"]: cell for cell in notebook["cells"]}
    assert "".join(cells["your-program"]["source"]) == "%%answer 21_beeps\n" + source.starter_code.rstrip()
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert ["".join(cell["source"]).split()[0] for cell in code] == [
        "%%answer", "%start", "%stop", "%check", "%hint", "%solution",
    ]  # fmt: skip
    assert all(cell["execution_count"] is None and cell["outputs"] == [] for cell in code)
    assert "../notebooks/21_beeps.ipynb" in "".join(cells["onward"]["source"])


def test_the_solved_notebook_expects_full_marks(built_once: Tree) -> None:
    source = load(built_once.solutions / "21_beeps.py")
    cells = {cell["id"]: cell for cell in load_json(built_once.solved / "21_beeps.ipynb")["cells"]}
    assert "".join(cells["your-program"]["source"]) == "%%answer 21_beeps\n" + source.solution_code.rstrip()
    assert cells["check"]["outputs"][0]["data"] == {"text/plain": ["Full marks: 10 of 10 points."]}
    assert [name for name, cell in cells.items() if cell.get("execution_count")] == ["check"]


@pytest.mark.parametrize(
    "name", ["21_beeps", "beeps", "21", "notebooks/21_beeps.ipynb", "solutions/21_beeps.py"]
)
def test_names_choose_what_is_built(built_once: Tree, name: str) -> None:
    assert select(built_once, [name]) == (["21_beeps"], ["21_beeps"])


def test_an_unknown_name_is_refused(built_once: Tree) -> None:
    with pytest.raises(
        AuthoringError, match=r"no lesson or exercise is called 'boops'\. There are: 21_beeps"
    ):
        select(built_once, ["boops"])


def test_a_broken_exercise_does_not_keep_others_from_being_built(course: Tree) -> None:
    (course.solutions / "22_lights.py").write_text("print()\n", encoding="utf-8")
    said: list[str] = []
    assert build(course, say=said.append) == 1
    assert any(words.startswith("FAILED") and "22_lights has no criteria" in words for words in said)
    assert any("exercises/21_beeps.ipynb" in words and words.startswith("unchanged") for words in said)


@pytest.mark.parametrize(
    ("text", "clean"),
    [
        ("/tmp/ipykernel_4711/123456.py:3: UserWarning", "<cell>:3: UserWarning"),
        ("<robot.Leg object at 0x7f3a11b2c4d0>", "<robot.Leg object at 0x…>"),
        ("[INFO] [1795197351.629123456] [robot]: up", "[INFO] [time] [robot]: up"),
        ("Time(nanoseconds=1795197351629123456)", "Time(nanoseconds=…)"),
        ("Duration(nanoseconds=500000000)", "Duration(nanoseconds=500000000)"),
        (
            "File ~/course/.venv/lib/python3.11/site-packages/rclpy/node.py:12",
            "File site-packages/rclpy/node.py:12",
        ),
        ('File "/home/ada/course/lesson_nodes/beeper.py", line 3', 'File "lesson_nodes/beeper.py", line 3'),
        ("/usr/lib/python3.12/threading.py", "python3/threading.py"),
        ("topic /robot/workbook/status", "topic /robot/workbook/status"),
        ("color 0xff00", "color 0xff00"),
    ],
)
def test_noise_is_cut_and_nothing_else(text: str, clean: str) -> None:
    assert sanitized(text) == clean


@given(st.text(alphabet=st.sampled_from("/0x7fa39[]. \nab_=ipykernel"), max_size=60))
def test_cleaning_twice_changes_nothing(text: str) -> None:
    assert sanitized(sanitized(text)) == sanitized(text)
