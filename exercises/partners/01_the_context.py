"""The guard's legs and arms, which walk when the guard logs a round, and fold if the guard has parked its arms.

The workbook runs this program along with exercise 01's program and stops it after that program. The workbook also
publishes what exercise 01's program printed after Ctrl-C.
"""

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import Log
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
from std_msgs.msg import Float32MultiArray, String

GUARD = "night_guard"
PARKED = "arms parked"
SPEED_MPS = 0.5
SHOWN_S = 1.5  # how long the node stays in the graph after its last pose, so that the pose is visible
FOLDED = [0.0, 0.0, 0.35, -2.2, 0.35, -2.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
IN_MID_STEP = [0.0, 0.0, 2.6, 0.4, 2.6, 0.4, 0.7, 1.1, 0.3, 0.0, 0.0, 0.0]
LAST_WORDS_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class GuardBody(Node):
    """Moves the body of the night guard.

    Subscriptions:
        /rosout (rcl_interfaces/Log): the log lines of all nodes. The guard's lines about a round make the body walk.
        /driver/last_words (std_msgs/String): the output of the guard's program from Ctrl-C to its exit.

    Topics:
        /robot/cmd_vel (geometry_msgs/Twist): one step forward for each round.
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles (rad), after the guard's program has exited.

    Attributes:
        done: A future that completes 1.5 s after the last pose.
    """

    def __init__(self) -> None:
        super().__init__("guard_body")
        self.done = Future()
        self.walk_publisher = self.create_publisher(Twist, "/robot/cmd_vel", 10)
        self.pose_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_subscription(Log, "/rosout", self.on_log, 100)
        self.create_subscription(String, "/driver/last_words", self.on_last_words, LAST_WORDS_QOS)

    def on_log(self, log: Log) -> None:
        """Take a step if the guard logs a round."""
        if log.name == GUARD and "round" in log.msg:
            step = Twist()
            step.linear.x = SPEED_MPS
            self.walk_publisher.publish(step)

    def on_last_words(self, words: String) -> None:
        """Stop, and fold the arms if the program has parked them. Otherwise, freeze in the middle of a step."""
        self.walk_publisher.publish(Twist())
        self.pose_publisher.publish(Float32MultiArray(data=FOLDED if PARKED in words.data else IN_MID_STEP))
        self.create_timer(SHOWN_S, lambda: self.done.set_result(None))


def main(args: list[str] | None = None) -> None:
    """Run the body until 1.5 s after its last pose, or until Ctrl-C. Then exit with code 0."""
    rclpy.init(args=args)
    body = GuardBody()
    try:
        rclpy.spin_until_future_complete(body, body.done)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
