"""The "sandbox" isolation tier: run each answer in an inner bubblewrap sandbox within an outer one.

The outer sandbox contains the judge's process and has its own network. Each inner sandbox contains one answer, which
uses that network, but has no capabilities and sees no other processes. The answer sees only the system's files, the
interpreter, and its own files, all read-only. The answer may write only to small folders in memory.
"""

import json
import os
import random
import signal
import subprocess
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from workbook.inside import proc
from workbook.inside.syscall_filter import against_sandbox_escapes, filter_problem
from workbook.isolation.bubblewrap import (
    ANSWER_FOLDER,
    HOME,
    WAITS,
    WRITABLE,
    WRITABLE_BYTES,
    inner_command,
)
from workbook.isolation.host_files import NOT_FOR_ANSWERS, PATH_OF_PROGRAMS, interpreter_folders
from workbook.programs.fork_client import ForkedProgram, ForkServer, NotForked, ServerGone
from workbook.programs.tier import Child, Confinement, Order, Started, limit_options
from workbook.programs.unconfined import KERNEL_LIMITS, FreshProgram, host_command, joining
from workbook.recording.limits import Limits

Code = TypeVar("Code", int, int | None)
NEGLIGIBLE_BYTES = 1_000_000
"""If the machine's sockets have fewer unread bytes, we don't count them when a program starts.

Reading the tables of sockets takes milliseconds.
"""


def filter_file() -> int:
    """Write bubblewrap's system call filter to a new file. Return its descriptor, or -1 if there is no filter."""
    program = against_sandbox_escapes()
    if program is None:
        return -1
    descriptor = os.memfd_create("what no program in a sandbox may call")
    os.write(descriptor, program)
    return descriptor


class SandboxedProgram(FreshProgram):
    """A bubblewrap process that runs a program in a sandbox.

    `descriptors`: the descriptors that bubblewrap inherits. bubblewrap writes its status to the first one. The command
    gets neither our environment nor our working folder, because the program could read them from bubblewrap's first
    process in the sandbox.
    """

    def __init__(self, command: Sequence[str], order: Order, descriptors: Sequence[int]) -> None:
        super().__init__(command, {}, Path("/"), order.output_fd, descriptors, order.input_fd)
        self._info_fd = descriptors[0]

    def poll(self) -> int | None:
        """Return the program's exit code, or None while bubblewrap is running.

        A negative code -n means that signal n killed the program.
        """
        return exit_status(super().poll())

    def interrupt(self) -> None:
        """Send SIGINT to the program in the sandbox. Do nothing before its start or after its exit."""
        pid = program_pid(read_info(self._info_fd))
        if pid is not None:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGINT)


@dataclass(frozen=True)
class SandboxedFork:
    """A program that was forked into a sandbox. See `workbook.programs.tier.Child`."""

    program: ForkedProgram
    sandbox: "subprocess.Popen[bytes]"

    @property
    def pid(self) -> int:
        """The program's process ID, as this process sees it."""
        return self.program.pid

    def poll(self) -> int | None:
        """Return the program's exit code, or None while it's running.

        A negative code -n means that signal n killed the program.
        """
        return self._unless_lost(self.program.poll())

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program to exit, and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` seconds, and ServerGone if the supervisor is gone.
        """
        return self._unless_lost(self.program.wait(timeout))

    def _unless_lost(self, code: Code) -> Code:
        """Return the exit code unchanged.

        Raises ServerGone if the supervisor exited without reporting one. The program can't have killed the supervisor
        from inside the sandbox.
        """
        if self.program.is_lost:
            raise ServerGone("the process is gone that this program was forked from")
        return code

    def interrupt(self) -> None:
        """Send SIGINT to the program, not to the sandbox."""
        self.program.interrupt()

    def tree(self) -> list[int]:
        """Return the process IDs of the program, its descendants, and the sandbox."""
        around = proc.process_tree(self.sandbox.pid)
        return [*self.program.tree(), *(around if self.sandbox.poll() is None else around[1:])]

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait until the sandbox has been removed. Raises subprocess.TimeoutExpired after `timeout` seconds."""
        self.sandbox.wait(timeout)

    def close(self) -> None:
        """Close the descriptor through which the program's status is reported."""
        self.program.close()


@dataclass
class Sandbox:
    """One program's sandbox. See `workbook.programs.tier.Confinement`.

    `readable`: the files that the program may read in addition to its own. If `server` is given, the program is forked
    from it.
    """

    scratch: Path
    readable: tuple[Path, ...]
    server: ForkServer | None = None
    _files: dict[str, int] = field(default_factory=dict)
    info_fd: int = field(default_factory=lambda: os.memfd_create("what bubblewrap says about itself"))
    filter_fd: int = field(default_factory=filter_file)
    _sockets_before: int = 0
    _queued_before: int = 0

    @property
    def descriptors(self) -> list[int]:
        """The descriptors that bubblewrap must inherit."""
        return [one for one in (self.info_fd, self.filter_fd, *self._files.values()) if one >= 0]

    def bring(self, file: Path, name: str) -> str:
        """Have bubblewrap copy the file into the sandbox. Return the copy's path in the sandbox."""
        self._files[name] = os.open(file, os.O_RDONLY | os.O_CLOEXEC)
        return f"{ANSWER_FOLDER}/{name}"

    def host_options(self, limits: Limits) -> list[str]:
        """Return options for the limits that the kernel enforces, including the number of processes."""
        return limit_options(limits, (*KERNEL_LIMITS, "processes"))

    def start(self, order: Order) -> Started:
        """Start the program in its own sandbox, by forking it from the server if possible. Raises OSError."""
        began = time.monotonic()
        self._sockets_before = proc.sockets_of_network()
        self._queued_before = proc.queued_bytes(NEGLIGIBLE_BYTES)
        environ = sandbox_environment(order.environ)
        forked = None if self.server is None else self._fork(self.server, environ, order)
        if forked is not None:
            return Started(forked, began)
        # Without --parent, because a sandbox is removed when we exit anyway, and our process ID isn't visible in it.
        command = joining(
            order.cgroup_join_file, self.command(host_command("--attended", *order.arguments), environ)
        )
        return Started(SandboxedProgram(command, order, self.descriptors), began)

    def command(
        self, command: Sequence[str], environ: Mapping[str, str], options: Sequence[str] = ()
    ) -> list[str]:
        """Return a command that runs `command` in this sandbox, with this environment and further bubblewrap options.

        The system call filter also applies to the sandbox's first process, because a program may write to that
        process's memory.
        """
        filtered = () if self.filter_fd < 0 else ("--seccomp", str(self.filter_fd))
        for descriptor in self.descriptors[1:]:  # because bubblewrap may read them for the second time
            os.lseek(descriptor, 0, os.SEEK_SET)
        return inner_command(
            command,
            files=self._files,
            readable=self.readable,
            environ=environ,
            options=("--info-fd", str(self.info_fd), *filtered, *options),
        )

    def empty(self) -> list[str]:
        """Return a command for an empty sandbox, which prints "ready" and exists until its first process is killed."""
        return self.command(WAITS, {}, ("--as-pid-1",))

    def _fork(self, server: ForkServer, environ: Mapping[str, str], order: Order) -> Child | None:
        """Create an empty sandbox, and fork the program into it. Return None if that fails."""
        server.start(environ)
        ready_fd, said_fd = os.pipe()
        try:
            sandbox = subprocess.Popen(
                self.empty(),
                stdin=subprocess.DEVNULL,
                stdout=said_fd,
                stderr=order.output_fd,
                env=order.environ,
                cwd=self.scratch,
                start_new_session=True,
                pass_fds=self.descriptors,
            )
        finally:
            os.close(said_fd)
        with os.fdopen(ready_fd, "rb") as ready:
            ready.readline()
        first = first_pid(read_info(self.info_fd))
        try:
            if first is None:
                raise NotForked("there is no sandbox")
            program = server.spawn(first, order, environ, HOME)
            return SandboxedFork(program, sandbox)
        except NotForked:
            sandbox.kill()
            sandbox.wait()
            os.ftruncate(self.info_fd, 0)
            os.lseek(self.info_fd, 0, os.SEEK_SET)
            return None

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files and folders in the fullest of the program's writable folders."""
        return most_files(pids)

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return zero, because a program can write only to private file systems with a fixed size."""
        return 0

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the number of sockets that have been added to our network namespace since the program was started.

        The program and this process share that namespace. Sockets that are in transit between processes count, too.
        """
        return proc.sockets_of_network() - self._sockets_before

    def queued_bytes(self, worth_counting: int) -> int:
        """Return how much the unread bytes in our network namespace's sockets have grown since the program was started.

        See `proc.queued_bytes`.
        """
        return proc.queued_bytes(worth_counting) - self._queued_before

    def exceeded(self) -> str | None:
        """Return None, because this tier has no memory cgroup."""
        return None

    def unfiltered(self) -> str:
        """Return why system calls can't be filtered on this machine, or an empty string if they can."""
        return filter_problem()

    def sweep(self) -> bool:
        """Return False without doing anything, because a sandbox's processes are killed together with the sandbox."""
        return False  # the kernel has killed them

    def remove(self) -> None:
        """Close the files that bubblewrap reads and writes."""
        for descriptor in self.descriptors:
            os.close(descriptor)
        self.info_fd = self.filter_fd = -1
        self._files.clear()


@dataclass(frozen=True)
class SandboxTier:
    """The "sandbox" tier. See `workbook.programs.tier.Tier`.

    If `server` is given, programs are forked from it into their sandboxes, so there is no need to start Python for each
    program. If `alternate` is given, one of the two servers is chosen at random for each program. The reason is that
    all programs forked from one server have the same hash seed for strings. So without an alternate, an answer that
    depends on a set's order would get the same verdict on every try. `readable`: the files that programs may read in
    addition to their own.
    """

    server: ForkServer | None = None
    alternate: ForkServer | None = None
    readable: tuple[Path, ...] = field(default_factory=interpreter_folders)

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement that runs the program in a sandbox. Its `start` method creates the sandbox."""
        return Sandbox(scratch, self.readable, random.choice((self.server, self.alternate or self.server)))


def sandbox_environment(environ: Mapping[str, str]) -> dict[str, str]:
    """Return the environment for a program in a sandbox, made from `environ`."""
    inside = {**environ, "HOME": HOME, "PWD": HOME, "PATH": PATH_OF_PROGRAMS}
    inside |= {"TMPDIR": "/tmp", "ROS_LOG_DIR": "/tmp"}
    return {name: value for name, value in inside.items() if name not in NOT_FOR_ANSWERS}


def read_info(info_fd: int) -> str:
    """Return everything that bubblewrap has reported about itself so far."""
    return os.pread(info_fd, 4096, 0).decode()


def first_pid(info: str) -> int | None:
    """Return the ID of the sandbox's first process, from bubblewrap's report, or None if the report isn't there yet."""
    try:
        return int(json.loads(info)["child-pid"])
    except (ValueError, KeyError, TypeError):
        return None


def program_pid(info: str) -> int | None:
    """Return the ID of the process that runs the program, using bubblewrap's report, or None before it exists.

    bubblewrap's child is the first process in the new PID namespace, and the program is that process's child.
    """
    first = first_pid(info)
    below = [] if first is None else proc.children(first)
    return below[0] if below else None


def exit_status(code: int | None) -> int | None:
    """Convert bubblewrap's exit code to the convention of `subprocess`: -n if signal n killed the program.

    bubblewrap returns 128 + n in that case. But 130 stays unchanged, because Python itself returns it after Ctrl-C.
    None stays None, too.
    """
    return 128 - code if code is not None and 128 < code <= 128 + 31 and code != 130 else code


def most_files(pids: Sequence[int]) -> int:
    """Return the number of files and folders in the fullest folder that a program in a sandbox may write to.

    A process that isn't in its sandbox yet sees the machine's folders. They're larger than a sandbox's, so we recognize
    and skip such a process.
    """
    most = 0
    for pid in pids:
        try:
            spaces = [proc.mount_usage(pid, folder) for folder in WRITABLE]
        except OSError:
            continue
        if all(space.f_blocks * space.f_frsize <= WRITABLE_BYTES for space in spaces):
            most = max(most, *(space.f_files - space.f_ffree for space in spaces))
    return most
