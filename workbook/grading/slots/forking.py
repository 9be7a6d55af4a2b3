"""Fork slots, so that Python, the judge, and rclpy are loaded only once for all of them.

    python -m workbook.grading.slots.forking CHANNEL TIER

CHANNEL is the file descriptor of an inherited socket. It carries requests (see `SlotRequest`), each with three
descriptors: for the slot's status, its standard input, and its standard output. Once the slot is in its sandbox, it
writes its process ID to the status descriptor. After all of the slot's processes have exited, this process adds an
empty line and the slot's exit status (from `os.waitpid`). If a slot exits too early, it doesn't report a process ID. In
that case, the empty line keeps the exit status from being read as the process ID.

In the "sandbox" tier, this process runs in an outer sandbox, and each slot gets its own outer sandbox inside that one.
We create an empty sandbox, and the forked process enters it.
"""

import gc
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
"""The number of fork servers for programs. Each has a different seed for string hashes (see `SandboxTier`)."""
LAST_WORDS_S = 2.0
"""The time (s) that slots have to exit by themselves when this process is asked to exit."""
POLL_S = 0.01
FAILED = 125
"""The exit code of a slot that couldn't enter its sandbox."""


@dataclass(frozen=True)
class SlotRequest:
    """A request for one slot.

    `groups`: the slot's folder for memory cgroups, or None. `folder`: its working directory. `port`: the port of a
    listener on this machine for a slot that first tests its isolation tier, or None for all other slots.
    """

    groups: str | None
    folder: str
    port: int | None


class EmptySandbox:
    """An outer sandbox that's empty until a slot enters it. Raises OSError if it can't be created."""

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
        """Kill the sandbox's processes, including the slot."""
        self._process.kill()
        self._process.wait()
        forget(self._process.pid)


@dataclass(frozen=True)
class RunningSlot:
    """A forked slot, its sandbox if it has one, and the descriptor for reporting its exit status."""

    pid: int
    status_fd: int
    sandbox: EmptySandbox | None


@dataclass
class SlotForker:
    """Forks slots that have the same isolation tier, and reports their exit statuses.

    `zygotes`: the fork servers from which the slots' own fork servers for programs are forked. `ended`: a descriptor
    that becomes readable when a child process exits.
    """

    isolation: Isolation
    channel: socket.socket
    zygotes: Sequence[Zygote]
    ended: int
    _running: dict[int, RunningSlot] = field(default_factory=dict)
    _lttng: LttngForkHooks = field(default_factory=LttngForkHooks)

    def work(self) -> None:
        """Serve requests until the channel is closed.

        In a forked slot's process, this method returns when the slot has finished its work.
        """
        for asked, descriptors in requests(self.channel, self.ended, self._report_ended):
            if len(descriptors) != DESCRIPTORS:  # this process has reached its limit on open descriptors
                close_all(descriptors)
            elif self._fork(SlotRequest(**asked), descriptors):
                return

    def _fork(self, request: SlotRequest, descriptors: Sequence[int]) -> bool:
        """Fork a slot.

        Return False in this process, and True in the slot's process when the slot has finished its work.
        """
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
        os.setpgid(pid, pid)  # the child does this, too, because either process may run first
        close_all(pipes)
        self._running[pid] = RunningSlot(pid, status, sandbox)
        return False

    def _become_slot(
        self, request: SlotRequest, descriptors: Sequence[int], sandbox: EmptySandbox | None
    ) -> None:
        """Enter the sandbox, and then work as a slot until its standard input is closed. If entering fails, exit."""
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
        """Reap the slots that have exited, kill their leftover processes, and report the exit statuses."""
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
        """Stop all slots. Kill those that don't exit by themselves in time."""
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
    """Exit in an orderly way. Ignore further SIGTERM signals."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(0)


def main() -> None:
    """Import everything that slots need. Then fork a slot for each request until the channel is closed."""
    channel, isolation = socket.socket(fileno=int(sys.argv[1])), named_tier(sys.argv[2])
    adopt_orphans()
    set_parent_death_signal(signal.SIGTERM)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end)
    environ = sandbox_environment(child_environment(0, log_folder=Path(os.devnull)))
    helpers = [start_helper(SERVER, environ) for _ in range(SEEDS if isolation == "sandbox" else 0)]
    import_what_answers_need()
    gc.collect()
    gc.freeze()  # a slot's collector then doesn't examine these objects, nor copy their memory by examining them
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
