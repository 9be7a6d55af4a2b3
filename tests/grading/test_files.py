"""Files of the gradebook:

written completely or not at all, with the mark that Excel needs, and named on a full disk.
"""

import errno
from pathlib import Path

import pytest

from workbook.grading.files import naming, write_whole

FULL = Path("/dev/full")


def test_a_byte_order_mark_is_written_when_it_is_asked_for(tmp_path: Path) -> None:
    text = "student\nŁukasz\n"
    assert write_whole(tmp_path / "with.csv", text, bom=True).read_bytes() == b"\xef\xbb\xbf" + text.encode()
    assert write_whole(tmp_path / "without.csv", text).read_bytes() == text.encode()


def test_a_full_disk_names_the_file_and_leaves_the_old_one(tmp_path: Path) -> None:
    path = write_whole(tmp_path / "grades.csv", "old")
    partial = tmp_path / ".grades.csv.part"
    partial.symlink_to(FULL)  # writing there fails, as on a full disk
    with pytest.raises(OSError, match=r"grades\.csv") as raised:
        write_whole(path, "new" * 100_000)
    assert raised.value.errno == errno.ENOSPC
    assert path.read_text() == "old"
    assert not partial.is_symlink()


def test_an_error_that_names_a_file_keeps_it(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="nowhere"), naming(tmp_path / "other"):
        (tmp_path / "nowhere").read_text()
