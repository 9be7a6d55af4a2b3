"""The robot that tests itself in exercise 12. It moves its joints, and responds right away, late, or never."""

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Float32MultiArray
from std_srvs.srv import Trigger

from lesson_nodes.self_test_server import SelfTestServer

RESPONSES = ("ok", "faulty", "slow", "never", "ok")
MOVED_S = 0.35
AT_REST = [0.0, 0.0, 0.22, -0.12, 0.22, -0.12, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
TESTING = [0.15, 0.1, 0.9, 0.5, 0.9, 0.5, 0.2, 0.3, 0.1, 0.2, 0.3, 0.1]


class SelfTestingRobot(SelfTestServer):
    """Moves each joint a little and back whenever its self-test is called.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles (rad), when a test begins and when it ends.
    """

    def __init__(self) -> None:
        super().__init__()
        self.pattern = list(RESPONSES)
        self.publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)

    async def on_call(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Move, and respond as `RESPONSES` says for this call."""
        self.publisher.publish(Float32MultiArray(data=TESTING))
        self.passed(MOVED_S).add_done_callback(
            lambda _: self.publisher.publish(Float32MultiArray(data=AT_REST))
        )
        return await super().on_call(request, response)


def main(args: list[str] | None = None) -> None:
    """Run the robot until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(SelfTestingRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
