"""Shuts this process in and becomes another program. Needs nothing of the workbook, only the standard library.

    python -I -S confine.py [--user ID] [--processes N] [--read PATH]... [--write PATH]... -- COMMAND...

Whatever is asked for, capabilities and ways to new ones are given up. `--user` takes an id (and the group of the same
number) that no account needs to have. With any `--read` or `--write` Landlock hides all other files, and keeps signals
and TCP connections inside, as far as this kernel knows how (`landlock_abi`). Without `--user`, a filter of system calls
then does what Landlock does not: it keeps the permissions of the user's files as they are (`filters_calls`).
"""

import ctypes
import importlib
import os
import resource
import stat
import struct
import sys
from pathlib import Path

if __name__ == "__main__":  # started by its path, without the workbook
    sys.path.insert(0, str(Path(__file__).parent))
powers = importlib.import_module("powers" if __name__ == "__main__" else "workbook.observing.powers")

SYS_LANDLOCK_CREATE_RULESET = 444
SYS_LANDLOCK_ADD_RULE = 445
SYS_LANDLOCK_RESTRICT_SELF = 446
LANDLOCK_CREATE_RULESET_VERSION = 1
LANDLOCK_RULE_PATH_BENEATH = 1
ABI_OF_TCP = 4
ABI_OF_SIGNALS = 6
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
MAKE_DEVICES = 1 << 6 | 1 << 11
TRUNCATE, IOCTL_DEV = 1 << 14, 1 << 15
FILE_RIGHTS = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL_DEV
FS_RIGHTS_OF_ABI = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}
"""How many rights over files each version of Landlock knows; later versions know those of the last one here."""
TCP_RIGHTS = 0b11
SCOPES = 0b11
"""Signals, and sockets with abstract names."""
FAILED = 126

_libc = ctypes.CDLL(None, use_errno=True)


class _Ruleset(ctypes.Structure):
    _fields_ = (("files", ctypes.c_uint64), ("tcp", ctypes.c_uint64), ("scopes", ctypes.c_uint64))


def landlock_abi() -> int:
    """The version of Landlock that this kernel speaks; 0 where there is none, or where it is switched off."""
    version = _libc.syscall(
        SYS_LANDLOCK_CREATE_RULESET, None, ctypes.c_size_t(0), LANDLOCK_CREATE_RULESET_VERSION
    )
    return max(0, int(version))


def become(user: int) -> None:
    """Take a user id and the group of the same number, and no other group, for good."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)


def _allow(ruleset: int, path: str, rights: int) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except FileNotFoundError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(place).st_mode):
            rights &= FILE_RIGHTS
        rule = struct.pack("=Qi", rights, place)  # struct landlock_path_beneath_attr, which is packed
        powers.checked(
            f"Landlock and {path}",
            _libc.syscall(SYS_LANDLOCK_ADD_RULE, ruleset, LANDLOCK_RULE_PATH_BENEATH, rule, 0),
        )
    finally:
        os.close(place)


def see_only(read: list[str], write: list[str]) -> None:
    """Hide all files but these, for good; keep signals and TCP inside where the kernel can. Needs `be_powerless`.

    Raises OSError where there is no Landlock.
    """
    abi = landlock_abi()
    if abi == 0:
        raise OSError("this kernel has no Landlock")
    files = (1 << FS_RIGHTS_OF_ABI.get(abi, 16)) - 1
    asked = _Ruleset(files, TCP_RIGHTS if abi >= ABI_OF_TCP else 0, SCOPES if abi >= ABI_OF_SIGNALS else 0)
    size = 24 if abi >= ABI_OF_SIGNALS else 16 if abi >= ABI_OF_TCP else 8
    ruleset = powers.checked(
        "Landlock",
        _libc.syscall(SYS_LANDLOCK_CREATE_RULESET, ctypes.byref(asked), ctypes.c_size_t(size), 0),
    )
    try:
        for path in [*read, f"/proc/{os.getpid()}"]:
            _allow(ruleset, path, (EXECUTE | READ_FILE | READ_DIR) & files)
        for path in write:
            _allow(ruleset, path, files & ~MAKE_DEVICES)
        powers.checked("Landlock", _libc.syscall(SYS_LANDLOCK_RESTRICT_SELF, ruleset, 0))
    finally:
        os.close(ruleset)


def limit_processes(most: int) -> None:
    """Threads and processes of this user, all together."""
    _, hard = resource.getrlimit(resource.RLIMIT_NPROC)
    wanted = most if hard == resource.RLIM_INFINITY else min(most, hard)
    resource.setrlimit(resource.RLIMIT_NPROC, (wanted, wanted))


def start(arguments: list[str]) -> None:
    """Do as the command line says. Ends with code 126 and a sentence when that is not possible."""
    asked: dict[str, list[str]] = {"--user": [], "--processes": [], "--read": [], "--write": []}
    while arguments[0] != "--":
        asked[arguments[0]].append(arguments[1])
        arguments = arguments[2:]
    try:
        os.umask(0o077)
        resource.setrlimit(resource.RLIMIT_MSGQUEUE, (0, 0))
        for most in asked["--processes"]:
            limit_processes(int(most))
        powers.close_the_bounds()
        for user in asked["--user"]:
            become(int(user))
        powers.be_powerless()
        if asked["--read"] or asked["--write"]:
            see_only(asked["--read"], asked["--write"])
            if not asked["--user"] and powers.filters_calls():
                powers.keep_permissions()
        os.execv(arguments[1], arguments[1:])
    except OSError as error:
        print(f"the program could not be shut in: {error}", file=sys.stderr, flush=True)
        os._exit(FAILED)


if __name__ == "__main__":
    start(sys.argv[1:])
