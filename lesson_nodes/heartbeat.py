"""A robot whose heart beats four times a second, and falls silent now and then.

Its state is said once and kept for those who come later. The heartbeat is best effort, and it comes with a promise:
never more than 0.5 s from one beat to the next (a deadline). Every so often the promise is broken on purpose.

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
    """Beats for a while, is silent for a while, and so on.

    Topics:
        /robot/status (std_msgs/String): "operational", said once at the start; reliable, transient local.
        /robot/heartbeat (std_msgs/String): "beat 1", "beat 2", ... at 4 Hz; best effort, deadline 0.5 s.

    Parameters (they replace the arguments of the same names):
        beats_for_s: Seconds of beating at a time.
        silent_for_s: Seconds of silence after that; 0.0 for a heart that never stops.

    Raises ValueError for times that are negative or, for the beating, zero.
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
        """Beat, unless this is a time of silence."""
        if self.ticks % self.ticks_in_a_round < self.beats_in_a_row:
            self.beats += 1
            self.beat_publisher.publish(String(data=f"beat {self.beats}"))
        self.ticks += 1


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Heartbeat())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
