"""Plays a battery with a bad cable to a monitor, and writes down what the monitor makes of each reading.

Run it with ``python -m lesson_nodes.battery_desk`` beside a battery monitor, and end it with Ctrl-C.
"""

import math
from collections.abc import Sequence

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

READINGS = (64.0, 63.5, -3.0, 63.0, math.nan, 62.5, 6553.5, 62.0)
PERIOD_S = 0.25
PATIENCE_TICKS = 12
OWN, OTHER = "/robot/battery", "/other_robot/battery"


class BatteryDesk(Node):
    """Says one reading after the other, now and then one of another robot, and listens to the monitor.

    Topics:
        /robot/battery (std_msgs/Float32), published: charge in percent.
        /other_robot/battery (std_msgs/Float32), published: charge of another robot in percent.
        /monitor/battery (std_msgs/Float32), heard: what the monitor passes on.
        /monitor/alarm (std_msgs/String), heard: what it finds wrong.

    Attributes:
        rows: For each reading the topic, the reading, and what the monitor said before the next one.
        done: Whether all readings are said and there was time to answer the last one.
    """

    def __init__(self, readings: Sequence[float] = READINGS) -> None:
        super().__init__("battery_desk")
        self.rows: list[tuple[str, float, list[str]]] = []
        self.done = False
        self.ticks = 0
        self.to_say = [(OWN, float(reading)) for reading in readings] + [(OTHER, 41.5), (OTHER, -40.0)]
        self.publishers_of = {topic: self.create_publisher(Float32, topic, 10) for topic in (OWN, OTHER)}
        self.create_subscription(Float32, "/monitor/battery", self.on_battery, 100)
        self.create_subscription(String, "/monitor/alarm", self.on_alarm, 100)
        self.create_timer(PERIOD_S, self.say_next)

    def say_next(self) -> None:
        """Say the next reading, once somebody listens; if nobody does for three seconds, give up."""
        self.ticks += 1
        if not self.rows and self.publishers_of[OWN].get_subscription_count() == 0:
            self.done = self.ticks >= PATIENCE_TICKS
            return
        if not self.to_say:
            self.done = True
            return
        topic, reading = self.to_say.pop(0)
        self.rows.append((topic, reading, []))
        self.publishers_of[topic].publish(Float32(data=reading))

    def on_battery(self, message: Float32) -> None:
        """Write down what was passed on."""
        self.note(f"passed on {message.data:g}")

    def on_alarm(self, message: String) -> None:
        """Write down what the alarm says."""
        self.note(f'alarm "{message.data}"')

    def note(self, words: str) -> None:
        """Put something down to the reading that was said last."""
        if self.rows:
            self.rows[-1][2].append(words)

    def table(self) -> str:
        """The readings as lines of text, with what the monitor made of them."""
        if not self.rows:
            return f"Nobody listens to {OWN}."
        lines = [
            f"{topic:<20} {reading:>7g}   {', '.join(said) or '-'}" for topic, reading, said in self.rows
        ]
        return "\n".join([f"{'topic':<20} {'reading':>7}   the monitor", *lines])


def main(args: list[str] | None = None) -> None:
    """Run the desk until all is said or Ctrl-C comes, print the table, and leave with exit code 0."""
    rclpy.init(args=args)
    desk = BatteryDesk()
    desk.get_logger().info("Battery desk started")
    try:
        while not desk.done:
            rclpy.spin_once(desk, timeout_sec=0.5)
        print(desk.table(), flush=True)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
