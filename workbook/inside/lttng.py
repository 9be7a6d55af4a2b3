"""LTTng, which rclpy's wheels load, and the forks of this process."""

import ctypes
import os

from workbook.inside.proc import mapped_libraries

SIGSET_BYTES = 128


class LttngForkHooks:
    """Tells LTTng of each fork.

    It has two threads, which a forked process does not get. Unless it is told so (what `liblttng-ust-fork` is for), at
    the program's end it cancels whatever threads have their place by then, and the program may hang.
    """

    def __init__(self) -> None:
        paths = mapped_libraries("liblttng-ust-") | mapped_libraries("liblttng-ust.so")
        libraries = [ctypes.CDLL(path) for path in sorted(paths)]
        self._library = next((one for one in libraries if hasattr(one, "ust_before_fork")), None)
        self._signals = ctypes.create_string_buffer(SIGSET_BYTES)

    def fork(self) -> int:
        """As `os.fork`; call `after_fork_in_program` in the forked process. Raises OSError when there is none."""
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
        """Start LTTng's threads anew; call right after the fork in the forked process."""
        if self._library is not None:
            self._library.ust_after_fork_child(self._signals)
