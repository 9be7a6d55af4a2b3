"""`workbook new`: what it writes passes every check but for what the author has still to write."""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from workbook.authoring.checking import check
from workbook.authoring.skeleton import new_exercise, new_lesson
from workbook.authoring.tree import AuthoringError, Tree
from workbook.cli.main import main


@pytest.fixture
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Tree:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    return Tree(tmp_path)


def test_after_new_only_todos_are_left(empty: Tree, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "exercise", "20_motor_warmth"]) == 0
    assert main(["new", "lesson", "motor_warmth"]) == 0, capsys.readouterr()
    said = capsys.readouterr().out
    assert "written    notebooks/sources/20_motor_warmth.py" in said
    assert "built      notebooks/20_motor_warmth.ipynb" in said
    found = check(empty)
    assert [problem for problem in found if "is still to be written" not in problem.words] == []
    assert {problem.where for problem in found} >= {
        "notebooks/sources/20_motor_warmth.py",
        "solutions/20_motor_warmth.py",
        "exercises/criteria/20_motor_warmth.py",
        "tests/wrong_answers/20_motor_warmth/wrong_name.py",
    }


def judged(tree: Tree, path: Path) -> tuple[Path, int, str]:
    done = subprocess.run(
        [sys.executable, "-m", "workbook.cli.main", "check", "20_motor_warmth", str(path)],
        env=os.environ | {"WORKBOOK_COURSE": str(tree.root)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    return path, done.returncode, done.stdout


@pytest.mark.slow
def test_a_new_exercise_can_be_judged_at_once(empty: Tree) -> None:
    files = new_exercise(empty, "20_motor_warmth")
    right = [
        empty.solutions / "20_motor_warmth.py",
        *(p for p in files if p.parent.parent == empty.right_answers),
    ]
    wrong = [path for path in files if path.parent.parent == empty.wrong_answers]
    titles = dict(
        re.findall(
            r'title="(.*?)".*\)\ndef (\w+)',
            (empty.criteria / "20_motor_warmth.py").read_text(encoding="utf-8"),
        )
    )
    names = {name: title for title, name in titles.items()}
    assert len(right) == 4
    assert len(wrong) == 5
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda path: judged(empty, path), [*right, *wrong]))
    for path, code, said in results[:4]:
        assert code == 0, f"{path}\n{said}"
        assert "Full marks: 5 of 5 points." in said
    for path, code, said in results[4:]:
        text = path.read_text(encoding="utf-8")
        loses = re.search(r"# loses: (.*)", text)
        says = re.search(r"# says: (.*)", text)
        assert loses is not None
        assert says is not None
        assert code == 1, f"{path}\n{said}"
        lost = re.findall(r"^  [✗◐] +\S+ +(.*)$", said, re.MULTILINE)
        assert lost == [names[name] for name in loses[1].split(", ")], f"{path}\n{said}"
        assert says[1] in said, f"{path}\n{said}"


def test_a_lesson_and_its_exercise_share_their_stem(empty: Tree) -> None:
    new_lesson(empty, "04_lights")
    assert new_exercise(empty, "lights")[0] == empty.solutions / "04_lights.py"
    assert new_lesson(empty, "horn")[0] == empty.sources / "05_horn.py"
    assert "(04_lights.ipynb)" in new_lesson(empty, "03_wheels")[0].read_text(encoding="utf-8")


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
