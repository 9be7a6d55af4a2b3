"""Report a battery's charge with a script: the state is in global variables.

Run it with ``python -m lesson_nodes.battery_script`` and end it with Ctrl-C. It publishes the charge in percent on
/robot/battery (std_msgs/Float32), every two seconds.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Float32

PERIOD_S = 2.0

level = 100.0


def send() -> None:
    """Drain the simulated battery a little, and publish the remaining charge."""
    global level
    level = max(0.0, level - 0.5)
    publisher.publish(Float32(data=level))


if __name__ == "__main__":
    rclpy.init()
    node = rclpy.create_node("battery_script")
    publisher = node.create_publisher(Float32, "/robot/battery", 10)
    node.create_timer(PERIOD_S, send)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
