"""Which cells count as read, and where the course's map tells the reader to continue."""

import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from workbook.lesson import activity
from workbook.lesson.activity import StudyPace, note_cell
from workbook.lesson.course_map import READ_SHARE, CourseMap, LessonState, course_map
from workbook.lesson.progress import LessonProgress, load_progress

ROOT = Path(__file__).resolve().parents[2]
STEM = "05_timers"
LATER = 3600.0


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path))
    monkeypatch.setenv("JPY_SESSION_NAME", f"/home/ada/work/notebooks/{STEM}.ipynb")
    monkeypatch.setattr(activity, "_pace", StudyPace())
    return tmp_path


def run(*cells: str, sent: float, every: float) -> None:
    """Run cells that the front end sent `every` seconds apart, the first one at `sent`."""
    for number, cell in enumerate(cells):
        note_cell(SimpleNamespace(info=SimpleNamespace(cell_id=cell)), sent + number * every)


def state(done: dict[str, LessonProgress], stem: str = STEM) -> LessonState:
    return next(one for one in course_map(ROOT, done).lessons if one.stem == stem)


def ids(stem: str = STEM) -> list[str]:
    from workbook.lesson.course_map import _lesson

    path = ROOT / "notebooks" / f"{stem}.ipynb"
    return [cell.id for cell in _lesson(path, path.stat().st_mtime_ns).cells]


def test_a_comment_in_code_is_no_heading_to_go_on_at() -> None:
    headings = {place.heading for place in state({}).missing}
    assert "Predict" in headings and not [one for one in headings if one.startswith(("A:", "B:"))]


def test_run_all_is_not_read(folder: Path) -> None:
    run("a", "b", "c", sent=LATER, every=0.004)
    assert load_progress(STEM).cells == ["a", "b", "c"]
    assert load_progress(STEM).read == []


def test_an_editor_that_sends_each_cell_when_the_last_has_ended_reads_nothing_either(folder: Path) -> None:
    for cell in ("a", "b", "c"):  # each cell is sent when the previous one has ended
        run(cell, sent=time.time(), every=0)
    assert load_progress(STEM).read == []


def test_cells_run_one_by_one_are_read(folder: Path) -> None:
    run("a", "b", "c", sent=LATER, every=4.0)
    assert load_progress(STEM).read == ["a", "b", "c"]


def test_run_all_later_takes_nothing_back(folder: Path) -> None:
    run("a", "b", sent=LATER, every=4.0)
    run("a", "b", "c", sent=LATER + 60, every=0.004)
    assert load_progress(STEM).read == ["a", "b"]


def test_a_key_held_down_is_not_read(folder: Path) -> None:
    run("a", "b", "c", "d", sent=LATER, every=0.6)
    assert load_progress(STEM).read == ["a"], "the first was run alone, as far as one can tell"


def test_a_prediction_that_was_made_counts_as_read() -> None:
    made = LessonProgress(predictions={"loop-and-timer": "b"}, cells=ids())
    assert state({STEM: made}).cells[0] == 1


def test_nine_in_ten_cells_are_a_lesson() -> None:
    cells = ids()
    enough = -int(-READ_SHARE * len(cells) // 1)
    assert state({STEM: LessonProgress(read=cells[:enough])}).is_read
    assert not state({STEM: LessonProgress(read=cells[: enough - 1])}).is_read
    assert not state({STEM: LessonProgress(cells=cells)}).is_read


def test_one_goes_on_after_the_last_cell_that_was_read() -> None:
    cells = ids()
    skipped = state({STEM: LessonProgress(read=[cells[0], cells[4]])})
    assert skipped.place is not None
    assert skipped.place.cell == cells[5]
    assert skipped.place.notebook == f"notebooks/{STEM}.ipynb"
    assert skipped.place.heading
    last = state({STEM: LessonProgress(read=[cells[0], cells[-1]])})
    assert last.place is not None and last.place.cell == cells[1]


def test_the_lesson_of_the_last_time_comes_first(folder: Path) -> None:
    done = {
        "02_nodes": LessonProgress(touched=1.0, read=ids("02_nodes")[:1]),
        STEM: LessonProgress(touched=2.0, read=ids()[:3]),
    }
    course = course_map(ROOT, done)
    assert course.next_lesson is not None and course.next_lesson.stem == STEM
    assert course.next_step.startswith("Continue with: 05 · Timers, at “")
    assert not course_map(ROOT, {}).has_begun


def test_sums_add_up() -> None:
    done = {
        STEM: LessonProgress(read=ids(), tries=1, best=10.0, solved=True, predictions={"two-timers-due": "a"})
    }
    course: CourseMap = course_map(ROOT, done)
    assert {name: n for name, (n, _) in course.sums.items()} == {
        "lessons read": 1,
        "predictions made": 1,
        "exercises solved": 1,
        "points": 10.0,
    }
    assert state(done).is_done
