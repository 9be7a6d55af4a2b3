"""The home page: whom it greets, what it says, and when it changes."""

import json
import re
from pathlib import Path

import pytest

from workbook.lab import home
from workbook.lab.home import Desk, desk_below, fingerprint, page
from workbook.lesson.progress import LessonProgress

ROOT = Path(__file__).resolve().parents[2]
STEM = "05_timers"


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """Make an unused student's copy."""
    (tmp_path / "work" / ".state").mkdir(parents=True)
    (tmp_path / "work" / ".state" / "delivered.json").write_text("{}")
    (tmp_path / "work" / "answers" / ".best").mkdir(parents=True)
    return desk_below(tmp_path / "work")


def keep(desk: Desk, stem: str, progress: LessonProgress) -> None:
    (desk.answers / ".progress.json").write_text(json.dumps({stem: vars(progress)}))


@pytest.mark.parametrize(
    ("root", "prefix"), [("work", ""), (".", "work/"), ("work/notebooks", ""), ("elsewhere", "")]
)
def test_it_finds_the_students_copy_from_each_folder(
    desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, root: str, prefix: str
) -> None:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    (tmp_path / "work" / "notebooks").mkdir()
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    assert desk_below(tmp_path / root) == Desk(desk.folder, prefix)


def test_without_a_copy_it_shows_the_course_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    assert desk_below(tmp_path) == Desk(tmp_path, "")


def test_at_first_it_offers_the_first_lesson(desk: Desk) -> None:
    text = page(desk)
    assert "<h1>Welcome</h1>" in text
    assert "Start 00 · Start here" in text
    assert text.count('class="wb-read"') == len(list((ROOT / "notebooks").glob("[0-9]*.ipynb")))
    assert "wb-warning" not in text


def test_it_leads_to_the_cell_to_go_on_at(desk: Desk) -> None:
    cells = [one for one in lesson_cells() if one["cell_type"] == "code"]
    keep(desk, STEM, LessonProgress(read=[cells[0]["id"], cells[1]["id"]], touched=1.0))
    button = re.search(r"<a [^>]*data-key=\"next\"[^>]*>", page(desk))
    assert button is not None
    assert f'data-path="notebooks/{STEM}.ipynb"' in button[0]
    assert f'data-cell="{cells[2]["id"]}"' in button[0]


def test_what_is_missing_for_read_is_linked_and_no_share_is_shown(desk: Desk) -> None:
    cells = [one["id"] for one in lesson_cells() if one["cell_type"] == "code"]
    unread = cells[5:8]
    keep(desk, STEM, LessonProgress(read=[one for one in cells if one not in unread], touched=1.0))
    text = page(desk)
    row = text.split(f'id="wb-{STEM}"')[1].split("</li>")[0]
    assert f"{len(cells) - 3} of {len(cells)} cells" in row
    assert "1 more to count as read:" in " ".join(row.split())
    assert f'data-cell="{unread[0]}"' in row
    assert not re.search(r"\d %", row)
    keep(desk, STEM, LessonProgress(read=cells[:9], touched=1.0))
    row = page(desk).split(f'id="wb-{STEM}"')[1].split("</li>")[0]
    assert "to count as read" not in row and f'data-cell="{cells[9]}"' in row


def test_each_lesson_promises_something_in_a_line(desk: Desk) -> None:
    promises = re.findall(r'<p class="wb-promise">(.*?)</p>', page(desk))
    assert len(promises) == len(list((ROOT / "notebooks").glob("[0-9]*.ipynb")))
    assert all(promises), "a lesson's `You will be able to` was not found"
    assert "Make a node repeat its work at a fixed rate" in promises


def lesson_cells() -> list[dict[str, str]]:
    cells: list[dict[str, str]] = json.loads((ROOT / "notebooks" / f"{STEM}.ipynb").read_text())["cells"]
    return cells


def test_it_warns_of_a_file_that_is_not_the_best_version_until_that_is_back(desk: Desk) -> None:
    keep(desk, STEM, LessonProgress(tries=1, best=8.0))
    (desk.answers / ".best" / f"{STEM}.py").write_text("best = 1\n")
    (desk.answers / f"{STEM}.py").write_text("worse = 1\n")
    assert f'data-restore="{STEM}"' in page(desk)
    home.restore_best(STEM, desk.answers)
    assert "data-restore" not in page(desk)


def test_it_changes_when_something_was_done_and_only_then(desk: Desk) -> None:
    first = fingerprint(desk)
    assert fingerprint(desk) == first
    keep(desk, STEM, LessonProgress(read=["intro-3"]))
    second = fingerprint(desk)
    (desk.answers / f"{STEM}.py").write_text("worse = 1\n")
    assert len({first, second, fingerprint(desk)}) == 3


def test_it_needs_no_network(desk: Desk) -> None:
    front_end = Path(home.__file__).with_name("front_end")
    shown = [page(desk), *(path.read_text() for path in front_end.rglob("*.[jc]s*"))]
    assert not [
        text for text in shown if re.search(r"https?://(?!www\.w3\.org/2000/svg)|@import|url\((?!#)", text)
    ]
