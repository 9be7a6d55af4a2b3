"""What a program has written to the disk or to shared memory, in tiers in which nothing but this look bounds it."""

import os
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path

from workbook.inside import proc
from workbook.recording.limits import ANSWER_LIMITS

LOOK_EVERY_S = 1.0
WORTH_A_LOOK = (ANSWER_LIMITS.stored or 0) // 4
"""So many bytes more on one of the file systems are looked after at once: who wrote them?"""
SHARED_MEMORY = "/dev/shm"
ENOUGH = 50_000
"""Files after which counting ends: it is more than any program may have."""
_BLOCK = 512


class WrittenFiles:
    """Counts what is in `own`, and what belongs to `user` in the folders `shared`. Not for two threads at once."""

    def __init__(self, own: Path, shared: Sequence[str] = (), user: int | None = None) -> None:
        self._own = own
        self._shared = shared
        self._user = user
        self._in_use = self._space_in_use()
        self._look_at = time.monotonic() + LOOK_EVERY_S
        self.files = self.bytes = 0

    def look(self) -> "WrittenFiles":
        """Count again if a second has gone by, or if somebody has written a lot."""
        now, in_use = time.monotonic(), self._space_in_use()
        if now >= self._look_at or in_use > self._in_use + WORTH_A_LOOK:
            self._look_at, self._in_use = now + LOOK_EVERY_S, in_use
            self._count()
        return self

    def _count(self) -> None:
        self.files = self.bytes = 0
        try:
            for status in islice(self._all_files(), ENOUGH):
                self.files += 1
                self.bytes += status.st_blocks * _BLOCK
        except (
            OSError
        ):  # folders so deep, or so closed, that nobody can look into them: none of an honest program are
            self.files = ENOUGH

    def _space_in_use(self) -> int:
        used = 0
        for folder in (str(self._own), *self._shared):
            with suppress(OSError):
                space = os.statvfs(folder)
                used += (space.f_blocks - space.f_bfree) * space.f_frsize
        return used

    def _all_files(self) -> Iterator[os.stat_result]:
        waiting = [str(self._own)]
        for folder in self._shared:
            for entry in _entries(folder):
                try:
                    status = _status(entry)
                except OSError:  # gone, or the mount of another user, which even root may not look at
                    continue
                if entry.path != waiting[0] and status.st_uid == self._user:
                    yield status
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)
        while waiting:
            for entry in _entries(waiting.pop()):
                with suppress(FileNotFoundError):
                    yield _status(entry)
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)


class SharedMemory:
    """What a program keeps in shared memory, where it is the user that the judge and other programs are as well.

    Nobody tells whose a file there is. It may be the program's if it is new, and as far as the program has written that
    much at all.
    """

    def __init__(self, folder: str = SHARED_MEMORY) -> None:
        self._folder = folder
        self._before = {(one.st_ino, one.st_ctime_ns) for one in self._files()}
        self._in_use = self._space_in_use()

    def bytes_of(self, pids: Sequence[int], elsewhere: int) -> int:
        """What these processes may keep there, if worth a look. `elsewhere`: what they have written to the disk."""
        if self._space_in_use() < self._in_use + WORTH_A_LOOK:
            return 0
        new = sum(
            one.st_blocks * _BLOCK
            for one in self._files()
            if (one.st_ino, one.st_ctime_ns) not in self._before and one.st_uid == os.getuid()
        )
        return min(new, max(0, sum(map(proc.written_bytes, pids)) - elsewhere))

    def _space_in_use(self) -> int:
        try:
            space = os.statvfs(self._folder)
        except OSError:
            return 0
        return (space.f_blocks - space.f_bfree) * space.f_frsize

    def _files(self) -> list[os.stat_result]:
        found = []
        for folder, _, names in os.walk(self._folder):
            for name in names:
                with suppress(OSError):
                    found.append(os.stat(os.path.join(folder, name), follow_symlinks=False))
            if len(found) > ENOUGH:
                break
        return found


def _status(entry: os.DirEntry[str]) -> os.stat_result:
    return entry.stat(follow_symlinks=False)


def _entries(folder: str) -> list[os.DirEntry[str]]:
    """What a folder holds, as far as it counts. Raises OSError where it cannot be seen."""
    try:
        with os.scandir(folder) as entries:
            return [*islice(entries, ENOUGH)]
    except (FileNotFoundError, NotADirectoryError):
        return []
