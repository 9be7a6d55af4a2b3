"""Waiting until DDS discovery is complete, with a hidden, short-lived node that reads the graph of a domain."""

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager

from rclpy.context import Context
from rclpy.node import Node
from rclpy.utilities import get_default_context

from workbook.inside.proc import udp_ports_in_use
from workbook.ros.domains import dds_port_range

NODE_UNKNOWN = "_NODE_NAME_UNKNOWN_"
_QUIET_S = 0.1
"""Discovery counts as complete when nothing new has come for so long."""
_POLL_S = 0.005
_FIRST_PARTICIPANT_PORT = 10
"""Offset of participant 0 within the ports of a domain (DDS-RTPS specification, section 9.6.1)."""


def current_domain() -> int:
    """The domain of this notebook: that of the running default context, or the one of the environment."""
    context = get_default_context()
    return context.get_domain_id() if context.ok() else int(os.environ.get("ROS_DOMAIN_ID") or 0)


@contextmanager
def discovery_node(domain_id: int | None = None) -> Iterator[Node]:
    """A hidden node on `domain_id` (default: the current domain) that goes when the block ends.

    It joins the context of this notebook where there is one, whose discovery is done already.
    """
    wanted = current_domain() if domain_id is None else domain_id
    shared = get_default_context()
    own: Context | None = None
    if not shared.ok() or shared.get_domain_id() != wanted:
        own = Context()
        own.init(args=[], initialize_logging=False, domain_id=wanted)
    node = Node(
        f"_workbook_probe_{os.getpid()}",
        context=own or shared,
        use_global_arguments=False,
        enable_rosout=False,
        start_parameter_services=False,
    )
    try:
        yield node
    finally:
        node.destroy_node()
        if own is not None:
            own.try_shutdown()
            own.destroy()


def _participants(node: Node) -> set[bytes]:
    """Participants discovered on the domain: one GUID prefix per process and context."""
    infos = node.get_publishers_info_by_topic("ros_discovery_info", no_mangle=True)
    return {bytes(info.endpoint_gid[:12]) for info in infos}


def _participants_here(domain_id: int) -> int:
    """How many participants this machine has on the domain: each holds one UDP port with an even number."""
    ports = dds_port_range(domain_id)
    used = udp_ports_in_use() & set(ports)
    return sum(1 for port in used if port - ports.start >= _FIRST_PARTICIPANT_PORT and port % 2 == 0)


def _view(node: Node) -> tuple[tuple[str, ...], bool]:
    """The endpoints known now, and whether the node name of one is still unknown."""
    topics = node.get_topic_names_and_types()
    endpoints = []
    for name, _ in topics:
        endpoints += node.get_publishers_info_by_topic(name)
        endpoints += node.get_subscriptions_info_by_topic(name)
    nameless = any(info.node_name == NODE_UNKNOWN for info in endpoints)
    return tuple(sorted(bytes(info.endpoint_gid).hex() for info in endpoints)), nameless


def wait_for_graph(node: Node, limit: float = 2.0) -> None:
    """Wait until every participant on this machine's domain is discovered and nothing new comes, at most `limit` s."""
    domain_id = node.context.get_domain_id()
    start = time.monotonic()
    last: object = None
    changed = start
    known_before = len(_participants(node)) > 1
    while time.monotonic() < start + limit:
        view, nameless = _view(node)
        complete = not nameless and len(_participants(node)) >= _participants_here(domain_id)
        now = time.monotonic()
        if last is None and complete and (known_before or _participants_here(domain_id) == 1):
            return
        if view != last or not complete:
            last, changed = view, now
        elif now - changed >= _QUIET_S:
            return
        time.sleep(_POLL_S)
