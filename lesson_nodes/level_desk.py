"""Asks the driver of exercise 03 for calls of publish_level, and writes down what went out because of each.

Run it with ``python -m lesson_nodes.level_desk`` beside the started exercise, and end it with Ctrl-C.
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
    """One call of publish_level: its argument, how it ended, and what went out meanwhile."""

    value: str
    how: str = "never came back"
    levels: list[float] = field(default_factory=list)


class LevelDesk(Node):
    """Says which values to try, and listens to the battery and to the driver.

    Topics:
        /driver/calls (std_msgs/String), published: the values as Python expressions, one a line.
        /driver/report (std_msgs/String), heard: what the driver does.
        /robot/battery (std_msgs/Float32), heard: charge in percent.

    Attributes:
        trouble: Why no call can be made, "" if they can.
        done: Whether all calls have been made, or none can be.
    """

    def __init__(self, values: Sequence[str] = VALUES) -> None:
        super().__init__("level_desk")
        self.heard: list[tuple[int, str | float]] = []
        self.trouble = ""
        self.done = False
        # rclpy's hints know callbacks of one argument only; the second one is told when the message was sent.
        self.create_subscription(Float32, "/robot/battery", self.on_level, 100)  # type: ignore[arg-type]
        self.create_subscription(String, "/driver/report", self.on_report, 200)  # type: ignore[arg-type]
        self.calls_publisher = self.create_publisher(String, "/driver/calls", LATCHED)
        self.calls_publisher.publish(String(data="\n".join(values)))

    def on_level(self, message: Float32, info: dict[str, int]) -> None:
        """Write down a level with the moment at which it was sent."""
        self.heard.append((info["source_timestamp"], message.data))

    def on_report(self, message: String, info: dict[str, int]) -> None:
        """Write down what the driver says of its calls, with the moment at which it said so."""
        self.heard.append((info["source_timestamp"], message.data))
        if message.data.startswith("not made: "):
            self.trouble = message.data.removeprefix("not made: ")
        self.done = bool(self.trouble) or message.data == "done"

    def calls(self) -> list[Call]:
        """The calls in order. A level belongs to the call that was announced last before it was sent."""
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
        """The calls as lines of text: what was given, what arrived, and how the call ended."""
        if self.trouble:
            return f"No call could be made: {self.trouble}"
        rows = [("given", "arrived", "the call")]
        for call in self.calls():
            arrived = " ".join(str(round(level, 5)) for level in call.levels) or "nothing"
            rows.append((call.value, arrived, call.how))
        widths = [max(len(row[column]) for row in rows) for column in range(2)]
        return "\n".join(f"{row[0]:<{widths[0]}}   {row[1]:<{widths[1]}}   {row[2]}" for row in rows)


def main(args: list[str] | None = None) -> None:
    """Run the desk until all calls are made or Ctrl-C comes, print the table, and leave with exit code 0."""
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
