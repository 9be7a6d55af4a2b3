"""Define the interface of an isolation tier. `NodeProcess` uses it without naming any tier (`workbook.isolation`)."""

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
        """The program's local process, whose process tree contains the program."""

    def poll(self) -> int | None:
        """Return the program's exit code (negative: a signal's number); None while it runs."""

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program's end, and return its exit code. Raises subprocess.TimeoutExpired after `timeout` s."""

    def interrupt(self) -> None:
        """Send SIGINT to the program, like Ctrl-C."""

    def tree(self) -> list[int]:
        """Return the program, its descendants, and the tier's processes around it.

        Processes that have been reaped are left out.
        """

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait until the tier's sandbox around it is gone. Raises subprocess.TimeoutExpired after `timeout` s."""

    def close(self) -> None:
        """Release resources. Call this after the program and its sandbox have ended."""


@dataclass(frozen=True)
class Order:
    """A program to start: its arguments for the host, environment, limits, and output descriptor.

    `cgroup_join_file`: the file with which it joins a memory cgroup before any of its code is read; None if there's no
    group. `input_fd`: its input descriptor; None for a program without input.
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
    """A tier's handling of one program, from its files to the processes and files that it leaves behind."""

    def bring(self, file: Path, name: str) -> str:
        """Let the program read a file. Return the path under which the program finds the file."""

    def host_options(self, limits: Limits) -> list[str]:
        """Return options for the host, to apply in the program's process before it runs the program."""

    def start(self, order: Order) -> Started:
        """Start the program in its tier, forked if possible. Raises OSError."""

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files in the program's fullest folder; zero if the tier doesn't limit files."""

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return how many bytes the program has written to shared file systems; zero if it has a private one."""

    def sockets(self, pids: Sequence[int]) -> int:
        """Return how many sockets the program has open.

        If the program's network is shared only with the judge, count all sockets in it.
        """

    def queued_bytes(self, worth_counting: int) -> int:
        """Return how many unread bytes are in sockets of the program's separate network.

        Return zero if there are fewer than `worth_counting`, or if it uses the machine's network.
        """

    def exceeded(self) -> str | None:
        """Return the limit that the program has exceeded according to the kernel.

        Return None if there's none, or if the kernel doesn't count.
        """

    def unfiltered(self) -> str:
        """Return why the tier can't filter the program's system calls here, as a clause; empty if it can."""

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
    """Return how many threads a program's libraries may start on this machine."""
    return THREADS_PER_CORE * (os.cpu_count() or 1)


@cache
def addresses_of_libraries() -> int:
    """Return the address space (bytes) that the largest installed libraries use: the size of their files.

    This is hardly any memory, because the kernel maps the files. PyTorch from PyPI maps 2.9 GB.
    """
    found = importlib.util.find_spec("torch")
    if found is None or not found.submodule_search_locations:
        return 0
    packages = Path(found.submodule_search_locations[0]).parent
    files = [path for name in LARGE_PACKAGES for path in (packages / name).rglob("*.so*")]
    return sum(path.stat().st_size for path in files)


def limit_options(limits: Limits, names: Sequence[str]) -> list[str]:
    """Return the host's options for the named limits, except for limits that aren't set.

    The kernel limits addresses and threads, while the judge counts memory and processes. So the kernel's limits are
    higher. The kernel also counts processes that have ended, which the judge doesn't.
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
