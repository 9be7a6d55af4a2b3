"""Refusing system calls for good: seccomp filters for programs that are not trusted."""

import ctypes
import errno
import os
import struct
import sys
from collections.abc import Iterable

from workbook.inside.libc import checked, libc

PR_SET_SECCOMP = 22
SECCOMP_MODE_FILTER = 2
SECCOMP_ALLOW = 0x7FFF0000
SECCOMP_ERRNO = 0x00050000
BPF_LOAD_WORD, BPF_JUMP_IF_EQUAL, BPF_JUMP_IF_AT_LEAST, BPF_RETURN = 0x20, 0x15, 0x35, 0x06
BPF_JUMP_IF_ANY_BIT = 0x45
ARCH_X86_64 = 0xC000003E
X32_SYSCALLS = 0x40000000
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
OF_THE_WHOLE_MACHINE = {"io_setup": 206}
"""What they make counts against one figure of the machine, which one answer could use up (/proc/sys/fs/aio-max-nr)."""
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
    "syslog": 103,
    "open_by_handle_at": 304,
    "finit_module": 313,
    "kexec_file_load": 320,
}
UNCOUNTED_MEMORY = {
    "shmget": 29,
    "semget": 64,
    "msgget": 68,
    "mq_open": 240,
    "splice": 275,
    "tee": 276,
    "vmsplice": 278,
    "memfd_create": 319,
    "memfd_secret": 447,
}
"""Memory that no process holds, or that stays when a process has unmapped it: no limit counts it."""
NEWS_OF_FILES = {"inotify_init": 253, "inotify_init1": 294, "fanotify_init": 300}
"""Who opens a file can be heard in every sandbox that sees it."""
LOCKS = {"flock": 73}
OF_ONE_PROCESS = {"prlimit64": 302}
SCHEDULING_OF_ONE = {
    "sched_setparam": 142,
    "sched_setscheduler": 144,
    "sched_setaffinity": 203,
    "sched_setattr": 314,
}
"""Calls whose first argument says which process they change; zero is the caller itself."""
SETPRIORITY, IOPRIO_SET = 141, 251
MMAP, SOCKET, SOCKETPAIR, SETSOCKOPT, FCNTL = 9, 41, 53, 54, 72
FAMILIES = {"AF_UNIX": 1, "AF_INET": 2, "AF_INET6": 10, "AF_NETLINK": 16}
"""The sockets that a node needs. With others (AF_VSOCK is one) a program reaches what is around the machine."""
MAP_SHARED, MAP_ANONYMOUS = 0x01, 0x20
SOL_SOCKET = 1
SEND_BUFFERS = {"SO_SNDBUF": 7, "SO_SNDBUFFORCE": 32}
FILE_LOCKS = {
    "F_GETLK": 5,
    "F_SETLK": 6,
    "F_SETLKW": 7,
    "F_OFD_GETLK": 36,
    "F_OFD_SETLK": 37,
    "F_OFD_SETLKW": 38,
    "F_SETLEASE": 1024,
    "F_NOTIFY": 1026,
}
PIPE_SIZE = {"F_SETPIPE_SZ": 1031}
"""All pipes of a user share one figure: beyond it, those of other answers hold a page or two."""
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


Step = tuple[int, int, int, int]
"""One step of a filter: the operation, how many steps to jump if it holds and if not, and a number."""
STEP_BYTES = 8


class _Filter(ctypes.Structure):
    _fields_ = (("steps", ctypes.c_ushort), ("code", ctypes.c_void_p))


def knows_this_machine() -> bool:
    """Whether the filter of system calls knows this kind of machine."""
    return os.uname().machine == "x86_64" and sys.maxsize > 2**32


def filter_problem() -> str:
    """Return why no filter of system calls can be installed on this machine, as a clause; empty if one can.

    A kernel that has filters and lets a process install them looks at the filter first, and here there is none to look
    at (EFAULT). Source: `seccomp(2)`, under `SECCOMP_SET_MODE_FILTER`.
    """
    if not knows_this_machine():
        return f"the filter does not know the system calls of this machine ({os.uname().machine})"
    libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, None, 0, 0)
    number = ctypes.get_errno()
    return "" if number == errno.EFAULT else f"this kernel refuses to install one ({os.strerror(number)})"


def one_of(argument: int, values: Iterable[int]) -> list[Step]:
    """Go on if the argument with this number is one of the values; else let the call through."""
    jumps = [*values]
    tests = [(BPF_JUMP_IF_EQUAL, len(jumps) - i, 0, value) for i, value in enumerate(jumps)]
    return [_load(argument), *tests, (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]


def none_of(argument: int, values: Iterable[int]) -> list[Step]:
    """Go on if the argument with this number is none of the values; else let the call through."""
    steps = [_load(argument)]
    for value in values:
        steps += [(BPF_JUMP_IF_EQUAL, 0, 1, value), (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]
    return steps


def all_bits(argument: int, *bits: int) -> list[Step]:
    """Go on if all these bits of the argument with this number are set; else let the call through."""
    steps = [_load(argument)]
    for bit in bits:
        steps += [(BPF_JUMP_IF_ANY_BIT, 1, 0, bit), (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]
    return steps


def not_zero(*arguments: int) -> list[Step]:
    """Go on if one of the arguments with these numbers is not zero; else let the call through."""
    steps: list[Step] = []
    for position, argument in enumerate(arguments):
        behind = 2 * (len(arguments) - position) - 1
        steps += [_load(argument), (BPF_JUMP_IF_EQUAL, 0, behind, 0)]
    return [*steps, (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]


def _load(argument: int) -> Step:
    """Load the lower half of an argument of the call: all of what the kernel reads of those that are looked at here."""
    return (BPF_LOAD_WORD, 0, 0, 16 + 8 * argument)


def case(number: int, error: int, *conditions: list[Step]) -> list[Step]:
    """Steps that make the call with this number fail with `error` (0: do nothing and report success).

    With `conditions` only if all of them hold.
    """
    body = [step for condition in conditions for step in condition]
    body.append((BPF_RETURN, 0, 0, SECCOMP_ERRNO | error))
    return [(BPF_JUMP_IF_EQUAL, 0, len(body), number), *body]


def compiled(
    refused: Iterable[int], without_effect: Iterable[int] = (), cases: Iterable[list[Step]] = ()
) -> bytes:
    """Return a filter as the kernel reads it, for `install` or for bubblewrap.

    The system calls in `refused` fail, and those in `without_effect` do nothing and report success; by number. `cases`:
    more of both, see `case`; one for each number.
    """
    steps: list[Step] = [
        (BPF_LOAD_WORD, 0, 0, 4),  # the architecture
        (BPF_JUMP_IF_EQUAL, 1, 0, ARCH_X86_64),
        (BPF_RETURN, 0, 0, SECCOMP_ERRNO | errno.ENOSYS),
        (BPF_LOAD_WORD, 0, 0, 0),  # the number of the call
        (BPF_JUMP_IF_AT_LEAST, 0, 1, X32_SYSCALLS),
        (BPF_RETURN, 0, 0, SECCOMP_ERRNO | errno.ENOSYS),
    ]
    everything = [case(number, 0) for number in without_effect]
    everything += [case(number, errno.EPERM) for number in refused]
    for one in (*everything, *cases):
        steps += one
    steps.append((BPF_RETURN, 0, 0, SECCOMP_ALLOW))
    return b"".join(struct.pack("=HBBI", *step) for step in steps)


def install(program: bytes) -> None:
    """Filter the system calls of this thread, and of all that it becomes and starts, by what `compiled` returned.

    Needs `drop_capabilities`, or what comes to the same. Raises OSError where the kernel has no such filters.
    """
    code = ctypes.create_string_buffer(program, len(program))
    steps = _Filter(len(program) // STEP_BYTES, ctypes.addressof(code))
    checked("seccomp", libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.byref(steps), 0, 0))


def bounded_memory() -> list[list[Step]]:
    """Cases that keep memory where limits count it, for `compiled`, along with UNCOUNTED_MEMORY.

    Shared memory without a file stays as a whole while one page of it is mapped. What is sent to a socket that nobody
    reads is held for its sender, as much as the send buffer takes: it keeps the size that the machine gives to each.
    """
    families = FAMILIES.values()
    return [
        case(MMAP, errno.EPERM, all_bits(3, MAP_SHARED, MAP_ANONYMOUS)),
        case(SOCKET, errno.EAFNOSUPPORT, none_of(0, families)),
        case(SOCKETPAIR, errno.EAFNOSUPPORT, none_of(0, families)),
        case(SETSOCKOPT, 0, one_of(1, [SOL_SOCKET]), one_of(2, SEND_BUFFERS.values())),
    ]


def others_left_alone() -> list[list[Step]]:
    """Cases that keep a program from changing limits and priorities of other processes, for `compiled`.

    They may belong to the same user: with a limit of no processor time, a program would end its judge. Libraries set
    the scheduling of their own threads by number, so that comes to nothing and is no error.
    """
    limits = [case(number, errno.EPERM, not_zero(0)) for number in OF_ONE_PROCESS.values()]
    scheduling = [case(number, 0, not_zero(0)) for number in SCHEDULING_OF_ONE.values()]
    return [
        *limits,
        *scheduling,
        case(SETPRIORITY, errno.EPERM, not_zero(0, 1)),
        case(IOPRIO_SET, errno.EPERM),
    ]


def against_sandbox_escapes() -> bytes | None:
    """Compile a filter against the calls with which programs have escaped from sandboxes, met in two, or hidden memory.

    Sandboxes share the files of the interpreter, so no file is locked or followed. The devices in a sandbox are those
    of the machine, and belong to root. If the grader is root, an answer could change their permissions and times, so it
    may only believe that it does. Returns None where `filter_problem` says why there is none.
    """
    if filter_problem():
        return None
    refused = (OTHER_PROCESSES, KEYS, INTO_THE_KERNEL, NAME_SPACES, MOUNTING, THE_MACHINE, ATTRIBUTES)
    owns_devices = os.stat(os.devnull).st_uid == os.getuid()
    believed = numbers(PERMISSIONS, OWNERS, TIMES) if owns_devices else ()
    cases = [
        *bounded_memory(),
        case(FCNTL, errno.EPERM, one_of(1, [*FILE_LOCKS.values(), *PIPE_SIZE.values()])),
    ]
    uncounted = (UNCOUNTED_MEMORY, OF_THE_WHOLE_MACHINE)
    return compiled(numbers(*refused, *uncounted, LOCKS, NEWS_OF_FILES), believed, cases)


def filter_sandbox_escapes() -> None:
    """Refuse what `against_sandbox_escapes` says, for good. Raises OSError.

    It is left out where `filter_problem` says why, which the result of the answer reports: it is a second line of
    defense behind the name spaces of the sandbox.
    """
    program = against_sandbox_escapes()
    if program is not None:
        install(program)


def filter_permission_changes() -> None:
    """Let no call through that changes permissions, owners or times of files, or meddles with other processes.

    Those of the first kind say that all went well, so that a copied file is no error. Raises OSError.
    """
    refused = (OTHER_PROCESSES, KEYS, INTO_THE_KERNEL, UNCOUNTED_MEMORY, OF_THE_WHOLE_MACHINE)
    unchanged = numbers(PERMISSIONS, OWNERS, TIMES, ATTRIBUTES)
    cases = [*bounded_memory(), *others_left_alone(), case(FCNTL, errno.EPERM, one_of(1, PIPE_SIZE.values()))]
    install(compiled(numbers(*refused), unchanged, cases))


def filter_uncounted_memory() -> None:
    """Let no call through that makes memory which no limit counts. Raises OSError.

    It is left out where `filter_problem` says why, which the result of the answer reports.
    """
    if filter_problem():
        return
    cases = [*bounded_memory(), case(FCNTL, errno.EPERM, one_of(1, PIPE_SIZE.values()))]
    install(compiled(numbers(UNCOUNTED_MEMORY, OF_THE_WHOLE_MACHINE), (), cases))


def numbers(*groups: dict[str, int]) -> list[int]:
    """The numbers of the calls in some groups."""
    return [number for group in groups for number in group.values()]
