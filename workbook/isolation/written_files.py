"""Count a program's files and bytes on disk and in shared memory, for tiers whose file systems don't limit them."""

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
"""If the space used in the watched file systems grows by more than this many bytes, we count the files right away."""
SHARED_MEMORY = "/dev/shm"
ENOUGH = 50_000
"""The number of files at which counting stops. No program may have that many."""
_BLOCK = 512


class WrittenFiles:
    """Counts the files in `own`, and the files in the `shared` folders that belong to `user`, with their bytes.

    The class isn't thread-safe.
    """

    def __init__(self, own: Path, shared: Sequence[str] = (), user: int | None = None) -> None:
        self._own = own
        self._shared = shared
        self._user = user
        self._in_use = self._space_in_use()
        self._look_at = time.monotonic() + LOOK_EVERY_S
        self.files = self.bytes = 0

    def look(self) -> "WrittenFiles":
        """Count again if a second has passed since the last count, or if much has been written. Return this object.

        Its attributes `files` and `bytes` have the latest counts.
        """
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
        except OSError:  # folders too deep or too closed to read, which an honest program doesn't have
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
                except OSError:  # gone, or another user's mount, which even root may not access
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
    """Estimates a program's use of shared memory while the judge and other programs run as the same user.

    The kernel doesn't report which process created a file in shared memory. So we count every new file as the
    program's, but not more bytes than the program has written in total.
    """

    def __init__(self, folder: str = SHARED_MEMORY) -> None:
        self._folder = folder
        self._before = {(one.st_ino, one.st_ctime_ns) for one in self._files()}
        self._in_use = self._space_in_use()

    def bytes_of(self, pids: Sequence[int], elsewhere: int) -> int:
        """Return the number of bytes that these processes may have written to shared memory.

        Return zero if the use of shared memory has hardly grown. `elsewhere`: the number of bytes that the processes
        have written to other files.
        """
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
    """Return a folder's first `ENOUGH` entries, or none if the folder is gone. Raises OSError if it can't be read."""
    try:
        with os.scandir(folder) as entries:
            return [*islice(entries, ENOUGH)]
    except (FileNotFoundError, NotADirectoryError):
        return []
