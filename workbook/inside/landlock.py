"""Hide the machine's files from this process permanently, using the Linux kernel's Landlock."""

import ctypes
import os
import stat
import struct

from workbook.inside.libc import checked, libc

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
"""The number of file rights in each Landlock version. Versions after 5 have at least the rights of version 5."""
TCP_RIGHTS = 0b11
SCOPES = 0b11
"""The bits that block signals to processes outside the sandbox, and connections to their abstract Unix sockets."""


class _Ruleset(ctypes.Structure):
    _fields_ = (("files", ctypes.c_uint64), ("tcp", ctypes.c_uint64), ("scopes", ctypes.c_uint64))


def landlock_abi() -> int:
    """Return the Landlock version that this kernel supports, or 0 if Landlock is missing or disabled."""
    version = libc.syscall(
        SYS_LANDLOCK_CREATE_RULESET, None, ctypes.c_size_t(0), LANDLOCK_CREATE_RULESET_VERSION
    )
    return max(0, int(version))


def _allow(ruleset: int, path: str, rights: int) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except FileNotFoundError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(place).st_mode):
            rights &= FILE_RIGHTS
        rule = struct.pack("=Qi", rights, place)  # struct landlock_path_beneath_attr, without padding
        checked(
            f"Landlock and {path}",
            libc.syscall(SYS_LANDLOCK_ADD_RULE, ruleset, LANDLOCK_RULE_PATH_BENEATH, rule, 0),
        )
    finally:
        os.close(place)


def restrict_to(read: list[str], write: list[str]) -> None:
    """Hide all files permanently, except those at or below the paths in `read` and `write`.

    If the kernel supports it, also block TCP connections and signals to processes outside the sandbox, which consists
    of this process and its descendants. Call `drop_capabilities` first. Raises OSError if the kernel has no Landlock.
    """
    abi = landlock_abi()
    if abi == 0:
        raise OSError("this kernel has no Landlock")
    files = (1 << FS_RIGHTS_OF_ABI.get(abi, 16)) - 1
    asked = _Ruleset(files, TCP_RIGHTS if abi >= ABI_OF_TCP else 0, SCOPES if abi >= ABI_OF_SIGNALS else 0)
    size = 24 if abi >= ABI_OF_SIGNALS else 16 if abi >= ABI_OF_TCP else 8
    ruleset = checked(
        "Landlock",
        libc.syscall(SYS_LANDLOCK_CREATE_RULESET, ctypes.byref(asked), ctypes.c_size_t(size), 0),
    )
    try:
        for path in [*read, f"/proc/{os.getpid()}"]:
            _allow(ruleset, path, (EXECUTE | READ_FILE | READ_DIR) & files)
        for path in write:
            _allow(ruleset, path, files & ~MAKE_DEVICES)
        checked("Landlock", libc.syscall(SYS_LANDLOCK_RESTRICT_SELF, ruleset, 0))
    finally:
        os.close(ruleset)
