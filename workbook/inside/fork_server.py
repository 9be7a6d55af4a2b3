"""Starts answers by forking: Python and rclpy are imported once, and not again for every answer.

    python -P run.py fork_server CHANNEL

CHANNEL is the number of an inherited socket. On it comes one request after another (see `Request`), each with two
descriptors: where to report the status of the program, and where its output goes. Two more may come: the open file by
which the program joins its memory cgroup, because a path would stay in the memory of the program, and what it is to
read. For each request, a supervisor is forked, and it forks the program, after joining the name spaces that were made
for it, if there are any. Such a program is confined before a line of the answer is read: in these name spaces, without
capabilities, with nothing open but its input and output. A program without name spaces of its own dies with its
supervisor, and that with this process.

A request may also be for a branch (see `Branch`): another such server, forked into the sandbox of a slot.

A program must not notice that something was imported before it. So the modules are kept in an `ImportCache`.
"""

import contextlib
import ctypes
import gc
import importlib
import os
import signal
import socket
import sys
from collections.abc import Sequence
from dataclasses import dataclass

from workbook.inside import capabilities, host, memory_cgroup, syscall_filter
from workbook.inside.fork_requests import close_all, report, requests
from workbook.inside.import_cache import ImportCache, import_what_answers_need
from workbook.inside.libc import die_with_parent, set_parent_death_signal
from workbook.inside.lttng import LttngForkHooks
from workbook.inside.namespaces import OF_A_PROGRAM, join_namespaces, settle_in_slot
from workbook.inside.proc import own_environment_range

MARK = b"WORKBOOK_RUN="
MARK_BYTES = 80
"""Room for the mark of a program (see `RunMark`): blanks that whoever starts this process leaves in its environment."""
READY = b"ready"
FAILED = 126


@dataclass(frozen=True)
class Request:
    """One program to start, and what `host.main` and the program are given.

    `namespaces_of`: the first process of the sandbox to join; 0 for none. `reads`: whether the last descriptor is its
    standard input.
    """

    namespaces_of: int
    arguments: list[str]
    environ: dict[str, str]
    folder: str
    reads: bool


@dataclass(frozen=True)
class Branch:
    """Another server to fork, for one slot. It ends when the other end of its channel is closed.

    `branch_in`: the first process of the sandbox that the slot is in.
    """

    branch_in: int


class RunMark:
    """The variable by which others find a program, and all that came of it, among the processes of the machine.

    The kernel goes on showing the environment that this process was started with, from its memory: there the mark has
    to be written.
    """

    def __init__(self) -> None:
        begin, end = own_environment_range()
        place = ctypes.string_at(begin, end - begin).find(MARK + b" " * MARK_BYTES)
        self._address = begin + place + len(MARK) if place >= 0 else 0

    def write(self, mark: str) -> None:
        """Show `mark` as the mark of this process. Raises ValueError when there is no room for it."""
        text = mark.encode()
        if not self._address or len(text) > MARK_BYTES:
            raise ValueError(f"there is no room for the mark {mark!r}")
        ctypes.memmove(self._address, text.ljust(MARK_BYTES, b"\0"), MARK_BYTES)


@dataclass(frozen=True)
class Hooks:
    """What has to act when the server forks."""

    lttng: LttngForkHooks
    mark: RunMark


def become_program(
    request: Request, parent: int, output: int, given: int | None, group: int | None, hooks: Hooks
) -> None:
    """Turn this forked process into the one that runs the answer. `group`: the open file of the cgroup to join.

    `given`: what it reads; None for an empty input, opened here, because flags of an inherited one would be those of
    all programs.
    """
    try:
        if group is not None:
            memory_cgroup.join(group)
        if request.namespaces_of:
            if group is not None:
                memory_cgroup.hide_group()
            capabilities.clear_bounding_set()
            capabilities.drop_capabilities()
            capabilities.set_dumpable()
            syscall_filter.filter_sandbox_escapes()
        else:
            hooks.mark.write(request.environ[MARK.decode().rstrip("=")])
            die_with_parent(parent)
        hooks.lttng.after_fork_in_program()  # only now: what it starts has no more rights than we
        os.setsid()
        os.chdir(request.folder)
        os.dup2(os.open(os.devnull, os.O_RDONLY) if given is None else given, 0)
        os.dup2(output, 1)
        os.dup2(output, 2)
        os.closerange(3, os.sysconf("SC_OPEN_MAX"))
        os.environ.clear()
        os.environ.update(request.environ)
    except BaseException as error:
        os.write(output, f"the program could not be started: {error}\n".encode())
        os._exit(FAILED)


def supervise(request: Request, descriptors: Sequence[int], hooks: Hooks) -> None:
    """In a fork: bring the program into its name spaces. Returns in the program; the supervisor itself ends here.

    It reports the program's process number, and how it ended (as `os.waitpid` has it) when it has. With a program in a
    sandbox, all that it has started ends: the sandbox goes.
    """
    code = 1
    status, output, *others = descriptors
    given = others.pop() if request.reads else None
    group = others[0] if others else None
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    try:
        set_parent_death_signal()
        if request.namespaces_of:
            join_namespaces(request.namespaces_of, OF_A_PROGRAM)
        parent = os.getpid()
        program = os.fork()
        if program == 0:
            become_program(request, parent, output, given, group, hooks)
            return
        os.close(output)
        if given is not None:
            os.close(given)
        if not report(status, f"{program}\n"):
            os.kill(program, signal.SIGKILL)
        _, ended = os.waitpid(program, 0)
        if request.namespaces_of:
            # Whoever has ended the sandbox already has ended the program, too.
            with contextlib.suppress(ProcessLookupError):
                os.kill(request.namespaces_of, signal.SIGKILL)
        report(status, f"{ended}\n")
        code = 0
    except BaseException as error:
        report(status, f"failed: {error}\n")
    os._exit(code)


def _reap(*_: object) -> None:
    """Take note of supervisors and branches that have ended."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        pass


def become_branch(branch: Branch, descriptor: int, hooks: Hooks) -> socket.socket:
    """Turn this forked process into a server for one slot. Returns its channel."""
    channel = socket.socket(fileno=descriptor)
    try:
        set_parent_death_signal()
        settle_in_slot(branch.branch_in)
    except OSError as error:
        channel.send(f"no branch: {error}".encode())
        os._exit(FAILED)
    hooks.lttng.after_fork_in_program()
    os.setsid()
    channel.send(READY)
    return channel


def serve(channel: socket.socket, hooks: Hooks) -> list[str] | None:
    """Fork a program for each request. Returns its arguments in the program, None when the channel is closed."""
    for asked, descriptors in requests(channel):
        try:
            forked = hooks.lttng.fork()
        except OSError as error:  # this one must not end all the others
            report(descriptors[0], f"failed: {error}\n")
            forked = -1
        if forked == 0 and "branch_in" in asked:
            channel.close()
            return serve(become_branch(Branch(**asked), descriptors[0], hooks), hooks)
        if forked == 0:
            request = Request(**asked)
            channel.detach()
            supervise(request, descriptors, hooks)
            return request.arguments
        close_all(descriptors)
    return None


def main(arguments: Sequence[str]) -> None:
    """Import what answers need, then fork a program for each request until the channel is closed."""
    importlib.import_module("rclpy.context")  # as the host does for every answer
    cache = ImportCache()
    cache.fill(import_what_answers_need)
    sys.meta_path.insert(0, cache)
    channel = socket.socket(fileno=int(arguments[0]))
    signal.signal(signal.SIGCHLD, _reap)
    channel.send(READY)
    gc.collect()
    gc.freeze()
    of_program = serve(channel, Hooks(LttngForkHooks(), RunMark()))
    if of_program is not None:
        host.main(of_program)
