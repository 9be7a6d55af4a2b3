"""Try to publish a last message on Ctrl-C. Run it with ``python -m lesson_nodes.last_words ALL``."""

import sys
import time

import rclpy
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import String

from lesson_nodes.night_guard import NightGuard


def main(handled_by: str) -> None:
    """Walk rounds until Ctrl-C, then try to publish "good night".

    `handled_by` is the name of a SignalHandlerOptions member: the signals that rclpy handles.
    """
    rclpy.init(signal_handler_options=getattr(SignalHandlerOptions, handled_by))
    guard = NightGuard()
    radio = guard.create_publisher(String, "/museum/radio", 10)
    try:
        rclpy.spin(guard)
    except KeyboardInterrupt:
        time.sleep(0.5)
        print("context:", "valid" if rclpy.ok() else "shut down")
        guard.get_logger().info("good night")
        radio.publish(String(data="good night"))
        print("said good night")
    rclpy.try_shutdown()


if __name__ == "__main__":
    main(sys.argv[1])
