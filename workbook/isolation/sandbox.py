"""The tier "sandbox": bubblewrap in bubblewrap.

The outer sandbox holds the observer and gives it a network of its own. An inner one holds one answer: the same network
and nothing else; no capabilities, no other processes, no files but the interpreter and the answer itself, read-only,
and small folders in memory to write to.
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


def filter_file() -> int:
    """Open a new file that holds the filter of system calls for bubblewrap; -1 where none can be installed."""
    program = against_sandbox_escapes()
    if program is None:
        return -1
    descriptor = os.memfd_create("what no program in a sandbox may call")
    os.write(descriptor, program)
    return descriptor


class SandboxedProgram(FreshProgram):
    """A sandbox with a program in it; `descriptors`: what bubblewrap says about itself, and what else it needs.

    bubblewrap gets no environment and no folder of ours: its first process in the sandbox would show them.
    """

    def __init__(self, command: Sequence[str], order: Order, descriptors: Sequence[int]) -> None:
        super().__init__(command, {}, Path("/"), order.output_fd, descriptors, order.input_fd)
        self._info_fd = descriptors[0]

    def poll(self) -> int | None:
        """The program's exit code (negative: the signal that ended it), or None while bubblewrap runs."""
        return exit_status(super().poll())

    def interrupt(self) -> None:
        """Send SIGINT to the program inside the sandbox; does nothing before it is there or after it has ended."""
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
        """Process number of the program, as this process sees it."""
        return self.program.pid

    def poll(self) -> int | None:
        """The program's exit code (negative: the signal that ended it), or None while it runs. Raises ServerGone."""
        return self._unless_lost(self.program.poll())

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program to end and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` s, and ServerGone.
        """
        return self._unless_lost(self.program.wait(timeout))

    def _unless_lost(self, code: Code) -> Code:
        """No program in a sandbox can end its supervisor."""
        if self.program.is_lost:
            raise ServerGone("the process is gone that this program was forked from")
        return code

    def interrupt(self) -> None:
        """Send SIGINT to the program, not to the sandbox."""
        self.program.interrupt()

    def tree(self) -> list[int]:
        """Process numbers of the program, what it has started, and the processes of the sandbox."""
        around = proc.process_tree(self.sandbox.pid)
        return [*self.program.tree(), *(around if self.sandbox.poll() is None else around[1:])]

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Wait for the sandbox to end. Raises subprocess.TimeoutExpired after `timeout` s."""
        self.sandbox.wait(timeout)

    def close(self) -> None:
        """Close the descriptor that reports the program's status."""
        self.program.close()


@dataclass
class Sandbox:
    """One program's sandbox. See `workbook.programs.tier.Confinement`.

    `readable`: what a program may read besides its own files. With a `server` the program is forked into the sandbox.
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
        """What bubblewrap must inherit."""
        return [one for one in (self.info_fd, self.filter_fd, *self._files.values()) if one >= 0]

    def bring(self, file: Path, name: str) -> str:
        """Have the file copied to the sandbox. Returns its path there."""
        self._files[name] = os.open(file, os.O_RDONLY | os.O_CLOEXEC)
        return f"{ANSWER_FOLDER}/{name}"

    def host_options(self, limits: Limits) -> list[str]:
        """The limits that the kernel enforces, that of processes included."""
        return limit_options(limits, (*KERNEL_LIMITS, "processes"))

    def start(self, order: Order) -> Started:
        """Start the program in a sandbox of its own, forked from the server where possible. Raises OSError."""
        began = time.monotonic()
        self._sockets_before, self._queued_before = proc.sockets_of_network(), proc.queued_bytes(0)
        environ = sandbox_environment(order.environ)
        forked = None if self.server is None else self._fork(self.server, environ, order)
        if forked is not None:
            return Started(forked, began)
        # Without --parent: a sandbox dies with us by itself, and its processes do not know our number.
        command = joining(
            order.cgroup_join_file, self.command(host_command("--attended", *order.arguments), environ)
        )
        return Started(SandboxedProgram(command, order, self.descriptors), began)

    def command(
        self, command: Sequence[str], environ: Mapping[str, str], options: Sequence[str] = ()
    ) -> list[str]:
        """`command` in this sandbox, in the environment `environ` and with further options of bubblewrap.

        The filter of system calls holds for the first process, too: a program may write to its memory.
        """
        filtered = () if self.filter_fd < 0 else ("--seccomp", str(self.filter_fd))
        for descriptor in self.descriptors[1:]:  # bubblewrap reads them, perhaps for the second time
            os.lseek(descriptor, 0, os.SEEK_SET)
        return inner_command(
            command,
            files=self._files,
            readable=self.readable,
            environ=environ,
            options=("--info-fd", str(self.info_fd), *filtered, *options),
        )

    def empty(self) -> list[str]:
        """An empty sandbox. It says "ready" on standard output, and stays until its first process is killed."""
        return self.command(WAITS, {}, ("--as-pid-1",))

    def _fork(self, server: ForkServer, environ: Mapping[str, str], order: Order) -> Child | None:
        """Make an empty sandbox and fork the program into it. None if that does not work here."""
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
        """How many files the fullest folder holds that the program may write to."""
        return most_files(pids)

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Zero: the folders that a program can write to are file systems of its own, of a fixed size."""
        return 0

    def sockets(self, pids: Sequence[int]) -> int:
        """How many sockets have come to the network of the program and this process, sent ones included."""
        return proc.sockets_of_network() - self._sockets_before

    def queued_bytes(self, worth_counting: int) -> int:
        """What has come to the sockets of this network and waits unread, from `worth_counting` bytes on; else zero."""
        return proc.queued_bytes(worth_counting) - self._queued_before

    def exceeded(self) -> str | None:
        """None: the tier itself has no memory cgroup."""
        return None

    def unfiltered(self) -> str:
        """Why system calls cannot be filtered on this machine; else empty."""
        return filter_problem()

    def sweep(self) -> bool:
        """False, and nothing to do: every process in a sandbox ends with it."""
        return False  # what is in a sandbox ends with it

    def remove(self) -> None:
        """Close the files that bubblewrap reports to and reads from."""
        for descriptor in self.descriptors:
            os.close(descriptor)
        self.info_fd = self.filter_fd = -1
        self._files.clear()


@dataclass(frozen=True)
class SandboxTier:
    """See `workbook.programs.tier.Tier`.

    With a `server`, programs are forked from it into their sandboxes, which saves the start of a Python for each. With
    an `alternate`, each comes from one of the two by chance. The programs of one server have the same seed for the
    hashes of strings, so an answer that depends on the order of a set would get the same verdict in every try.
    """

    server: ForkServer | None = None
    alternate: ForkServer | None = None
    readable: tuple[Path, ...] = field(default_factory=interpreter_folders)

    def confine(self, scratch: Path) -> Confinement:
        """A confinement in a sandbox that `start` creates."""
        return Sandbox(scratch, self.readable, random.choice((self.server, self.alternate or self.server)))


def sandbox_environment(environ: Mapping[str, str]) -> dict[str, str]:
    """What a program in a sandbox finds in its environment."""
    inside = {**environ, "HOME": HOME, "PWD": HOME, "PATH": PATH_OF_PROGRAMS}
    inside |= {"TMPDIR": "/tmp", "ROS_LOG_DIR": "/tmp"}
    return {name: value for name, value in inside.items() if name not in NOT_FOR_ANSWERS}


def read_info(info_fd: int) -> str:
    """What bubblewrap has told of itself up to now."""
    return os.pread(info_fd, 4096, 0).decode()


def first_pid(info: str) -> int | None:
    """The first process of the sandbox, from what bubblewrap told; None while it is not there."""
    try:
        return int(json.loads(info)["child-pid"])
    except (ValueError, KeyError, TypeError):
        return None


def program_pid(info: str) -> int | None:
    """The process that runs the program, from what bubblewrap told; None while it is not there.

    The child of bubblewrap is the first process of the new process space; the program is the child of that.
    """
    first = first_pid(info)
    below = [] if first is None else proc.children(first)
    return below[0] if below else None


def exit_status(code: int | None) -> int | None:
    """The exit code of the program as `subprocess` would tell it: negative for a signal; None while it runs.

    bubblewrap says 128 + n for a program that signal n has ended. 130 is left alone: Python itself says it for Ctrl-C.
    """
    return 128 - code if code is not None and 128 < code <= 128 + 31 and code != 130 else code


def most_files(pids: Sequence[int]) -> int:
    """How many files and folders the fullest folder holds that a program in a sandbox may write to.

    A process that is not in its sandbox yet sees the folders of the machine, which have more room: they do not count.
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
