"""Publish three messages right after the start, and measure how long it takes to find a subscription.

Run it with ``python -m lesson_nodes.first_words`` while another program subscribes to /robot/greeting. It prints the
time from the creation of its publisher until it found a subscription, in milliseconds; -1.0 if it found none.
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
    """Publishes its messages right away, or waits for a subscription first.

    Topics:
        /robot/greeting (std_msgs/String): three messages; reliable.

    Parameters (each overrides the argument of the same name):
        wait_for: What to wait for before the first message. "nothing": don't wait; "count": poll the
            number of subscriptions until it's above zero; "matched": wait for the publisher's matched event.
        latched: Whether to keep the messages for late subscriptions (transient local).

    Raises ValueError for any other value of `wait_for`.
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
        """Record that a subscription was found."""
        self.has_match = True

    def greet(self) -> None:
        """Publish the three messages, one right after another."""
        for word in WORDS:
            self.publisher.publish(String(data=word))

    def look_for_listener(self) -> float:
        """Wait up to 4 s for a subscription. Return the publisher's age at that time (ms), or -1.0 without one."""
        deadline = time.monotonic() + PATIENCE_S
        while self.publisher.get_subscription_count() == 0:
            if time.monotonic() > deadline:
                return -1.0
            time.sleep(LOOK_AGAIN_S)
        return 1000.0 * (time.monotonic() - self.began)

    def wait_for_match(self) -> None:
        """Spin until the matched event has occurred, for at most 4 s."""
        deadline = time.monotonic() + PATIENCE_S
        while not self.has_match and time.monotonic() < deadline:
            rclpy.spin_once(self, timeout_sec=0.1)


def main(args: list[str] | None = None) -> None:
    """Publish the messages as the parameters specify, print the time to the first match (ms), and exit with code 0."""
    rclpy.init(
        args=args, signal_handler_options=SignalHandlerOptions.NO
    )  # the loops below need a valid context until Ctrl-C ends them
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
