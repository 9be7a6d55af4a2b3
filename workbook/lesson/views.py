"""Show live views of the robot on this notebook's domain: the moving figure and the status dashboard."""

import math
import os
import time
from collections.abc import Callable
from typing import Any

from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

from workbook.lesson.robot_in_cell import PosedRobot, RobotInCell, draws_robots
from workbook.pictures import dashboard, humanoid
from workbook.pictures.live import LiveFigure
from workbook.pictures.moving_robot import MovingRobot
from workbook.pictures.stills import Still
from workbook.ros.kernel_node import kernel_node
from workbook.ros.session import Condition, Stopped, run

MOST_PICTURES = "WORKBOOK_PICTURES_PER_SECOND"
"""The environment variable with the highest number of frames per second, which limits the `fps` that a cell asks for.
"""
ROBOT_TEXT = "a humanoid robot with twelve joints, posed by the last message on /robot/joint_positions"


class _View(Node):
    """A node whose subscriptions exist while a view is open. It uses the context of the kernel's hidden node."""

    def __init__(self, name: str) -> None:
        super().__init__(
            name,
            context=kernel_node().context,
            enable_rosout=False,
            start_parameter_services=False,
            use_global_arguments=False,
        )


class RobotView(_View):
    """Sets the robot's pose from /robot/joint_positions, and its lamp from /robot/status."""

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
        """Return the current frame as PNG bytes, or None if it hasn't changed."""
        return self.robot.frame()


class StatusView(_View):
    """Collects the messages on /robot/status and /robot/battery for the dashboard."""

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
        """Draw the dashboard's current frame and return PNG bytes."""
        return dashboard.draw(self.status, self.battery, self.arrivals, now=self._now(), window=self.window)


async def watched(
    view: Any,
    refresh: Callable[[], None],
    seconds: float | None = None,
    fps: float = 20.0,
    until: Condition = None,
    *,
    ends_program: bool = False,
) -> None:
    """Run a view and call `refresh` for each frame. At the end, remove the view's node from the graph.

    The view closes after `seconds`, when `until` is met, or on Stop. After Stop, print the names of the programs that
    are still running, unless the caller stops them (`ends_program`).
    """
    fps = min(fps, float(os.environ.get(MOST_PICTURES, "inf")))
    try:
        await run(view, seconds=seconds, each_frame=refresh, fps=fps, until=until)
    except Stopped:
        # This import starts a process, which a view alone doesn't need.
        from workbook.lesson.programs import still_running

        if not ends_program and (names := still_running()):
            verb, it = ("runs", "it") if len(names) == 1 else ("run", "them")
            print(f"You stopped watching, but {' and '.join(names)} still {verb}: stop() ends {it}.")
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
    """Show the robot live, in the pose from the messages on /robot/joint_positions.

    `seconds`: the duration, or None to continue until Stop. `fps`: frames per second. `ease`: the time (s) that the
    robot takes to glide to a new pose; with 0, it jumps. Raise ValueError if `seconds` isn't positive and finite.
    """
    if seconds is not None and (not math.isfinite(seconds) or seconds <= 0):
        raise ValueError(f"seconds must be above zero, not {seconds}")
    view = RobotView(ease)
    if not draws_robots():
        await _show(view, ROBOT_TEXT, seconds, fps)
        return
    if RobotInCell.moves_here():
        await watched(view, lambda: None, seconds, fps)
        return
    robot = PosedRobot(ROBOT_TEXT, ease)
    try:
        await watched(view, lambda: robot.show(view.robot.news()), seconds, fps)
    finally:
        robot.leave(view.frame())


async def watch_status(seconds: float | None = 10.0, fps: float = 15.0, window: float = 10.0) -> StatusView:
    """Show a dashboard of /robot/status and /robot/battery live for `seconds` (None: until Stop).

    `fps`: frames per second. `window`: the number of seconds for which arrivals are shown. Return the view with the
    last `status` and `battery`, and with the `arrivals` by topic (s since the view was opened).
    """
    view = StatusView(window)
    await _show(view, dashboard.DESCRIPTION, seconds, fps)
    return view


def robot(*angles: float, lamp: str | None = None, caption: str = "") -> Still:
    """Draw a still of the robot at twelve joint angles (rad), with a `caption` under its feet.

    `lamp`: "operational", "error", or None (off).
    """
    return Still(humanoid.draw(angles, lamp=lamp, caption=caption), f"a humanoid robot. {caption}".strip())  # type: ignore[arg-type]
