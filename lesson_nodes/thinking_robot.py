"""Simulate a robot that waves, publishes a heartbeat, and regularly thinks for a while in a callback.

Run it with ``python -m lesson_nodes.thinking_robot`` and end it with Ctrl-C.
"""

import math
import threading
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import Executor, ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray, String

HEARTBEAT_PERIOD_S = 0.1
THINK_PERIOD_S = 3.0
THINK_TAKES_S = 1.0
WAVE_PERIOD_S = 2.0
JOINT_COUNT = 12
RIGHT_SHOULDER, RIGHT_ELBOW = 4, 5


class ThinkingRobot(Node):
    """Publishes heartbeats and waves with one timer, and thinks with another.

    Topics:
        /robot/heartbeat (std_msgs/String): "alive".
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, with each heartbeat.
        /robot/thought (std_msgs/String): "done", at the end of each thought.

    Parameters:
        heartbeat_period_s (float): Time between two heartbeats, in seconds.
        think_period_s (float): Time from the start of one thought to the next, in seconds.
        think_takes_s (float): How long the thinking callback takes, in real seconds.
        own_group (bool): Whether the thinking callback has a separate callback group.
        threads (int): Number of executor threads. With 1, the executor is a SingleThreadedExecutor.

    Raises:
        ValueError: A period is not a positive number, `think_takes_s` is negative or not finite, or `threads` < 1.
    """

    def __init__(self) -> None:
        super().__init__("thinking_robot")
        heartbeat_period_s = self.declare_parameter("heartbeat_period_s", HEARTBEAT_PERIOD_S).value
        think_period_s = self.declare_parameter("think_period_s", THINK_PERIOD_S).value
        self.think_takes_s = self.declare_parameter("think_takes_s", THINK_TAKES_S).value
        own_group = self.declare_parameter("own_group", False).value
        self.threads = self.declare_parameter("threads", 1).value
        for period_s in (heartbeat_period_s, think_period_s):
            if not 0.0 < period_s < math.inf:
                raise ValueError(
                    f"A period is the time between two ticks in seconds, for example 0.1, not {period_s}."
                )
        if not 0.0 <= self.think_takes_s < math.inf:
            raise ValueError(f"A thought takes 0 s or longer, not {self.think_takes_s}.")
        if self.threads < 1:
            raise ValueError(f"An executor has 1 thread or more, not {self.threads}.")
        group = MutuallyExclusiveCallbackGroup() if own_group else None
        self.closing = threading.Event()
        self.began = time.monotonic()
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.thought_publisher = self.create_publisher(String, "/robot/thought", 10)
        self.create_timer(heartbeat_period_s, self.beat)
        self.create_timer(think_period_s, self.think, callback_group=group)

    def beat(self) -> None:
        """Publish a heartbeat, and move the waving arm."""
        self.heartbeat_publisher.publish(String(data="alive"))
        phase = 2.0 * math.pi * (time.monotonic() - self.began) / WAVE_PERIOD_S
        angles = [0.0] * JOINT_COUNT
        angles[RIGHT_SHOULDER] = 2.2
        angles[RIGHT_ELBOW] = 0.6 + 0.6 * math.sin(phase)
        self.joint_publisher.publish(Float32MultiArray(data=angles))

    def think(self) -> None:
        """Block the thread for a while, as a slow planner would."""
        if self.closing.wait(self.think_takes_s):
            return
        self.thought_publisher.publish(String(data="done"))


def executor_for(node: ThinkingRobot) -> Executor:
    """Return an executor with as many threads as the node's parameter says."""
    return SingleThreadedExecutor() if node.threads == 1 else MultiThreadedExecutor(num_threads=node.threads)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    node = ThinkingRobot()
    executor = executor_for(node)
    executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.closing.set()  # so that a thought in another thread doesn't delay the exit
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
