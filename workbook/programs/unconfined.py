"""Run our own programs and the students' own programs with limits, but without isolation."""

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
"""The limits that the kernel enforces per process.

The number of processes isn't one of them, because the kernel would count all of the user's processes. Also, it doesn't
apply that limit to root.
"""

_JOINED = ("/bin/sh", "-c", 'echo 0 >"$0" && exec "$@"')


def host_command(*options: str) -> list[str]:
    """Return the command that runs a program: the host in a new Python interpreter."""
    return [sys.executable, "-P", str(RUN), "host", *options]


def joining(joins: str | None, command: Sequence[str]) -> list[str]:
    """Return `command`, extended to join the memory cgroup whose join file is `joins` before it runs.

    If `joins` is None, return `command` unchanged.
    """
    return [*command] if joins is None else [*_JOINED, joins, *command]


class FreshProgram(subprocess.Popen[bytes]):
    """A program in a new Python process, which leads its own session and has the working folder `folder`."""

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
        """Return the process IDs of the program, unless it has exited, and of its descendants."""
        below = process_tree(self.pid)
        return below if self.poll() is None else below[1:]

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Return right away, because this program has no sandbox."""

    def close(self) -> None:
        """Do nothing, because such a program doesn't leave any resources to release when it exits."""


@dataclass(frozen=True)
class UnconfinedProgram:
    """A program without isolation, which reads its files at their original paths.

    See `workbook.programs.tier.Confinement`.
    """

    scratch: Path

    def bring(self, file: Path, name: str) -> str:
        """Return the file's absolute path, where the program reads it."""
        return str(file.resolve())

    def host_options(self, limits: Limits) -> list[str]:
        """Return options for the limits that the kernel enforces per process."""
        return limit_options(limits, KERNEL_LIMITS)

    def start(self, order: Order) -> Started:
        """Fork the program if this process has a fork server, or else start it in a new Python interpreter.

        Raises OSError.
        """
        server = own_server.ready()
        if server is not None:
            began = time.monotonic()  # not earlier: waiting for the server isn't part of the run
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
        """Return zero, because files aren't limited."""
        return 0

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return zero, because files aren't limited."""
        return 0

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the number of sockets that these processes have open."""
        return proc.sockets_open(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """Return zero, because the program uses the machine's network."""
        return 0

    def exceeded(self) -> str | None:
        """Return None, because this confinement has no memory cgroup."""
        return None

    def unfiltered(self) -> str:
        """Return an empty string, because no system calls need to be filtered."""
        return ""

    def sweep(self) -> bool:
        """Return False without killing anything, because nothing is swept up outside of the program's process tree."""
        return False

    def remove(self) -> None:
        """Do nothing, because `bring` created no files."""


class Unconfined:
    """Limits programs without isolating them. See `workbook.programs.tier.Tier`."""

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement that only sets limits."""
        return UnconfinedProgram(scratch)
