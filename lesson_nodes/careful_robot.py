"""A humanoid that raises its arms when something is close: each message of its sensor moves it a little.

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
    """The pose of a robot that has something in front of it.

    Args:
        distance_m: How far it is, in meters.
        close_m: From this distance on, in meters, the robot feels that it has to do something.

    Returns:
        12 angles in radians: arms down as long as all is far away, arms up when it is almost touched.
    """
    worry = min(1.0, max(0.0, (close_m - distance_m) / (close_m - TOUCH_M)))
    angles = [0.0] * JOINT_COUNT
    angles[LEFT_SHOULDER] = angles[RIGHT_SHOULDER] = ARMS_DOWN_RAD + worry * (ARMS_UP_RAD - ARMS_DOWN_RAD)
    angles[LEFT_ELBOW] = angles[RIGHT_ELBOW] = 0.3 * worry - 0.1
    return angles


class CarefulRobot(Node):
    """Raises its arms the more, the closer the next wall is.

    It has no timer and no loop: all it does, it does when a message comes.

    Subscriptions:
        /robot/distance (std_msgs/Float32): distance in meters.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, one pose for each distance.

    Parameters:
        close_m (float): From this distance on, in meters, the arms go up.

    Raises:
        ValueError: close_m is not a number above 0.2, where the arms are up already.
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
        """Take the posture that suits this distance."""
        self.joint_publisher.publish(Float32MultiArray(data=posture(message.data, self.close_m)))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(CarefulRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
