"""What a program has written is counted: by folder and by user, however it is hidden."""

import os
from pathlib import Path

import pytest

from workbook.isolation import written_files
from workbook.isolation.written_files import ENOUGH, WrittenFiles


@pytest.fixture(autouse=True)
def _always_look(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(written_files, "LOOK_EVERY_S", 0.0)


def test_files_and_bytes_of_a_folder_are_counted_and_links_are_not_followed(tmp_path: Path) -> None:
    own, other = tmp_path / "own", tmp_path / "other"
    for folder in (own / "deep" / "er", other):
        folder.mkdir(parents=True)
    written = WrittenFiles(own)
    assert (written.look().files, written.look().bytes > 100_000) == (2, False)
    for place in (own / "deep" / "er" / "x", other / "y"):
        place.write_bytes(b"x" * 1_000_000)
    (own / "link").symlink_to(other)
    assert written.look().files == 4
    assert 1_000_000 <= written.bytes < 1_500_000
    (own / "deep" / "er" / "x").unlink()
    assert written.look().bytes < 500_000


def test_in_shared_folders_what_belongs_to_the_user_counts(tmp_path: Path) -> None:
    shared, own = tmp_path / "shared", tmp_path / "shared" / "own"
    (shared / "folder").mkdir(parents=True)
    own.mkdir()
    for place in (shared / "file", shared / "folder" / "file", own / "file"):
        place.write_bytes(b"x" * 100_000)
    mine = WrittenFiles(own, [str(shared), str(tmp_path / "none")], os.getuid())
    assert mine.look().files == 4, "what lies in its own folder counts once"
    assert WrittenFiles(own, [str(shared)], 60_600).look().files == 1


def test_a_folder_that_nobody_can_look_into_counts_as_too_many(tmp_path: Path) -> None:
    before = os.getcwd()
    os.chdir(tmp_path)
    try:
        for _ in range(60):
            os.mkdir("d" * 100)
            os.chdir("d" * 100)
    finally:
        os.chdir(before)
    assert WrittenFiles(tmp_path).look().files == ENOUGH


def test_counting_ends_where_it_is_too_much(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(written_files, "ENOUGH", 10)
    for number in range(30):
        (tmp_path / str(number)).touch()
    assert WrittenFiles(tmp_path).look().files == 10


def test_without_a_reason_it_is_not_counted_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(written_files, "LOOK_EVERY_S", 1000.0)
    in_use = [0]
    monkeypatch.setattr(WrittenFiles, "_space_in_use", lambda self: in_use[0])
    written = WrittenFiles(tmp_path)
    (tmp_path / "file").touch()
    assert written.look().files == 0
    in_use[0] += written_files.WORTH_A_LOOK + 1
    assert written.look().files == 1, "somebody has written a lot"
