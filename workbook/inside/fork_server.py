"""Start answers by forking, so that Python and rclpy are loaded only once for all of them.

    python -P run.py fork_server CHANNEL

CHANNEL is the file descriptor of an inherited socket. It carries requests (see `Request`). Each request comes with two
descriptors: one for reporting the program's status, and one for its output. Two more descriptors are optional: one of
the file through which the program joins its memory cgroup, and one for the program's input. The cgroup file is passed
as a descriptor, because the file's path would stay in the program's memory.

For each request, this process forks a supervisor. The supervisor joins the namespaces that were created for the
program, if there are any, and forks the program. In namespaces, the program's process gives up its capabilities before
it reads any of the answer. It closes all descriptors except its standard input and output. The kernel kills the
supervisor when this process exits, and a program without namespaces when its supervisor exits.

A request may also be for a branch (see `Branch`), which is another fork server inside a slot's sandbox. A slot is a
process that judges answers.

An `ImportCache` hides the modules that this process has imported, because a program must not notice them.
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
"""The number of spaces that this process's parent reserves for a mark in our environment (see `RunMark`)."""
READY = b"ready"
FAILED = 126


@dataclass(frozen=True)
class Request:
    """A request to start a program. `arguments`: the arguments for `host.main`.

    `namespaces_of`: the process ID of the first process in the sandbox that the program joins, or 0 for no sandbox.
    `folder`: the program's working directory. `reads`: whether the last descriptor is the program's standard input.
    """

    namespaces_of: int
    arguments: list[str]
    environ: dict[str, str]
    folder: str
    reads: bool


@dataclass(frozen=True)
class Branch:
    """A request to fork another server, for one slot. That server exits when the other end of its channel is closed.

    `branch_in`: the process ID of the first process in the slot's sandbox.
    """

    branch_in: int


class RunMark:
    """The mark, which identifies a program and its descendants among the machine's processes.

    The mark is the value of an environment variable. For /proc/PID/environ, the kernel reads the memory that contains
    the process's original environment. So we write the mark to that memory, where other processes can read it.
    """

    def __init__(self) -> None:
        begin, end = own_environment_range()
        place = ctypes.string_at(begin, end - begin).find(MARK + b" " * MARK_BYTES)
        self._address = begin + place + len(MARK) if place >= 0 else 0

    def write(self, mark: str) -> None:
        """Make `mark` this process's mark. Raises ValueError if it doesn't fit into the reserved space."""
        text = mark.encode()
        if not self._address or len(text) > MARK_BYTES:
            raise ValueError(f"there is no room for the mark {mark!r}")
        ctypes.memmove(self._address, text.ljust(MARK_BYTES, b"\0"), MARK_BYTES)


@dataclass(frozen=True)
class Hooks:
    """The objects that must act when the server forks."""

    lttng: LttngForkHooks
    mark: RunMark


def become_program(
    request: Request, parent: int, output: int, given: int | None, group: int | None, hooks: Hooks
) -> None:
    """Prepare this forked process to run the answer: set its rights, session, folder, descriptors, and environment.

    `group`: the descriptor of the file through which to join a memory cgroup. `given`: the descriptor of the program's
    input, or None for empty input. For empty input, we open /dev/null here, because programs that inherited the same
    descriptor would share its flags. If anything fails, write the reason to `output`, and exit.
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
        hooks.lttng.after_fork_in_program()  # only now, so that LTTng's threads get no more rights than ours
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
    """Fork the program into its namespaces, and wait for it.

    Only the forked program returns; the supervisor exits here. The supervisor reports the program's process ID, and
    later its exit status (from `os.waitpid`). When a program in a sandbox exits, the supervisor kills the sandbox's
    first process, and with it all processes that the program started.
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
            # the sandbox's first process may have exited already, and the program with it
            with contextlib.suppress(ProcessLookupError):
                os.kill(request.namespaces_of, signal.SIGKILL)
        report(status, f"{ended}\n")
        code = 0
    except BaseException as error:
        report(status, f"failed: {error}\n")
    os._exit(code)


def _reap(*_: object) -> None:
    """Reap the supervisors and branches that have exited."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        pass


def become_branch(branch: Branch, descriptor: int, hooks: Hooks) -> socket.socket:
    """Turn this forked process into a server for one slot. Return the new server's channel.

    If that fails, report the reason and exit.
    """
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
    """Fork a program for each request.

    In each forked program, return the program's arguments. In the server, return None when the channel is closed.
    """
    for asked, descriptors in requests(channel):
        try:
            forked = hooks.lttng.fork()
        except OSError as error:  # this error must not affect the other programs
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
    """Import everything that answers need. Then fork a program for each request until the channel is closed."""
    importlib.import_module("rclpy.context")  # the host does this for every answer
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
