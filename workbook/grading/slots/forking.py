"""Forks slots: Python, the judge and rclpy are imported once, and not again for every slot.

    python -m workbook.grading.slots.forking CHANNEL TIER

CHANNEL is the number of an inherited socket. On it comes one request after another (see `SlotRequest`), each with three
descriptors: where to report the status of the slot, and its standard input and output. The status is its process
number, as soon as it is in its sandbox; and how it ended (as `os.waitpid` has it), when it has and nothing of it is
left. Before that comes an empty line: a slot that ends too early has no number, and how it ended must not be taken for
one.

With the tier "sandbox" this process is in an outer sandbox of its own, and each slot gets another one: an empty one is
made, and the forked process enters it.
"""

import os
import random
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from workbook.grading.slots.worker import serve
from workbook.inside.fork_requests import close_all, report, requests
from workbook.inside.import_cache import import_what_answers_need
from workbook.inside.libc import set_parent_death_signal
from workbook.inside.lttng import LttngForkHooks
from workbook.inside.namespaces import settle_in_slot
from workbook.inside.orphans import StillThere, adopt_orphans, exempt, forget, forget_all, sweep_orphans
from workbook.isolation.bubblewrap import empty_outer_command
from workbook.isolation.sandbox import first_pid, read_info, sandbox_environment
from workbook.isolation.tiers import Isolation, named_tier
from workbook.programs.fork_client import SERVER, ForkServer, Zygote
from workbook.programs.helpers import start_helper
from workbook.ros.environment import child_environment

DESCRIPTORS = 3
SEEDS = 2
"""So many fork servers for programs: each has its own seed for the hashes of strings. See `SandboxTier`."""
LAST_WORDS_S = 2.0
"""So long slots may take to end in order when this process is told to end."""
POLL_S = 0.01
FAILED = 125
"""Exit code of a slot that could not enter its sandbox."""


@dataclass(frozen=True)
class SlotRequest:
    """One slot. `groups`: its folder for memory cgroups, None without them; `folder`: where it works.

    `port`: of a listener on this machine, for a slot that tries out its tier first; None for the others.
    """

    groups: str | None
    folder: str
    port: int | None


class EmptySandbox:
    """An outer sandbox that waits for a slot to enter it. Raises OSError when there is none."""

    def __init__(self, groups: str | None) -> None:
        info_fd = os.memfd_create("what bubblewrap says about itself")
        try:
            self._process = subprocess.Popen(
                empty_outer_command(info_fd, None if groups is None else Path(groups)),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                start_new_session=True,
                pass_fds=[info_fd],
            )
            exempt(self._process.pid)
            assert self._process.stdout is not None
            with self._process.stdout as said:
                said.readline()
            first = first_pid(read_info(info_fd))
        finally:
            os.close(info_fd)
        if first is None:
            self.close()
            raise OSError("there is no sandbox for the slot")
        self.first = first

    def close(self) -> None:
        """End it, and what is in it with it."""
        self._process.kill()
        self._process.wait()
        forget(self._process.pid)


@dataclass(frozen=True)
class RunningSlot:
    """A slot that was forked, what it is in, and where its end is reported."""

    pid: int
    status_fd: int
    sandbox: EmptySandbox | None


@dataclass
class SlotForker:
    """Forks slots of one tier, and reports how they end.

    `zygotes`: the fork servers for their programs; `ended`: can be read when a child has ended.
    """

    isolation: Isolation
    channel: socket.socket
    zygotes: Sequence[Zygote]
    ended: int
    _running: dict[int, RunningSlot] = field(default_factory=dict)
    _lttng: LttngForkHooks = field(default_factory=LttngForkHooks)

    def work(self) -> None:
        """Follow requests until the channel is closed. Returns in a slot as well, when that has ended."""
        for asked, descriptors in requests(self.channel, self.ended, self._report_ended):
            if len(descriptors) != DESCRIPTORS:  # there is no room for them in this process
                close_all(descriptors)
            elif self._fork(SlotRequest(**asked), descriptors):
                return

    def _fork(self, request: SlotRequest, descriptors: Sequence[int]) -> bool:
        """Fork a slot. Returns whether this is it, and it has ended."""
        status, *pipes = descriptors
        sandbox = None
        try:
            if self.isolation == "sandbox":
                sandbox = EmptySandbox(request.groups)
            pid = self._lttng.fork()
        except OSError as error:
            report(status, f"failed: {error}\n")
            close_all(descriptors)
            if sandbox is not None:
                sandbox.close()
            return False
        if pid == 0:
            self._become_slot(request, descriptors, sandbox)
            return True
        exempt(pid)
        os.setpgid(pid, pid)  # as it does itself: whoever comes first
        close_all(pipes)
        self._running[pid] = RunningSlot(pid, status, sandbox)
        return False

    def _become_slot(
        self, request: SlotRequest, descriptors: Sequence[int], sandbox: EmptySandbox | None
    ) -> None:
        """Be a slot, until it ends. Enters the sandbox before anything else, or ends."""
        status, *pipes = descriptors
        os.close(signal.set_wakeup_fd(-1))
        os.close(self.ended)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        try:
            if sandbox is not None:
                settle_in_slot(sandbox.first)
            os.chdir(request.folder)
        except OSError as error:
            report(status, f"a slot could not enter its sandbox: {error}\n")
            os._exit(FAILED)
        self._lttng.after_fork_in_program()
        os.setpgid(0, 0)
        report(status, f"{os.getpid()}\n")
        os.close(status)
        for ours, number in zip(pipes, (0, 1), strict=True):
            os.dup2(ours, number)
            os.close(ours)
        self.channel.close()
        for running in self._running.values():
            os.close(running.status_fd)
        forget_all()
        random.seed()
        servers = [] if sandbox is None else [ForkServer(zygote, sandbox.first) for zygote in self.zygotes]
        groups = None if request.groups is None else Path(request.groups)
        serve(self.isolation, port=request.port, groups=groups, servers=servers)

    def _report_ended(self) -> None:
        """Reap slots that have ended, end what they have left, and report them."""
        for slot in [*self._running.values()]:
            with suppress(ChildProcessError):
                pid, code = os.waitpid(slot.pid, os.WNOHANG)
                if pid:
                    self._forget(slot)
                    report(slot.status_fd, f"\n{code}\n")
                    os.close(slot.status_fd)

    def _forget(self, slot: RunningSlot) -> None:
        del self._running[slot.pid]
        forget(slot.pid)
        if slot.sandbox is not None:
            slot.sandbox.close()
        try:
            sweep_orphans()
        except StillThere as error:
            print(error, file=sys.stderr, flush=True)

    def close(self) -> None:
        """End all slots: in order if they do so at once."""
        for pid in self._running:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGTERM)
        deadline = time.monotonic() + LAST_WORDS_S
        while self._running and time.monotonic() < deadline:
            self._report_ended()
            time.sleep(POLL_S)
        for slot in [*self._running.values()]:
            with suppress(ProcessLookupError):
                os.killpg(slot.pid, signal.SIGKILL)
            os.waitpid(slot.pid, 0)
            self._forget(slot)


def _end(*_: object) -> None:
    """End in order, and only once."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(0)


def main() -> None:
    """Import what slots need, then fork a slot for each request until the channel is closed."""
    channel, isolation = socket.socket(fileno=int(sys.argv[1])), named_tier(sys.argv[2])
    adopt_orphans()
    set_parent_death_signal(signal.SIGTERM)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end)
    environ = sandbox_environment(child_environment(0, log_folder=Path(os.devnull)))
    helpers = [start_helper(SERVER, environ) for _ in range(SEEDS if isolation == "sandbox" else 0)]
    import_what_answers_need()
    ended, wakes = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    signal.set_wakeup_fd(wakes, warn_on_full_buffer=False)
    server = SlotForker(isolation, channel, [Zygote(channel) for _, channel in helpers], ended)
    owner = os.getpid()
    try:
        server.work()
    finally:
        if os.getpid() == owner:
            server.close()
            for helper, _ in helpers:
                helper.kill()
                helper.wait()


if __name__ == "__main__":
    main()
