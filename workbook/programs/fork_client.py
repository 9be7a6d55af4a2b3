"""Start programs by having a server fork them, which is faster than starting a Python interpreter for each.

This is the client of `inside/fork_server.py`. For each program, the server also forks a supervisor, which waits for the
program and reports its exit status.
"""

import atexit
import contextlib
import json
import os
import select
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.inside.memory_cgroup import open_group
from workbook.inside.orphans import forget
from workbook.inside.proc import process_tree
from workbook.programs.ending import RUN_MARK
from workbook.programs.helpers import start_helper
from workbook.programs.tier import Order
from workbook.ros.environment import child_environment

MARK_BYTES = 80
"""The number of spaces reserved in a server's environment.

A forked program overwrites them with its mark (see `ending`), so that other processes can read the mark in /proc.
"""
SERVER = "fork_server"
START_S = 30.0
ANSWER_S = 10.0
LOOK_AGAIN_S = 1.0
"""After this time (s), a thread that waits for a program to exit polls again, in case the kernel hasn't woken it."""


class NotForked(RuntimeError):
    """Raised when the program couldn't be forked. The message says why. Start it in a new interpreter instead."""


class ServerGone(RuntimeError):
    """Raised when a program's supervisor has exited without reporting how the program exited.

    The program isn't to blame, because no program in a sandbox can kill its supervisor.
    """


class ForkedProgram:
    """A program that the server forked. See `workbook.programs.tier.Child`.

    `is_lost`: whether the supervisor exited without reporting how the program exited. A program in a sandbox can't kill
    its supervisor, so in that case, the server is gone.
    """

    def __init__(self, pid: int, status_fd: int, told: bytes) -> None:
        self.pid = pid
        self.returncode: int | None = None
        self.is_lost = False
        self._status_fd = status_fd
        self._told = told
        self._reading = threading.Lock()

    def poll(self) -> int | None:
        """Return the program's exit code, or None while it's running.

        A negative code -n means that signal n killed the program.
        """
        return self._read_status()

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the program to exit, and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` seconds. Several threads may wait at the same time. The
        supervisor exits after its last report. That closes the pipe and so wakes all of the threads, although only one
        of them reads the report.
        """
        deadline = None if timeout is None else time.monotonic() + timeout
        while (code := self._read_status()) is None:
            left = LOOK_AGAIN_S if deadline is None else deadline - time.monotonic()
            if left <= 0:
                raise subprocess.TimeoutExpired("the program", timeout or 0.0)
            select.select([self._status_fd], [], [], min(left, LOOK_AGAIN_S))
        return code

    def _read_status(self) -> int | None:
        """Read the supervisor's reports, and return the exit code, or None while the program runs. Thread-safe."""
        with self._reading:
            while self.returncode is None and select.select([self._status_fd], [], [], 0.0)[0]:
                chunk = os.read(self._status_fd, 100)
                self._told += chunk
                if b"\n" in self._told and self._told.strip().isdigit():
                    self.returncode = os.waitstatus_to_exitcode(int(self._told))
                elif not chunk:  # the supervisor is gone, and the program with it
                    self.is_lost = True
                    self.returncode = -signal.SIGKILL
            return self.returncode

    def close(self) -> None:
        """Close the status descriptor. Call this method after the program has exited."""
        with self._reading:
            if self.returncode is not None and self._status_fd >= 0:
                os.close(self._status_fd)
                self._status_fd = -1

    def interrupt(self) -> None:
        """Send SIGINT to the program."""
        if self.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGINT)

    def tree(self) -> list[int]:
        """Return the process IDs of the program, unless it has exited, and of its descendants."""
        below = process_tree(self.pid)
        return below if self.poll() is None else below[1:]

    def wait_for_sandbox(self, timeout: float | None = None) -> None:
        """Return right away, because this program has no sandbox."""


def request_fork(channel: socket.socket, request: Mapping[str, object], descriptors: Sequence[int]) -> int:
    """Ask a server to fork a program.

    Return a file descriptor for reading the supervisor's reports about the program. Raises OSError if the server is
    gone. `descriptors`: the file descriptors to pass to the program, such as the one for its output.
    """
    status_fd, theirs = os.pipe()
    try:
        socket.send_fds(channel, [json.dumps(request).encode()], [theirs, *descriptors])
    except OSError:
        os.close(status_fd)
        raise
    finally:
        os.close(theirs)
    return status_fd


def started_program(status_fd: int, timeout_s: float) -> ForkedProgram:
    """Wait for the first report about a requested program, and return the program.

    Raises NotForked if the program wasn't forked, or if no report arrives within `timeout_s` seconds. `status_fd`: the
    descriptor from `request_fork`. It's closed if the program wasn't forked.
    """
    told = b""
    while b"\n" not in told:
        chunk = os.read(status_fd, 100) if select.select([status_fd], [], [], timeout_s)[0] else b""
        if not chunk:
            break
        told += chunk
    first, _, more = told.partition(b"\n")
    if not first.isdigit():
        os.close(status_fd)
        raise NotForked(first.decode(errors="replace") or "the process that forks does not answer")
    return ForkedProgram(int(first), status_fd, more)


class ForkServer:
    """The server process that forks programs. It exits when its owner does.

    `zygote`: a running server outside of the slot's sandbox, from which this server is forked if possible. `slot`: the
    process ID of the first process in the slot's sandbox. (A slot is a process that judges answers.)
    """

    def __init__(self, zygote: "Zygote | None" = None, slot: int = 0) -> None:
        self._turn = threading.RLock()
        self._zygote = zygote
        self._slot = slot
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: socket.socket | None = None
        self._ready = False

    @property
    def pid(self) -> int | None:
        """The server's process ID, or None if the server isn't running or was forked from a zygote."""
        return None if self._process is None else self._process.pid

    def start(self, environ: Mapping[str, str]) -> None:
        """Start the server if it isn't running. Don't wait until it's ready.

        `environ` must not contain anything that programs may not see. It's ignored if a zygote forks the server,
        because the server then inherits the zygote's environment.
        """
        with self._turn:
            if self._channel is not None and not _has_hung_up(self._channel):
                return
            self.close()
            zygote, self._zygote = self._zygote, None  # only once: if it breaks, we start a new one
            self._channel = None if zygote is None else zygote.fork_into(self._slot)
            if self._channel is None:
                self._process, self._channel = start_helper(SERVER, environ)

    def spawn(
        self,
        namespaces_of: int,
        order: Order,
        environ: Mapping[str, str],
        folder: str,
    ) -> ForkedProgram:
        """Fork a program into the namespaces of the process whose ID is `namespaces_of`.

        Raises NotForked if that fails. If `namespaces_of` is 0, the program enters no namespaces. `environ` replaces
        the environment in `order`. `folder`: the program's working directory.
        """
        request = {
            "namespaces_of": namespaces_of,
            "arguments": [*order.arguments],
            "environ": dict(environ),
            "folder": folder,
            "reads": order.input_fd is not None,
        }
        try:
            groups = [] if order.cgroup_join_file is None else [open_group(order.cgroup_join_file)]
        except OSError as error:
            raise NotForked(f"there is no memory cgroup ({error})") from error
        inputs = [] if order.input_fd is None else [order.input_fd]
        try:
            with self._turn:
                self.wait_until_ready()
                assert self._channel is not None
                status_fd = request_fork(self._channel, request, [order.output_fd, *groups, *inputs])
        except OSError as error:
            self.close()
            raise NotForked(f"the fork server is gone ({error})") from error
        finally:
            for descriptor in groups:
                os.close(descriptor)
        return started_program(status_fd, ANSWER_S)

    def wait_until_ready(self) -> None:
        """Wait until the server can fork programs. Raises OSError if the server was never started or fails to start."""
        with self._turn:
            if self._channel is None:
                raise OSError("it was never started")
            if not self._ready:
                self._channel.settimeout(START_S)
                said = self._channel.recv(100)
                if said != b"ready":
                    raise OSError(said.decode(errors="replace") or "it ended right away")
                self._ready = True

    def close(self) -> None:
        """Stop the server."""
        with self._turn:
            self._ready = False
            if self._channel is not None:
                self._channel.close()
                self._channel = None
            if self._process is not None:
                self._process.kill()
                self._process.wait()
                forget(self._process.pid)
                self._process = None


@dataclass(frozen=True)
class Zygote:
    """A fork server from which other fork servers are forked, each into a slot's sandbox."""

    channel: socket.socket

    def fork_into(self, slot: int) -> socket.socket | None:
        """Have the zygote fork a server into a sandbox.

        Return our end of the new server's channel, or None if the zygote is gone. `slot`: the process ID of the
        sandbox's first process.
        """
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            try:
                socket.send_fds(self.channel, [json.dumps({"branch_in": slot}).encode()], [theirs.fileno()])
            except OSError:
                ours.close()
                return None
        return ours


def _has_hung_up(channel: socket.socket) -> bool:
    """Return whether the process at the other end of a channel has closed it, for example by exiting."""
    waiting = select.poll()
    waiting.register(channel, 0)
    return any(event & (select.POLLHUP | select.POLLERR) for _, event in waiting.poll(0))


class OwnServer:
    """This process's fork server, for programs without isolation. It isn't used until `keep` is called.

    Most processes start only one or two programs, so a server would cost them more time than it saves.
    """

    def __init__(self) -> None:
        self._wanted = False
        self._owner = 0
        self._server: ForkServer | None = None
        self._turn = threading.Lock()

    def keep(self) -> None:
        """Use a fork server from now on. The server starts when the first program does."""
        self._wanted = True

    def ready(self) -> ForkServer | None:
        """Wait until the server can fork programs, and return it.

        Return None if `keep` wasn't called or if the server fails to start.
        """
        if not self._wanted:
            return None
        with self._turn:
            if self._server is None or self._owner != os.getpid():  # a fork of the owner needs its own
                self._server, self._owner = ForkServer(), os.getpid()
                atexit.register(self.close)
            environ = child_environment(0, log_folder=Path(os.devnull))
            try:
                self._server.start({**environ, RUN_MARK: " " * MARK_BYTES})
                self._server.wait_until_ready()
            except OSError:
                return None
            return self._server

    @property
    def pid(self) -> int | None:
        """The server's process ID, or None if there is no server."""
        return None if self._server is None else self._server.pid

    def close(self) -> None:
        """Stop the server. The next program starts a new one."""
        if self._server is not None and self._owner == os.getpid():
            self._server.close()


own_server = OwnServer()
