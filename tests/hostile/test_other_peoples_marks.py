"""Hand-ins that try to get another student's points, or an earlier time: times, aliases, names, and logins."""

import csv
import io
import unicodedata
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.batch import UNREADABLE, Batch, BatchSummary
from workbook.grading.exports import canvas, moodle, nbgrader
from workbook.grading.grades_csv import grades_csv
from workbook.grading.judges import Job
from workbook.grading.new_results import GradedBy, Submission, ungradable_result
from workbook.grading.results import Result
from workbook.grading.roster import Roster
from workbook.grading.skipped import find_skipped
from workbook.grading.slots import scheduler
from workbook.grading.slots.scheduler import LocalSlots

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)


@pytest.fixture(autouse=True)
def nothing_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def stand_in(jobs: Iterable[Job[object]], *_: object, **__: object) -> Iterable[object]:
        for job in jobs:
            yield job, Judgement(job.stem, job.answer.sha256, "infra_error", "not run", (), None)

    monkeypatch.setattr(scheduler, "judge_all", stand_in)


def put(folder: Path, *names: str, text: str = "x = 1\n") -> Path:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def graded(tmp_path: Path, **aliases: str) -> BatchSummary:
    roster = Roster({name.replace("__", "/"): student for name, student in aliases.items()})
    return Batch(EXERCISE, tmp_path / "out", LocalSlots(1), roster).run([tmp_path / "class"])


def by_student(summary: BatchSummary) -> dict[str, Result]:
    return {result.student: result for result in summary.results}


# --- times ------------------------------------------------------------------------------------------------------------


def test_a_time_of_ones_own_does_not_beat_the_one_that_nbgrader_wrote(tmp_path: Path) -> None:
    place = tmp_path / "class" / "submitted" / "s1" / STEM
    put(place, "mine/deep/answer.py")
    put(place, "timestamp.txt", text="2025-02-02 12:00:00 UTC\n")
    put(place, "mine/timestamp.txt", "mine/deep/timestamp.txt", text="2025-01-01 12:00:00 UTC\n")
    [result] = graded(tmp_path).results
    assert result.submitted_at == "2025-02-02 12:00:00 UTC"


@pytest.mark.parametrize("outermost", ["link", "folder", "huge"])
def test_an_outermost_time_that_cannot_be_read_is_not_replaced_by_an_inner_one(
    tmp_path: Path, outermost: str
) -> None:
    place = put(tmp_path / "class" / "s1", "deep/answer.py")
    put(place, "deep/timestamp.txt", text="2025-01-01 12:00:00 UTC\n")
    stamp = place / "timestamp.txt"
    if outermost == "link":
        stamp.symlink_to("deep/timestamp.txt")
    elif outermost == "folder":
        stamp.mkdir()
    else:
        stamp.write_text("2" * 300)
    [result] = graded(tmp_path).results
    assert result.submitted_at == UNREADABLE


# --- aliases ----------------------------------------------------------------------------------------------------------


def test_a_file_called_like_anothers_alias_deeper_down_is_not_hers(tmp_path: Path) -> None:
    put(tmp_path / "class", "upload_17.py", "mallory/upload_17.py")
    found = by_student(graded(tmp_path, **{"upload_17.py": "alice"}))
    assert {name: one.answer for name, one in found.items()} == {
        "alice": "upload_17.py",
        "mallory": "mallory/upload_17.py",
    }


def test_a_whole_path_or_a_name_at_the_top_is_an_alias(tmp_path: Path) -> None:
    put(tmp_path / "class", "box/deep/a.py", "upload_2/b.py", "upload_3.py")
    found = by_student(graded(tmp_path, box__deep__a_py="x", upload_2="bob", upload_3="eve"))
    assert set(found) == {"box", "bob", "eve"}
    found = by_student(
        graded(tmp_path, **{"box/deep/a.py": "alice", "upload_2": "bob", "upload_3.py": "eve"})
    )
    assert set(found) == {"alice", "bob", "eve"}


def test_two_hand_ins_for_one_student_are_refused_also_after_aliasing(tmp_path: Path) -> None:
    put(tmp_path / "class", "upload_1.py", "upload_2.py", "alice.py", "bob.py")
    summary = graded(tmp_path, **{"upload_1.py": "alice", "upload_2.py": "eve"})
    found = by_student(summary)
    assert len(summary.results) == 3
    assert found["alice"].status == "ungradable"
    assert "2 hand-ins of one student: alice.py, upload_1.py" in (found["alice"].reason or "")
    assert found["bob"].status == found["eve"].status == "infra_error", "they are judged"


def test_a_file_that_is_hers_by_name_and_anothers_by_alias_is_refused(tmp_path: Path) -> None:
    put(tmp_path / "class", "alice.py", "upload_2.py", text="x = 2\n")
    put(tmp_path / "class", "upload_3.py")
    found = by_student(graded(tmp_path, **{"alice.py": "bob", "upload_2.py": "alice", "upload_3.py": "eve"}))
    assert found["bob"].status == found["alice"].status == "ungradable"
    assert "alice.py is alice's by its name and bob's by an alias" in (found["bob"].reason or "")
    assert found["eve"].status == "infra_error"


def test_a_hand_in_that_two_aliases_give_to_two_students_is_refused(tmp_path: Path) -> None:
    put(tmp_path / "class", "box/a.py")
    found = by_student(graded(tmp_path, **{"box/a.py": "alice", "box": "bob"}))
    assert {one.status for one in found.values()} == {"ungradable"}
    assert "aliases give it to alice and to bob" in (found["alice"].reason or "")


def test_the_same_command_again_gives_the_same_marks(tmp_path: Path) -> None:
    put(tmp_path / "class", "upload_1.py", "alice.py", "mallory/upload_1.py")
    first, second = (graded(tmp_path, **{"upload_1.py": "alice"}) for _ in range(2))
    assert [(one.student, one.answer, one.status) for one in first.results] == [
        (one.student, one.answer, one.status) for one in second.results
    ]


def test_an_alias_that_fits_nothing_is_said(tmp_path: Path) -> None:
    put(tmp_path / "class", "mallory/upload_17.py")
    said = "\n".join(graded(tmp_path, **{"upload_17.py": "alice"}).remarks)
    assert "1 alias fits no hand-in: upload_17.py" in said


# --- names ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("S1.PY", "its name ends in .PY, so rename it to S1.py"),
        ("s2.Ipynb", "rename it to s2.ipynb"),
        ("s3.py.txt", "its name ends in .txt"),
        ("__s4.py", "begins with two underscores"),
        ("..py", "begins with a dot"),
        (".s5.py", "begins with a dot"),
        ("s6.py~", "its name ends in .py~"),
        ("s7.py ", "its name ends in '.py '"),
        (".s8/answer.py", "begins with a dot"),
        ("s9/more/S9.PY", "rename it to S9.py"),
    ],
)
def test_what_looks_like_an_answer_and_is_none_is_said_with_the_reason(
    tmp_path: Path, name: str, reason: str
) -> None:
    put(tmp_path / "class", name)
    [skipped] = find_skipped([tmp_path / "class"])
    assert skipped.label == (name if name != ".s8/answer.py" else ".s8")
    assert reason in skipped.reason
    [said] = graded(tmp_path).remarks
    assert skipped.label in said
    assert reason in said


def test_what_nobody_means_as_an_answer_is_passed_over_in_silence(tmp_path: Path) -> None:
    put(
        tmp_path / "class",
        "s1.py",
        "__init__.py",
        "._s1.py",
        "notes.txt",
        ".git/x.py",
        "s2/__init__.py",
        "s2/a.py",
    )
    assert find_skipped([tmp_path / "class"]) == []


def test_a_folder_with_nothing_but_such_a_name_tells_its_student(tmp_path: Path) -> None:
    put(tmp_path / "class", "s1/S1.PY")
    [result] = graded(tmp_path).results
    assert result.reason == (
        "the folder holds no .py and no .ipynb file, but S1.PY: its name ends in .PY, so rename it to S1.py"
    )


# --- one student, one name --------------------------------------------------------------------------------------------

ALIKE = ("blank", " blank", "blank ", "bla\nnk", "bla nk", "bla  nk", "bla\x00nk", "=x", "'=x", " =x", "=x\n")


def exported(students: Iterable[str]) -> dict[str, list[str]]:
    refused = ungradable_result(Submission("", "x.py", ""), "empty", GradedBy(EXERCISE, "sandbox", Path()))
    results = [replace(refused, student=one, status="graded", score=3.0) for one in students]
    texts = {
        "canvas": (canvas(results, "X (1)", 10.0), 3, 2),
        "moodle": (moodle(results, "X"), 0, 1),
        "nbgrader": (nbgrader(results), 3, 1),
        "grades": (grades_csv(results), 0, 1),
    }
    return {
        name: [row[column] for row in list(csv.reader(io.StringIO(text)))[head:]]
        for name, (text, column, head) in texts.items()
    }


def test_spaces_and_control_characters_make_no_two_students_one() -> None:
    for name, logins in exported(ALIKE).items():
        assert len({login.strip().casefold() for login in logins}) == len(ALIKE), name
        assert "blank" in logins, "who has a plain name keeps it"


def test_a_student_has_the_same_name_in_every_export() -> None:
    by_export = exported(ALIKE)
    assert len({tuple(sorted(logins)) for logins in by_export.values()}) == 1


def test_names_that_an_importer_takes_for_one_login_are_told_apart() -> None:
    found = exported(["Ada", "ada", "bob"])
    for name in ("canvas", "moodle"):
        assert "bob" in found[name]
        assert "ada" not in [login.casefold() for login in found[name]]
    assert sorted(found["grades"]) == ["Ada", "ada", "bob"]


LOOK_ALIKE = ("ada", "\u0430d\u0430", "a\u200bda", "\uff41da", "\u00e9l", "e\u0301l", "o\ufb01r", "ofir")
"""Cyrillic letters, a zero-width space, full-width letters, a separate accent, a ligature."""


def test_names_that_look_alike_are_different_students(tmp_path: Path) -> None:
    """Each has a result and a login, even for an importer that simplifies names.

    Only the two ways to store one accent are the same name. Of two such hand-ins, neither counts.
    """
    put(tmp_path / "class", *(f"{name}.py" for name in LOOK_ALIKE))
    results = graded(tmp_path).results
    assert {one.student for one in results} == {unicodedata.normalize("NFC", name) for name in LOOK_ALIKE}
    [accent] = [one for one in results if one.student == "\u00e9l"]
    assert "2 hand-ins of one student" in str(accent.reason)
    for name, logins in exported(LOOK_ALIKE).items():
        assert len(set(logins)) == len(LOOK_ALIKE), name
    for name in ("canvas", "moodle"):
        simple = [
            "".join(one for one in unicodedata.normalize("NFKC", login) if unicodedata.category(one) != "Cf")
            for login in exported(LOOK_ALIKE)[name]
        ]
        assert len({login.casefold() for login in simple}) == len(LOOK_ALIKE), simple
    assert "ofir" in exported(["ofir", "bob"])["canvas"]


@given(
    st.lists(
        st.text(alphabet="aA =+'\n\x00\u00a0\u2028[]0", min_size=1, max_size=4),
        min_size=2,
        max_size=6,
        unique=True,
    )
)
@settings(deadline=None, derandomize=True, max_examples=200)
def test_different_students_have_different_cells(names: list[str]) -> None:
    for logins in exported(names).values():
        assert len(set(logins)) == len(names)
        assert not [login for login in logins if login.startswith(("=", "+", "-", "@"))]
