"""Determine, from a thread's system call, whether the thread sleeps for a time that it chose itself.

`time.sleep` makes one of the `nanosleep` calls. An event loop (asyncio, selectors, zmq) sleeps in `epoll_wait` or
`poll` with a numeric timeout. A futex wait with a timeout proves nothing, because rclpy itself waits like that.
"""

import os
from collections.abc import Callable, Sequence

SHORT_MS = 250
"""A `poll` with a longer timeout (ms) counts as rest.

Programs that spin nodes in one thread wait like that in another.
"""

Sleeps = Callable[[Sequence[bytes]], bool]


def _always(_: Sequence[bytes]) -> bool:
    return True


def _milliseconds(place: int) -> Sleeps:
    """Return a test for calls whose argument at index `place` is a timeout (ms). A negative timeout means forever."""
    return lambda arguments: int(arguments[place], 16) & 0xFFFFFFFF <= SHORT_MS


def _pointer(place: int) -> Sleeps:
    """Return a test for calls whose argument at index `place` points to a timeout, which we can't read.

    A null pointer means forever.
    """
    return lambda arguments: int(arguments[place], 16) != 0


_CALLS: dict[str, dict[bytes, Sleeps]] = {
    "x86_64": {
        b"35": _always,  # nanosleep
        b"230": _always,  # clock_nanosleep
        b"7": _milliseconds(2),  # poll
        b"232": _milliseconds(3),  # epoll_wait
        b"281": _milliseconds(3),  # epoll_pwait
        b"23": _pointer(4),  # select
        b"270": _pointer(4),  # pselect6
        b"271": _pointer(2),  # ppoll
    },
    "aarch64": {
        b"101": _always,  # nanosleep
        b"115": _always,  # clock_nanosleep
        b"22": _milliseconds(3),  # epoll_pwait
        b"72": _pointer(4),  # pselect6
        b"73": _pointer(2),  # ppoll
    },
}
CALLS = _CALLS.get(os.uname().machine, {})
"""Maps a call's number to a test of its arguments: does the thread soon continue by itself?

Empty for any other kind of machine.
"""


def goes_on_by_itself(call: bytes) -> bool:
    """Return whether a thread in this system call soon continues by itself. `call`: the call's number and arguments."""
    number, *arguments = call.split() or [b""]
    return number in CALLS and len(arguments) > 4 and CALLS[number](arguments)
