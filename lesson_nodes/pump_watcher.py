"""Watch a robot during a call of `pump`: request the call, send words, and record the robot's messages.

It belongs to exercise 06, whose driver subscribes to /driver/go. Run it with ``python -m lesson_nodes.pump_watcher``
and end it with Ctrl-C.
"""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32, Int32MultiArray, String

ORDER_S = 2.0
WORDS_AFTER_S = 1.0
WORDS = 10


class PumpWatcher(Node):
    """Requests ``pump(robot, 2.0)``, publishes ten words one second later, and records when things happen.

    Topics:
        /driver/go (std_msgs/String): the request, repeated until the call begins.
        /robot/words (std_msgs/Int32): ten numbers, one second after the call begins.

    Subscriptions:
        /driver/pump (std_msgs/String): "begin 1", "end 1 2.001".
        /robot/heartbeat, /robot/heard (std_msgs/Int32MultiArray): beats, and handled words.

    Attributes:
        begin: When the call began (time.monotonic, s); None before that.
        end: When the call returned (time.monotonic, s); None before that.
        rows: Times of events (s after the call began), by kind of event.
    """

    def __init__(self) -> None:
        super().__init__("pump_watcher")
        self.begin: float | None = None
        self.end: float | None = None
        self.words_left = WORDS
        self.rows: dict[str, list[float]] = {"begin and end": [], "heartbeats": [], "words handled": []}
        self.go_publisher = self.create_publisher(String, "/driver/go", 10)
        self.word_publisher = self.create_publisher(Int32, "/robot/words", 100)
        self.create_subscription(String, "/driver/pump", self.on_pump, 10)
        self.create_subscription(Int32MultiArray, "/robot/heartbeat", lambda _: self.note("heartbeats"), 100)
        self.create_subscription(Int32MultiArray, "/robot/heard", lambda _: self.note("words handled"), 100)
        self.create_timer(0.1, self.order)

    @property
    def took(self) -> float | None:
        """The call's duration (s); None until the call returns."""
        return None if self.begin is None or self.end is None else self.end - self.begin

    def order(self) -> None:
        """Publish the request until the call begins. Publish the words one second after that."""
        if self.begin is None:
            self.go_publisher.publish(String(data=f"1 robot {ORDER_S}"))
        elif time.monotonic() - self.begin >= WORDS_AFTER_S:
            while self.words_left > 0:
                self.word_publisher.publish(Int32(data=self.words_left))
                self.words_left -= 1

    def on_pump(self, message: String) -> None:
        """Record when the call begins and when it returns."""
        if self.end is not None or (self.begin is not None and message.data.startswith("begin")):
            return  # a repeated report
        if self.begin is None:
            self.begin = time.monotonic()
        else:
            self.end = time.monotonic()
        self.note("begin and end")

    def note(self, row: str) -> None:
        """Record the current time for an event of this kind."""
        if self.begin is not None:
            self.rows[row].append(time.monotonic() - self.begin)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(PumpWatcher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
