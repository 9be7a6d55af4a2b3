"""Define the interface of an isolation tier. `NodeProcess` depends only on it; `workbook.isolation` has the tiers."""

import importlib.util
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Protocol

from workbook.recording.limits import ADDRESSES_PER_THREAD, ENDED_PROCESSES, THREADS_PER_CORE, Limits

LARGE_PACKAGES = ("torch", "nvidia")
"""PyTorch, and the CUDA packages that it loads even if there's no graphics processor."""


class Child(Protocol):
    """A program that was started."""

    @property
    def pid(self) -> int:
        """The ID of the process on this machine whose process tree contains the program."""

    def poll(self) -> int | None:
        """Return the program's exit code, or None while it's running.

        A negative code is the number of the signal that ended it.
        """

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program to end, and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` seconds.
        """

    def interrupt(self) -> None:
        """Send SIGINT to the program, like Ctrl-C."""

    def tree(self) -> list[int]:
        """Return the process IDs of the program, its descendants, and the tier's sandbox.

        Processes that have been reaped are left out.
        """

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait for the tier's sandbox, if there's one, to end.

        Raises subprocess.TimeoutExpired after `timeout` seconds.
        """

    def close(self) -> None:
        """Release resources. Call this after the program and its sandbox have ended."""


@dataclass(frozen=True)
class Order:
    """A program to start: its environment, limits, and output descriptor, and the `arguments` for its host.

    `cgroup_join_file`: the file through which the program joins a memory cgroup before any of its code is read; None if
    there's no group. `input_fd`: its input descriptor; None for a program without input.
    """

    arguments: Sequence[str]
    environ: Mapping[str, str]
    limits: Limits
    output_fd: int
    cgroup_join_file: str | None = None
    input_fd: int | None = None


@dataclass(frozen=True)
class Started:
    """A program, and its start time (`time.monotonic`, s)."""

    child: Child
    at: float


class Confinement(Protocol):
    """Isolates one program: provides its files, starts it, measures it, and removes its leftovers."""

    def bring(self, file: Path, name: str) -> str:
        """Make a file readable for the program, under this name. Return the path under which the program finds it."""

    def host_options(self, limits: Limits) -> list[str]:
        """Return the host's options for these limits.

        The host applies them in the program's process before it runs the program.
        """

    def start(self, order: Order) -> Started:
        """Start the program in its tier, by forking if possible. Raises OSError if it can't be started."""

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files in the program's fullest folder; zero if the tier doesn't limit files."""

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return how many bytes the program has written to shared file systems; zero if they're private."""

    def sockets(self, pids: Sequence[int]) -> int:
        """Return how many sockets the program has open.

        If only the judge and the program share a network, return how many sockets were added to it since the start.
        """

    def queued_bytes(self, worth_counting: int) -> int:
        """Return the number of unread bytes held by the sockets in the program's separate network namespace.

        If the sockets hold at most `worth_counting` bytes, the result may be zero. If the program uses the machine's
        network, the result is always zero.
        """

    def exceeded(self) -> str | None:
        """Return the limit that the program has exceeded according to its memory cgroup.

        Return None if it has exceeded none, or if it has no group.
        """

    def unfiltered(self) -> str:
        """Return why the tier can't filter the program's system calls, as a clause; empty if it can or needn't."""

    def sweep(self) -> bool:
        """End all processes that the ended program left running. Return whether there were any.

        Raises StillThere if that isn't possible.
        """

    def remove(self) -> None:
        """Remove the files that `bring` created, and release all other resources."""


class Tier(Protocol):
    """An isolation tier, which confines one program after another."""

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement for one program, whose working folder is `scratch`."""


def threads_of_libraries() -> int:
    """Return how many threads a program's libraries may start on this machine, in addition to the program's own."""
    return THREADS_PER_CORE * (os.cpu_count() or 1)


@cache
def addresses_of_libraries() -> int:
    """Return the address space (bytes) that the largest installed libraries take up: the size of their files.

    They use hardly any memory, because the kernel only maps the files. PyTorch from PyPI maps 2.9 GB.
    """
    found = importlib.util.find_spec("torch")
    if found is None or not found.submodule_search_locations:
        return 0
    packages = Path(found.submodule_search_locations[0]).parent
    files = [path for name in LARGE_PACKAGES for path in (packages / name).rglob("*.so*")]
    return sum(path.stat().st_size for path in files)


def limit_options(limits: Limits, names: Sequence[str]) -> list[str]:
    """Return the host's options for the named limits, except for limits that aren't set.

    The kernel limits address space and threads, while the judge counts memory and processes, so the kernel's limits are
    higher. The kernel also counts ended processes that haven't been reaped, which the judge doesn't.
    """
    threads = threads_of_libraries()
    more = {
        "memory": ADDRESSES_PER_THREAD * threads + addresses_of_libraries(),
        "processes": threads + ENDED_PROCESSES,
    }
    values = {name: getattr(limits, name) for name in names}
    return [
        part
        for name, value in values.items()
        if value is not None
        for part in ("--limit", f"{name}={value + more.get(name, 0)}")
    ]
