"""Define the interface of an isolation tier, which is one way to protect the machine from a program.

The tiers themselves are in `workbook.isolation`. `NodeProcess` depends only on this interface. The *host* is the file
`inside/host.py`, which runs in the program's process and loads the program.
"""

import importlib.util
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Protocol

from workbook.recording.limits import ADDRESSES_PER_THREAD, ENDED_PROCESSES, THREADS_PER_CORE, Limits

LARGE_PACKAGES = ("torch", "nvidia")
"""PyTorch, and the CUDA packages that it loads even on a machine without a GPU."""


class Child(Protocol):
    """A program that has been started."""

    @property
    def pid(self) -> int:
        """The ID of the process on this machine whose process tree contains the program."""

    def poll(self) -> int | None:
        """Return the program's exit code, or None while it's running.

        A negative code -n means that signal n killed the program.
        """

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program to exit, and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` seconds.
        """

    def interrupt(self) -> None:
        """Send SIGINT to the program, like Ctrl-C."""

    def tree(self) -> list[int]:
        """Return the process IDs of the program, its descendants, and the tier's sandbox.

        Processes that have been reaped are left out.
        """

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait until the tier's sandbox, if there is one, has been removed.

        Raises subprocess.TimeoutExpired after `timeout` seconds.
        """

    def close(self) -> None:
        """Release resources. Call this method after the program has exited and its sandbox has been removed."""


@dataclass(frozen=True)
class Order:
    """A program to start: its environment, limits, and output descriptor, and the `arguments` for its host.

    `cgroup_join_file`: the file through which the process joins a memory cgroup before it reads the program's code, or
    None if there's no group. `input_fd`: the descriptor for standard input, or None for a program without input.
    """

    arguments: Sequence[str]
    environ: Mapping[str, str]
    limits: Limits
    output_fd: int
    cgroup_join_file: str | None = None
    input_fd: int | None = None


@dataclass(frozen=True)
class Started:
    """A program and its start time (`time.monotonic`, in seconds)."""

    child: Child
    at: float


class Confinement(Protocol):
    """Isolates one program: provides its files, starts it, measures its use of resources, and removes its leftovers."""

    def bring(self, file: Path, name: str) -> str:
        """Make a file readable for the program, under this name. Return the path at which the program can read it."""

    def host_options(self, limits: Limits) -> list[str]:
        """Return the host's options for these limits.

        The host sets the limits in the program's process before it runs the program.
        """

    def start(self, order: Order) -> Started:
        """Start the program in its tier, by forking if possible. Raises OSError if it can't be started."""

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files in the program's fullest folder, or zero if the tier doesn't limit files."""

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return the number of bytes that the program has written to file systems that it shares with others.

        Return zero if the program can write only to private file systems.
        """

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the number of sockets that the program has open.

        If only the judge and the program use a network namespace, return the number of sockets added to it since the
        program was started.
        """

    def queued_bytes(self, worth_counting: int) -> int:
        """Return the number of unread bytes held by the sockets in the program's separate network namespace.

        If the sockets hold at most `worth_counting` bytes, the result may be zero. If the program uses the machine's
        network, the result is always zero.
        """

    def exceeded(self) -> str | None:
        """Return the limit that the program has exceeded according to its memory cgroup.

        Return None if the program hasn't exceeded any limit, or if it has no group.
        """

    def unfiltered(self) -> str:
        """Return why the tier can't filter the program's system calls.

        The reason is a clause. It's an empty string if the tier can filter the calls or doesn't need to.
        """

    def sweep(self) -> bool:
        """Kill all processes that the program left behind when it exited. Return whether there were any.

        Raises StillThere if one of them can't be killed.
        """

    def remove(self) -> None:
        """Remove the files that `bring` created, and release all other resources."""


class Tier(Protocol):
    """An isolation tier, which provides a confinement for each program."""

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement for one program with the working folder `scratch`."""


def threads_of_libraries() -> int:
    """Return the number of threads that a program's libraries may start in addition to the program's own threads."""
    return THREADS_PER_CORE * (os.cpu_count() or 1)


@cache
def addresses_of_libraries() -> int:
    """Return the address space, in bytes, that the largest installed libraries take up: the total size of their files.

    The libraries use much less memory than address space, because the kernel maps their files and loads only the parts
    in use. PyTorch from PyPI maps 2.9 GB.
    """
    found = importlib.util.find_spec("torch")
    if found is None or not found.submodule_search_locations:
        return 0
    packages = Path(found.submodule_search_locations[0]).parent
    files = [path for name in LARGE_PACKAGES for path in (packages / name).rglob("*.so*")]
    return sum(path.stat().st_size for path in files)


def limit_options(limits: Limits, names: Sequence[str]) -> list[str]:
    """Return the host's options for the named limits, except for limits that aren't set.

    The kernel limits address space and the number of threads, while the judge limits memory and the number of
    processes. Those are smaller, so the options add a margin to the judge's limits. The margin also allows for zombies,
    which only the kernel counts.
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
