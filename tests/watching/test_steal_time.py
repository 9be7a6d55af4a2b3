"""CPU time taken by the host: from the kernel's table to the longest standstill."""

from pathlib import Path

from workbook.inside.proc import stolen_s
from workbook.watching.steal_time import StealTime

TABLE = """\
cpu  10 0 10 1000 0 0 0 {both} 0 0
cpu0 5 0 5 500 0 0 0 {first} 0 0
cpu1 5 0 5 500 0 0 0 {second} 0 0
intr 3 0 1
ctxt 77
"""


def write(folder: Path, first: int, second: int) -> Path:
    path = folder / "stat"
    path.write_text(TABLE.format(both=first + second, first=first, second=second))
    return path


def test_the_longest_standstill_of_one_processor_since_the_last_poll(tmp_path: Path) -> None:
    steal = StealTime(write(tmp_path, 100, 200))
    assert steal.longest_since_last() == 0.0
    write(tmp_path, 110, 280)
    assert round(steal.longest_since_last(), 6) == 0.8
    assert steal.longest_since_last() == 0.0
    write(tmp_path, 150, 281)
    assert round(steal.longest_since_last(), 6) == 0.4
    assert round(steal.in_all(), 6) == round((0.5 + 0.81) / 2, 6)


def test_where_nobody_tells_nothing_stands_still(tmp_path: Path) -> None:
    assert stolen_s(tmp_path / "absent") == {}
    (tmp_path / "stat").write_text("cpu  1 2 3\ncpu0 1 2 3\n\n")
    assert StealTime(tmp_path / "stat").longest_since_last() == 0.0
    assert StealTime(tmp_path / "stat").in_all() == 0.0


def test_this_machine_tells_of_each_of_its_processors() -> None:
    assert all(seconds >= 0.0 for seconds in stolen_s().values())
    assert len(stolen_s()) >= 1
