"""What a grader leaves behind: its processes, and its files in the common places."""

import os
import re
import time
from collections.abc import Callable
from pathlib import Path

PLACES = (Path("/tmp"), Path("/dev/shm"))
PATIENCE_S = 60.0
_UUID = re.compile(
    r"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"
)  # names by chance, of whomever: no process ids


class Traces:
    """Follows one grader among all that happens on the machine.

    The grader is started with `home` as its HOME, which no other process has. Slots and boxes inherit it, but programs
    in boxes do not: those are known by the network that they share with their slot. Call `look` now and then while it
    runs, because a slot that has gone cannot be asked for its network any more.
    """

    def __init__(self, home: Path) -> None:
        self._mark = f"HOME={home}".encode()
        self._own_network = os.readlink("/proc/self/ns/net")
        self._networks: set[str] = set()
        self._pids: set[int] = set()

    def look(self) -> dict[int, str]:
        """Processes that belong to the grader, with their command lines."""
        marked = {pid for pid in _all_pids() if self._mark in _read(pid, "environ").split(b"\0")}
        self._networks |= {network for pid in marked if (network := _network(pid)) is not None}
        self._networks.discard(self._own_network)
        found = marked | {pid for pid in _all_pids() if _network(pid) in self._networks}
        self._pids |= found
        return {pid: _read(pid, "cmdline").replace(b"\0", b" ").decode(errors="replace") for pid in found}

    def files(self) -> list[Path]:
        """What lies in the common places and is named after one of its processes."""
        return [
            path
            for place in PLACES
            for path in place.glob("*")
            if self._pids
            & {
                int(word)
                for word in _UUID.sub("", path.name).replace("_", "-").split("-")
                if word.isdecimal()
            }
        ]


def _all_pids() -> list[int]:
    return [int(entry) for entry in os.listdir("/proc") if entry.isdecimal() and int(entry) != os.getpid()]


def _read(pid: int, name: str) -> bytes:
    try:
        return Path(f"/proc/{pid}/{name}").read_bytes()
    except OSError:
        return b""


def _network(pid: int) -> str | None:
    try:
        return os.readlink(f"/proc/{pid}/ns/net")
    except OSError:
        return None


def wait_until(condition: Callable[[], object], what: str) -> None:
    """Wait until a condition holds; fail, saying `what` was waited for, when it does not within a minute."""
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < deadline, f"waited {PATIENCE_S:.0f} s in vain: {what}"
        time.sleep(0.02)
