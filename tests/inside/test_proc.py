"""The kernel's tables: in the format that it writes, and in other possible ones."""

import time
from pathlib import Path

import pytest

from workbook.inside import proc

TABLE = """\
cpu  1000 100 300 4000 500 10 20 70 900 0
cpu0 600 100 200 2000 500 10 20 30 500 0
cpu1 400 0 100 2000 0 0 0 40 400 0
intr 12345 0 0
ctxt 999
"""
TICK_S = 0.01


@pytest.fixture
def table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(proc, "_TICK_S", TICK_S)
    path = tmp_path / "stat"
    path.write_text(TABLE)
    return path


def test_idle_is_also_who_waits_for_a_disk_and_guests_do_not_count_twice(table: Path) -> None:
    assert proc.idle_and_all_s(table) == (pytest.approx(45.0), pytest.approx(60.0))


def test_what_was_taken_away_is_told_of_each_processor(table: Path) -> None:
    assert proc.stolen_s(table) == {"cpu0": pytest.approx(0.3), "cpu1": pytest.approx(0.4)}


def test_where_nobody_tells_there_is_nothing(tmp_path: Path) -> None:
    (tmp_path / "stat").write_text("cpu  many\ncpu0\n")
    for path in (tmp_path / "stat", tmp_path / "absent"):
        assert proc.idle_and_all_s(path) == (0, 0)
        assert proc.stolen_s(path) == {}


def test_of_this_machine_the_time_goes_on() -> None:
    idle, passed = proc.idle_and_all_s()
    assert 0 <= idle <= passed
    while proc.idle_and_all_s()[1] <= passed:
        time.sleep(TICK_S)


def test_paths_with_spaces_are_read_whole(tmp_path: Path) -> None:
    maps, sockets = (tmp_path / name for name in ("maps", "unix"))
    library = "/home/ä b/my course/.venv/lib/liblttng-ust-1.so"
    maps.write_text(
        f"7f00-7f10 r-xp 00000000 08:01 123                        {library}\n7f20-7f30 rw-p 00000000 00:00 0\n"
    )
    assert proc.mapped_libraries("liblttng-ust-", str(maps)) == {library}
    sockets.write_text(
        "Num       RefCount Protocol Flags    Type St Inode Path\n"
        "0000: 00000002 00000000 00010000 0001 01 11 @/my course/lease\n"
        "0000: 00000003 00000000 00000000 0001 03 12\n"
    )
    assert proc.unix_socket_names(str(sockets)) == {"@/my course/lease"}
