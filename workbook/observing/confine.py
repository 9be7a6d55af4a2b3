"""Shuts this process in and becomes another program. Needs nothing of the workbook, only the standard library.

    python -I -S confine.py [--user ID] [--processes N] [--read PATH]... [--write PATH]... -- COMMAND...

Whatever is asked for, capabilities and ways to new ones are given up. `--user` takes an id (and the group of the same
number) that no account needs to have. With any `--read` or `--write` Landlock hides all other files, and keeps signals
and TCP connections inside, as far as this kernel knows how (`landlock_abi`). Without `--user`, a filter of system calls
then does what Landlock does not: it keeps the permissions of the user's files as they are (`filters_calls`).
"""

import ctypes
import errno
import os
import resource
import stat
import struct
import sys

PR_SET_NO_NEW_PRIVS = 38
PR_CAPBSET_DROP = 24
PR_CAP_AMBIENT = 47
PR_CAP_AMBIENT_CLEAR_ALL = 4
CAPABILITY_VERSION_3 = 0x20080522
CAPABILITIES = 64

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

PR_SET_SECCOMP = 22
SECCOMP_MODE_FILTER = 2
SECCOMP_ALLOW = 0x7FFF0000
SECCOMP_ERRNO = 0x00050000
BPF_LOAD_WORD, BPF_JUMP_IF_EQUAL, BPF_JUMP_IF_AT_LEAST, BPF_RETURN = 0x20, 0x15, 0x35, 0x06
ARCH_X86_64 = 0xC000003E
CALLS_OF_X32 = 0x40000000
CALLS_WITHOUT_EFFECT = (
    *(90, 91, 92, 93, 94, 260, 268, 452),  # chmod, chown and their kin
    *(132, 235, 261, 280),  # utime and its kin
    *(188, 189, 190, 197, 198, 199, 463, 466, 469),  # setxattr, removexattr and their kin, file_setattr
)
"""By their numbers on x86_64. They say that all went well, so that a copied file is no error."""
REFUSED_CALLS = (
    *(29, 64, 68),  # shmget, semget, msgget: what they make outlives a program
    *(101, 310, 311),  # ptrace, process_vm_readv, process_vm_writev
    *(248, 249, 250),  # keys
    *(298, 321, 323, 425),  # perf_event_open, bpf, userfaultfd, io_uring_setup
)

_libc = ctypes.CDLL(None, use_errno=True)


class _Ruleset(ctypes.Structure):
    _fields_ = (("files", ctypes.c_uint64), ("tcp", ctypes.c_uint64), ("scopes", ctypes.c_uint64))


class _Filter(ctypes.Structure):
    _fields_ = (("steps", ctypes.c_ushort), ("code", ctypes.c_void_p))


def _call(what: str, result: int) -> int:
    """Raises OSError when a system call has failed."""
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{what}: {os.strerror(number)}")
    return result


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


def close_the_bounds() -> None:
    """No program that this one becomes can gain a capability."""
    for capability in range(CAPABILITIES):
        _libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)  # only root may, and only root needs it


def be_powerless() -> None:
    """Drop what capabilities a process still holds; set-user-id programs will not help it."""
    _libc.prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0)
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    _call("capset", _libc.capset(header, (ctypes.c_uint32 * 6)()))
    _call("no_new_privs", _libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def _allow(ruleset: int, path: str, rights: int) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except FileNotFoundError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(place).st_mode):
            rights &= FILE_RIGHTS
        rule = struct.pack("=Qi", rights, place)  # struct landlock_path_beneath_attr, which is packed
        _call(
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
    ruleset = _call(
        "Landlock",
        _libc.syscall(SYS_LANDLOCK_CREATE_RULESET, ctypes.byref(asked), ctypes.c_size_t(size), 0),
    )
    try:
        for path in [*read, f"/proc/{os.getpid()}"]:
            _allow(ruleset, path, (EXECUTE | READ_FILE | READ_DIR) & files)
        for path in write:
            _allow(ruleset, path, files & ~MAKE_DEVICES)
        _call("Landlock", _libc.syscall(SYS_LANDLOCK_RESTRICT_SELF, ruleset, 0))
    finally:
        os.close(ruleset)


def filters_calls() -> bool:
    """Whether the filter of system calls knows this kind of machine."""
    return os.uname().machine == "x86_64" and sys.maxsize > 2**32


def filter_calls() -> None:
    """Let no call through that changes permissions, owners or times of files, or looks into other processes.

    For good, and for all that this process becomes and starts. Needs `be_powerless`.
    """
    calls = [(number, SECCOMP_ERRNO) for number in CALLS_WITHOUT_EFFECT]
    calls += [(number, SECCOMP_ERRNO | errno.EPERM) for number in REFUSED_CALLS]
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
    _call("seccomp", _libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.byref(program), 0, 0))


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
        close_the_bounds()
        for user in asked["--user"]:
            become(int(user))
        be_powerless()
        if asked["--read"] or asked["--write"]:
            see_only(asked["--read"], asked["--write"])
            if not asked["--user"] and filters_calls():
                filter_calls()
        os.execv(arguments[1], arguments[1:])
    except OSError as error:
        print(f"the program could not be shut in: {error}", file=sys.stderr, flush=True)
        os._exit(FAILED)


if __name__ == "__main__":
    start(sys.argv[1:])
