"""Show a moving figure in a notebook cell, where its last frame remains as a still.

Everything runs in the kernel's one thread. Frames are drawn while a cell awaits `animate`; ROS callbacks, widgets, and
other tasks run in between. Stop ends the animation and leaves the last frame on the page.
"""

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from workbook.pictures.png import img_tag
from workbook.pictures.stills import Still


class Screen(Protocol):
    """The place where a live figure is shown."""

    def show(self, still: Still) -> None:
        """Show the first frame."""

    def update(self, still: Still) -> None:
        """Replace the frame with the next one."""

    def finish(self, still: Still) -> None:
        """Leave the last frame on display."""


class CellOutput:
    """The output area of the running cell: one figure, replaced in place.

    While the figure moves, each new frame is sent only as HTML. `finish` sends the last frame in all the formats of a
    still.
    """

    def __init__(self) -> None:
        self._handle: Any = None

    def show(self, still: Still) -> None:
        """Show the first frame in the cell."""
        from IPython.display import display

        self._handle = display(still, display_id=True)

    def update(self, still: Still) -> None:
        """Replace the frame, as HTML only."""
        if self._handle is not None:
            bundle = {"text/plain": repr(still), "text/html": img_tag(still.png, still.description)}
            self._handle.update(bundle, raw=True)

    def finish(self, still: Still) -> None:
        """Replace the frame with the last one, in all formats."""
        if self._handle is not None:
            self._handle.update(still)


class LiveFigure:
    """A figure on the page. Each `show(png)` replaces its frame.

    `describe` is the alternative text, which is the same for every frame.
    """

    def __init__(self, describe: str, screen: Screen | None = None) -> None:
        self.describe = describe
        self.frames = 0
        self.still: Still | None = None
        self._screen: Screen = screen or CellOutput()

    def show(self, png: bytes) -> None:
        """Show this frame instead of the previous one."""
        still = Still(png, self.describe)
        if self.still is None:
            self._screen.show(still)
        else:
            self._screen.update(still)
        self.still = still
        self.frames += 1

    def finish(self) -> None:
        """Leave the last frame in the cell as a still."""
        if self.still is not None:
            self._screen.finish(self.still)


@dataclass(frozen=True, repr=False)
class LiveStill(Still):
    """The last frame of a live figure, and the speed at which the frames were shown.

    `frames` were shown in `seconds` of real time. `stopped` is True if the figure was stopped early.
    """

    frames: int = 0
    seconds: float = 0.0
    stopped: bool = False
    cell: int | None = None

    @property
    def frames_per_second(self) -> float:
        """The actual number of frames shown per second."""
        return self.frames / self.seconds if self.seconds > 0 else 0.0

    def _ipython_display_(self) -> None:
        # In the cell that showed the figure live, it's already on the page.
        if self.cell is None or self.cell != _running_cell():
            from IPython.display import display

            display(Still(self.png, self.description))


async def animate(
    frame: Callable[[], bytes | None],
    seconds: float,
    fps: float = 20.0,
    *,
    describe: str,
    screen: Screen | None = None,
) -> LiveStill:
    """Show the PNG that `frame()` returns, up to `fps` times per second, for `seconds` of real time.

    `frame` returns None if nothing has changed, and then the previous frame stays. It may let waiting ROS callbacks
    run, but it must not block. A busy machine shows fewer frames, but they don't lag. If the cell is interrupted (Stop)
    or the task canceled, the animation ends early without an error, and the code after it continues.

    Return the last frame, with the true `frames_per_second`. Raises ValueError if `seconds` or `fps` isn't positive,
    and RuntimeError if `frame` always returned None.
    """
    if not fps > 0 or not seconds > 0:
        raise ValueError(f"seconds and fps must be above zero, not {seconds} and {fps}")
    figure = LiveFigure(describe, screen)
    start = time.perf_counter()
    try:
        stopped = await _show_frames(figure, frame, start + seconds, 1.0 / fps)
    finally:
        elapsed = time.perf_counter() - start
        figure.finish()
    if figure.still is None:
        raise RuntimeError("there was no frame to show: frame() returned None each time")
    return LiveStill(
        figure.still.png,
        describe,
        frames=figure.frames,
        seconds=elapsed,
        stopped=stopped,
        cell=_running_cell(),
    )


async def _show_frames(
    figure: LiveFigure, frame: Callable[[], bytes | None], end: float, period: float
) -> bool:
    """Show frames until the time `end` of `time.perf_counter()`. Return whether the figure was stopped early.

    A Stop before the first frame raises an exception, as usual.
    """
    due = now = time.perf_counter()
    try:
        while now < end:
            png = frame()
            if png is not None:
                figure.show(png)
            now = time.perf_counter()
            due = max(due + period, now)
            # Give other tasks at least one iteration of the event loop, even if a frame takes longer than its period.
            await asyncio.sleep(max(0.0, min(due, end) - now))
            now = time.perf_counter()
    except asyncio.CancelledError:
        if figure.still is None:
            raise
        task = asyncio.current_task()
        if task is not None:
            task.uncancel()
        return True
    except KeyboardInterrupt:
        if figure.still is None:
            raise
        return True
    return False


def _running_cell() -> int | None:
    try:
        from IPython.core.getipython import get_ipython
    except ImportError:
        return None
    shell = get_ipython()
    return None if shell is None else int(shell.execution_count)
