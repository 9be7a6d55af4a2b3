"""Wait until a newly started program is in the graph and spinning, or has exited."""

import time
from collections import Counter

from rcl_interfaces.srv import ListParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.utilities import get_default_context

from workbook.programs.process import NodeProcess
from workbook.ros.fresh_nodes import nodes_in
from workbook.ros.kernel_node import kernel_node
from workbook.watching.rest import RestDetector

NODES_WITHIN_S = 10.0
"""The longest wait (s) for a node. After that, we assume that the program has none, even if one appears later."""
SERVES_WITHIN_S = 30.0
"""The longest wait (s) for a program that keeps working. It's long, so that a busy machine shows the program's first
error late rather than not at all.
"""
IDLE_S = 3.0
"""The longest wait (s) for an idle program. Its nodes may lack parameter services, or a callback may block them."""
GONE_WITHIN_S = 1.0
"""The longest wait (s) for a stopped program's nodes to leave the graph. A killed program's nodes stay much longer."""
POLL_S = 0.02


def wait_until_it_serves(process: NodeProcess, node: str) -> None:
    """Wait until a node responds to a service request, which only a spinning node does.

    `node`: the node's fully qualified name. A node is in the graph as soon as its base class is initialized. Later
    lines of the program may still fail, so seeing the node's name isn't enough. Return early if the program exits, or
    if it has been idle for three seconds without a response. The longest wait is 30 seconds.
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
    rest = RestDetector(process.pid)
    idle = 0.0
    last = time.monotonic()
    deadline = last + SERVES_WITHIN_S
    try:
        while process.is_running() and idle < IDLE_S and not (reply and reply.done()):
            if reply is None and client.service_is_ready():
                reply = client.call_async(ListParameters.Request())
            executor.spin_once(timeout_sec=POLL_S)
            now = time.monotonic()
            if rest.is_quiet():
                idle += now - last
            last = now
            if now > deadline:
                break
    finally:
        rest.close()
        executor.shutdown()
        client_node.destroy_node()


def wait_for_nodes(process: NodeProcess, known: Counter[str]) -> list[str]:
    """Wait until nodes that aren't in `known` appear in the graph, and return their names.

    A second node with a known name counts, too. Nodes that this notebook creates with `fresh` during the wait don't
    count. Return an empty list if the program exits first, or if no node appears within ten seconds.
    """
    own = own_names()
    deadline = time.monotonic() + NODES_WITHIN_S
    while time.monotonic() < deadline:
        now = node_names()
        new = sorted(now - (known | own))
        known = known & now  # a node that has left is no longer known, because its name may appear again
        if new or not process.is_running():
            return new
        time.sleep(POLL_S)
    return []


def wait_until_gone(nodes: Counter[str]) -> None:
    """Wait, at most one second, until each of a stopped program's nodes has left the graph.

    `nodes`: the number of nodes of each name that the graph contained. A program announces over DDS that it's leaving,
    but the announcement may arrive after the process has exited.
    """

    def are_there() -> bool:
        now = node_names()
        return any(now[name] >= number for name, number in nodes.items())

    deadline = time.monotonic() + GONE_WITHIN_S
    while are_there() and time.monotonic() < deadline:
        time.sleep(POLL_S)


def waiting_for_clock(nodes: list[str]) -> list[str]:
    """Return the nodes that wait for `/clock` while nothing publishes it, so that their timers never fire."""
    node = kernel_node()
    if node.count_publishers("/clock"):
        return []
    found = node.get_subscriptions_info_by_topic("/clock")
    listening = {f"{info.node_namespace.rstrip('/')}/{info.node_name}" for info in found}
    return [name for name in nodes if name in listening]


def own_names() -> Counter[str]:
    """Count the nodes that this notebook made with `fresh`, by fully qualified name."""
    return Counter(node.get_fully_qualified_name() for node in nodes_in(get_default_context()))


def node_names() -> Counter[str]:
    """Count the nodes on this notebook's domain, except hidden ones, by fully qualified name."""
    found = kernel_node().get_node_names_and_namespaces()
    return Counter(f"{namespace.rstrip('/')}/{name}" for name, namespace in found if not name.startswith("_"))
