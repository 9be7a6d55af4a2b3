"""Use memory cgroups, with which the kernel counts all of an answer's memory and kills the answer at the limit.

The kernel also counts memory that polling misses: files in memory, shared memory, pipes, page tables, and sockets.

Groups are nested. `group_keeper` creates one group inside the group that our process belongs to, so the limits of our
process's group also apply to the answers. The keeper removes its group even if our process is killed. The keeper's
group contains a group for each slot, which is a process that judges answers (`lease_groups`). A slot's group contains a
group for each answer. If groups can't be used, `groups_problem` returns the reason, and the judge polls resident and
shared memory instead.
"""

import atexit
import errno
import fcntl
import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from workbook.inside import RUN
from workbook.inside.memory_cgroup import (
    divide_group,
    groups_in,
    open_group,
    processes_in,
    remove_group,
    version_of,
    write,
)
from workbook.inside.orphans import exempt, forget
from workbook.inside.proc import OWN_GROUPS, OWN_MOUNTS, mounted, own_groups, process_tree, read_text
from workbook.recording.limits import ANSWER_LIMITS, Limits

PREFIX = "rclpy-workbook-"
LEAF = "grader-of-rclpy-workbook"
"""The group that we move our processes to in cgroup v2.

There, a group that contains processes can't limit its subgroups' memory.
"""
SOCKETS_FACTOR = 2
"""The kernel's limit on socket memory, as a multiple of the judge's limit.

The kernel's limit is higher, so that an answer can exceed the judge's limit and the judge can report that.
"""
_JOIN = ("/bin/sh", "-c", 'echo 0 >"$0"')
_JOIN_S = 10.0
_DELEGATE = "systemd-run --user --scope -p Delegate=memory workbook grade …"
_once = threading.RLock()
"""Slots start in parallel. The first slot creates the group that they share, and the other slots wait for this lock."""


class NoMemoryGroups(RuntimeError):
    """Raised when no memory cgroup is available. The message says why."""


@dataclass(frozen=True)
class Hierarchy:
    """The machine's cgroups as this process sees them: version 1 or 2, the mount point, and the process's own group."""

    version: int
    mount: Path
    own: Path


def find_hierarchy(groups: str = OWN_GROUPS, mounts: str = OWN_MOUNTS) -> Hierarchy:
    """Find the cgroup hierarchy that counts memory.

    `groups` and `mounts`: the kernel's tables of this process's groups and mounts. Raises NoMemoryGroups if there is
    none.
    """
    memberships = own_groups(groups)
    first = [path for _, controllers, path in memberships if "memory" in controllers.split(",")]
    second = [path for number, controllers, path in memberships if number == "0" and not controllers]
    for version, kind, paths in ((1, "cgroup", first), (2, "cgroup2", second)):
        for root, mount, options in mounted(kind, mounts):
            if not paths or (version == 1 and "memory" not in options):
                continue
            below = os.path.relpath(paths[0], root)
            own = Path(os.path.normpath(os.path.join(mount, below)))
            if not below.startswith("..") and own.is_dir():
                return Hierarchy(version, Path(mount), own)
    raise NoMemoryGroups("this process is in no cgroup that can be seen")


class MemoryGroup:
    """The memory cgroup for one answer, with the answer's limits. Raises OSError if the kernel doesn't allow it."""

    def __init__(self, folder: Path, limits: Limits) -> None:
        self.version = version_of(str(folder))
        self._limits = limits
        self._exceeded: str | None = None
        self.path = Path(tempfile.mkdtemp(prefix="answer-", dir=folder))
        try:
            self._limit()
            os.close(open_group(self.joins))
        except OSError:
            self.remove()
            raise

    @property
    def joins(self) -> str:
        """The path of the group's join file: a process that writes "0" to it joins the group.

        Version 1 has two such files. We use the one that doesn't make the kernel lock all processes.
        """
        return str(self.path / ("tasks" if self.version == 1 else "cgroup.procs"))

    def _limit(self) -> None:
        memory, queued = self._limits.memory, self._limits.queued
        if self.version == 2:
            write(str(self.path / "memory.max"), str(memory))
            for name, value in (("memory.swap.max", "0"), ("memory.oom.group", "1")):
                with suppress(FileNotFoundError):  # the kernel has no swap, or is older than 4.19
                    write(str(self.path / name), value)
            return
        write(str(self.path / "memory.limit_in_bytes"), str(memory))
        with suppress(OSError):  # the kernel doesn't count swap
            write(str(self.path / "memory.memsw.limit_in_bytes"), str(memory))
        if queued is not None:
            with suppress(OSError):  # the kernel doesn't count socket memory
                write(str(self.path / "memory.kmem.tcp.limit_in_bytes"), str(SOCKETS_FACTOR * queued))

    def exceeded(self) -> str | None:
        """Return the name (in `Limits`) of a limit that the answer has exceeded, or None if it exceeded none."""
        if self._exceeded is None:
            if self._ended_by_kernel():
                self._exceeded = "memory"
            elif self._limits.queued is not None and self._in_sockets() > self._limits.queued:
                self._exceeded = "sockets"
            elif self._limits.kernel is not None and self._in_kernel() > self._limits.kernel:
                self._exceeded = "descriptors"
        return self._exceeded

    def _ended_by_kernel(self) -> bool:
        events = "memory.events" if self.version == 2 else "memory.oom_control"
        return number_in(self.path / events, "oom_kill") > 0

    def _in_sockets(self) -> int:
        if self.version == 1:
            return number_in(self.path / "memory.kmem.tcp.usage_in_bytes")
        return number_in(self.path / "memory.stat", "sock")

    def _in_kernel(self) -> int:
        if self.version == 1:
            return number_in(self.path / "memory.kmem.usage_in_bytes")
        return number_in(self.path / "memory.stat", "kernel")  # zero before Linux 5.18

    def remove(self) -> None:
        """Check the limits one last time, kill the group's remaining processes, and remove the group."""
        self.exceeded()
        remove_group(str(self.path))


def number_in(path: Path, name: str = "") -> int:
    """Return the number in one of the kernel's files or, if `name` is given, the number after `name` in a table.

    Return zero if there is no such number.
    """
    try:
        rows = [line.split() for line in read_text(str(path)).splitlines()]
        return next((int(row[-1]) for row in rows if not name or row[0] == name), 0)
    except (OSError, ValueError, IndexError):
        return 0


class LeasedGroups:
    """A slot's group, inside the group `above`. It contains the groups of the slot's answers.

    `given_back` is called once, after the group has been removed. Raises OSError if the group can't be created.
    """

    def __init__(self, above: Path, given_back: Callable[[], None] = lambda: None) -> None:
        self._given_back: list[Callable[[], None]] = []
        self.path = Path(tempfile.mkdtemp(prefix="slot-", dir=above))
        try:
            divide_group(str(self.path))
        except OSError:
            self.remove()
            raise
        self._given_back.append(given_back)

    def remove(self) -> None:
        """Kill the group's remaining processes, and remove the group."""
        remove_group(str(self.path))
        while self._given_back:
            self._given_back.pop()()


class KeptGroup:
    """A group inside `own` that's removed by `close`, or when this process exits.

    Raises NoMemoryGroups if the group can't be created.
    """

    def __init__(self, own: Path) -> None:
        self._owner = os.getpid()
        self._keeper = subprocess.Popen(
            [sys.executable, "-I", "-S", str(RUN), "group_keeper", str(own), f"{PREFIX}{os.getpid()}-"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={},
            start_new_session=True,
        )
        exempt(self._keeper.pid)
        assert self._keeper.stdout is not None
        told = self._keeper.stdout.readline().strip()
        if not told.startswith("/"):
            self.close()
            raise NoMemoryGroups(f"no group can be made in {own}: {told.removeprefix('!')}")
        self.path = Path(told)

    def close(self) -> None:
        """Have the keeper remove the group, and wait until the keeper exits.

        Do nothing in a forked child of this process.
        """
        if self._owner == os.getpid():
            self._keeper.communicate()
            forget(self._keeper.pid)


def lease_groups() -> LeasedGroups | None:
    """Return a group for one slot, or None if that's impossible (see `groups_problem`).

    When the last slot's group is removed, the group that contained the slots' groups is removed, too.
    """
    if groups_problem() is not None:
        return None
    with _once:
        try:
            leased = LeasedGroups(_keeper.kept().path, _keeper.given_back)
        except (OSError, NoMemoryGroups):
            return None
        _keeper.leases += 1
        return leased


def groups_problem() -> str | None:
    """Return why answers can't have a memory cgroup on this machine, or None if they can.

    The first call tries to create a group. It also removes the groups that killed processes left behind.
    """
    with _once:
        return _groups_problem()


@cache
def _groups_problem() -> str | None:
    try:
        hierarchy = find_hierarchy()
        sweep_groups(hierarchy.mount)
        try_out(_keeper.kept().path)
    except NoMemoryGroups as error:
        return str(error)
    return None


def groups_in_words() -> str:
    """Describe in a sentence how answers' memory is limited on this machine."""
    problem = groups_problem()
    if problem is None:
        return f"Memory is limited by a cgroup (version {find_hierarchy().version})."
    return f"Memory is watched 20 times a second, without a cgroup: {problem}."


class _Keeper:
    """Holds the group that contains the groups of all this process's slots, as long as at least one of them is leased.

    The class isn't thread-safe, so callers must hold the lock `_once`.
    """

    def __init__(self) -> None:
        self._kept: KeptGroup | None = None
        self.leases = 0

    def kept(self) -> KeptGroup:
        """Return the group. Create it if necessary. Raises NoMemoryGroups if that fails."""
        if self._kept is None:
            self._kept = KeptGroup(prepare(find_hierarchy()))
            atexit.register(self._kept.close)
        return self._kept

    def given_back(self) -> None:
        """Decrease the number of leases by one. After the last one, remove the group."""
        with _once:
            self.leases -= 1
            if not self.leases:
                self.close()

    def close(self) -> None:
        """Remove the group, if there is one."""
        if self._kept is not None:
            kept, self._kept = self._kept, None
            atexit.unregister(kept.close)
            kept.close()


_keeper = _Keeper()


def prepare(hierarchy: Hierarchy) -> Path:
    """Enable memory limits for the subgroups of this process's own group. Return that own group.

    In version 2, this process and its descendants may have to move to a subgroup (`LEAF`). That's impossible if the
    group also contains other processes. Raises NoMemoryGroups.
    """
    own = hierarchy.own
    if hierarchy.version == 1:
        return own
    if "memory" not in _words(own / "cgroup.controllers"):
        raise NoMemoryGroups(f"{own} is not given the memory controller (try: {_DELEGATE})")
    if "memory" in _words(own / "cgroup.subtree_control"):
        return own
    try:
        _divide(own)
    except OSError as error:
        raise NoMemoryGroups(f"{own} may not be divided: {error.strerror} (try: {_DELEGATE})") from error
    return own


def _divide(own: Path) -> None:
    control = own / "cgroup.subtree_control"
    try:
        write(str(control), "+memory")
        return
    except OSError as error:
        if error.errno != errno.EBUSY or set(processes_in(str(own))) - set(process_tree(os.getpid())):
            raise
    leaf = own / LEAF
    leaf.mkdir(exist_ok=True)
    for pid in processes_in(str(own)):
        with suppress(ProcessLookupError):
            write(str(leaf / "cgroup.procs"), str(pid))
    write(str(control), "+memory")


def _words(path: Path) -> list[str]:
    try:
        return read_text(str(path)).split()
    except OSError:
        return []


def try_out(above: Path) -> None:
    """Create a group for an answer, have a process join the group, and remove it. Raises NoMemoryGroups on failure."""
    try:
        groups = LeasedGroups(above)
    except OSError as error:
        raise NoMemoryGroups(f"no group can be made in {above}: {error.strerror}") from error
    try:
        group = MemoryGroup(groups.path, ANSWER_LIMITS)
        if group.version == 1 and "oom_kill" not in _words(group.path / "memory.oom_control"):
            raise NoMemoryGroups("this kernel is older than 4.13")
        joined = subprocess.run([*_JOIN, group.joins], stderr=subprocess.DEVNULL, timeout=_JOIN_S)
        if joined.returncode != 0:
            raise NoMemoryGroups(f"no process may join a group in {above}")
    except OSError as error:
        raise NoMemoryGroups(f"no limit can be set in {above}: {error.strerror}") from error
    finally:
        groups.remove()


def sweep_groups(mount: Path) -> None:
    """Remove all groups that killed processes left behind, anywhere in the hierarchy mounted at `mount`."""
    waiting = [str(mount)]
    while waiting:
        for group in groups_in(waiting.pop()):
            if not os.path.basename(group).startswith(PREFIX):
                waiting.append(group)
            else:
                _remove_if_nobodys(group)


def _remove_if_nobodys(group: str) -> None:
    try:
        descriptor = os.open(group, os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        remove_group(group)
    except BlockingIOError:  # the group's owner is alive
        pass
    finally:
        os.close(descriptor)
