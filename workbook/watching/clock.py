"""Robot time that we drive: a publisher on /clock whose seconds are shorter than real ones."""

import bisect
import time
from typing import Any

from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rosgraph_msgs.msg import Clock

# A program counts its timers from zero; a clock that starts late makes the first ticks fall due at once, which is
# what a timer does on the wall clock only after its first period. Starting near zero keeps both alike.
START_NS = 1_000_000
CLOCK_QOS = QoSProfile(
    history=HistoryPolicy.KEEP_LAST,
    depth=100,
    reliability=ReliabilityPolicy.RELIABLE,
    durability=DurabilityPolicy.VOLATILE,
)


class SimulatedClock:
    """Publishes robot time on /clock in equal steps.

    `step_s` is the resolution of robot time in seconds. `advance` moves it by one step when that step is due at
    the speed set (robot seconds per real second). Robot time never skips: if the machine is late, it waits. Where
    nobody measures, it may take several steps at once (see `run_at`): each one costs whoever listens processor time.
    """

    def __init__(self, node: Any, step_s: float) -> None:
        self._publisher = node.create_publisher(Clock, "/clock", CLOCK_QOS)
        self.step_ns = round(step_s * 1e9)
        self.now_ns = START_NS
        self._speed = 1.0
        self._stride = 1
        self._due = time.monotonic()
        self._moments: list[float] = []
        self._times: list[float] = []

    @property
    def now(self) -> float:
        """Robot time in seconds since the clock was started."""
        return (self.now_ns - START_NS) / 1e9

    def followers(self) -> int:
        """Programs that listen to /clock."""
        return int(self._publisher.get_subscription_count())

    def run_at(self, speed: float, stride: int = 1) -> None:
        """Set the speed, and how many steps are taken at once; the next are due when so much time has passed."""
        self._speed = speed
        self._stride = stride
        self._due = time.monotonic() + self._real_step

    @property
    def _real_step(self) -> float:
        return self._stride * self.step_ns / 1e9 / self._speed

    def until_due(self) -> float:
        """Real seconds until the next step is due (zero when it is)."""
        return max(0.0, self._due - time.monotonic())

    def publish(self) -> None:
        """Publish the present robot time on /clock, and note at which real moment."""
        message = Clock()
        message.clock.sec, message.clock.nanosec = divmod(self.now_ns, 1_000_000_000)
        self._moments.append(time.monotonic())
        self._times.append(self.now)
        self._publisher.publish(message)

    def advance(self) -> None:
        """Move robot time on by what is due at once, and publish it."""
        self.now_ns += self._stride * self.step_ns
        self._due = max(self._due + self._real_step, time.monotonic() + self._real_step / 2)
        self.publish()

    def robot_time(self, moment: float) -> float:
        """Robot time (s) at a moment of `time.monotonic`: the last one published before it."""
        index = bisect.bisect_right(self._moments, moment) - 1
        return self._times[index] if index >= 0 else 0.0
