"""Whether a program that was started got through its first lines, or is about to end with an error."""

import time

from rcl_interfaces.srv import ListParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from workbook.observing.process import NodeProcess
from workbook.ros.standing import standing_node

PATIENCE_S = 3.0
"""For programs whose nodes never answer: they have no parameter services, or a callback keeps them busy."""


def wait_until_it_serves(process: NodeProcess, node: str) -> None:
    """Return once the node (full name) has answered a question, which only a spinning node does.

    A node is on the graph as soon as its base class is made. What comes after that in the program may still fail, so
    seeing its name is not enough. Returns early when the program ends, and after three seconds at the latest.
    """
    context = standing_node().context
    asker = Node(
        "_asker",
        context=context,
        enable_rosout=False,
        start_parameter_services=False,
        use_global_arguments=False,
    )
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(asker)
    client = asker.create_client(ListParameters, f"{node}/list_parameters")
    answer = None
    deadline = time.monotonic() + PATIENCE_S
    try:
        while process.is_running() and time.monotonic() < deadline and not (answer and answer.done()):
            if answer is None and client.service_is_ready():
                answer = client.call_async(ListParameters.Request())
            executor.spin_once(timeout_sec=0.02)
    finally:
        executor.shutdown()
        asker.destroy_node()
