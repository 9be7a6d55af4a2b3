"""Limit each student's disk space with an image: a sparse file that contains everything the student can write.

FOLDER/disks/NAME.ext4        the image
FOLDER/students/NAME/disk     where it's mounted; its folders are then mounted over the three folders of `Place`

Only the hub and the servers that it starts see the mounts, because they share a mount namespace. When its last process
has ended, in whatever way, the kernel unmounts the images and frees their loop devices.
"""

import os
import shutil
import subprocess
import threading
from contextlib import suppress
from pathlib import Path

from deploy.jupyterhub.places import Place
from workbook.inside.libc import checked, libc
from workbook.inside.proc import command_line, owner, pids

GATE = Path(__file__).with_name("gate.py")
CLONE_NEWNS = 0x00020000
IMAGE = ".ext4"
OPTIONS = "nosuid,nodev,discard,noinit_itable"  # the real disk keeps only what a student's files need
PROGRAMS = ("mkfs.ext4", "e2fsck", "resize2fs", "losetup", "mount")
REPAIRED = 1
"""The highest exit code of e2fsck that means that the file system is in order (e2fsck(8))."""
_one_at_a_time = threading.Lock()


class NoDisk(RuntimeError):
    """A student's disk can't be used. The message, for the hub's log, says why."""


def missing() -> str | None:
    """Return what this machine lacks for images; None if it lacks nothing."""
    programs = [program for program in PROGRAMS if shutil.which(program) is None]
    if programs:
        return f"{', '.join(programs)} (apt install e2fsprogs mount)"
    return None if Path("/dev/loop-control").exists() else "loop devices (/dev/loop-control)"


def enter_mounts(hub: int) -> None:
    """Move this thread into a mount namespace whose mounts reach its sandboxes but not the rest of the machine.

    `hub`: the hub's port. If servers of an earlier hub on this port are running, share their namespace, so that an
    instructor among them sees later students' hand-ins. The process mustn't have other threads yet. Raises OSError or
    NoDisk.
    """
    for pid in pids():
        words = command_line(pid).split(b"\0")
        if owner(pid) == 0 and str(GATE).encode() in words and f"--hub={hub}".encode() in words:
            with suppress(FileNotFoundError), open(f"/proc/{pid}/ns/mnt", "rb") as namespace:
                checked("setns", libc.setns(namespace.fileno(), CLONE_NEWNS))
                return
    checked("unshare", libc.unshare(CLONE_NEWNS))
    _run("mount", "--make-rslave", "/")
    _run("mount", "--make-rshared", "/")


def image_of(place: Place) -> Path:
    """Return the path of a student's image."""
    return place.top / "disks" / f"{place.name}{IMAGE}"


def students_with_image(top: Path) -> list[str]:
    """Return the names of all students who have an image."""
    return sorted(image.name.removesuffix(IMAGE) for image in (top / "disks").glob(f"*{IMAGE}"))


def attach(place: Place, size: int) -> None:
    """Mount a student's image. Create it if there's none, and enlarge it to `size` bytes if it's smaller.

    With a size of 0, neither create nor enlarge it. Raises NoDisk.
    """
    with _one_at_a_time:
        _attach(place, size)


def _attach(place: Place, size: int) -> None:
    image, disk = image_of(place), place.home.parent / "disk"
    if not image.exists() and not size:
        return
    disk.mkdir(exist_ok=True)
    image.parent.mkdir(mode=0o700, exist_ok=True)
    folders = {"work": place.work, "home": place.home, "hand_ins": place.hand_ins}
    if not image.exists():
        _create(image, size, disk, folders)
    elif not disk.is_mount():
        if not _device(image):
            _check_and_enlarge(image, size)
        _mount(image, disk)
    for name, folder in folders.items():
        if not folder.is_mount():
            _run("mount", "--bind", str(disk / name), str(folder))


def _create(image: Path, size: int, disk: Path, folders: dict[str, Path]) -> None:
    """Create an image with copies of the folders, and mount it. It gets its name last, when it's complete."""
    new = image.with_suffix(".new")
    new.unlink(missing_ok=True)  # the creation was interrupted
    with new.open("xb") as file:
        file.truncate(size)
    _run("mkfs.ext4", "-q", "-F", "-m", "0", "-J", "size=8", str(new))
    _mount(new, disk)
    try:
        for name, folder in folders.items():
            _run("cp", "--archive", "--no-target-directory", str(folder), str(disk / name))
        _run("sync", "--file-system", str(disk))
        new.rename(image)
    except BaseException:
        _run("umount", str(disk))
        new.unlink()
        raise


def _mount(image: Path, disk: Path) -> None:
    """Mount an image, through the same loop device if it's also mounted in the namespace of an earlier hub."""
    device = _device(image)
    _run("mount", "-o", OPTIONS if device else f"{OPTIONS},loop", device or str(image), str(disk))
    device = _device(image)
    is_its_own = bool(device) and os.stat(device).st_rdev == disk.stat().st_dev
    if not is_its_own:  # another image got the device after we had looked
        _run("umount", str(disk))
        raise NoDisk(f"{image} changed its loop device; starting the server again helps")


def _check_and_enlarge(image: Path, size: int) -> None:
    _run("e2fsck", "-p", str(image), highest=REPAIRED)
    if image.stat().st_size < size:
        _run("e2fsck", "-f", "-p", str(image), highest=REPAIRED)
        _run("resize2fs", str(image), f"{size >> 10}K")


def _device(image: Path) -> str:
    return _run("losetup", "--noheadings", "--output", "NAME", "--associated", str(image)).strip()


def _run(*command: str, highest: int = 0) -> str:
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    if done.returncode > highest:
        raise NoDisk(f"`{' '.join(command)}` failed: {done.stdout}{done.stderr}")
    return done.stdout
