"""Saving answers: nothing that a student saves is ever lost, in any order."""

import shutil
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from workbook.exercise.answer_files import KEPT_VERSIONS, Saved, answers_folder, replace_answer, save_answer
from workbook.lesson.progress import TRIES_BEFORE_SOLUTION, LessonProgress, load_progress, save_progress

STEM = "09_joint_positions"
STARTER = "# TODO\nrobot = None\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path / "answers"))
    return tmp_path / "answers"


def save(text: str) -> Saved:
    return save_answer(STEM, text, STARTER)


def kept(folder: Path) -> list[str]:
    return [path.read_text() for path in sorted((folder / ".previous").glob("*.py"))]


def test_the_first_cell_is_saved_even_if_it_is_the_starter(folder: Path) -> None:
    saved = save(STARTER)
    assert (saved.outcome, saved.previous) == ("new", None)
    assert (folder / f"{STEM}.py").read_text() == STARTER


def test_a_change_keeps_what_was_there(folder: Path) -> None:
    save("robot = 1")
    saved = save("robot = 2")
    assert saved.outcome == "changed"
    assert saved.previous is not None
    assert saved.previous.read_text() == "robot = 1\n"
    assert saved.path.read_text() == "robot = 2\n"


def test_spaces_at_line_ends_are_no_change(folder: Path) -> None:
    save("robot = 1\nspeed = 2\n")
    assert save("robot = 1   \nspeed = 2\n\n").outcome == "unchanged"
    assert kept(folder) == []


def test_the_starter_never_replaces_work(folder: Path) -> None:
    save("robot = 1")
    assert save(STARTER).outcome == "refused"
    assert save(STARTER.replace("\n", "  \n")).outcome == "refused"
    assert (folder / f"{STEM}.py").read_text() == "robot = 1\n"


def test_a_reset_brings_the_starter_and_keeps_the_answer(folder: Path) -> None:
    save("robot = 1")
    saved = replace_answer(STEM, STARTER)
    assert saved.path.read_text() == STARTER
    assert kept(folder) == ["robot = 1\n"]
    assert save("robot = 2").outcome == "changed"


def test_a_file_in_another_encoding_is_put_aside_as_it_is(folder: Path) -> None:
    folder.mkdir()
    (folder / f"{STEM}.py").write_bytes(b"# gr\xfc\xdfe\n")
    saved = save("robot = 1")
    assert saved.previous is not None
    assert saved.previous.read_bytes() == b"# gr\xfc\xdfe\n"


def test_files_that_a_student_put_beside_the_versions_do_not_matter(folder: Path) -> None:
    (folder / ".previous").mkdir(parents=True)
    for name in (f"{STEM}.old.py", f"{STEM}.py", f"{STEM}.0007.copy.py"):
        (folder / ".previous" / name).write_text("mine\n")
    save("robot = 1")
    saved = save("robot = 2")
    assert saved.previous is not None
    assert saved.previous.name == f"{STEM}.0001.py"
    assert (folder / ".previous" / f"{STEM}.old.py").read_text() == "mine\n"


def test_exercises_do_not_mix(folder: Path) -> None:
    for stem in (STEM, "09_joint_positions_more"):
        save_answer(stem, "robot = 1", STARTER)
        save_answer(stem, "robot = 2", STARTER)
    assert len(list((folder / ".previous").iterdir())) == 2


def test_only_the_last_fifty_versions_are_kept(folder: Path) -> None:
    for number in range(KEPT_VERSIONS + 11):
        save(f"robot = {number}")
    assert kept(folder) == [f"robot = {number}\n" for number in range(10, KEPT_VERSIONS + 10)]


programs = st.sampled_from(
    [STARTER, "robot = 1\n", "robot = 2\n", "robot = 3", "robot = 3\n\n", "# empty", "\n"]
)
actions = st.one_of(st.tuples(st.just("save"), programs), st.tuples(st.just("reset"), st.just(STARTER)))


@given(st.lists(actions, max_size=KEPT_VERSIONS))
@settings(deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_every_text_that_was_saved_is_still_there(folder: Path, sequence: list[tuple[str, str]]) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    ever: list[str] = []
    for what, text in sequence:
        if what == "reset":
            replace_answer(STEM, text)
            ever.append(text)
        elif save(text).outcome in ("new", "changed"):
            ever.append(text)
    current = folder / f"{STEM}.py"
    there = {*(kept(folder)), *([current.read_text()] if current.exists() else [])}
    for text in ever:
        assert (text if text.endswith("\n") else text + "\n") in there
    assert not list(folder.rglob("*.part"))


def test_where_answers_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("WORKBOOK_ANSWERS", raising=False)
    (tmp_path / ".state").mkdir()
    (tmp_path / "exercises" / "deep").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "exercises" / "deep")
    assert answers_folder() == tmp_path / "answers"
    (tmp_path / "exercises" / "answers").mkdir()
    assert answers_folder() == tmp_path / "exercises" / "answers"
    monkeypatch.setenv("WORKBOOK_ANSWERS", "/elsewhere")
    assert answers_folder() == Path("/elsewhere")


def test_progress_is_kept_by_exercise(folder: Path) -> None:
    assert load_progress(STEM) == LessonProgress()
    save_progress(STEM, LessonProgress(tries=2, hints=1))
    save_progress("05_timers", LessonProgress(solved=True, best=10.0))
    assert load_progress(STEM) == LessonProgress(tries=2, hints=1)
    assert load_progress("05_timers").may_see_solution
    assert not load_progress(STEM).may_see_solution
    assert LessonProgress(tries=TRIES_BEFORE_SOLUTION).may_see_solution


@pytest.mark.parametrize(
    "damaged", ["", "{", "[]", '{"09_joint_positions": 7}', '{"09_joint_positions": {"x": 1}}']
)
def test_a_damaged_progress_file_starts_over(folder: Path, damaged: str) -> None:
    folder.mkdir()
    (folder / ".progress.json").write_text(damaged)
    assert load_progress(STEM) == LessonProgress()
    save_progress(STEM, LessonProgress(tries=1))
    assert load_progress(STEM).tries == 1
