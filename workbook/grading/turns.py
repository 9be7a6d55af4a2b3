"""Turns: below the sandbox answers meet on the network of the machine, so one is judged after another.

An answer could speak on the domain of another one, or lease all domains. With one at a time there is no other.
"""

import fcntl
import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from workbook.isolation.tiers import Isolation, meets_others

_mine = threading.Lock()


def _file_of_turns() -> Path:
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(cache) / "rclpy-workbook" / f"turn-{os.uname().nodename}"


@contextmanager
def turn(isolation: Isolation) -> Iterator[None]:
    """Wait until no other answer of this user is judged on this machine in a tier in which answers meet.

    The kernel ends a turn with its process. Without a cache that can be written, turns are within this process only.
    """
    if not meets_others(isolation):
        yield
        return
    with _mine:
        held = _open_file()
        try:
            if held is not None:
                with suppress(OSError):  # a file system without locks
                    fcntl.flock(held, fcntl.LOCK_EX)
            yield
        finally:
            if held is not None:
                with suppress(OSError):
                    fcntl.flock(held, fcntl.LOCK_UN)
                os.close(held)


def _open_file() -> int | None:
    path = _file_of_turns()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        return os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    except OSError:
        return None
