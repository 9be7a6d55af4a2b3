"""A picture that moves in a notebook cell, and stays as a still when it has ended.

Everything runs in the one thread of the kernel: frames are drawn while a cell awaits `animate`, and ROS callbacks,
widgets and other tasks run in between. Stop ends it with the last frame on the page.
"""

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from workbook.pictures.png import img_tag
from workbook.pictures.stills import Still


class Screen(Protocol):
    """Where a live picture is shown."""

    def show(self, still: Still) -> None:
        """Show the first picture."""

    def update(self, still: Still) -> None:
        """Replace it by the next one."""

    def finish(self, still: Still) -> None:
        """Leave the last one."""


class CellOutput:
    """The output area of the running cell: one picture, replaced in place.

    While it moves, each frame travels once; `finish` leaves the last one in all the forms that a still has.
    """

    def __init__(self) -> None:
        self._handle: Any = None

    def show(self, still: Still) -> None:
        """Show the first picture in the cell."""
        from IPython.display import display

        self._handle = display(still, display_id=True)

    def update(self, still: Still) -> None:
        """Replace the picture, as HTML only."""
        if self._handle is not None:
            bundle = {"text/plain": repr(still), "text/html": img_tag(still.png, still.description)}
            self._handle.update(bundle, raw=True)

    def finish(self, still: Still) -> None:
        """Replace the picture by the last one, in all forms."""
        if self._handle is not None:
            self._handle.update(still)


class LiveFigure:
    """One picture on the page that is replaced by each `show(png)`.

    `describe` is the text for those who cannot see it; it stays the same for every frame.
    """

    def __init__(self, describe: str, screen: Screen | None = None) -> None:
        self.describe = describe
        self.frames = 0
        self.still: Still | None = None
        self._screen: Screen = screen or CellOutput()

    def show(self, png: bytes) -> None:
        """Put this frame in the place of the one before."""
        still = Still(png, self.describe)
        if self.still is None:
            self._screen.show(still)
        else:
            self._screen.update(still)
        self.still = still
        self.frames += 1

    def finish(self) -> None:
        """Leave the last frame as the still picture of the cell."""
        if self.still is not None:
            self._screen.finish(self.still)


@dataclass(frozen=True, repr=False)
class LiveStill(Still):
    """The last frame of a live picture, with what was measured of the showing.

    `frames` pictures were shown in `seconds` of real time; `stopped` is True when it was stopped before its time.
    """

    frames: int = 0
    seconds: float = 0.0
    stopped: bool = False
    cell: int | None = None

    @property
    def frames_per_second(self) -> float:
        """How many pictures per second were really shown."""
        return self.frames / self.seconds if self.seconds > 0 else 0.0

    def _ipython_display_(self) -> None:
        # In the cell that showed it live, the picture is on the page already.
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
    """Show the PNG that `frame()` gives, up to `fps` times per second, for `seconds` of real time.

    `frame` returns None when there is nothing new: the picture stays. It may let waiting ROS callbacks run, but it
    must not block. A busy machine shows fewer frames and never falls behind. Stop (the cell is interrupted, the task
    canceled) ends the showing early, without an error, and the code after it goes on.

    Returns the last frame, with `frames_per_second` as really shown. Raises ValueError for a rate or time that is
    not positive, RuntimeError if `frame` never gave a picture.
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
        raise RuntimeError("there was no picture to show: frame() gave None each time")
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
    """Show frames until `end`, on the clock of `time.perf_counter`. Returns whether it was stopped before.

    A Stop before there was any picture is passed on.
    """
    due = now = time.perf_counter()
    try:
        while now < end:
            png = frame()
            if png is not None:
                figure.show(png)
            now = time.perf_counter()
            due = max(due + period, now)
            # At least one iteration of the event loop for other tasks, also when a frame takes longer than its period.
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
