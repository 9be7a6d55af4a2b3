"""A program's written data is counted by folder and by user, even if the program hides it."""

import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.programs.support import write
from workbook.isolation import written_files
from workbook.isolation.limits import LimitsTier
from workbook.isolation.written_files import ENOUGH, SharedMemory, WrittenFiles
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import Limits


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

    def statvfs(_: str) -> SimpleNamespace:
        return SimpleNamespace(f_blocks=10**12, f_bfree=10**12 - in_use[0], f_frsize=1)

    monkeypatch.setattr(os, "statvfs", statvfs)
    written = WrittenFiles(tmp_path)
    (tmp_path / "file").touch()
    assert written.look().files == 0
    in_use[0] += written_files.WORTH_A_LOOK + 1
    assert written.look().files == 1, "somebody has written a lot"


def test_what_comes_to_shared_memory_counts_for_who_has_written_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(written_files, "WORTH_A_LOOK", 0)
    (tmp_path / "before").write_bytes(b"x" * 1_000_000)
    shared = SharedMemory(str(tmp_path))
    assert shared.bytes_of([os.getpid()], 0) == 0
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as innocent:
        (tmp_path / "new").write_bytes(b"x" * 3_000_000)
        assert 3_000_000 <= shared.bytes_of([os.getpid()], 0) < 3_500_000
        assert shared.bytes_of([innocent.pid], 0) < 100_000, "it has written next to nothing"
        assert shared.bytes_of([os.getpid()], 10**15) == 0, "all that it has written is elsewhere"


FILLS_SHARED_MEMORY = """
import os, time
for number in range(8):
    with open(f"/dev/shm/@@NAME@@-{number}", "wb") as file:
        file.write(bytes(5_000_000))
time.sleep(600)
"""


def test_below_all_isolation_a_program_that_fills_shared_memory_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(written_files, "WORTH_A_LOOK", 5_000_000)
    name = f"workbook-test-{os.getpid()}"
    spec = ProgramSpec(
        write(tmp_path, FILLS_SHARED_MEMORY.replace("@@NAME@@", name)),
        limits=Limits(processes=64, stored=20_000_000),
    )
    try:
        with NodeProcess(spec, 0, LimitsTier()) as process:
            assert process.wait(60.0), "it is ended"
            record = process.record()
    finally:
        for path in Path("/dev/shm").glob(f"{name}-*"):
            path.unlink()
    assert (record.limits_hit, record.ended_by) == (("disk",), "judge")
