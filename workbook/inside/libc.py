"""Call functions of the C library that Python doesn't provide."""

import ctypes
import os
import signal

PR_SET_PDEATHSIG = 1

libc = ctypes.CDLL(None, use_errno=True)


def checked(what: str, result: int) -> int:
    """Return the result of a C library call. If it failed, raise OSError with `what` as its description."""
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{what}: {os.strerror(number)}")
    return result


def set_parent_death_signal(number: signal.Signals = signal.SIGKILL) -> None:
    """Make the kernel send the signal `number` to this process when the thread that started this process finishes."""
    libc.prctl(PR_SET_PDEATHSIG, number, 0, 0, 0)


def die_with_parent(parent: int) -> None:
    """Make the kernel kill this process when its parent process `parent` exits.

    If the parent has already exited, exit right away.
    """
    set_parent_death_signal()
    if os.getppid() != parent:
        os._exit(1)
