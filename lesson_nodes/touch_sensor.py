"""The skin of a hand: it numbers each touch and reports it, sometimes several in one moment.

It begins when enough others listen. Run it with ``python -m lesson_nodes.touch_sensor`` and end it with Ctrl-C.
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
    """When the hand is touched: pairs of the moment (s) and how often at once. The same in every run.

    Raises:
        ValueError: There is no touch to plan.
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
    """Reports touches with a running number, from 1 on.

    Topics:
        /robot/touch (std_msgs/Int32): the number of the touch.

    Parameters:
        touches (int): How many touches there are in all.
        listeners (int): How many subscriptions it waits for before it begins.
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
        """Report the touches that are due."""
        if self.began is None:
            if self.touch_publisher.get_subscription_count() < self.listeners:
                return
            self.began = time.monotonic()
        while self.plan and self.plan[0][0] <= time.monotonic() - self.began:
            for _ in range(self.plan.pop(0)[1]):
                self.number += 1
                self.touch_publisher.publish(Int32(data=self.number))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TouchSensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
