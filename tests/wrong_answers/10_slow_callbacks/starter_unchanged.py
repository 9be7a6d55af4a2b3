# loses: heartbeat_share, heartbeat_gap
# says: While a plan is made, nobody serves the timer
"""A humanoid that shows its heartbeat, and plans the bend of its elbow when asked."""

import math
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 0.1  # 10 Hz
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
    """Beats ten times a second, and plans its elbow when asked.

    Topics:
        /robot/heartbeat (std_msgs/String), 10 Hz: "alive".
        /robot/plan (std_msgs/Float32): the bend of the elbow in rad, one for each request.

    Subscriptions:
        /robot/plan_request (std_msgs/Float32): distance of the hand from the shoulder in m.
    """

    def __init__(self) -> None:
        super().__init__("tea_robot")
        self.planner = ElbowPlanner()
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.plan_publisher = self.create_publisher(Float32, "/robot/plan", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        self.create_subscription(Float32, "/robot/plan_request", self.on_request, 10)

    def beat(self) -> None:
        """Show that the robot is well."""
        self.heartbeat_publisher.publish(String(data="alive"))

    def on_request(self, request: Float32) -> None:
        """Plan the elbow for the distance asked for. This takes 0.8 s."""
        # TODO: while this callback plans, the heart stands still. Give the planning another place.
        bend = self.planner.plan(request.data)
        self.plan_publisher.publish(Float32(data=bend))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TeaRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
