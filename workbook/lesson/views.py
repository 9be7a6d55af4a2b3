"""Live views of the robot on this notebook's domain: the figure that moves, and the status dashboard."""

import math
import os
import time
from collections.abc import Callable
from typing import Any

from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

from workbook.pictures import dashboard, humanoid
from workbook.pictures.live import LiveFigure
from workbook.pictures.moving_robot import MovingRobot
from workbook.pictures.stills import Still
from workbook.ros.kernel_node import kernel_node
from workbook.ros.session import Condition, Stopped, run

MOST_PICTURES = "WORKBOOK_PICTURES_PER_SECOND"
"""Environment variable: draw no more, whatever a cell asks for."""
ROBOT_TEXT = "a humanoid robot with twelve joints, posed by the last message on /robot/joint_positions"


class _View(Node):
    """A node that listens while a view is open. It lives in the context of the kernel's hidden node."""

    def __init__(self, name: str) -> None:
        super().__init__(
            name,
            context=kernel_node().context,
            enable_rosout=False,
            start_parameter_services=False,
            use_global_arguments=False,
        )


class RobotView(_View):
    """Poses the figure by what arrives on /robot/joint_positions; its lamp follows /robot/status."""

    def __init__(self, ease: float) -> None:
        super().__init__("robot_view")
        self.robot = MovingRobot(ease)
        self.create_subscription(Float32MultiArray, "/robot/joint_positions", self._on_joints, 10)
        self.create_subscription(String, "/robot/status", self._on_status, 10)

    def _on_joints(self, message: Any) -> None:
        self.robot.pose(message.data)

    def _on_status(self, message: Any) -> None:
        self.robot.status(message.data)

    def frame(self) -> bytes | None:
        """The picture as it is now; None while it is the one before."""
        return self.robot.frame()


class StatusView(_View):
    """Collects /robot/status and /robot/battery for the dashboard."""

    def __init__(self, window: float) -> None:
        super().__init__("dashboard")
        self.status: str | None = None
        self.battery: float | None = None
        self.window = window
        self._began = time.monotonic()
        self.arrivals: dict[str, list[float]] = {dashboard.STATUS_TOPIC: [], dashboard.BATTERY_TOPIC: []}
        self.create_subscription(String, dashboard.STATUS_TOPIC, self._on_status, 10)
        self.create_subscription(Float32, dashboard.BATTERY_TOPIC, self._on_battery, 10)

    def _now(self) -> float:
        return time.monotonic() - self._began

    def _on_status(self, message: Any) -> None:
        self.status = message.data
        self.arrivals[dashboard.STATUS_TOPIC].append(self._now())

    def _on_battery(self, message: Any) -> None:
        self.battery = message.data
        self.arrivals[dashboard.BATTERY_TOPIC].append(self._now())

    def frame(self) -> bytes:
        """The dashboard as it is now, as PNG bytes."""
        return dashboard.draw(self.status, self.battery, self.arrivals, now=self._now(), window=self.window)


async def watched(
    view: Any,
    refresh: Callable[[], None],
    seconds: float | None = None,
    fps: float = 20.0,
    until: Condition = None,
) -> None:
    """Let a view run, with `refresh` for each picture, until its time is over or Stop; then take it off the graph."""
    fps = min(fps, float(os.environ.get(MOST_PICTURES, "inf")))
    try:
        await run(view, seconds=seconds, each_frame=refresh, fps=fps, until=until)
    except Stopped:
        pass
    finally:
        view.destroy_node()


async def _show(view: Any, describe: str, seconds: float | None, fps: float) -> LiveFigure:
    figure = LiveFigure(describe)

    def refresh() -> None:
        picture = view.frame()
        if picture is not None:
            figure.show(picture)

    await watched(view, refresh, seconds, fps)
    return figure


async def watch_robot(seconds: float | None = 10.0, fps: float = 20.0, ease: float = 0.8) -> None:
    """Show the robot that the messages on /robot/joint_positions pose, live, for `seconds` (None: until Stop).

    `fps`: pictures per second. `ease`: seconds in which the figure glides to a new pose; 0 jumps.
    """
    if seconds is not None and (not math.isfinite(seconds) or seconds <= 0):
        raise ValueError(f"seconds must be above zero, not {seconds}")
    await _show(RobotView(ease), ROBOT_TEXT, seconds, fps)


async def watch_status(seconds: float | None = 10.0, fps: float = 15.0, window: float = 10.0) -> StatusView:
    """Show the dashboard of /robot/status and /robot/battery, live, for `seconds` (None: until Stop).

    Returns the view, which holds the last `status`, `battery` and the `arrivals` (s since it was opened).
    """
    view = StatusView(window)
    await _show(view, dashboard.DESCRIPTION, seconds, fps)
    return view


def robot(*angles: float, lamp: str | None = None, caption: str = "") -> Still:
    """A still of the robot at twelve angles (rad)."""
    return Still(humanoid.draw(angles, lamp=lamp, caption=caption), f"a humanoid robot. {caption}".strip())  # type: ignore[arg-type]
