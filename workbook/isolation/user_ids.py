"""Lease unused user IDs for untrusted programs, and kill the processes that run under those IDs.

Each slot, which is a process that judges answers, gets a pair of IDs. The IDs don't need user accounts. Programs run
under the first ID; the process that kills them runs under the second (see `inside/sweeper.py`).
"""

import ctypes
import os
import pwd
import random
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from workbook.inside import RUN, proc
from workbook.inside.orphans import LONGEST_SWEEP_S, StillThere
from workbook.inside.sweeper import RANGES
from workbook.ros.scratch import remove_scratch

SHARED_FOLDERS = ("/tmp", "/var/tmp", "/dev/shm", "/run/lock")
SOCKET_PREFIX = "rclpy-workbook/user/"
_POLL_S = 0.002
_TRIES = 200
_IPC_REMOVE = 0


class NoIds(RuntimeError):
    """Raised when no user ID can be leased on this machine. The message says why."""


class Ids:
    """A leased pair of user IDs: `user` for programs, and `sweeper` for the process that kills them.

    `holder`: the socket that represents the lease, or None for a pair that isn't leased. The lease lasts until
    `release` is called or the socket is closed in another way.
    """

    def __init__(self, user: int, holder: socket.socket | None = None) -> None:
        self.user = user
        self.sweeper = user + 1
        self._holder = holder

    def release(self) -> None:
        """Release the lease. If it has already been released, do nothing."""
        if self._holder is not None:
            self._holder.close()
            self._holder = None

    def sweep(self) -> bool:
        """Kill all of `user`'s processes, and remove the user's files in shared folders and System V IPC objects.

        Return whether there were any processes. Raises StillThere if a process is still running after 20 s.
        """
        command = [sys.executable, "-I", "-S", str(RUN), "sweeper", str(self.user), str(self.sweeper)]
        found = bool(processes_of(self.user))
        deadline = time.monotonic() + LONGEST_SWEEP_S
        while True:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
            if done.returncode not in (
                0,
                -signal.SIGKILL,
            ):  # another sweeper of this user may have killed ours
                raise StillThere(
                    f"user {self.user} still has processes or files: {done.stderr.strip()[-200:]}"
                )
            left = processes_of(self.user)
            if not left:
                break
            if time.monotonic() > deadline:
                raise StillThere(f"processes of user {self.user} do not end: {left}")
            time.sleep(_POLL_S)
        remove_files_of(self.user)
        remove_shared_memory_of(self.user)
        return found


def lease_ids() -> Ids:
    """Lease a pair of unused user IDs until `release` is called or this process exits. Raises NoIds if it can't."""
    if os.geteuid() != 0:
        raise NoIds("only root can run programs under separate user ids")
    known = [one for one in RANGES if proc.knows_ids(*one)]
    if not known:
        raise NoIds("this container knows too few user ids (see /proc/self/uid_map)")
    first, count = known[0]
    taken = {owner for _, owner in proc.running_users()} | {account.pw_uid for account in pwd.getpwall()}
    for _ in range(_TRIES):
        user = first + 2 * random.randrange(count // 2)
        if taken & {user, user + 1}:
            continue
        holder = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)  # it only reserves its address
        try:
            holder.bind(f"\0{SOCKET_PREFIX}{user}")
        except OSError:
            holder.close()
            continue
        return Ids(user, holder)
    raise NoIds(f"the user ids from {first} on are taken")


def processes_of(user: int) -> list[int]:
    """Return the IDs of a user's running processes."""
    return [pid for pid, owner in proc.running_users() if owner == user]


def shared_folders() -> tuple[str, ...]:
    """Return this machine's folders that every user may write to."""
    return tuple({*SHARED_FOLDERS, tempfile.gettempdir()})


def remove_files_of(user: int) -> None:
    """Remove a user's files and folders from the folders that every user may write to."""
    for folder in shared_folders():
        try:
            entries = [*Path(folder).iterdir()]
        except OSError:
            continue
        for entry in entries:
            try:
                if entry.lstat().st_uid != user:
                    continue
                if entry.is_dir() and not entry.is_symlink():
                    remove_scratch(entry)
                else:
                    entry.unlink()
            except OSError:  # gone, or another user's mount, which even root may not access
                continue


def remove_shared_memory_of(user: int) -> None:
    """Remove a user's System V shared memory, semaphores, and message queues."""
    libc = ctypes.CDLL(None)
    removers = {
        "shmid": lambda number: libc.shmctl(number, _IPC_REMOVE, None),
        "semid": lambda number: libc.semctl(number, 0, _IPC_REMOVE),
        "msqid": lambda number: libc.msgctl(number, _IPC_REMOVE, None),
    }
    for table in ("shm", "sem", "msg"):
        for row in proc.system_v_ipc(table):
            if row["cuid"] == str(user):
                [name] = row.keys() & removers.keys()
                removers[name](int(row[name]))
