"""Simulate a humanoid that waves its left hand on request: it offers the service /robot/wave.

Run it with ``python -m lesson_nodes.waves_when_asked`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray
from std_srvs.srv import SetBool

PERIOD_S = 0.05
WAVES_PER_SECOND = 0.8
AT_REST = (0.0, 0.0, 0.15, 0.1, 0.15, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
LEFT_SHOULDER, LEFT_ELBOW = 2, 3


class WavesWhenAsked(Node):
    """Stands still or waves, as requested through a service.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray), 20 Hz: 12 angles in radians.

    Services:
        /robot/wave (std_srvs/SetBool): true to wave, false to stop. `success` is false if the robot already does that.
    """

    def __init__(self) -> None:
        super().__init__("waves_when_asked")
        self.waving = False
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(PERIOD_S, self.publish_joint_positions)
        self.create_service(SetBool, "/robot/wave", self.on_wave)
        self.get_logger().info("Waving robot started")

    def on_wave(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        """Start or stop waving, and report the new state in the response."""
        response.success = request.data != self.waving
        self.waving = request.data
        doing = "waving" if self.waving else "standing still"
        response.message = f"I am {doing}" if response.success else f"I was {doing} already"
        return response

    def publish_joint_positions(self) -> None:
        """Publish the current joint angles."""
        pose = list(AT_REST)
        if self.waving:
            seconds = self.get_clock().now().nanoseconds / 1e9
            pose[LEFT_SHOULDER] = 2.2
            pose[LEFT_ELBOW] = 0.45 + 0.5 * math.sin(2.0 * math.pi * WAVES_PER_SECOND * seconds)
        self.joint_publisher.publish(Float32MultiArray(data=pose))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(WavesWhenAsked())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
