"""Report a battery's charge with a closure: an inner function uses the outer function's variables.

Run it with ``python -m lesson_nodes.battery_closure`` and end it with Ctrl-C. It publishes the charge in percent on
/robot/battery (std_msgs/Float32), every two seconds.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Float32

PERIOD_S = 2.0


def main() -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init()
    node = rclpy.create_node("battery_closure")
    publisher = node.create_publisher(Float32, "/robot/battery", 10)
    level = 100.0

    def send() -> None:
        nonlocal level
        level = max(0.0, level - 0.5)
        publisher.publish(Float32(data=level))

    node.create_timer(PERIOD_S, send)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
