"""Refuse system calls of untrusted programs permanently, using the Linux kernel's seccomp filters."""

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
# System call numbers on x86_64, from arch/x86/entry/syscalls/syscall_64.tbl in Linux.
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
"""Calls whose objects count toward a machine-wide limit (/proc/sys/fs/aio-max-nr), which one answer could use up."""
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
"""Calls that use memory that no limit counts.

Such memory belongs to no process, or it stays allocated after a process has unmapped it.
"""
NEWS_OF_FILES = {"inotify_init": 253, "inotify_init1": 294, "fanotify_init": 300}
"""Calls that would report to a program when another process opens a file that both can see."""
LOCKS = {"flock": 73}
OF_ONE_PROCESS = {"prlimit64": 302}
SCHEDULING_OF_ONE = {
    "sched_setparam": 142,
    "sched_setscheduler": 144,
    "sched_setaffinity": 203,
    "sched_setattr": 314,
}
"""Calls whose first argument is the ID of the process that they change. Zero means the caller itself."""
SETPRIORITY, IOPRIO_SET = 141, 251
MMAP, SOCKET, SOCKETPAIR, SETSOCKOPT, FCNTL = 9, 41, 53, 54, 72
FAMILIES = {"AF_UNIX": 1, "AF_INET": 2, "AF_INET6": 10, "AF_NETLINK": 16}
"""The socket families that a node needs. With other families, such as AF_VSOCK, a program could reach other systems."""
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
"""All of a user's pipes share one limit on their total size.

If one answer used it up, other answers' new pipes would have room for only a page or two.
"""
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
"""One filter step: the operation, the numbers of steps to skip if its test succeeds or fails, and a value."""
STEP_BYTES = 8


class _Filter(ctypes.Structure):
    _fields_ = (("steps", ctypes.c_ushort), ("code", ctypes.c_void_p))


def knows_this_machine() -> bool:
    """Return whether the system call filter supports this machine's architecture."""
    return os.uname().machine == "x86_64" and sys.maxsize > 2**32


def filter_problem() -> str:
    """Return why no system call filter can be installed on this machine, as a clause, or "" if one can.

    To test that, we pass a null pointer as the filter. If the kernel lets this process install a filter, it tries to
    read the filter, which fails with EFAULT. Source: `seccomp(2)`, under `SECCOMP_SET_MODE_FILTER`.
    """
    if not knows_this_machine():
        return f"the filter does not know the system calls of this machine ({os.uname().machine})"
    libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, None, 0, 0)
    number = ctypes.get_errno()
    return "" if number == errno.EFAULT else f"this kernel refuses to install one ({os.strerror(number)})"


def one_of(argument: int, values: Iterable[int]) -> list[Step]:
    """Return steps that continue if the call's argument is one of the values, and otherwise allow the call."""
    jumps = [*values]
    tests = [(BPF_JUMP_IF_EQUAL, len(jumps) - i, 0, value) for i, value in enumerate(jumps)]
    return [_load(argument), *tests, (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]


def none_of(argument: int, values: Iterable[int]) -> list[Step]:
    """Return steps that continue if the call's argument is none of the values, and otherwise allow the call."""
    steps = [_load(argument)]
    for value in values:
        steps += [(BPF_JUMP_IF_EQUAL, 0, 1, value), (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]
    return steps


def all_bits(argument: int, *bits: int) -> list[Step]:
    """Return steps that continue if all these bits of the call's argument are set, and otherwise allow the call."""
    steps = [_load(argument)]
    for bit in bits:
        steps += [(BPF_JUMP_IF_ANY_BIT, 1, 0, bit), (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]
    return steps


def not_zero(*arguments: int) -> list[Step]:
    """Return steps that continue if at least one of the call's arguments isn't zero, and otherwise allow the call."""
    steps: list[Step] = []
    for position, argument in enumerate(arguments):
        behind = 2 * (len(arguments) - position) - 1
        steps += [_load(argument), (BPF_JUMP_IF_EQUAL, 0, behind, 0)]
    return [*steps, (BPF_RETURN, 0, 0, SECCOMP_ALLOW)]


def _load(argument: int) -> Step:
    """Return a step that loads the lower half of a call's argument.

    That's enough, because the kernel ignores the upper half of the arguments that we test.
    """
    return (BPF_LOAD_WORD, 0, 0, 16 + 8 * argument)


def case(number: int, error: int, *conditions: list[Step]) -> list[Step]:
    """Return steps that make the system call `number` fail with `error`.

    If `error` is 0, the call does nothing and reports success. If there are `conditions`, such as from `one_of`, the
    steps apply only if all conditions are true.
    """
    body = [step for condition in conditions for step in condition]
    body.append((BPF_RETURN, 0, 0, SECCOMP_ERRNO | error))
    return [(BPF_JUMP_IF_EQUAL, 0, len(body), number), *body]


def compiled(
    refused: Iterable[int], without_effect: Iterable[int] = (), cases: Iterable[list[Step]] = ()
) -> bytes:
    """Return a filter in the kernel's binary format, for `install` or for bubblewrap.

    The system calls with the numbers in `refused` fail with EPERM. The calls in `without_effect` do nothing and report
    success. `cases`: the rules for further calls (see `case`), at most one for each number.
    """
    steps: list[Step] = [
        (BPF_LOAD_WORD, 0, 0, 4),  # the architecture
        (BPF_JUMP_IF_EQUAL, 1, 0, ARCH_X86_64),
        (BPF_RETURN, 0, 0, SECCOMP_ERRNO | errno.ENOSYS),
        (BPF_LOAD_WORD, 0, 0, 0),  # the system call's number
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
    """Install a filter from `compiled` for this thread and its descendants.

    Call `drop_capabilities` or `forbid_new_rights` first. Raises OSError if the kernel doesn't support such filters.
    """
    code = ctypes.create_string_buffer(program, len(program))
    steps = _Filter(len(program) // STEP_BYTES, ctypes.addressof(code))
    checked("seccomp", libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.byref(steps), 0, 0))


def bounded_memory() -> list[list[Step]]:
    """Return cases for `compiled` that, together with UNCOUNTED_MEMORY, block memory that isn't counted.

    Shared memory without a file stays allocated as a whole as long as one of its pages is mapped. Unread bytes in a
    socket can use as much memory as the sender's buffer is large, so programs can't change the buffer's size.
    """
    families = FAMILIES.values()
    return [
        case(MMAP, errno.EPERM, all_bits(3, MAP_SHARED, MAP_ANONYMOUS)),
        case(SOCKET, errno.EAFNOSUPPORT, none_of(0, families)),
        case(SOCKETPAIR, errno.EAFNOSUPPORT, none_of(0, families)),
        case(SETSOCKOPT, 0, one_of(1, [SOL_SOCKET]), one_of(2, SEND_BUFFERS.values())),
    ]


def others_left_alone() -> list[list[Step]]:
    """Return cases for `compiled` that keep a program from changing other processes' limits and priorities.

    Those processes may belong to the same user, so a program could stop its judge by reducing the judge's CPU time.
    Libraries set their threads' scheduling by thread ID, so these calls must not fail: they do nothing and report
    success.
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
    """Compile a filter for calls with which programs could escape from sandboxes, communicate, or use uncounted memory.

    Sandboxes share the interpreter's files, so programs could communicate by locking or watching them. Therefore, no
    program may lock or watch a file. Sandboxes also share the machine's devices, which belong to root. If we run as
    root, an answer could change the devices' permissions and times, so the calls for that do nothing and report
    success. Return None if no filter can be installed. `filter_problem` returns the reason.
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
    """Install the filter from `against_sandbox_escapes` permanently. Raises OSError on failure.

    If `filter_problem` returns a reason, no filter is installed, and the answer's result reports that. The filter is
    only a second line of defense behind the sandbox's namespaces.
    """
    program = against_sandbox_escapes()
    if program is not None:
        install(program)


def filter_permission_changes() -> None:
    """Block calls that change files' permissions, owners, or times, affect processes, or use uncounted memory.

    Calls that change permissions, owners, or times report success, so that copying a file doesn't fail. Raises OSError.
    """
    refused = (OTHER_PROCESSES, KEYS, INTO_THE_KERNEL, UNCOUNTED_MEMORY, OF_THE_WHOLE_MACHINE)
    unchanged = numbers(PERMISSIONS, OWNERS, TIMES, ATTRIBUTES)
    cases = [*bounded_memory(), *others_left_alone(), case(FCNTL, errno.EPERM, one_of(1, PIPE_SIZE.values()))]
    install(compiled(numbers(*refused), unchanged, cases))


def filter_uncounted_memory() -> None:
    """Block the calls that use memory that no limit counts. Raises OSError on failure.

    If `filter_problem` returns a reason, no filter is installed, and the answer's result reports that.
    """
    if filter_problem():
        return
    cases = [*bounded_memory(), case(FCNTL, errno.EPERM, one_of(1, PIPE_SIZE.values()))]
    install(compiled(numbers(UNCOUNTED_MEMORY, OF_THE_WHOLE_MACHINE), (), cases))


def numbers(*groups: dict[str, int]) -> list[int]:
    """Return the numbers of the system calls in these groups, such as `KEYS`."""
    return [number for group in groups for number in group.values()]
