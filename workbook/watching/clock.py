"""Drive simulated time with a publisher on /clock that can run faster than real time."""

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
    """A publisher of simulated time on /clock, in equal steps from `start_ns` (default: the current time of day).

    With the default, a program that's switched to this clock keeps its timers' schedule. `now` and `simulated_time`
    count from the start. `step_s`: the length of a step (s). Call `advance` whenever the next step is due (see
    `until_due`). The speed is in simulated seconds per real second. Simulated time never skips a step, so on a slow
    machine, it lags instead.
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
        """The simulated time (s) since the clock was started."""
        return (self._now_ns - self._start_ns) / 1e9

    def followers(self) -> int:
        """Return the number of subscriptions that are connected to our /clock publisher."""
        return int(self._publisher.get_subscription_count())

    def run_at(self, speed: float) -> None:
        """Set the clock's speed. The next step is due one step from now, at the new speed."""
        self._speed = speed
        self._due = time.monotonic() + self._real_step

    @property
    def _real_step(self) -> float:
        return self.step_ns / 1e9 / self._speed

    def until_due(self) -> float:
        """Return the real time, in seconds, until the next step is due, or zero if it's due now."""
        return max(0.0, self._due - time.monotonic())

    def publish(self) -> None:
        """Publish the current simulated time on /clock, and record the real time of this publication."""
        message = Clock()
        message.clock.sec, message.clock.nanosec = divmod(self._now_ns, 1_000_000_000)
        self._moments.append(time.monotonic())
        self._times.append(self.now)
        self._publisher.publish(message)

    def advance(self) -> None:
        """Advance simulated time by one step, and publish it."""
        self._now_ns += self.step_ns
        self._due = max(self._due + self._real_step, time.monotonic() + self._real_step / 2)
        self.publish()

    def close(self) -> None:
        """Destroy the publisher on /clock."""
        self._node.destroy_publisher(self._publisher)

    def simulated_time(self, moment: float) -> float:
        """Return the simulated time (s) at the real time `moment` (`time.monotonic`, s).

        That's the last simulated time published by then, or zero if none was published.
        """
        index = bisect.bisect_right(self._moments, moment) - 1
        return self._times[index] if index >= 0 else 0.0
