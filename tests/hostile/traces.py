"""Find what a grader leaves behind: its processes, and its files in shared places."""

import contextlib
import os
import re
import weakref
from pathlib import Path

from workbook.isolation.memory_groups import find_hierarchy, groups_problem

PLACES = (Path("/tmp"), Path("/dev/shm"))
_UUID = re.compile(
    r"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"
)  # random names of any process: their digits aren't process ids


class Traces:
    """Distinguishes one grader from everything else on the machine.

    The grader is started with `home` as its HOME, which no other process has. Slots and sandboxes inherit it, but
    programs in sandboxes don't. Such a program is recognized by the network that it shares with its slot.

    Call `look` regularly while the grader runs, because the network of an ended slot is unknown. Each network that was
    found is kept open. Otherwise, the kernel could reuse its number, even for another grader's network.
    """

    def __init__(self, home: Path) -> None:
        self._mark = f"HOME={home}".encode()
        self._own_network = _network(os.getpid())
        self._networks: dict[int, int] = {}
        self._pids: set[int] = set()
        weakref.finalize(self, _close_all, self._networks)

    def look(self) -> dict[int, str]:
        """Return the grader's processes, with their command lines."""
        marked = {pid for pid in _all_pids() if self._mark in _read(pid, "environ").split(b"\0")}
        for pid in marked:
            self._keep_network(pid)
        found = marked | {pid for pid in _all_pids() if _network(pid) in self._networks}
        self._pids |= found
        return {pid: _read(pid, "cmdline").replace(b"\0", b" ").decode(errors="replace") for pid in found}

    def _keep_network(self, pid: int) -> None:
        """Open a process's network and keep it by its number, unless it is our own."""
        with contextlib.suppress(OSError):
            held = os.open(f"/proc/{pid}/ns/net", os.O_RDONLY | os.O_CLOEXEC)
            number = os.fstat(held).st_ino
            if number == self._own_network or number in self._networks:
                os.close(held)
            else:
                self._networks[number] = held

    def files(self) -> list[Path]:
        """Return files in shared places, and memory cgroups, whose names contain the id of one of its processes."""
        return [
            path
            for place in (*PLACES, *_groups())
            for path in place.glob("*")
            if self._pids
            & {
                int(word)
                for word in _UUID.sub("", path.name).replace("_", "-").split("-")
                if word.isdecimal()
            }
        ]


def _groups() -> list[Path]:
    """Return where our memory cgroups are; empty on a machine without them."""
    return [] if groups_problem() is not None else [find_hierarchy().own]


def _all_pids() -> list[int]:
    return [int(entry) for entry in os.listdir("/proc") if entry.isdecimal() and int(entry) != os.getpid()]


def _read(pid: int, name: str) -> bytes:
    try:
        return Path(f"/proc/{pid}/{name}").read_bytes()
    except OSError:
        return b""


def _close_all(networks: dict[int, int]) -> None:
    for held in networks.values():
        os.close(held)


def _network(pid: int) -> int | None:
    try:
        return os.stat(f"/proc/{pid}/ns/net").st_ino
    except OSError:
        return None
