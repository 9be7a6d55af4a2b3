"""Provide an executor whose `step` runs at most one callback and returns whether one ran."""

import os
import sysconfig
import traceback
from pathlib import Path
from types import FrameType, TracebackType

import rclpy
from rclpy.context import Context
from rclpy.executors import (
    ConditionReachedException,
    ShutdownException,
    SingleThreadedExecutor,
    TimeoutException,
    TimeoutObject,
)

TAKING = ("_take_subscription", "_take_client", "_take_service")
"""The methods of an rclpy executor that create a message, a response, or a request."""
_INTERNAL = tuple(f"{Path(file).parent}{os.sep}" for file in (rclpy.__file__, __file__))
_LIBRARY = (f"{sysconfig.get_paths()['stdlib']}{os.sep}", "<frozen ")


def callback_traceback(error: BaseException) -> TracebackType | None:
    """Return the traceback of `error` from the first frame outside rclpy and the workbook on, or None without one."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code.co_filename.startswith(_INTERNAL):
        trace = trace.tb_next
    return trace


def callback_place(error: BaseException) -> str:
    """Return the name and line of the callback that raised `error`, or "" if no callback did."""
    frames = traceback.extract_tb(callback_traceback(error), limit=1)
    return f"{frames[0].name}(), line {frames[0].lineno}: {frames[0].line}" if frames else ""


def in_code_of_a_node(frame: FrameType | None) -> bool:
    """Return whether this frame, or one of its callers, belongs to a node's callback.

    Libraries don't count as callbacks. Nor does a message class while rclpy takes a message, because an exception there
    would be lost in C++. Nor does rclpy's own code between two callbacks, because an exception there would leave the
    callback group locked.
    """
    found = False
    while frame is not None and frame.f_code is not SteppingExecutor.step.__code__:
        if frame.f_code.co_name in TAKING and frame.f_code.co_filename.startswith(_INTERNAL):
            return False
        found = found or not _is_of_library(frame.f_code.co_filename)
        frame = frame.f_back
    return found


def _is_of_library(file: str) -> bool:
    """Return whether a file belongs to rclpy, the workbook, or Python's standard library."""
    return file.startswith(_INTERNAL) or (file.startswith(_LIBRARY) and "-packages" not in file)


class SteppingExecutor(SingleThreadedExecutor):
    """Runs the callbacks of one call's nodes. `in_callback` is True while a callback is taken and run."""

    def __init__(self, context: Context) -> None:
        super().__init__(context=context)
        # Always pass the same object, so that rclpy returns all callbacks that one wait found ready before it waits
        # again.
        self._timeout = TimeoutObject(0.0)
        self.in_callback = False

    def step(self, wait: float) -> bool:
        """Run the next callback, after waiting at most `wait` seconds for it. Return whether one ran.

        Raise the callback's exception, or ExternalShutdownException if the context is shut down.
        """
        self._timeout.timeout = wait
        try:
            handler, _, _ = self.wait_for_ready_callbacks(self._timeout)
        except (TimeoutException, ConditionReachedException, ShutdownException):
            return False
        self.in_callback = True
        try:
            handler()
        finally:
            self.in_callback = False
        error = handler.exception()
        if error is not None:
            raise error
        return True

    def close(self) -> None:
        """Remove the nodes. Cancel coroutine callbacks that are still waiting, which frees their callback groups."""
        for node in self.get_nodes():
            self.remove_node(node)
            if node.executor is self:
                node.executor = None  # type: ignore[assignment]
        with self._tasks_lock:
            unfinished = [task for task, _, _ in self._tasks if not task.done()]
            self._tasks.clear()
        for task in unfinished:
            task.cancel()
        self.shutdown()
