"""Waiting until a program that was just started is on the graph and at work, or has ended with an error."""

import time
from collections import Counter

from rcl_interfaces.srv import ListParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.utilities import get_default_context

from workbook.programs.process import NodeProcess
from workbook.ros.fresh_nodes import nodes_in
from workbook.ros.kernel_node import kernel_node
from workbook.watching.quiescence import Quiescence

NODES_WITHIN_S = 10.0
"""A program whose node has not appeared by then is taken for one without a node. It may come up later all the same."""
SERVES_WITHIN_S = 30.0
"""On a machine so busy that a program takes this long, its first error is shown late rather than not at all."""
IDLE_S = 3.0
"""For programs whose nodes never reply: they have no parameter services, or a callback keeps them busy."""
POLL_S = 0.02


def wait_until_it_serves(process: NodeProcess, node: str) -> None:
    """Return once the node (fully qualified name) has replied to a service request, which only a spinning node does.

    A node is on the graph as soon as its base class is made. What comes after that in the program may still fail, so
    seeing its name is not enough. Returns early when the program ends, and when it has been idle for three seconds
    without a reply. A program that is busy, or waits for a processor, is given half a minute.
    """
    context = kernel_node().context
    client_node = Node(
        "_startup_client",
        context=context,
        enable_rosout=False,
        start_parameter_services=False,
        use_global_arguments=False,
    )
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(client_node)
    client = client_node.create_client(ListParameters, f"{node}/list_parameters")
    reply = None
    quiescence = Quiescence(process.pid)
    idle = 0.0
    last = time.monotonic()
    deadline = last + SERVES_WITHIN_S
    try:
        while process.is_running() and idle < IDLE_S and not (reply and reply.done()):
            if reply is None and client.service_is_ready():
                reply = client.call_async(ListParameters.Request())
            executor.spin_once(timeout_sec=POLL_S)
            now = time.monotonic()
            if quiescence.is_quiet():
                idle += now - last
            last = now
            if now > deadline:
                break
    finally:
        quiescence.close()
        executor.shutdown()
        client_node.destroy_node()


def wait_for_nodes(process: NodeProcess, known: Counter[str]) -> list[str]:
    """Names of nodes that appeared on the graph since `known`, as soon as there is one.

    A duplicate of a known name counts as well. Returns an empty list when the program ends or ten seconds have passed.
    Nodes that this notebook has just made with `fresh` may come onto the graph meanwhile; they are left out.
    """
    own = own_names()
    deadline = time.monotonic() + NODES_WITHIN_S
    while time.monotonic() < deadline:
        now = node_names()
        new = sorted(now - (known | own))
        known = known & now  # one that has gone since is no longer known: its name may come again
        if new or not process.is_running():
            return new
        time.sleep(POLL_S)
    return []


def waiting_for_clock(nodes: list[str]) -> list[str]:
    """Those of some nodes that wait for `/clock` while nothing publishes it: their timers never fire."""
    node = kernel_node()
    if node.count_publishers("/clock"):
        return []
    found = node.get_subscriptions_info_by_topic("/clock")
    listening = {f"{info.node_namespace.rstrip('/')}/{info.node_name}" for info in found}
    return [name for name in nodes if name in listening]


def own_names() -> Counter[str]:
    """Fully qualified names of the nodes that this notebook made with `fresh`."""
    return Counter(node.get_fully_qualified_name() for node in nodes_in(get_default_context()))


def node_names() -> Counter[str]:
    """Fully qualified names of all nodes on this notebook's domain, hidden ones left out."""
    found = kernel_node().get_node_names_and_namespaces()
    return Counter(f"{namespace.rstrip('/')}/{name}" for name, namespace in found if not name.startswith("_"))
