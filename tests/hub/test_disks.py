"""Each student's disk: what an image contains, and how it's created, mounted, and enlarged."""

import multiprocessing
import os
import shutil
import subprocess
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import pytest

from deploy.jupyterhub.disks import NoDisk, attach, enter_mounts, image_of, missing
from deploy.jupyterhub.places import Place, place_of
from tests.hub.class_server import wait_until

FIRST_ID = 700_000
SIZE = 32 << 20
pytestmark = [
    pytest.mark.whole,
    pytest.mark.skipif(os.geteuid() != 0 or missing() is not None, reason="disks need root and loop devices"),
]


@pytest.fixture
def place(tmp_path: Path) -> Iterator[Place]:
    yield place_of("ada", tmp_path / "class", FIRST_ID)
    wait_until(lambda: not devices(tmp_path), "a loop device is left")


@contextmanager
def hub() -> Iterator[ProcessPoolExecutor]:
    """A process with a mount namespace of its own, like a hub's."""
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, context, initializer=enter_mounts, initargs=(0,)) as process:
        yield process


def devices(folder: Path) -> list[str]:
    listed = subprocess.run(["losetup", "-O", "NAME,BACK-FILE"], capture_output=True, text=True, check=True)
    return [line for line in listed.stdout.splitlines() if str(folder) in line]


def size_of(folder: Path) -> int:
    return shutil.disk_usage(folder).total


def test_the_first_disk_has_all_files_from_before(place: Place) -> None:
    for folder in (place.work, place.home, place.hand_ins):
        file = folder / "mine.txt"
        file.write_text(folder.name)
        os.chown(file, place.user, FIRST_ID)
        file.chmod(0o640)
    with hub() as one:
        one.submit(attach, place, SIZE).result()
        for folder in (place.work, place.home, place.hand_ins):
            assert one.submit(size_of, folder).result() < SIZE
            assert one.submit(Path.read_text, folder / "mine.txt").result() == folder.name
            for path in (folder, folder / "mine.txt"):
                inside, outside = one.submit(Path.stat, path).result(), path.stat()
                assert (inside.st_uid, inside.st_gid, inside.st_mode) == (
                    outside.st_uid,
                    outside.st_gid,
                    outside.st_mode,
                )
                assert inside.st_dev != outside.st_dev


def test_a_second_hub_shares_the_disk_that_servers_of_the_first_still_use(place: Place) -> None:
    with hub() as first, hub() as second:
        first.submit(attach, place, SIZE).result()
        second.submit(attach, place, SIZE).result()
        first.submit(Path.write_text, place.work / "mine.txt", "seen by both").result()
        assert second.submit(Path.read_text, place.work / "mine.txt").result() == "seen by both"
        assert len(devices(place.top)) == 1


def test_a_killed_hub_leaves_no_disk_mounted(place: Place) -> None:
    with hub() as one:
        one.submit(attach, place, SIZE).result()
        assert len(devices(place.top)) == 1
        [process] = multiprocessing.active_children()
        process.kill()
        wait_until(lambda: not devices(place.top), "a loop device is left")


def test_an_interrupted_creation_is_repeated(place: Place) -> None:
    new = image_of(place).with_suffix(".new")
    new.parent.mkdir()
    new.write_bytes(b"the beginning")
    (place.work / "mine.txt").write_text("kept")
    with hub() as one:
        one.submit(attach, place, SIZE).result()
        assert one.submit(Path.read_text, place.work / "mine.txt").result() == "kept"
    assert image_of(place).exists() and not new.exists()


def test_files_that_do_not_fit_stay_where_they_are(place: Place) -> None:
    (place.work / "large").write_bytes(os.urandom(2 * SIZE))
    with hub() as one:
        with pytest.raises(NoDisk, match="No space left on device"):
            one.submit(attach, place, SIZE).result()
        one.submit(attach, place, 4 * SIZE).result()
        assert one.submit(Path.stat, place.work / "large").result().st_size == 2 * SIZE


def test_a_higher_limit_enlarges_the_disk_and_no_limit_leaves_it(place: Place) -> None:
    for size, at_least in ((SIZE, 0), (4 * SIZE, 3 * SIZE), (0, 3 * SIZE)):
        with hub() as one:
            one.submit(attach, place, size).result()
            assert one.submit(size_of, place.work).result() > at_least
        wait_until(lambda: not devices(place.top), "the image is still in use")


def test_without_a_limit_there_is_no_disk(place: Place) -> None:
    attach(place, 0)
    assert not image_of(place).parent.exists()
