"""`workbook new`: the names and contents of its files. test_templates.py runs every check on its output."""

from pathlib import Path

import pytest

from workbook.authoring.skeleton import new_exercise, new_lesson, still_from_template
from workbook.authoring.tree import AuthoringError, Tree
from workbook.cli.main import main


@pytest.fixture
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Tree:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    return Tree(tmp_path)


def test_new_says_what_it_wrote_and_what_comes_next(empty: Tree, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "exercise", "20_motor_warmth"]) == 0
    said = capsys.readouterr().out
    assert "written    solutions/20_motor_warmth.py" in said
    assert "built      exercises/20_motor_warmth.ipynb" in said
    assert "Next: `workbook new lesson 20_motor_warmth`" in said
    assert "--notes" in said


def test_a_line_of_the_template_is_noted_until_it_is_changed(empty: Tree) -> None:
    path, *_ = new_exercise(empty, "20_motor_warmth", "function")
    text = path.read_text(encoding="utf-8")
    assert "@" not in text
    line = text.splitlines().index('"""Finds the nearest obstacle."""') + 1
    noted = {str(one) for one in still_from_template(empty)}
    note = f"solutions/20_motor_warmth.py:{line}: is still the template's text: "
    assert f'{note}"""Finds the nearest obstacle."""' in noted
    path.write_text(text.replace("Finds the nearest", "Finds each"), encoding="utf-8")
    assert not any(str(one).startswith(note) for one in still_from_template(empty))


def test_an_unknown_template_is_refused(empty: Tree) -> None:
    with pytest.raises(AuthoringError, match="there are publisher, listener, service, function"):
        new_exercise(empty, "20_motor_warmth", "dancer")


def test_a_lesson_and_its_exercise_share_their_stem(empty: Tree) -> None:
    new_lesson(empty, "04_lights")
    assert new_exercise(empty, "lights")[0] == empty.solutions / "04_lights.py"
    assert new_lesson(empty, "horn")[0] == empty.sources / "05_horn.py"


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("Slow Callbacks", "cannot be a name"),
        ("4_lights", "cannot be a name"),
        ("lights", "04_lights is there already"),
        ("04_lights", "04_lights is there already"),
        ("04_horn", "number 04 is taken by 04_lights"),
        ("05_lights", "04_lights is there already"),
    ],
)
def test_a_name_that_does_not_do_is_refused(empty: Tree, name: str, says: str) -> None:
    new_lesson(empty, "04_lights")
    with pytest.raises(AuthoringError, match=says):
        new_lesson(empty, name)
    assert main(["new", "lesson", name]) == 2


def test_nothing_is_overwritten(empty: Tree) -> None:
    path = empty.criteria / "04_lights.py"
    path.write_text("mine", encoding="utf-8")
    with pytest.raises(AuthoringError, match="is there already"):
        new_exercise(empty, "04_lights")
    assert path.read_text(encoding="utf-8") == "mine"
    assert not empty.solutions.exists()


def test_a_template_for_a_lesson_is_refused(empty: Tree, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "lesson", "04_lights", "--template", "listener"]) == 2
    assert "leave out --template" in capsys.readouterr().err
    assert not empty.sources.exists()
