"""Simulate a robot that publishes four heartbeats a second, optionally with silent periods.

The robot publishes its state once, and keeps it for late subscriptions. The heartbeat is best effort and
offers a deadline: at most 0.5 s from one beat to the next. The silent periods violate this deadline on purpose.

Run it with ``python -m lesson_nodes.heartbeat`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

BEAT_PERIOD_S = 0.25
DEADLINE_S = 0.5

STATUS_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
BEAT_QOS = QoSProfile(
    depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=DEADLINE_S)
)


class Heartbeat(Node):
    """Alternates between periods with heartbeats and periods of silence.

    Topics:
        /robot/status (std_msgs/String): "operational", published once at the start; reliable, transient local.
        /robot/heartbeat (std_msgs/String): "beat 1", "beat 2", ... at 4 Hz; best effort, deadline 0.5 s.

    Parameters (each overrides the argument of the same name):
        beats_for_s: Length of each period with heartbeats, in seconds.
        silent_for_s: Length of each silent period, in seconds. With 0.0, the heartbeat never stops.

    Raises ValueError if a time is negative, or if `beats_for_s` is zero.
    """

    def __init__(self, beats_for_s: float = 5.0, silent_for_s: float = 0.0) -> None:
        super().__init__("heartbeat")
        beats_for_s = self.declare_parameter("beats_for_s", beats_for_s).value
        silent_for_s = self.declare_parameter("silent_for_s", silent_for_s).value
        if not (beats_for_s > 0.0 and silent_for_s >= 0.0):
            raise ValueError(f"cannot beat for {beats_for_s} s and be silent for {silent_for_s} s")
        self.beats_in_a_row = max(1, round(beats_for_s / BEAT_PERIOD_S))
        self.ticks_in_a_round = self.beats_in_a_row + round(silent_for_s / BEAT_PERIOD_S)
        self.ticks = 0
        self.beats = 0
        self.status_publisher = self.create_publisher(String, "/robot/status", STATUS_QOS)
        self.beat_publisher = self.create_publisher(String, "/robot/heartbeat", BEAT_QOS)
        self.status_publisher.publish(String(data="operational"))
        self.create_timer(BEAT_PERIOD_S, self.on_tick)
        self.get_logger().info("Heartbeat started")

    def on_tick(self) -> None:
        """Publish a heartbeat, except in a silent period."""
        if self.ticks % self.ticks_in_a_round < self.beats_in_a_row:
            self.beats += 1
            self.beat_publisher.publish(String(data=f"beat {self.beats}"))
        self.ticks += 1


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Heartbeat())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
