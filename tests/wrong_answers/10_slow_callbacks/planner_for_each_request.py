# Each request gets a thread and a planner of its own; they search side by side, and keep the order.
# loses: all_in_order
# cause: all-in-order.side-by-side
import math
import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

LINK_M = 0.4  # upper arm and forearm are equally long


class ElbowPlanner:
    """Finds the bend of the elbow that brings the hand to a distance from the shoulder. Leave it as it is.

    It halves the range in which the bend must lie, again and again. It remembers one search: begin the next one only
    when the one before is finished.
    """

    STEPS = 20
    STEP_S = 0.04  # the collision checker takes its time

    def begin(self, distance: float) -> None:
        """Begin a search for a distance in m."""
        self._distance = distance
        self._low, self._high = 0.0, math.pi  # rad; 0 is a straight arm

    def step(self) -> None:
        """One step of the search. Waits for the collision checker."""
        time.sleep(self.STEP_S)
        middle = (self._low + self._high) / 2.0
        if 2.0 * LINK_M * math.cos(middle / 2.0) > self._distance:
            self._low = middle
        else:
            self._high = middle

    def bend(self) -> float:
        """The bend found so far, in rad."""
        return (self._low + self._high) / 2.0

    def plan(self, distance: float) -> float:
        """A whole search: returns the bend (rad) for a distance (m), after 0.8 s."""
        self.begin(distance)
        for _ in range(self.STEPS):
            self.step()
        return self.bend()


class TeaRobot(Node):
    def __init__(self):
        super().__init__("tea_robot")
        self.heartbeat = self.create_publisher(String, "/robot/heartbeat", 10)
        self.plans = self.create_publisher(Float32, "/robot/plan", 10)
        self.create_timer(0.1, lambda: self.heartbeat.publish(String(data="alive")))
        self.create_subscription(Float32, "/robot/plan_request", self.on_request, 10)
        self.before = None

    def on_request(self, request):
        thread = threading.Thread(target=self.work, args=(request.data, self.before), daemon=True)
        self.before = thread
        thread.start()

    def work(self, distance, before):
        bend = ElbowPlanner().plan(distance)
        if before is not None:
            before.join()  # plans leave in the order of their requests
        self.plans.publish(Float32(data=bend))


def main():
    rclpy.init()
    try:
        rclpy.spin(TeaRobot())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
