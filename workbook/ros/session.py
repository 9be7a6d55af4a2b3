"""Start and stop ROS and run nodes from lesson cells, all in the notebook's single thread."""

import asyncio
import inspect
import math
import signal
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

import rclpy
from rclpy.exceptions import InvalidHandle
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.task import Future
from rclpy.utilities import get_default_context, try_shutdown

from workbook.ros import exit_cleanup, fresh_nodes
from workbook.ros.environment import is_prepared, prepare
from workbook.ros.executor import (
    SteppingExecutor,
    callback_place,
    callback_traceback,
    in_code_of_a_node,
)
from workbook.ros.fresh_nodes import fresh as fresh

LONGEST_WAIT_S = 0.02
"""The longest wait (s) in the wait set while nothing else is ready: short enough for Jupyter's widgets."""
SHORTEST_WAIT_S = 0.0005
"""The wait (s) in the wait set while other tasks of the event loop are ready."""
LONGEST_ITERATION_S = 0.005
"""How long (s) callbacks may run in a row before the event loop gets its turn."""
CALLBACK_TIME_PER_FRAME = 3.0
"""After a frame was drawn, only callbacks run for this many times as long as the drawing took."""
_SYNC_WAIT_S = 0.05
"""The longest wait (s) in the wait set in code without `await`, where nothing else is waiting."""

Condition = Callable[[], object] | Future | None


class _ShownAsSentence:
    """An exception that a notebook shows as a sentence, without a traceback."""

    def _render_traceback_(self) -> list[str]:
        return [f"■ {self}"]


class Stopped(_ShownAsSentence, asyncio.CancelledError):
    """Raised when the reader presses Stop (Interrupt) while `run` is running. The nodes still exist."""


class StoppedInBetween(_ShownAsSentence, KeyboardInterrupt):
    """Raised when the reader presses Stop (Interrupt) while `spin_for` is running. The nodes still exist."""


def init(args: list[str] | None = None) -> None:
    """Start ROS in this notebook. Do nothing if it's already running.

    In plain Python, without the kernel's setup, this function also sets the environment variables. They keep traffic on
    this machine and turn off shared memory, so that a killed process doesn't leave files in `/dev/shm`.
    """
    exit_cleanup.register()
    if get_default_context().ok():
        return
    if not is_prepared():
        prepare()
    try_shutdown()  # clear a context that other code has shut down
    rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)


def shutdown() -> None:
    """Destroy the nodes made with `fresh` and stop ROS in this notebook. Do nothing if it's already stopped."""
    fresh_nodes.destroy_all()
    try_shutdown()


def _flatten(nodes: tuple[Node | Iterable[Node], ...]) -> list[Node]:
    found: list[Node] = []
    for item in nodes:
        for node in [item] if isinstance(item, (Node, type)) or not isinstance(item, Iterable) else item:
            if isinstance(node, type):
                raise TypeError(f"{node.__name__} is a class. Make a node first: fresh({node.__name__})")
            if not isinstance(node, Node):
                raise TypeError(f"expected a node, got {type(node).__name__}")
            if node not in found:
                found.append(node)
    if not found:
        raise TypeError("which node is to run? Pass one or several.")
    return found


def _check(nodes: list[Node]) -> None:
    for node in nodes:
        if not node.context.ok():
            raise RuntimeError("ROS was shut down after this node was made. Start ROS, make the node again.")
        try:
            with node.handle:
                name = node.get_fully_qualified_name()
        except InvalidHandle:
            raise RuntimeError(
                "this node was destroyed, for example because its cell ran again. Use the new one."
            ) from None
        if node.context is not nodes[0].context:
            raise ValueError(f"{name} is in a different context from {nodes[0].get_fully_qualified_name()}.")
        if isinstance(node.executor, SteppingExecutor):
            raise RuntimeError(f"{name} is running already. Run several nodes together: run(a, b)")


@contextmanager
def serving(*nodes: Node | Iterable[Node]) -> Iterator[SteppingExecutor]:
    """Yield a private executor for `nodes`. Afterward, return each node to its former executor."""
    served = _flatten(nodes)
    _check(served)
    former = [(node, node.executor) for node in served]
    executor = SteppingExecutor(served[0].context)
    try:
        for node in served:
            executor.add_node(node)
        yield executor
    finally:
        executor.close()
        for node, other in former:
            if other is not None:
                other.add_node(node)


class _Interrupts:
    """Turns an Interrupt into a flag and, inside a callback, into KeyboardInterrupt."""

    def __init__(self, executor: SteppingExecutor) -> None:
        self._executor = executor
        self._usable = threading.current_thread() is threading.main_thread()
        self._before: Any = None
        self.requested = False

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        self.requested = True
        if self._executor.in_callback and in_code_of_a_node(frame):
            raise KeyboardInterrupt

    def __enter__(self) -> "_Interrupts":
        if self._usable:
            self._before = signal.signal(signal.SIGINT, self._on_signal)
        return self

    def __exit__(self, *exception: object) -> None:
        if self._usable:
            signal.signal(signal.SIGINT, self._before)


class _SpinRun:
    """The state of one call of `run` or `spin_for`: when it ends, and its result or message."""

    def __init__(self, executor: SteppingExecutor, seconds: float | None, until: Condition) -> None:
        self.executor = executor
        self.interrupts = _Interrupts(executor)
        self.seconds = math.inf if seconds is None else float(seconds)
        if math.isnan(self.seconds) or self.seconds < 0:
            raise ValueError(f"seconds must be 0 or more, not {seconds}")
        if until is not None and not isinstance(until, Future) and not callable(until):
            raise TypeError(f"until must be a function or a Future, not {type(until).__name__}")
        self.until = until
        self.start = time.monotonic()
        self.end = self.start + self.seconds
        self.shut_down = False
        self._was_reached = False

    def reached(self) -> bool:
        """Return whether the condition has become true.

        Once the condition has been true, it isn't evaluated again, because it might become false.
        """
        if not self._was_reached and self.until is not None:
            until = self.until
            done = until.done() or until.cancelled() if isinstance(until, Future) else until()
            self._was_reached = bool(done)
        return self._was_reached

    def over(self) -> bool:
        return self.shut_down or self.reached() or time.monotonic() >= self.end

    def iteration(self, until: float, longest_wait: float) -> None:
        """Wait for a callback, then run all ready callbacks for a few milliseconds."""
        started = time.monotonic()
        wait_end = min(until, started + longest_wait, self.end)
        try:
            # Run at least one step, so that slow frames can't hold up messages forever.
            while self.executor.step(max(0.0, wait_end - time.monotonic())):
                if (
                    self.interrupts.requested
                    or self.reached()
                    or time.monotonic() - started > LONGEST_ITERATION_S
                ):
                    return
        except ExternalShutdownException:
            self.shut_down = True

    def result(self) -> Any:
        if self.until is None:
            return None
        if self.reached():
            return self.until.result() if isinstance(self.until, Future) else None
        if self.shut_down:
            raise RuntimeError("ROS was shut down before the condition became true.")
        raise TimeoutError(f"{self.seconds:g} s have passed and the condition has not become true.")

    def stopped(self, interrupt: BaseException) -> str:
        sentence = f"You stopped this after {time.monotonic() - self.start:.1f} s. The nodes are still there."
        place = callback_place(interrupt) if isinstance(interrupt, KeyboardInterrupt) else ""
        return f"{sentence} It was busy in {place}" if place else sentence


async def run(
    *nodes: Node | Iterable[Node],
    seconds: float | None = 5.0,
    until: Condition = None,
    each_frame: Callable[[], object] | None = None,
    fps: float = 15.0,
) -> Any:
    """Run nodes for `seconds` s of real time, or until a condition is true. Buttons and Stop keep working.

    `until` is a function that is called after each callback, or a Future whose result is returned; `seconds` is the
    limit. With `seconds=None`, nodes run until Stop is pressed. `each_frame` is called `fps` times a second and once at
    the end. If it returns an awaitable, `run` awaits it. If frames are slow, `each_frame` is called less often, so that
    at least three quarters of the time remain for callbacks.

    Raise a callback's exception, TimeoutError if `until` didn't become true, or Stopped on Interrupt.
    """
    __tracebackhide__ = True
    with serving(*nodes) as executor:
        this = _SpinRun(executor, seconds, until)
        next_frame = this.start if each_frame is not None else math.inf
        try:
            while True:
                if (begun := time.monotonic()) >= next_frame:
                    await _show(each_frame)
                    shown = time.monotonic()
                    next_frame = max(
                        next_frame + 1.0 / fps, shown + CALLBACK_TIME_PER_FRAME * (shown - begun)
                    )
                if this.over():
                    break
                with this.interrupts:
                    this.iteration(next_frame, _free_time())
                if this.interrupts.requested:
                    raise KeyboardInterrupt
                await asyncio.sleep(0)
            if each_frame is not None:
                await _show(each_frame)
        except (KeyboardInterrupt, asyncio.CancelledError) as interrupt:
            raise Stopped(this.stopped(interrupt)) from None
        except Exception as error:
            raise error.with_traceback(callback_traceback(error) or error.__traceback__)  # noqa: B904
    return this.result()


def _free_time() -> float:
    """Return the time, in seconds, that this iteration may wait without delaying widgets and the event loop's tasks."""
    loop = asyncio.get_running_loop()
    ready = getattr(loop, "_ready", None)
    timers = getattr(loop, "_scheduled", None)
    if ready is None or timers is None:  # an event loop without these attributes
        return LONGEST_WAIT_S / 2
    if ready:
        return SHORTEST_WAIT_S
    next_timer = timers[0].when() - loop.time() if timers else math.inf
    return max(SHORTEST_WAIT_S, min(LONGEST_WAIT_S, next_timer))


async def _show(each_frame: Callable[[], object] | None) -> None:
    outcome = each_frame() if each_frame is not None else None
    if inspect.isawaitable(outcome):
        await outcome


async def live(
    *nodes: Node | Iterable[Node],
    each_frame: Callable[[], object],
    seconds: float | None = 10.0,
    fps: float = 15.0,
    until: Condition = None,
) -> Any:
    """Call `run` with a live view: `each_frame` is called `fps` times per second."""
    __tracebackhide__ = True
    return await run(*nodes, seconds=seconds, until=until, each_frame=each_frame, fps=fps)


def spin_for(*nodes: Node | Iterable[Node], seconds: float = 1.0, until: Condition = None) -> Any:
    """Run nodes as `run` does, but in code without `await`, so nothing else runs in the notebook in the meantime.

    Raise a callback's exception, TimeoutError if `until` didn't become true, or KeyboardInterrupt on Interrupt.
    """
    __tracebackhide__ = True
    with serving(*nodes) as executor:
        this = _SpinRun(executor, seconds, until)
        try:
            with this.interrupts:
                while not this.over():
                    this.iteration(math.inf, _SYNC_WAIT_S)
                    if this.interrupts.requested:
                        raise KeyboardInterrupt
        except KeyboardInterrupt as interrupt:
            raise StoppedInBetween(this.stopped(interrupt)) from None
        except Exception as error:
            raise error.with_traceback(callback_traceback(error) or error.__traceback__)  # noqa: B904
    return this.result()
