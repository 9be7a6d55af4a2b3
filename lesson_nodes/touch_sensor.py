"""Simulate the skin of a hand: number each touch, and publish it. Sometimes, several touches are simultaneous.

It waits for enough subscriptions. Run it with ``python -m lesson_nodes.touch_sensor`` and end it with Ctrl-C.
"""

import random
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32

TOUCHES = 120
LOOK_PERIOD_S = 0.005
PAUSE_S = (0.05, 0.25)
AT_ONCE = (1, 2, 4, 5, 6)


def touch_plan(touches: int, seed: int = 11) -> list[tuple[float, int]]:
    """Return pairs of a time (s) and a number of simultaneous touches. They are the same in every run.

    Raises:
        ValueError: `touches` is below 1.
    """
    if touches < 1:
        raise ValueError(f"A plan has 1 touch or more, not {touches}.")
    chance = random.Random(seed)
    plan: list[tuple[float, int]] = []
    moment = 0.5
    left = touches
    while left > 0:
        moment += chance.uniform(*PAUSE_S)
        at_once = min(left, chance.choice(AT_ONCE))
        plan.append((moment, at_once))
        left -= at_once
    return plan


class TouchSensor(Node):
    """Publishes touches, numbered from 1.

    Topics:
        /robot/touch (std_msgs/Int32): the touch's number.

    Parameters:
        touches (int): Total number of touches.
        listeners (int): Number of subscriptions to wait for before the first touch.
    """

    def __init__(self) -> None:
        super().__init__("touch_sensor")
        self.plan = touch_plan(self.declare_parameter("touches", TOUCHES).value)
        self.listeners = self.declare_parameter("listeners", 1).value
        self.began: float | None = None
        self.number = 0
        self.touch_publisher = self.create_publisher(Int32, "/robot/touch", 100)
        self.create_timer(LOOK_PERIOD_S, self.feel)

    def feel(self) -> None:
        """Publish the touches that are due."""
        if self.began is None:
            if self.touch_publisher.get_subscription_count() < self.listeners:
                return
            self.began = time.monotonic()
        while self.plan and self.plan[0][0] <= time.monotonic() - self.began:
            for _ in range(self.plan.pop(0)[1]):
                self.number += 1
                self.touch_publisher.publish(Int32(data=self.number))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TouchSensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
