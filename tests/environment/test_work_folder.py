"""The student's copy: nothing that the student wrote is ever lost."""

import json
import platform
import re
from pathlib import Path

import pytest

from workbook.lab import work_folder
from workbook.lab.work_folder import fingerprint, reset, update_work_folder


def notebook(*sources: str, output: str = "", count: int | None = None) -> str:
    cells: list[dict[str, object]] = [
        {
            "cell_type": "code",
            "source": [source],
            "outputs": [{"output_type": "stream", "name": "stdout", "text": output}] if output else [],
            "execution_count": count,
            "metadata": {},
            "id": f"cell-{number}",
        }
        for number, source in enumerate(sources)
    ]
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5})


@pytest.fixture
def course(tmp_path: Path) -> Path:
    root = tmp_path / "course"
    for name, text in {
        "notebooks/05_timers.ipynb": notebook("timer()"),
        "notebooks/00_start_here.ipynb": notebook("hello()"),
        "exercises/09_joint_positions.ipynb": notebook("%%answer 09_joint_positions\n# TODO"),
        "notebooks/sources/00_start_here.py": "# text",
    }.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


@pytest.fixture
def work(course: Path) -> Path:
    return course / "work"


ROOT = Path(__file__).resolve().parents[2]
LESSON = "notebooks/05_timers.ipynb"
EXERCISE = "exercises/09_joint_positions.ipynb"


def test_the_first_start_copies_lessons_and_exercises(course: Path, work: Path) -> None:
    report = update_work_folder(course, work)
    assert report.added == ["notebooks/00_start_here.ipynb", LESSON, EXERCISE]
    assert (work / LESSON).read_text() == (course / LESSON).read_text()
    assert (work / "answers").is_dir()
    assert not (work / "notebooks" / "sources").exists()
    assert work_folder.first_lesson(course) == "notebooks/00_start_here.ipynb"
    assert update_work_folder(course, work).lines() == []


def test_the_copy_holds_no_outputs_and_the_committed_notebook_keeps_them(course: Path, work: Path) -> None:
    committed = notebook("timer()", "print(1)", output="tick", count=7)
    (course / LESSON).write_text(committed)
    update_work_folder(course, work)
    copy = json.loads((work / LESSON).read_text())
    assert [(cell["outputs"], cell["execution_count"]) for cell in copy["cells"]] == [([], None)] * 2
    assert [cell["source"] for cell in copy["cells"]] == [["timer()"], ["print(1)"]]
    assert (course / LESSON).read_text() == committed
    assert fingerprint(work / LESSON) == fingerprint(course / LESSON)
    reset(course, work, "joint_positions")
    assert update_work_folder(course, work).lines() == []


def test_a_copy_of_an_older_version_that_was_never_run_loses_its_outputs(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    committed = notebook("timer()", output="tick", count=1)
    (course / LESSON).write_text(committed)
    (work / LESSON).write_text(committed)
    update_work_folder(course, work)
    assert "tick" not in (work / LESSON).read_text()
    own = notebook("timer()", output="tock", count=3)
    (work / LESSON).write_text(own)
    update_work_folder(course, work)
    assert (work / LESSON).read_text() == own


def test_no_lesson_of_the_course_arrives_with_outputs(tmp_path: Path) -> None:
    update_work_folder(ROOT, tmp_path)
    for path in work_folder.lessons(tmp_path):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        assert all(not cell.get("outputs") and not cell.get("execution_count") for cell in cells), path.name
    committed = json.loads((ROOT / "notebooks" / "05_timers.ipynb").read_text(encoding="utf-8"))["cells"]
    assert any(cell.get("outputs") for cell in committed)


def test_a_new_lesson_comes_and_a_deleted_one_comes_back(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    (course / "notebooks" / "08_humanoid.ipynb").write_text(notebook("robot()"))
    (work / LESSON).unlink()
    assert update_work_folder(course, work).added == [LESSON, "notebooks/08_humanoid.ipynb"]


def test_a_lesson_that_was_only_run_is_upgraded_with_a_backup(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    ran = notebook("timer()", output="tick", count=7)
    (work / LESSON).write_text(ran)
    (course / LESSON).write_text(notebook("better_timer()"))
    report = update_work_folder(course, work)
    assert report.upgraded == [LESSON]
    assert (work / LESSON).read_text() == (course / LESSON).read_text()
    (kept,) = (work / work_folder.BACKUPS / "notebooks").iterdir()
    assert kept.read_text() == ran


def test_a_changed_file_stays_and_the_new_version_lies_beside_it_once(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    mine = notebook("%%answer 09_joint_positions\nimport rclpy")
    (work / EXERCISE).write_text(mine)
    assert update_work_folder(course, work).lines() == []
    (course / EXERCISE).write_text(notebook("%%answer 09_joint_positions\n# TODO, said better"))
    report = update_work_folder(course, work)
    assert report.beside == [(EXERCISE, "exercises/09_joint_positions.new.ipynb")]
    assert "Yours stays" in report.lines()[0]
    assert (work / EXERCISE).read_text() == mine
    assert (work / "exercises/09_joint_positions.new.ipynb").read_text() == (course / EXERCISE).read_text()
    (work / "exercises/09_joint_positions.new.ipynb").unlink()
    assert update_work_folder(course, work).lines() == []


def test_work_in_the_new_version_is_kept_when_a_newer_one_comes(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    (work / EXERCISE).write_text(notebook("mine"))
    (course / EXERCISE).write_text(notebook("second"))
    update_work_folder(course, work)
    beside = work / "exercises/09_joint_positions.new.ipynb"
    beside.write_text(notebook("mine too"))
    (course / EXERCISE).write_text(notebook("third"))
    update_work_folder(course, work)
    assert beside.read_text() == notebook("third")
    (kept,) = (work / work_folder.BACKUPS / "exercises").iterdir()
    assert kept.read_text() == notebook("mine too")


def test_a_lost_state_file_never_costs_work(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    (work / LESSON).write_text(notebook("mine"))
    (work / work_folder.STATE).write_text("{torn")
    report = update_work_folder(course, work)
    assert (work / LESSON).read_text() == notebook("mine")
    assert report.beside == [(LESSON, "notebooks/05_timers.new.ipynb")]


def test_outputs_and_ids_are_no_change_but_text_is(tmp_path: Path) -> None:
    files = [tmp_path / name for name in "abcd"]
    texts = (notebook("a"), notebook("a", output="ran", count=3), notebook("b"), "not a notebook")
    for path, text in zip(files, texts, strict=True):
        path.write_text(text)
    marks = [fingerprint(path) for path in files]
    assert marks[0] == marks[1]
    assert len(set(marks)) == 3


def test_reset_restores_the_starter_and_keeps_both_files(course: Path, work: Path) -> None:
    update_work_folder(course, work)
    (work / EXERCISE).write_text(notebook("mine"))
    (work / "answers" / "09_joint_positions.py").write_text("import rclpy")
    stem, kept = reset(course, work, "joint_positions")
    assert stem == "09_joint_positions"
    assert (work / EXERCISE).read_text() == (course / EXERCISE).read_text()
    assert not (work / "answers" / "09_joint_positions.py").exists()
    assert [path.read_text() for path in kept] == [notebook("mine"), "import rclpy"]
    again, more = reset(course, work, "9")
    assert (again, len(more)) == (stem, 1)
    assert kept[0].exists()
    assert update_work_folder(course, work).lines() == []


@pytest.mark.parametrize(
    "name", ["09_joint_positions", "joint_positions", "9", "09", "exercises/09_joint_positions.ipynb"]
)
def test_an_exercise_has_several_names(course: Path, name: str) -> None:
    assert work_folder.find_exercise(course, name) == "09_joint_positions"


def test_an_unknown_exercise_lists_those_there_are(course: Path) -> None:
    with pytest.raises(work_folder.NoSuchExercise, match="09_joint_positions"):
        work_folder.find_exercise(course, "walking")


def test_pages_to_read_are_always_the_newest(course: Path, work: Path) -> None:
    page = course / "notebooks" / "error_museum.md"
    page.write_text("old\n")
    update_work_folder(course, work)
    assert (work / "notebooks" / "error_museum.md").read_text() == "old\n"
    page.write_text("new\n")
    update_work_folder(course, work)
    assert (work / "notebooks" / "error_museum.md").read_text() == "new\n"
    assert work_folder.first_lesson(course) == "notebooks/00_start_here.ipynb"


def test_a_notebook_says_which_python_it_is_for_so_that_opening_it_changes_nothing(
    course: Path, work: Path
) -> None:
    lesson = json.loads((course / LESSON).read_text())
    lesson["metadata"] = {"language_info": {"name": "python"}}
    (course / LESSON).write_text(json.dumps(lesson))
    work.joinpath("notebooks").mkdir(parents=True)
    (work / LESSON).write_text(json.dumps(lesson))  # as an earlier version of the course delivered it
    update_work_folder(course, work)
    told = json.loads((work / LESSON).read_text())["metadata"]["language_info"]
    assert told == {"name": "python", "version": platform.python_version()}


def test_the_nodes_of_the_lessons_are_there_to_be_read(course: Path, work: Path) -> None:
    (course / "lesson_nodes").mkdir()
    (course / "lesson_nodes" / "two_arms.py").write_text("# a node\n")
    assert update_work_folder(course, work).lines() == ["Added 3 notebooks to work/."]
    assert (work / "lesson_nodes" / "two_arms.py").read_text() == "# a node\n"


def test_every_link_of_a_lesson_leads_somewhere_in_the_students_copy(tmp_path: Path) -> None:
    work = tmp_path / "work"
    update_work_folder(ROOT, work)
    dead = []
    for path in sorted((work / "notebooks").glob("*.ipynb")):
        cells = json.loads(path.read_text())["cells"]
        text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
        prose = re.sub(r"^ *```.*?^ *```|`[^`\n]*`", "", text, flags=re.DOTALL | re.MULTILINE)
        for link in re.findall(r"\]\((?!https?:|#)([^)#]+)", prose):
            if not (path.parent / link).is_file():
                dead.append(f"{path.name}: {link}")
    assert not dead
