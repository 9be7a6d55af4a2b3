"""Whether a program that was started got through its first lines, or is about to end with an error."""

import time

from rcl_interfaces.srv import ListParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from workbook.observing.process import NodeProcess
from workbook.observing.rest import Rest
from workbook.ros.standing import standing_node

LONGEST_S = 30.0
PATIENCE_S = 3.0
"""For programs whose nodes never answer: they have no parameter services, or a callback keeps them busy."""


def wait_until_it_serves(process: NodeProcess, node: str) -> None:
    """Return once the node (full name) has answered a question, which only a spinning node does.

    A node is on the graph as soon as its base class is made. What comes after that in the program may still fail, so
    seeing its name is not enough. Returns early when the program ends, and when it has been at rest for three seconds
    without an answer. A program that is still at work, or waits for a processor, is given half a minute.
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
    rest = Rest(process.pid)
    rested = 0.0
    last = time.monotonic()
    deadline = last + LONGEST_S
    try:
        while process.is_running() and rested < PATIENCE_S and not (answer and answer.done()):
            if answer is None and client.service_is_ready():
                answer = client.call_async(ListParameters.Request())
            executor.spin_once(timeout_sec=0.02)
            now = time.monotonic()
            if rest.now():
                rested += now - last
            last = now
            if now > deadline:
                break
    finally:
        rest.close()
        executor.shutdown()
        asker.destroy_node()
