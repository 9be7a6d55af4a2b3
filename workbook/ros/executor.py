"""An executor that runs one callback at a time and says whether there was one."""

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
"""Methods of an executor of rclpy that make a message, a response or a request."""
_INTERNAL = tuple(f"{Path(file).parent}{os.sep}" for file in (rclpy.__file__, __file__))
_LIBRARY = (f"{sysconfig.get_paths()['stdlib']}{os.sep}", "<frozen ")


def callback_traceback(error: BaseException) -> TracebackType | None:
    """The traceback of `error` from the first frame on that is neither rclpy's nor the workbook's, if any."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code.co_filename.startswith(_INTERNAL):
        trace = trace.tb_next
    return trace


def callback_place(error: BaseException) -> str:
    """Which callback was running, and where it was, when `error` was raised; nothing if none was."""
    frames = traceback.extract_tb(callback_traceback(error), limit=1)
    return f"{frames[0].name}(), line {frames[0].lineno}: {frames[0].line}" if frames else ""


def in_code_of_a_node(frame: FrameType | None) -> bool:
    """Whether this frame of a callback, or one that called it, is of a node, and not of a library that serves it.

    The class of a message does not count while rclpy takes one: an exception there would be lost in C++, and one in
    rclpy's own code between two callbacks would leave the callback group locked for good.
    """
    found = False
    while frame is not None and frame.f_code is not SteppingExecutor.step.__code__:
        if frame.f_code.co_name in TAKING and frame.f_code.co_filename.startswith(_INTERNAL):
            return False
        found = found or not _is_of_library(frame.f_code.co_filename)
        frame = frame.f_back
    return found


def _is_of_library(file: str) -> bool:
    """Whether a file is rclpy's, the workbook's or of Python's standard library, which all of them call."""
    return file.startswith(_INTERNAL) or (file.startswith(_LIBRARY) and "-packages" not in file)


class SteppingExecutor(SingleThreadedExecutor):
    """Serves the nodes of one call. `in_callback` is true while a callback is taken and run."""

    def __init__(self, context: Context) -> None:
        super().__init__(context=context)
        # The same object each time: rclpy then hands out what one wait has found before it waits again.
        self._timeout = TimeoutObject(0.0)
        self.in_callback = False

    def step(self, wait: float) -> bool:
        """Run the next callback, waiting at most `wait` seconds for one; whether one ran.

        Raises what the callback raises, and ExternalShutdownException when the context is shut down.
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
        """Remove the nodes. A coroutine callback that still waits is canceled, and its callback group is free again."""
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
