"""Programs of our own, and those of the reader: limits, and no isolation."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from workbook.inside import RUN, proc
from workbook.inside.proc import process_tree
from workbook.programs.fork_client import NotForked, own_server
from workbook.programs.tier import Confinement, Order, Started, limit_options
from workbook.recording.limits import Limits

KERNEL_LIMITS = ("memory", "file_size", "open_files", "cpu", "core", "signals")
"""Not that of processes: the kernel would count everything that the same user runs, and nothing for root."""

_JOINED = ("/bin/sh", "-c", 'echo 0 >"$0" && exec "$@"')


def host_command(*options: str) -> list[str]:
    """The command that runs a program: the host in a fresh Python."""
    return [sys.executable, "-P", str(RUN), "host", *options]


def joining(joins: str | None, command: Sequence[str]) -> list[str]:
    """`command` in the memory cgroup that one joins by the file `joins`; as it is for None."""
    return [*command] if joins is None else [*_JOINED, joins, *command]


class FreshProgram(subprocess.Popen[bytes]):
    """A program in a Python of its own, which leads a session and works in `folder`."""

    def __init__(
        self,
        command: Sequence[str],
        environ: Mapping[str, str],
        folder: Path,
        output_fd: int,
        pass_fds: Sequence[int] = (),
        input_fd: int | None = None,
    ) -> None:
        super().__init__(
            command,
            stdin=subprocess.DEVNULL if input_fd is None else input_fd,
            stdout=output_fd,
            stderr=output_fd,
            env=environ,
            cwd=folder,
            start_new_session=True,
            pass_fds=pass_fds,
        )

    def interrupt(self) -> None:
        """Send SIGINT to the program."""
        self.send_signal(signal.SIGINT)

    def tree(self) -> list[int]:
        """Process numbers of the program and of all that it has started; without its own once it has ended."""
        below = process_tree(self.pid)
        return below if self.poll() is None else below[1:]

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Return at once: no tier has put anything around this program."""

    def close(self) -> None:
        """Do nothing: a program in a fresh Python holds no resources once it has ended."""


@dataclass(frozen=True)
class UnconfinedProgram:
    """See `workbook.programs.tier.Confinement`. The program reads its files where they are."""

    scratch: Path

    def bring(self, file: Path, name: str) -> str:
        """The absolute path of the file, which the program reads in its place."""
        return str(file.resolve())

    def host_options(self, limits: Limits) -> list[str]:
        """The limits that the kernel enforces for each process."""
        return limit_options(limits, KERNEL_LIMITS)

    def start(self, order: Order) -> Started:
        """Start the program: forked where this process has a fork server, else in a fresh Python. Raises OSError."""
        server = own_server.ready()
        if server is not None:
            began = time.monotonic()  # not before: to wait for the server is no part of its life
            with suppress(NotForked):
                folder = str(self.scratch)
                return Started(server.spawn(0, order, order.environ, folder), began)
        began = time.monotonic()
        command = joining(
            order.cgroup_join_file, host_command("--parent", str(os.getpid()), *order.arguments)
        )
        return Started(
            FreshProgram(command, order.environ, self.scratch, order.output_fd, input_fd=order.input_fd),
            began,
        )

    def most_files(self, pids: Sequence[int]) -> int:
        """Zero: files are not limited."""
        return 0

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Zero: files are not limited."""
        return 0

    def sockets(self, pids: Sequence[int]) -> int:
        """How many sockets the program and all that it has started have open."""
        return proc.sockets_open(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """Zero: the network is that of the machine."""
        return 0

    def exceeded(self) -> str | None:
        """None: the tier itself has no memory cgroup."""
        return None

    def unfiltered(self) -> str:
        """Nothing to report: no system calls are to be filtered."""
        return ""

    def sweep(self) -> bool:
        """False: nothing is looked for beyond the program's own process tree."""
        return False

    def remove(self) -> None:
        """Do nothing: `bring` made no files."""


class Unconfined:
    """See `workbook.programs.tier.Tier`."""

    def confine(self, scratch: Path) -> Confinement:
        """A confinement that sets limits and nothing else."""
        return UnconfinedProgram(scratch)
