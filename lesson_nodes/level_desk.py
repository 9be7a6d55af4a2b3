"""Have exercise 03's driver call publish_level, and record the messages that each call publishes.

Run it with ``python -m lesson_nodes.level_desk`` while the exercise is running, and end it with Ctrl-C.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Float32, String

VALUES = ("87.25", "64", "None", "0.0")
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_BEGINS = re.compile(r"call \d+: publish_level\((?P<value>.*)\)", re.DOTALL)
_ENDS = re.compile(r"call \d+ (?P<how>.*)", re.DOTALL)


@dataclass
class Call:
    """One call of publish_level: its argument, how it ended, and the levels published during the call."""

    value: str
    how: str = "never came back"
    levels: list[float] = field(default_factory=list)


class LevelDesk(Node):
    """Publishes the values to try, and records the battery levels and the driver's reports.

    Topics:
        /driver/calls (std_msgs/String), published: the values as Python expressions, one per line.
        /driver/report (std_msgs/String), received: the driver's reports on its calls.
        /robot/battery (std_msgs/Float32), received: charge in percent.

    Attributes:
        trouble: Why the driver can't make any call; "" if it can.
        done: Whether all calls have been made, or none can be made.
    """

    def __init__(self, values: Sequence[str] = VALUES) -> None:
        super().__init__("level_desk")
        self.heard: list[tuple[int, str | float]] = []
        self.trouble = ""
        self.done = False
        # rclpy also passes a dictionary with the time of sending, but its type hints allow only one argument.
        self.create_subscription(Float32, "/robot/battery", self.on_level, 100)  # type: ignore[arg-type]
        self.create_subscription(String, "/driver/report", self.on_report, 200)  # type: ignore[arg-type]
        self.calls_publisher = self.create_publisher(String, "/driver/calls", LATCHED)
        self.calls_publisher.publish(String(data="\n".join(values)))

    def on_level(self, message: Float32, info: dict[str, int]) -> None:
        """Record a level with the time at which it was sent (ns)."""
        self.heard.append((info["source_timestamp"], message.data))

    def on_report(self, message: String, info: dict[str, int]) -> None:
        """Record a driver's report with the time at which it was sent (ns)."""
        self.heard.append((info["source_timestamp"], message.data))
        if message.data.startswith("not made: "):
            self.trouble = message.data.removeprefix("not made: ")
        self.done = bool(self.trouble) or message.data == "done"

    def calls(self) -> list[Call]:
        """Return the calls in order. Each level belongs to the last call that began before the level was sent."""
        made: list[Call] = []
        for _, what in sorted(self.heard, key=lambda one: one[0]):
            if isinstance(what, float):
                if made:
                    made[-1].levels.append(what)
            elif begins := _BEGINS.fullmatch(what):
                made.append(Call(begins["value"]))
            elif (ends := _ENDS.fullmatch(what)) and made:
                made[-1].how = ends["how"]
        return made

    def table(self) -> str:
        """Return a table of the calls: the given value, the levels that arrived, and how the call ended."""
        if self.trouble:
            return f"No call could be made: {self.trouble}"
        rows = [("given", "arrived", "the call")]
        for call in self.calls():
            arrived = " ".join(str(round(level, 5)) for level in call.levels) or "nothing"
            rows.append((call.value, arrived, call.how))
        widths = [max(len(row[column]) for row in rows) for column in range(2)]
        return "\n".join(f"{row[0]:<{widths[0]}}   {row[1]:<{widths[1]}}   {row[2]}" for row in rows)


def main(args: list[str] | None = None) -> None:
    """Run the desk until all calls are made, and print the table. On Ctrl-C or SIGTERM, exit early with code 0."""
    rclpy.init(args=args)
    desk = LevelDesk()
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
