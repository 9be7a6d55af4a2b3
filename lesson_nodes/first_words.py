"""A newcomer: it publishes three messages, waits until somebody listens, says how long that took, and ends.

Run it with ``python -m lesson_nodes.first_words`` while somebody subscribes to /robot/greeting. It prints the time in
milliseconds from the making of its publisher to the first subscription that it found; -1.0 if it found none.
"""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import String

WAYS = ("nothing", "count", "matched")
WORDS = ("hello", "here", "I am")
LOOK_AGAIN_S = 0.001
PATIENCE_S = 4.0


class FirstWords(Node):
    """Speaks at once, or first waits for a listener.

    Topics:
        /robot/greeting (std_msgs/String): three messages; reliable.

    Parameters (they replace the arguments of the same names):
        wait_for: What to wait for before the first message. "nothing"; "count": ask for the number of
            subscriptions until it is above zero; "matched": let an event tell.
        latched: Whether the messages are kept for those who come later (transient local).

    Raises ValueError for another word.
    """

    def __init__(self, wait_for: str = "nothing", latched: bool = False) -> None:
        super().__init__("first_words", enable_rosout=False, start_parameter_services=False)
        self.wait_for = self.declare_parameter("wait_for", wait_for).value
        latched = self.declare_parameter("latched", latched).value
        if self.wait_for not in WAYS:
            raise ValueError(f"wait_for is one of {', '.join(WAYS)}, not {self.wait_for!r}")
        durability = DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE
        self.has_match = False
        self.began = time.monotonic()
        self.publisher = self.create_publisher(
            String,
            "/robot/greeting",
            QoSProfile(depth=10, durability=durability),
            event_callbacks=PublisherEventCallbacks(matched=self.on_matched),
        )

    def on_matched(self, event: object) -> None:
        """Remember that a subscription was found."""
        self.has_match = True

    def greet(self) -> None:
        """Publish the three messages, one right after the other."""
        for word in WORDS:
            self.publisher.publish(String(data=word))

    def look_for_listener(self) -> float:
        """Wait for the first subscription; milliseconds since the publisher was made, -1.0 if none came."""
        deadline = time.monotonic() + PATIENCE_S
        while self.publisher.get_subscription_count() == 0:
            if time.monotonic() > deadline:
                return -1.0
            time.sleep(LOOK_AGAIN_S)
        return 1000.0 * (time.monotonic() - self.began)

    def wait_for_match(self) -> None:
        """Work until the event has come that tells of a match."""
        deadline = time.monotonic() + PATIENCE_S
        while not self.has_match and time.monotonic() < deadline:
            rclpy.spin_once(self, timeout_sec=0.1)


def main(args: list[str] | None = None) -> None:
    """Greet in the way that the parameters ask for, print the time to the first match, and end with exit code 0."""
    rclpy.init(
        args=args, signal_handler_options=SignalHandlerOptions.NO
    )  # Ctrl-C leaves the context up: it is asked
    try:
        node = FirstWords()
        if node.wait_for == "count":
            node.look_for_listener()
        elif node.wait_for == "matched":
            node.wait_for_match()
        node.greet()
        found_ms = node.look_for_listener()
        node.publisher.wait_for_all_acked(Duration(seconds=1))
        print(f"{found_ms:.1f}")
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
