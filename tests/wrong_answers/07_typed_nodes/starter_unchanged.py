# loses: clean, wrong_message_found, wrong_value_found, numbers_arrive, refuses_wrong_types, refuses_wrong_words
# says: Function is missing a return type annotation
"""Reports battery and status of a humanoid. Others send through it, too, and cannot get the types wrong unnoticed."""

# TODO 1: what do you need from typing?
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

BATTERY_PERIOD_S = 1.0
STATUS_PERIOD_S = 2.0
DRAIN_PERCENT = 0.125

# TODO 2: a Protocol with a publish method for one type of message, and a function that makes such a publisher
# TODO 3: a type for the two words of the status


class RobotReport(Node):
    """Reports the charge in percent and one word on how the robot is.

    Topics:
        /robot/battery (std_msgs/Float32), 1 Hz: charge in percent.
        /robot/status (std_msgs/String), 0.5 Hz: "operational" or "error".
    """

    # TODO 4: hints for every function, and for what others use
    def __init__(self):
        super().__init__("robot_report")
        self.level = 100.0
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_timer(BATTERY_PERIOD_S, self.report_battery)
        self.create_timer(STATUS_PERIOD_S, self.report_status)

    def report_battery(self):
        """Drain the simulated battery a little and report it."""
        self.level = max(0.0, self.level - DRAIN_PERCENT)
        self.send_battery(self.level)

    def report_status(self):
        """Report whether the robot can work."""
        self.send_status("operational" if self.level > 0.0 else "error")

    def send_battery(self, level):
        """Send a charge in percent."""
        # TODO 5: what is no number raises a TypeError, and nothing is sent; a whole number is sent as a float
        self.battery_publisher.publish(Float32(data=level))

    def send_status(self, word):
        """Send one of the two agreed words."""
        # TODO 6: another word raises a ValueError, and nothing is sent
        self.status_publisher.publish(String(data=word))


def main():
    """Run the node until Ctrl-C or a request to end."""
    rclpy.init()
    try:
        rclpy.spin(RobotReport())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
