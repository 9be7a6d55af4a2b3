"""The remote control of lesson 12, which asks the robot to wave, then to stand still, and so on."""

from rclpy.node import Node
from std_srvs.srv import SetBool

PERIOD_S = 2.0


class RemoteControl(Node):
    """Calls /robot/wave (std_srvs/SetBool) every two seconds with alternating values, beginning with true."""

    def __init__(self) -> None:
        super().__init__("remote_control")
        self.wanted = True
        self.wave = self.create_client(SetBool, "/robot/wave")
        self.create_timer(PERIOD_S, self.ask)

    def ask(self) -> None:
        """Send a request without waiting for the response."""
        self.wave.call_async(SetBool.Request(data=self.wanted))
        self.wanted = not self.wanted
