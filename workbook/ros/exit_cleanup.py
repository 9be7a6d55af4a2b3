"""Shut ROS down when this process exits, even if the program doesn't.

If a thread still waits inside rclpy during Python's shutdown, the process aborts. So we first shut contexts down, then
join the spinning threads, and then destroy executors and nodes while their dependencies still exist.
"""

import atexit
import concurrent.futures.thread  # noqa: F401  (its exit hook must be registered before ours)
import gc
import io
import sys
import threading
import time
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

_JOIN_LIMIT_S = 2.0
"""The longest wait (s) for all spinning threads together. A callback that never returns mustn't block the exit."""
_registered = False


def register() -> None:
    """Have `shut_down_ros` called when this process exits. It's safe to call this function again."""
    global _registered
    if _registered:
        return
    _registered = True
    # This hook runs before Python waits for non-daemon threads; a public atexit hook would run only after that wait.
    before_threads = getattr(threading, "_register_atexit", atexit.register)
    before_threads(shut_down_ros)


def _instances(*kinds: type) -> Iterable[Any]:
    """Return all instances of these classes and their subclasses. A notebook has half a million objects to search."""
    waiting = list(kinds)
    family: dict[int, type] = {}
    while waiting:
        kind = waiting.pop()
        if id(kind) not in family:
            family[id(kind)] = kind
            waiting += type.__subclasses__(kind)
    return [thing for thing in gc.get_objects() if id(type(thing)) in family]


def _waits_in_rclpy(thread: threading.Thread) -> bool:
    frame = sys._current_frames().get(thread.ident or 0)
    while frame is not None:
        if frame.f_globals.get("__name__", "").startswith("rclpy"):
            return True
        frame = frame.f_back
    return False


def shut_down_ros() -> None:
    """Shut down every context, wait for spinning threads (at most 2 s), and destroy executors and nodes."""
    if "rclpy" not in sys.modules:
        return
    from rclpy.context import Context
    from rclpy.executors import Executor, ExternalShutdownException
    from rclpy.node import Node

    default_hook = threading.excepthook

    def without_shutdown(failure: threading.ExceptHookArgs) -> None:
        if failure.exc_type is None or not issubclass(failure.exc_type, ExternalShutdownException):
            default_hook(failure)

    threading.excepthook = without_shutdown
    for context in _instances(Context):
        with suppress(Exception):
            context.try_shutdown()
    limit = time.monotonic() + _JOIN_LIMIT_S
    for thread in threading.enumerate():
        if thread is not threading.current_thread() and _waits_in_rclpy(thread):
            thread.join(max(0.0, limit - time.monotonic()))
    for executor in _instances(Executor):
        with suppress(Exception):
            executor.shutdown(0.0)
    for node in _instances(Node):
        with suppress(Exception):
            node.destroy_node()
    threading.excepthook = default_hook
    _skip_garbage_collection()


def _skip_garbage_collection() -> None:
    """Skip Python's final garbage collection, which takes half a second in a notebook for no benefit.

    Flush all files first, because the collection would have flushed the files in reference cycles.
    """
    for file in _instances(io.TextIOWrapper, io.BufferedWriter, io.BufferedRandom):
        with suppress(Exception):
            file.flush()
    gc.freeze()
