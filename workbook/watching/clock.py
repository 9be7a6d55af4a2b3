"""Simulated time that we drive: a publisher on /clock whose seconds are shorter than real ones."""

import bisect
import time
from typing import Any

from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rosgraph_msgs.msg import Clock

CLOCK_QOS = QoSProfile(
    history=HistoryPolicy.KEEP_LAST,
    depth=100,
    reliability=ReliabilityPolicy.RELIABLE,
    durability=DurabilityPolicy.VOLATILE,
)


class SimulatedClock:
    """Publishes simulated time on /clock in equal steps, from `start_ns` on or from the present time of day.

    From the time of day on, the timers of a program that is switched to this clock are due when they would have been.
    `now` and `simulated_time` count from the start.

    `step_s` is the resolution of simulated time in seconds. `advance` moves it by one step when that step is due at
    the speed set (simulated seconds per real second). Simulated time never skips: if the machine is late, it waits.
    """

    def __init__(self, node: Any, step_s: float, start_ns: int | None = None) -> None:
        self._node = node
        self._publisher = node.create_publisher(Clock, "/clock", CLOCK_QOS)
        self.step_ns = round(step_s * 1e9)
        self._start_ns = self._now_ns = time.time_ns() if start_ns is None else start_ns
        self._speed = 1.0
        self._due = time.monotonic()
        self._moments: list[float] = []
        self._times: list[float] = []

    @property
    def now(self) -> float:
        """Simulated time in seconds since the clock was started."""
        return (self._now_ns - self._start_ns) / 1e9

    def followers(self) -> int:
        """Subscriptions of others to /clock."""
        return int(self._publisher.get_subscription_count())

    def run_at(self, speed: float) -> None:
        """Set the speed; the next step is due when so much time has passed."""
        self._speed = speed
        self._due = time.monotonic() + self._real_step

    @property
    def _real_step(self) -> float:
        return self.step_ns / 1e9 / self._speed

    def until_due(self) -> float:
        """Real seconds until the next step is due (zero when it is)."""
        return max(0.0, self._due - time.monotonic())

    def publish(self) -> None:
        """Publish the present simulated time on /clock, and note at which real moment."""
        message = Clock()
        message.clock.sec, message.clock.nanosec = divmod(self._now_ns, 1_000_000_000)
        self._moments.append(time.monotonic())
        self._times.append(self.now)
        self._publisher.publish(message)

    def advance(self) -> None:
        """Move simulated time on by one step, and publish it."""
        self._now_ns += self.step_ns
        self._due = max(self._due + self._real_step, time.monotonic() + self._real_step / 2)
        self.publish()

    def close(self) -> None:
        """Take /clock off the graph."""
        self._node.destroy_publisher(self._publisher)

    def simulated_time(self, moment: float) -> float:
        """Simulated time (s) at a moment of `time.monotonic`: the last one published before it."""
        index = bisect.bisect_right(self._moments, moment) - 1
        return self._times[index] if index >= 0 else 0.0
