"""Implement the owner's side of a slot: start or fork the slot, send it an answer, and receive the judgment."""

import contextlib
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO

from workbook.exercise.answers import Answer
from workbook.exercise.definition import OWN_CRITERIA
from workbook.exercise.judgement import Judgement, Report
from workbook.grading.slots.health import SlotHealth
from workbook.grading.slots.protocol import (
    CANCEL_SOAK,
    JudgingOrder,
    LineReader,
    Message,
    Progress,
    judgement_in,
    line_of,
)
from workbook.inside.fork_requests import close_all
from workbook.inside.orphans import StillThere
from workbook.isolation.memory_groups import LeasedGroups, lease_groups
from workbook.isolation.tiers import Isolation, lease_for, slot_command
from workbook.isolation.user_ids import NoIds
from workbook.programs.ending import kill_programs_of
from workbook.programs.fork_client import ForkedProgram, NotForked, request_fork, started_program
from workbook.ros.environment import child_environment

ANSWER_DEADLINE_S = 120.0
"""The longest time (s) that judging one answer may take on a slot that never has to wait for a processor.

A slot that has to wait gets more time (see `SlotHealth.slowed_by`).
"""
SLOT_MODULE = ("-m", "workbook.grading.slots.worker")
KILLED_S = 30.0
"""The longest time (s) that we wait for a killed slot and its answer's leftover processes to exit."""
SERVER_MODULE = ("-m", "workbook.grading.slots.forking")
UNTRIED = "no slot has tried it yet"
TRIAL_S = 60.0
END_S = 5.0
FORKED_S = 30.0
"""The longest time (s) that forking a slot may take. For the first slot, that includes the server's start."""

ShowProgress = Callable[[Progress], None]


class SlotBroken(RuntimeError):
    """Raised when the slot exited or didn't respond in time, so the answer wasn't judged.

    The message says what happened.
    """


class NotBegun(SlotBroken):
    """Raised when the slot couldn't start. The message says why. The answer isn't to blame."""


def slot_environment(own_criteria: Path | None) -> dict[str, str]:
    """Return the environment for starting a slot."""
    # A slot creates its own log folder. If we created the folder and were killed, it would stay behind.
    environ = child_environment(0, log_folder=Path(os.devnull))
    del environ["ROS_DOMAIN_ID"]
    for name in ("WORKBOOK_COURSE", OWN_CRITERIA, "PYTHONPATH"):
        if name in os.environ:
            environ[name] = os.environ[name]
    if own_criteria is not None:
        environ[OWN_CRITERIA] = str(own_criteria)
    environ.pop("ROS_LOG_DIR")
    return environ


class ForkedSlot:
    """A slot that was forked by a SlotServer.

    It implements the part of `subprocess.Popen` that the slot's owner uses.
    """

    def __init__(self, child: ForkedProgram, stdin: IO[bytes], stdout: IO[bytes]) -> None:
        self._child = child
        self.pid = child.pid
        self.stdin, self.stdout = stdin, stdout

    def close(self) -> None:
        """Close the slot's pipes."""
        self.stdin.close()
        self.stdout.close()

    def poll(self) -> int | None:
        """Return the exit code, or None while the slot or its leftover processes exist.

        A negative code -n means that signal n killed the slot.
        """
        return self._child.poll()

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the slot to exit, and return its exit code.

        Raises subprocess.TimeoutExpired after `timeout` seconds.
        """
        code = self._child.wait(timeout)
        self._child.close()
        return code


class SlotServer:
    """The process that forks a run's slots, all of them in the same isolation tier. Thread-safe.

    `environ`: the environment for each slot. The constructor doesn't wait until the server can fork; `fork` does.
    Raises NoSandbox if the tier is "sandbox" and bubblewrap isn't installed.
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
        """The ID of the server's process on this machine, whose process tree contains the slots."""
        return self._process.pid

    @property
    def is_tried(self) -> bool:
        """Whether the first slot has been forked and has tested its tier.

        Until then, all callers of `fork` wait for that test.
        """
        return self._problem != UNTRIED

    @property
    def is_running(self) -> bool:
        """Whether the server can still fork slots."""
        return self._process.poll() is None

    def fork(self, groups: LeasedGroups | None) -> ForkedSlot:
        """Fork a slot. `groups`: the memory cgroups that the caller leased for it. Raises NotForked or OSError.

        The first slot tests whether its isolation tier works, while other callers wait. The test is necessary because a
        forked slot runs in a sandbox within a sandbox, which may not work.
        """
        with self._trial:
            if self._problem == UNTRIED:
                try:
                    slot, self._problem = self._tried(groups)
                except NotForked as error:
                    self._problem = str(error)
                    raise
                if self._problem is None:
                    return slot
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(slot.pid, signal.SIGKILL)
                slot.close()
        if self._problem is not None:
            raise NotForked(self._problem)
        return self._fork(groups)

    def _tried(self, groups: LeasedGroups | None) -> tuple[ForkedSlot, str | None]:
        """Fork a slot, and have it test its tier.

        Return the slot, and the reason why the tier doesn't work, or None if it works.
        """
        with socket.create_server(("127.0.0.1", 0)) as listener:
            slot = self._fork(groups, listener.getsockname()[1])
            try:
                problem = (LineReader(slot.stdout.fileno()).next(TRIAL_S) or {})["problem"]
            except (ValueError, KeyError, EOFError):
                return slot, "the self-test of the slot broke"
        return slot, None if problem is None else str(problem)

    def _fork(self, groups: LeasedGroups | None, port: int | None = None) -> ForkedSlot:
        request = {
            "groups": None if groups is None else str(groups.path),
            "folder": str(Path.cwd()),
            "port": port,
        }
        (their_stdin, stdin), (stdout, their_stdout) = os.pipe(), os.pipe()
        try:
            try:
                with self._turn:
                    status = request_fork(self._channel, request, [their_stdin, their_stdout])
            finally:
                close_all([their_stdin, their_stdout])
            child = started_program(status, FORKED_S)
        except (NotForked, OSError) as error:
            close_all([stdin, stdout])
            raise NotForked(f"no slot could be forked: {error}") from error
        return ForkedSlot(child, os.fdopen(stdin, "wb"), os.fdopen(stdout, "rb"))

    def close(self) -> None:
        """Stop the server and its remaining slots."""
        self._channel.close()
        for number in (signal.SIGTERM, signal.SIGKILL):
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(END_S)
            if self._process.returncode is None:
                os.killpg(self._process.pid, number)
        self._process.wait()
        self._give_back()

    def _give_back(self) -> None:
        if self._groups is not None:
            self._groups.remove()


class Slot:
    """A slot, as a running process. Not thread-safe.

    `isolation`: the isolation tier in which programs run (see `workbook.isolation.tiers`). `own_criteria`: the folder
    with an instructor's own criteria, or None for the same folder as in this process. `port`: the port of a listener on
    this machine, or None. If it's given, the slot first tests whether the tier isolates programs (see `problem`).
    `server`: the server from which the slot is forked if possible. It must have the same tier and environment. Raises
    SlotBroken if no user ID is free for the "uid" tier.
    """

    def __init__(
        self,
        isolation: Isolation = "limits",
        own_criteria: Path | None = None,
        *,
        port: int | None = None,
        server: SlotServer | None = None,
    ) -> None:
        try:
            self._ids = lease_for(isolation)
        except NoIds as error:
            raise SlotBroken(str(error)) from error
        self._groups = lease_groups()
        self.environ = slot_environment(own_criteria)
        self._process: subprocess.Popen[bytes] | ForkedSlot
        try:
            self._process, self._health = self._forked(server) or self._fresh(isolation, port)
        except BaseException:
            self._sweep()
            raise
        assert self._process.stdout is not None
        self._lines = LineReader(self._process.stdout.fileno())

    def _forked(self, server: SlotServer | None) -> tuple[ForkedSlot, SlotHealth] | None:
        """Have the server fork a slot. Return None if there is no server or if forking fails."""
        if server is None:
            return None
        try:
            process = server.fork(self._groups)
        except (NotForked, OSError):
            return None
        return process, SlotHealth(process.pid)

    def _fresh(self, isolation: Isolation, port: int | None) -> tuple[subprocess.Popen[bytes], SlotHealth]:
        command = [sys.executable, *SLOT_MODULE, isolation]
        if self._ids is not None:
            command += ["--user", str(self._ids.user)]
        folder = None if self._groups is None else self._groups.path
        if folder is not None:
            command += ["--groups", str(folder)]
        if port is not None:
            command += ["--try", str(port)]
        process = subprocess.Popen(
            slot_command(isolation, command, folder),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=self.environ,
            start_new_session=True,
        )
        return process, SlotHealth(process.pid, SLOT_MODULE)

    def problem(self, timeout_s: float) -> str | None:
        """Return why the slot's tier doesn't isolate programs on this machine, or None if it does.

        Call this method before the first job, and only if the slot was created with a `port`.

        Raises SlotBroken if the slot hasn't finished the test after `timeout_s` seconds.
        """
        self._health.begin()
        found = self._read_line(time.monotonic(), timeout_s)["problem"]
        return None if found is None else str(found)

    @property
    def is_running(self) -> bool:
        """Whether the slot's process is running."""
        return self._process.poll() is None

    def _read_line(self, began: float, timeout_s: float) -> Message:
        """Return the slot's next message. Raises SlotBroken if it doesn't arrive in time or if the slot has a problem.

        The slot has `timeout_s` seconds from `began`, and more if other processes keep the machine busy.
        """
        while True:
            left = began + timeout_s - time.monotonic()
            if left <= 0:
                left = began + timeout_s * self._health.slowed_by() - time.monotonic()
            if left <= 0:
                raise SlotBroken("the slot did not answer in time")
            try:
                message = self._lines.next(min(left, 1.0))
            except EOFError:
                raise SlotBroken(f"the slot ended with code {self._process.wait()}") from None
            except ValueError as error:
                raise SlotBroken(f"the slot sent an invalid message: {error}") from error
            if message is None:
                problem = self._health.problem()
                if problem is not None:
                    raise SlotBroken(problem)
            elif "broken" in message:
                raise NotBegun(message["broken"])
            else:
                return message

    def judge(
        self,
        stem: str,
        answer: Answer,
        *,
        soak: bool,
        seed: int | None = None,
        report: Report | None = None,
        progress: ShowProgress | None = None,
    ) -> Judgement:
        """Judge one answer. See `Judge.judge`. After SlotBroken, the slot can't be used anymore.

        `progress` is called several times per second.
        """
        order = JudgingOrder(stem, answer.text, soak, seed, progress is not None)
        self._health.begin()
        began = time.monotonic()
        try:
            self._send(line_of(order))
        except OSError as error:
            self._read_line(began, ANSWER_DEADLINE_S)  # the slot may have sent the reason
            raise SlotBroken("the slot is gone") from error
        while True:
            message = self._read_line(began, ANSWER_DEADLINE_S)
            if "progress" in message:
                if progress is not None:
                    progress(Progress(**message["progress"]))
            elif "ready" not in message:
                judgement = judgement_in(message, stem, answer.sha256)
                if message["final"]:
                    return judgement
                if report is not None:
                    report(judgement)

    def _send(self, line: bytes) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line)
        self._process.stdin.flush()

    def cancel_soak(self) -> None:
        """Cancel the real-time watch of the judged program. Thread-safe."""
        with contextlib.suppress(OSError, ValueError):
            self._send(line_of(CANCEL_SOAK))

    def close(self) -> None:
        """Stop the slot by closing its input. If it's still running after two seconds, kill it."""
        if self._process.stdin is not None:
            try:
                self._process.stdin.close()
            except OSError:
                pass
        try:
            self._process.wait(2.0)
        except subprocess.TimeoutExpired:
            self.kill()
        self._sweep()
        if self._process.stdout is not None:
            self._process.stdout.close()

    def kill(self) -> None:
        """Kill the slot, the program that it watches, and all child processes of the program."""
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, signal.SIGKILL)
        with contextlib.suppress(subprocess.TimeoutExpired):  # on a timeout, the slot's server is stuck
            self._process.wait(KILLED_S)
        kill_programs_of(self._process.pid)
        self._sweep()

    def _sweep(self) -> None:
        """Remove the slot's memory cgroups, kill the processes with its user ID, and release the ID."""
        if self._groups is not None:
            self._groups.remove()
        if self._ids is not None:
            try:
                self._ids.sweep()
            except StillThere:  # no other slot may get this ID while a process is still running under it
                return
            self._ids.release()
            self._ids = None

    def __enter__(self) -> "Slot":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
