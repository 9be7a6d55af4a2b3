"""Notify LTTng when this process is forked. LTTng is a tracing library that rclpy's wheels load."""

import ctypes
import os

from workbook.inside.proc import mapped_libraries

SIGSET_BYTES = 128


class LttngForkHooks:
    """Notifies LTTng of each fork.

    LTTng has two threads, which a forked process doesn't inherit. LTTng's `liblttng-ust-fork` has functions to call
    before and after a fork. Without those calls, LTTng would cancel the wrong threads when the program exits, and the
    program might hang.
    """

    def __init__(self) -> None:
        paths = mapped_libraries("liblttng-ust-") | mapped_libraries("liblttng-ust.so")
        libraries = [ctypes.CDLL(path) for path in sorted(paths)]
        self._library = next((one for one in libraries if hasattr(one, "ust_before_fork")), None)
        self._signals = ctypes.create_string_buffer(SIGSET_BYTES)

    def fork(self) -> int:
        """Fork as `os.fork` does. The child must call `after_fork_in_program`. Raises OSError if the fork fails."""
        if self._library is not None:
            self._library.ust_before_fork(self._signals)  # blocks all signals
        pid = -1
        try:
            pid = os.fork()
        finally:
            if pid != 0 and self._library is not None:
                self._library.ust_after_fork_parent(self._signals)
        return pid

    def after_fork_in_program(self) -> None:
        """Restart LTTng's threads. Call this method in the forked process once it has given up its rights."""
        if self._library is not None:
            self._library.ust_after_fork_child(self._signals)
