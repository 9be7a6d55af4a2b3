"""Simulate a humanoid that raises its arms when something is close: each distance message sets a pose.

Run it with ``python -m lesson_nodes.careful_robot`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray

CLOSE_M = 1.2
TOUCH_M = 0.2
ARMS_DOWN_RAD = 0.22
ARMS_UP_RAD = 2.45
JOINT_COUNT = 12
LEFT_SHOULDER, LEFT_ELBOW, RIGHT_SHOULDER, RIGHT_ELBOW = 2, 3, 4, 5


def posture(distance_m: float, close_m: float = CLOSE_M) -> list[float]:
    """Compute the pose of a robot with an obstacle in front of it.

    Args:
        distance_m: Distance to the obstacle, in meters.
        close_m: Distance, in meters, below which the arms begin to rise.

    Returns:
        12 angles in radians. The arms are down at `close_m` or farther, and fully up at 0.2 m or nearer.
    """
    worry = min(1.0, max(0.0, (close_m - distance_m) / (close_m - TOUCH_M)))
    angles = [0.0] * JOINT_COUNT
    angles[LEFT_SHOULDER] = angles[RIGHT_SHOULDER] = ARMS_DOWN_RAD + worry * (ARMS_UP_RAD - ARMS_DOWN_RAD)
    angles[LEFT_ELBOW] = angles[RIGHT_ELBOW] = 0.3 * worry - 0.1
    return angles


class CarefulRobot(Node):
    """Raises its arms as an obstacle gets closer.

    The node has no timer and no loop, so it acts only when a message arrives.

    Subscriptions:
        /robot/distance (std_msgs/Float32): distance in meters.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, one pose for each distance.

    Parameters:
        close_m (float): Distance, in meters, below which the arms begin to rise.

    Raises:
        ValueError: close_m is not a finite number above 0.2, the distance at which the arms are fully up.
    """

    def __init__(self) -> None:
        super().__init__("careful_robot")
        self.close_m = self.declare_parameter("close_m", CLOSE_M).value
        if not TOUCH_M < self.close_m < math.inf:
            raise ValueError(
                f"close_m is a distance in meters above {TOUCH_M}, for example 1.2, not {self.close_m}."
            )
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)

    def on_distance(self, message: Float32) -> None:
        """Publish the pose for a distance."""
        self.joint_publisher.publish(Float32MultiArray(data=posture(message.data, self.close_m)))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(CarefulRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
