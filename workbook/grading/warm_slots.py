"""Starting slots by forking, instead of a fresh Python for each: the other side of `slot_server.py`."""

import json
import os
import select
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO

from workbook.isolation.memory_groups import LeasedGroups, lease_groups
from workbook.isolation.tiers import Isolation, slot_command
from workbook.programs.warm_start import NoWarmStart, WarmProgram, started_program

SERVER_MODULE = ("-m", "workbook.grading.slot_server")
FORKED: tuple[Isolation, ...] = ("sandbox", "limits")
"""The tiers with many slots at once. In the others there is one, for which a server is not worth its start."""
UNTRIED = "no slot has tried it yet"
TRIAL_S = 60.0
END_S = 5.0
ANSWER_S = 30.0
"""The first slot waits for the server's start."""


class ForkedSlot:
    """A slot that the server has forked, with the part of `subprocess.Popen` that its owner uses."""

    def __init__(self, child: WarmProgram, stdin: IO[bytes], stdout: IO[bytes]) -> None:
        self._child = child
        self.pid = child.pid
        self.stdin, self.stdout = stdin, stdout

    def close(self) -> None:
        """Close its pipes."""
        self.stdin.close()
        self.stdout.close()

    def poll(self) -> int | None:
        """The exit code (negative: the signal that ended it), or None while it, or what it left, is there."""
        return self._child.poll()

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the end. Raises subprocess.TimeoutExpired after `timeout` s."""
        code = self._child.wait(timeout)
        self._child.close()
        return code


class SlotServer:
    """The process from which the slots of one run are forked, in one tier. For use by several threads.

    `environ`: what each slot finds in its environment. It starts without waiting; see `fork`. Raises NoSandbox.
    """

    def __init__(self, isolation: Isolation, environ: Mapping[str, str]) -> None:
        self.environ = dict(environ)
        self._turn, self._trial = threading.Lock(), threading.Lock()
        self._problem: str | None = UNTRIED
        self._groups = lease_groups()
        self._channel, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            command = [sys.executable, *SERVER_MODULE, str(theirs.fileno()), isolation]
            above = None if self._groups is None else self._groups.path.parent
            try:
                self._process = subprocess.Popen(
                    slot_command(isolation, command, above),
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    env=self.environ,
                    pass_fds=[theirs.fileno()],
                    start_new_session=True,
                )
            except BaseException:
                self._channel.close()
                self._give_back()
                raise

    @property
    def pid(self) -> int:
        """The process that stands for it here: its tree holds the slots."""
        return self._process.pid

    @property
    def is_tried(self) -> bool:
        """Whether it is known if slots can be forked: until then, all wait for that."""
        return self._problem != UNTRIED

    def fork(self, groups: LeasedGroups | None) -> ForkedSlot:
        """Fork a slot. `groups`: leased for it by the caller. Raises NoWarmStart and OSError.

        The first one tries out its tier, while others wait: a slot that was forked is in a sandbox in a sandbox.
        """
        with self._trial:
            if self._problem == UNTRIED:
                try:
                    slot, self._problem = self._tried(groups)
                except NoWarmStart as error:
                    self._problem = str(error)
                    raise
                if self._problem is None:
                    return slot
                with suppress(ProcessLookupError):
                    os.killpg(slot.pid, signal.SIGKILL)
                slot.close()
        if self._problem is not None:
            raise NoWarmStart(self._problem)
        return self._fork(groups)

    def _tried(self, groups: LeasedGroups | None) -> tuple[ForkedSlot, str | None]:
        """A slot, and what is wrong with its tier."""
        with socket.create_server(("127.0.0.1", 0)) as listener:
            slot = self._fork(groups, listener.getsockname()[1])
            ready = select.select([slot.stdout], [], [], TRIAL_S)[0]
            said = os.read(slot.stdout.fileno(), 10_000) if ready else b""
        try:
            problem = json.loads(said)["problem"]
        except (ValueError, KeyError):
            return slot, "the self-test of the slot broke"
        return slot, None if problem is None else str(problem)

    def _fork(self, groups: LeasedGroups | None, port: int | None = None) -> ForkedSlot:
        request: dict[str, str | int | None] = {
            "groups": None if groups is None else str(groups.path),
            "folder": str(Path.cwd()),
            "port": port,
        }
        pipes = [os.pipe() for _ in range(3)]
        (their_stdin, stdin), (stdout, their_stdout), (status, their_status) = pipes
        theirs = (their_stdin, their_stdout, their_status)
        try:
            with self._turn:
                socket.send_fds(self._channel, [json.dumps(request).encode()], theirs)
        except OSError as error:
            for ours in (stdin, stdout, status):
                os.close(ours)
            raise NoWarmStart(f"the slot server is gone ({error})") from error
        finally:
            for descriptor in theirs:
                os.close(descriptor)
        try:
            child = started_program(status, ANSWER_S, "the slot server")
        except NoWarmStart:
            os.close(stdin)
            os.close(stdout)
            raise
        return ForkedSlot(child, os.fdopen(stdin, "wb"), os.fdopen(stdout, "rb"))

    def close(self) -> None:
        """End the server, and the slots that are left."""
        self._channel.close()
        for number in (signal.SIGTERM, signal.SIGKILL):
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(END_S)
            if self._process.returncode is None:
                os.killpg(self._process.pid, number)
        self._process.wait()
        self._give_back()

    def _give_back(self) -> None:
        if self._groups is not None:
            self._groups.remove()
