"""Calls into the C library that Python has no function for."""

import ctypes
import os
import signal

PR_SET_PDEATHSIG = 1

libc = ctypes.CDLL(None, use_errno=True)


def checked(what: str, result: int) -> int:
    """The result of a call into the C library. Raises OSError, with `what` was tried, when it has failed."""
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{what}: {os.strerror(number)}")
    return result


def set_parent_death_signal(number: signal.Signals = signal.SIGKILL) -> None:
    """Have the kernel send `number` to this process when the thread that started it ends."""
    libc.prctl(PR_SET_PDEATHSIG, number, 0, 0, 0)


def die_with_parent(parent: int) -> None:
    """Be killed when the process `parent` ends; end at once if it has ended already."""
    set_parent_death_signal()
    if os.getppid() != parent:
        os._exit(1)
