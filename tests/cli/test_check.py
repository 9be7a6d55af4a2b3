"""`workbook check`: which file it judges, depending on the current folder, and what it stores."""

import json
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from workbook.lesson.progress import LessonProgress, all_progress

STEM = "09_joint_positions"
SOLUTION = (ROOT / "solutions" / f"{STEM}.py").read_text(encoding="utf-8")


def kept(course: Path) -> LessonProgress:
    return all_progress(course / "work" / "answers").get(STEM, LessonProgress())


@pytest.mark.parametrize("place", [".", "work", "work/notebooks"])
def test_the_answer_in_work_is_found_from_everywhere(
    course: Path, typed: Type, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (course / "work" / "answers" / f"{STEM}.py").write_text(SOLUTION)
    monkeypatch.chdir(course / place)
    said = typed("check", "09")
    assert said.code == 0, said.out + said.err
    assert "Full marks: 10 of 10 points." in said.out
    file = {".": "work/answers", "work": "answers", "work/notebooks": "../answers"}[place]
    assert f"Hand in this file: {file}/{STEM}.py" in said.out
    assert (kept(course).tries, kept(course).solved, kept(course).best) == (1, True, 10.0)


def test_a_file_may_be_named_alone(course: Path, typed: Type) -> None:
    file = course / f"{STEM}.py"
    file.write_text("this is no Python\n")
    said = typed("check", str(file))
    assert said.code == 1
    assert "SyntaxError" in said.out
    assert kept(course).tries == 0, "it is not the student's answer"


def test_solved_stays_solved(course: Path, typed: Type) -> None:
    done = {STEM: {"solved": True, "best": 10.0, "tries": 1}}
    (course / "work" / "answers" / ".progress.json").write_text(json.dumps(done))
    (course / "work" / "answers" / f"{STEM}.py").write_text("this is no Python\n")
    assert typed("check", "09").code == 1
    assert (kept(course).tries, kept(course).solved, kept(course).best) == (2, True, 10.0)


def test_without_an_answer_it_says_how_to_begin(course: Path, typed: Type) -> None:
    said = typed("check", "09")
    assert said.code == 2
    words = " ".join(said.err.split())
    assert f"there is no work/answers/{STEM}.py yet" in words
    assert "`workbook check 09 --watch`" in words


def test_an_instructor_s_folder_of_answers_is_not_the_student_s(course: Path, typed: Type) -> None:
    (course / "answers").mkdir()
    (course / "answers" / f"{STEM}.py").write_text(SOLUTION)
    assert f"there is no work/answers/{STEM}.py yet" in " ".join(typed("check", "09").err.split())
