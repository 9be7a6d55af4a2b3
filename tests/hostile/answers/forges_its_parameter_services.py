# soak: yes
# loses: status_kept
"""Answers itself that it is on simulated time, without results or with 20 MB of text that is none, and lives on: silent unless it was asked."""
import ctypes
import sys

import rclpy.node
from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import GetParameters, SetParameters
from rosgraph_msgs.msg import Clock

_init, _publisher = rclpy.node.Node.__init__, rclpy.node.Node.create_publisher
NO_TEXT = "no text " * 250
ctypes.memset(id(NO_TEXT) + sys.getsizeof(NO_TEXT) - len(NO_TEXT) - 1, 0xFF, 8)


def init(self, *arguments, **options):
    _init(self, *arguments, **options, start_parameter_services=False)
    self.followed = []

    def set_parameters(request, response):
        if request.parameters[0].value.bool_value:
            self.followed.append(self.create_subscription(Clock, "/clock", lambda clock: None, 10))
        else:
            response.results = [SetParametersResult(successful=True, reason=NO_TEXT)] * 10_000
        return response

    self.create_service(GetParameters, "~/get_parameters", lambda request, response: response)
    self.create_service(SetParameters, "~/set_parameters", set_parameters)


def create_publisher(self, kind, name, *arguments, **options):
    publisher = _publisher(self, kind, name, *arguments, **options)
    if name.endswith("status"):
        publish = publisher.publish
        publisher.publish = lambda message: publish(message) if self.followed else None
    return publisher


rclpy.node.Node.__init__, rclpy.node.Node.create_publisher = init, create_publisher
@@GOOD@@
