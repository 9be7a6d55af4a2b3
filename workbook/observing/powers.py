"""Giving up powers for good: capabilities, and system calls that no node needs.

It needs nothing of the workbook, only the standard library: programs that shut others in load it by its path.
"""

import ctypes
import errno
import os
import struct
import sys
from collections.abc import Iterable

PR_SET_DUMPABLE = 4
PR_SET_SECCOMP = 22
PR_CAPBSET_DROP = 24
PR_SET_NO_NEW_PRIVS = 38
PR_CAP_AMBIENT = 47
PR_CAP_AMBIENT_CLEAR_ALL = 4
CAPABILITY_VERSION_3 = 0x20080522
CAPABILITIES = 64

SECCOMP_MODE_FILTER = 2
SECCOMP_ALLOW = 0x7FFF0000
SECCOMP_ERRNO = 0x00050000
BPF_LOAD_WORD, BPF_JUMP_IF_EQUAL, BPF_JUMP_IF_AT_LEAST, BPF_RETURN = 0x20, 0x15, 0x35, 0x06
ARCH_X86_64 = 0xC000003E
CALLS_OF_X32 = 0x40000000
# The numbers of the calls on x86_64: arch/x86/entry/syscalls/syscall_64.tbl in Linux.
OTHER_PROCESSES = {
    "ptrace": 101,
    "process_vm_readv": 310,
    "process_vm_writev": 311,
    "kcmp": 312,
    "pidfd_getfd": 438,
}
KEYS = {"add_key": 248, "request_key": 249, "keyctl": 250}
INTO_THE_KERNEL = {
    "perf_event_open": 298,
    "bpf": 321,
    "userfaultfd": 323,
    "io_uring_setup": 425,
    "io_uring_enter": 426,
    "io_uring_register": 427,
}
NAME_SPACES = {"unshare": 272, "setns": 308}
MOUNTING = {
    "pivot_root": 155,
    "mount": 165,
    "umount2": 166,
    "open_tree": 428,
    "move_mount": 429,
    "fsopen": 430,
    "fsconfig": 431,
    "fsmount": 432,
    "fspick": 433,
    "mount_setattr": 442,
}
THE_MACHINE = {
    "acct": 163,
    "swapon": 167,
    "swapoff": 168,
    "reboot": 169,
    "init_module": 175,
    "delete_module": 176,
    "kexec_load": 246,
    "open_by_handle_at": 304,
    "finit_module": 313,
    "kexec_file_load": 320,
}
SYSTEM_V_IPC = {"shmget": 29, "semget": 64, "msgget": 68}
PERMISSIONS = {"chmod": 90, "fchmod": 91, "fchmodat": 268, "fchmodat2": 452}
OWNERS = {"chown": 92, "fchown": 93, "lchown": 94, "fchownat": 260}
TIMES = {"utime": 132, "utimes": 235, "futimesat": 261, "utimensat": 280}
ATTRIBUTES = {
    "setxattr": 188,
    "lsetxattr": 189,
    "fsetxattr": 190,
    "removexattr": 197,
    "lremovexattr": 198,
    "fremovexattr": 199,
    "setxattrat": 463,
    "removexattrat": 466,
    "file_setattr": 469,
}

_libc = ctypes.CDLL(None, use_errno=True)


class _Filter(ctypes.Structure):
    _fields_ = (("steps", ctypes.c_ushort), ("code", ctypes.c_void_p))


def checked(what: str, result: int) -> int:
    """The result of a call into the C library. Raises OSError, with `what` was tried, when it has failed."""
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{what}: {os.strerror(number)}")
    return result


def close_the_bounds() -> None:
    """No program that this one becomes can gain a capability."""
    for capability in range(CAPABILITIES):
        _libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)  # only root may, and only root needs it


def be_powerless() -> None:
    """Drop what capabilities a thread still holds; set-user-id programs will not help it."""
    _libc.prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0)
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    checked("capset", _libc.capset(header, (ctypes.c_uint32 * 6)()))
    checked("no_new_privs", _libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def be_seen() -> None:
    """Changed powers hide a process from others of its user, and from itself. Be one like any other."""
    checked("dumpable", _libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0))


def filters_calls() -> bool:
    """Whether the filter of system calls knows this kind of machine."""
    return os.uname().machine == "x86_64" and sys.maxsize > 2**32


def filter_calls(refused: Iterable[int], without_effect: Iterable[int] = ()) -> None:
    """Refuse system calls, and let others do nothing and say that all went well. Both by their numbers.

    For this thread and all that it becomes and starts. Needs `be_powerless`, or what comes to the same. Raises OSError
    where the kernel has no such filters.
    """
    calls = [(number, SECCOMP_ERRNO) for number in without_effect]
    calls += [(number, SECCOMP_ERRNO | errno.EPERM) for number in refused]
    steps = [
        (BPF_LOAD_WORD, 0, 0, 4),  # the architecture
        (BPF_JUMP_IF_EQUAL, 1, 0, ARCH_X86_64),
        (BPF_RETURN, 0, 0, SECCOMP_ERRNO | errno.ENOSYS),
        (BPF_LOAD_WORD, 0, 0, 0),  # the number of the call
        (BPF_JUMP_IF_AT_LEAST, 0, 1, CALLS_OF_X32),
        (BPF_RETURN, 0, 0, SECCOMP_ERRNO | errno.ENOSYS),
    ]
    for number, outcome in calls:
        steps += [(BPF_JUMP_IF_EQUAL, 0, 1, number), (BPF_RETURN, 0, 0, outcome)]
    steps.append((BPF_RETURN, 0, 0, SECCOMP_ALLOW))
    code = ctypes.create_string_buffer(b"".join(struct.pack("=HBBI", *step) for step in steps))
    program = _Filter(len(steps), ctypes.addressof(code))
    checked("seccomp", _libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.byref(program), 0, 0))


def fence() -> None:
    """Refuse the calls that programs have got out of boxes with.

    The devices in a box are those of the machine, and belong to root. If the grader is root, an answer could change
    their permissions, so it may only believe that it does. A kernel that has no filters leaves this out: it is a second
    fence behind that of the box.
    """
    if not filters_calls():
        return
    refused = (OTHER_PROCESSES, KEYS, INTO_THE_KERNEL, NAME_SPACES, MOUNTING, THE_MACHINE, ATTRIBUTES)
    owns_devices = os.stat(os.devnull).st_uid == os.getuid()
    try:
        filter_calls(numbers(*refused), numbers(PERMISSIONS) if owns_devices else ())
    except OSError:
        return


def keep_permissions() -> None:
    """Let no call through that changes permissions, owners or times of files, or looks into other processes.

    Those of the first kind say that all went well, so that a copied file is no error. Raises OSError.
    """
    refused = (OTHER_PROCESSES, KEYS, INTO_THE_KERNEL, SYSTEM_V_IPC)
    filter_calls(numbers(*refused), numbers(PERMISSIONS, OWNERS, TIMES, ATTRIBUTES))


def numbers(*groups: dict[str, int]) -> list[int]:
    """The numbers of the calls in some groups."""
    return [number for group in groups for number in group.values()]
