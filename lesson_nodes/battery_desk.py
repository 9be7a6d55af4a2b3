"""Simulate a battery sensor with a bad cable, and record how a battery monitor handles each reading.

Run it with ``python -m lesson_nodes.battery_desk`` while a battery monitor is running, and end it with Ctrl-C.
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
HEAD_START_TICKS = 2
OWN, OTHER = "/robot/battery", "/other_robot/battery"


class BatteryDesk(Node):
    """Publishes its readings, then two readings from another robot, and records the monitor's messages.

    Topics:
        /robot/battery (std_msgs/Float32), published: charge in percent.
        /other_robot/battery (std_msgs/Float32), published: another robot's charge in percent.
        /monitor/battery (std_msgs/Float32), received: the readings that the monitor passes on.
        /monitor/alarm (std_msgs/String), received: the monitor's alarms.

    Attributes:
        rows: For each reading, its topic, its value (percent), and the monitor's messages before the next reading.
        done: Whether the monitor has had time to react to the last reading, or no monitor was found.
    """

    def __init__(self, readings: Sequence[float] = READINGS) -> None:
        super().__init__("battery_desk")
        self.rows: list[tuple[str, float, list[str]]] = []
        self.done = False
        self.ticks = 0
        self.ticks_with_monitor = 0
        self.to_say = [(OWN, float(reading)) for reading in readings] + [(OTHER, 41.5), (OTHER, -40.0)]
        self.publishers_of = {topic: self.create_publisher(Float32, topic, 10) for topic in (OWN, OTHER)}
        self.create_subscription(Float32, "/monitor/battery", self.on_battery, 100)
        self.create_subscription(String, "/monitor/alarm", self.on_alarm, 100)
        self.create_timer(PERIOD_S, self.say_next)

    def say_next(self) -> None:
        """Publish the next reading. Before the first one, wait for a subscription, but give up after 3 s.

        Then wait a little longer, because the monitor needs time to discover the desk's subscriptions.
        """
        self.ticks += 1
        if not self.rows and self.publishers_of[OWN].get_subscription_count() == 0:
            self.done = self.ticks >= PATIENCE_TICKS
            return
        self.ticks_with_monitor += 1
        if self.ticks_with_monitor <= HEAD_START_TICKS:
            return
        if not self.to_say:
            self.done = True
            return
        topic, reading = self.to_say.pop(0)
        self.rows.append((topic, reading, []))
        self.publishers_of[topic].publish(Float32(data=reading))

    def on_battery(self, message: Float32) -> None:
        """Record a reading that the monitor passed on."""
        self.note(f"passed on {message.data:g}")

    def on_alarm(self, message: String) -> None:
        """Record an alarm."""
        self.note(f'alarm "{message.data}"')

    def note(self, words: str) -> None:
        """Add an entry to the row of the latest reading."""
        if self.rows:
            self.rows[-1][2].append(words)

    def table(self) -> str:
        """Return a table of the readings and the monitor's messages, one line per reading."""
        if not self.rows:
            return f"Nobody listens to {OWN}."
        lines = [
            f"{topic:<20} {reading:>7g}   {', '.join(said) or '-'}" for topic, reading, said in self.rows
        ]
        return "\n".join([f"{'topic':<20} {'reading':>7}   the monitor", *lines])


def main(args: list[str] | None = None) -> None:
    """Run the desk until it's done, and print the table. On Ctrl-C or SIGTERM, exit early with code 0."""
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
