"""Make rclpy calls in a notebook cell obey the Interrupt button.

rclpy waits in C code until an entity is ready. With idle nodes, an Interrupt doesn't end that wait, because the
notebook's kernel has replaced rclpy's signal handler. So we wait in short slices, between which Python can raise
KeyboardInterrupt. We don't restore rclpy's handler, because it would also shut down the nodes' context.

An Interrupt may also arrive while rclpy's C++ code creates a message. Without our changes, it would turn into a
RuntimeError that doesn't mention the Interrupt, and would leave the subscription's callback group locked.
"""

import functools
import time
from typing import Any

import rclpy
from rclpy.executors import Executor, TimeoutException, TimeoutObject

from workbook.ros.executor import TAKING

SLICE_S = 0.1
"""The longest delay (s) of an Interrupt. With shorter slices, an idle node would use more CPU time."""


_OF_AN_INTERRUPT = "Unable to convert call argument"
"""pybind11's message for an exception in a message class. In rclpy, only an Interrupt causes one."""


def install() -> None:
    """Change rclpy in this process permanently. It's safe to call this function again."""
    original = Executor.wait_for_ready_callbacks
    if getattr(original, "waits_in_slices", False):
        return

    def wait_for_ready_callbacks(self: Any, timeout_sec: Any = None, *args: Any, **kwargs: Any) -> Any:
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        forever = seconds is None or seconds < 0
        if not forever and seconds <= SLICE_S:
            return original(self, timeout_sec, *args, **kwargs)
        end = time.monotonic() + (0.0 if forever else seconds)
        slice_timeout = self.__dict__.setdefault("_slice_timeout", TimeoutObject(SLICE_S))
        while True:
            slice_timeout.timeout = SLICE_S if forever else max(0.0, min(SLICE_S, end - time.monotonic()))
            try:
                return original(self, slice_timeout, *args, **kwargs)
            except TimeoutException:
                if not forever and time.monotonic() >= end:
                    raise

    wait_for_ready_callbacks.waits_in_slices = True  # type: ignore[attr-defined]
    Executor.wait_for_ready_callbacks = wait_for_ready_callbacks  # type: ignore[method-assign]

    for name in TAKING:
        setattr(Executor, name, _interruptible(getattr(Executor, name)))

    def leave_signals_to_the_kernel(*options: Any) -> None:
        return None

    setattr(rclpy, "install_signal_handlers", leave_signals_to_the_kernel)  # noqa: B010


def _interruptible(take: Any) -> Any:
    """Wrap an executor's method so that it raises KeyboardInterrupt if pybind11 has turned one into another error.

    In that case, the wrapper also releases the callback group, as rclpy's handler does after a callback.
    """

    @functools.wraps(take)
    def taken(self: Any, entity: Any) -> Any:
        try:
            return take(self, entity)
        except RuntimeError as error:
            if _OF_AN_INTERRUPT not in str(error):
                raise
            entity._executor_event = False
            entity.callback_group.ending_execution(entity)
            raise KeyboardInterrupt from None

    return taken
