"""What a tier of isolation offers to `NodeProcess`, which knows none of them by name (see `workbook.isolation`)."""

import importlib.util
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Protocol

from workbook.recording.limits import ADDRESSES_PER_THREAD, ENDED_PROCESSES, THREADS_PER_CORE, Limits

LARGE_PACKAGES = ("torch", "nvidia")
"""PyTorch, and the packages of CUDA that it loads even where there is no graphics processor."""


class Child(Protocol):
    """A program that was started."""

    @property
    def pid(self) -> int:
        """The process that stands for it here: its tree holds the program."""

    def poll(self) -> int | None:
        """The program's exit code (negative: the signal that ended it), or None while it runs."""

    def wait(self, timeout: float | None = None) -> int:
        """Wait for its end. Raises subprocess.TimeoutExpired after `timeout` s."""

    def interrupt(self) -> None:
        """Send SIGINT to the program, what Ctrl-C sends."""

    def tree(self) -> list[int]:
        """All that it has started, itself, and what the tier has put around it, as far as nobody has reaped them."""

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait until what the tier has put around it is gone. Raises subprocess.TimeoutExpired after `timeout` s."""

    def close(self) -> None:
        """Forget it; call it when all of it has ended."""


@dataclass(frozen=True)
class Order:
    """A program to start: arguments for the host, environment and limits, and the descriptor that it prints to.

    `cgroup_join_file`: the file by which it joins a memory cgroup, before a line of it is read; None where there is no
    such group. `input_fd`: the descriptor that it reads from; None for a program that gets nothing to read.
    """

    arguments: Sequence[str]
    environ: Mapping[str, str]
    limits: Limits
    output_fd: int
    cgroup_join_file: str | None = None
    input_fd: int | None = None


@dataclass(frozen=True)
class Started:
    """A program, and the moment (of `time.monotonic`, s) from which its life counts."""

    child: Child
    at: float


class Confinement(Protocol):
    """What a tier does for one program, from its files to whatever it leaves behind."""

    def bring(self, file: Path, name: str) -> str:
        """Let the program read a file. Returns the path at which it finds it."""

    def host_options(self, limits: Limits) -> list[str]:
        """What the host is to do in the program's process before it runs it."""

    def start(self, order: Order) -> Started:
        """Start the program in its tier, forked where that is possible. Raises OSError."""

    def most_files(self, pids: Sequence[int]) -> int:
        """How many files the fullest folder of the program holds; zero where the tier has no limit of them."""

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """What the program has written to files that are not in a file system of its own; else zero."""

    def sockets(self, pids: Sequence[int]) -> int:
        """How many sockets the program holds; where its network is its own and the judge's, all that are in it."""

    def queued_bytes(self, worth_counting: int) -> int:
        """What waits unread in sockets of the program's own network, from `worth_counting` bytes on; else zero."""

    def exceeded(self) -> str | None:
        """The limit that the program has exceeded where the kernel counts for it; None if none, or nobody counts."""

    def unfiltered(self) -> str:
        """Why the tier cannot filter the program's system calls on this machine, as a clause; else empty."""

    def sweep(self) -> bool:
        """End whatever the program has left running, when it has ended. Returns whether there was anything.

        Raises StillThere when that is not possible.
        """

    def remove(self) -> None:
        """Remove what `bring` has made, and let go of all else."""


class Tier(Protocol):
    """A tier of isolation, in which programs are started one after another."""

    def confine(self, scratch: Path) -> Confinement:
        """A confinement for one program whose folder to work in is `scratch`."""


def threads_of_libraries() -> int:
    """How many threads the libraries of one program may start on this machine."""
    return THREADS_PER_CORE * (os.cpu_count() or 1)


@cache
def addresses_of_libraries() -> int:
    """Address space that the largest libraries installed here take when they are loaded: the size of their files.

    It is hardly any memory: the kernel maps the files. PyTorch as it comes from PyPI maps 2.9 GB of them.
    """
    found = importlib.util.find_spec("torch")
    if found is None or not found.submodule_search_locations:
        return 0
    packages = Path(found.submodule_search_locations[0]).parent
    files = [path for name in LARGE_PACKAGES for path in (packages / name).rglob("*.so*")]
    return sum(path.stat().st_size for path in files)


def limit_options(limits: Limits, names: Sequence[str]) -> list[str]:
    """Options for the host: those of the limits with these names that are set.

    The kernel limits addresses and threads where the judge counts memory and processes: they get more. It also counts
    processes that have ended, which the judge does not.
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
