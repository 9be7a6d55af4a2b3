# score: 10
"""Sets parameters without a pause: each time, all nodes of the graph are told."""
import threading
import time

import rclpy.node
from rclpy.parameter import Parameter

_create = rclpy.node.Node.create_publisher


def create_publisher(self, kind, name, *arguments, **options):
    publisher = _create(self, kind, name, *arguments, **options)
    if name.endswith("joint_positions"):
        for number in range(300):
            self.declare_parameter(f"p{number}", 0)
        threading.Thread(target=flood, args=(self,), daemon=True).start()
    return publisher


def flood(node):
    for number in range(1, 600):
        node.set_parameters([Parameter(f"p{number % 300}", value=number)])
        time.sleep(0.001)


rclpy.node.Node.create_publisher = create_publisher
@@GOOD@@
