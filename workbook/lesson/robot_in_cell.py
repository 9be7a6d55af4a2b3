"""Show the robot in a cell. JupyterLab draws and moves it.

In other front ends, readers see a still image instead. The front end's code is in workbook/lab/front_end/panel/cell.js.
"""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, ClassVar

from IPython.core.getipython import get_ipython
from IPython.display import DisplayHandle, display

from workbook.lesson.front_end import front_end_data, request

ROBOT = "application/vnd.rclpy-workbook.robot+json"
GLIDES = 4
"""The duration of a glide, in time constants of rig.js. After that, only a fiftieth of the movement is left."""


@cache
def _still() -> Any:
    from workbook.pictures import humanoid  # slow to load, and not needed by each kernel
    from workbook.pictures.joints import NEUTRAL
    from workbook.pictures.stills import Still

    return Still(humanoid.draw(NEUTRAL), "a humanoid robot with twelve joints")


def _bundle(kernel: str | None) -> dict[str, object]:
    still, _ = _still()._repr_mimebundle_()
    return {**still, ROBOT: {"kernel": kernel}}


def kernel_id() -> str | None:
    """Return this kernel's ID in JupyterLab, or None outside of a kernel."""
    kernel = getattr(get_ipython(), "kernel", None)
    parent = getattr(kernel, "parent", None)
    file = getattr(parent, "connection_file", "")
    return Path(file).stem.removeprefix("kernel-") or None


def draws_robots() -> bool:
    """Return whether the front end that runs this cell draws the robot itself."""
    return front_end_data().get("robot") is True


class RobotInCell:
    """A robot below the running cell. Until `rest` is called, it follows the messages of this notebook's programs."""

    _newest: ClassVar[object] = None

    def __init__(self) -> None:
        kernel = kernel_id()
        RobotInCell._newest = request().get("header")
        self._display: DisplayHandle | None = None
        if kernel is not None:
            self._display = display(_bundle(kernel), raw=True, display_id=True)

    @classmethod
    def moves_here(cls) -> bool:
        """Return whether a `RobotInCell` is already shown below the running cell, where it follows the messages."""
        return draws_robots() and cls._newest == request().get("header")

    def rest(self) -> None:
        """Put the robot to sleep, because its program has exited."""
        if self._display is not None:
            self._display.update(_bundle(None), raw=True)


class PosedRobot:
    """A robot below the running cell. It glides to each pose that the kernel sends within `ease` seconds."""

    def __init__(self, description: str, ease: float) -> None:
        self._text = description
        self._glide = 1000 * ease / GLIDES
        self._display: DisplayHandle | None = None
        self._news: dict[str, object] = {}

    def show(self, news: dict[str, object]) -> None:
        """Send the robot's new state to the front end, unless nothing has changed."""
        if news == self._news:
            return
        self._news = news
        self._put({"text/plain": self._text})

    def leave(self, picture: bytes | None) -> None:
        """Keep the last pose on the page, with `picture` as a still for other front ends. Without one, do nothing."""
        if picture is not None:
            from workbook.pictures.stills import Still

            self._put(Still(picture, self._text)._repr_mimebundle_()[0])

    def _put(self, shown: Mapping[str, object]) -> None:
        robot = {"kernel": None, "news": {"text": self._text, **self._news}, "glide": self._glide}
        if self._display is None:
            self._display = display({**shown, ROBOT: robot}, raw=True, display_id=True)
        else:
            self._display.update({**shown, ROBOT: robot}, raw=True)
