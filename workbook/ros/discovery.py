"""Wait until DDS discovery is complete, using a hidden, short-lived node that reads a domain's graph."""

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from rclpy.context import Context
from rclpy.node import Node
from rclpy.utilities import get_default_context

from workbook.inside.proc import pids, stat_fields, udp_ports_in_use, udp_ports_of
from workbook.ros.domains import dds_port_range

NODE_UNKNOWN = "_NODE_NAME_UNKNOWN_"
PATIENCE_S = 10.0
"""The longest wait (s) for participants.

Programs announce themselves every 3 s by default, and an announcement may get lost.
"""
_LOOK_EVERY_S = 1.0
"""How often (s) we check, while waiting, whether a process is stopped (Ctrl-Z)."""
_QUIET_S = 0.1
"""Discovery counts as complete when nothing new has appeared for this long (s)."""
_EMPTY_S = 1.0
"""The same time (s) if a participant still hasn't announced nodes, or an endpoint's node. It may not have any."""
_POLL_S = 0.005
_FIRST_PARTICIPANT_PORT = 10
"""Offset of participant 0 within the ports of a domain (DDS-RTPS specification, section 9.6.1)."""


def current_domain() -> int:
    """Return this notebook's domain: the default context's if that context is running, or else the environment's."""
    context = get_default_context()
    return context.get_domain_id() if context.ok() else int(os.environ.get("ROS_DOMAIN_ID") or 0)


@contextmanager
def discovery_node(domain_id: int | None = None) -> Iterator[Node]:
    """Yield a hidden node on `domain_id` (default: the current domain), and destroy it after the block.

    If possible, the node joins this notebook's context, where discovery is already complete.
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
    """Return the GUID prefixes of the domain's discovered participants. Each context of a process is a participant."""
    infos = node.get_publishers_info_by_topic("ros_discovery_info", no_mangle=True)
    return {bytes(info.endpoint_gid[:12]) for info in infos}


def _ports_here(domain_id: int) -> set[int]:
    """Return the even-numbered UDP port of each of this machine's participants on the domain."""
    ports = dds_port_range(domain_id)
    used = udp_ports_in_use() & set(ports)
    return {port for port in used if port - ports.start >= _FIRST_PARTICIPANT_PORT and port % 2 == 0}


def _stopped(ports: set[int]) -> list[int]:
    """Return the IDs of processes that use some of these ports, but can't respond because they're stopped (Ctrl-Z)."""
    if not ports:
        return []
    halted = [pid for pid in pids() if _is_stopped(pid)]
    return [pid for pid in halted if udp_ports_of([pid]) & ports]


def _is_stopped(pid: int) -> bool:
    try:
        return stat_fields(pid)[0] in (b"T", b"t")
    except (OSError, IndexError):
        return False


@dataclass(frozen=True)
class _View:
    """A snapshot of the graph.

    `nameless`: whether an endpoint's node is still unknown. `empty`: the number of participants without endpoints,
    minus the number of nodes without endpoints.
    """

    endpoints: tuple[str, ...]
    nodes: tuple[tuple[str, str], ...]
    participants: int
    nameless: bool
    empty: int

    @property
    def complete(self) -> bool:
        """Whether each discovered participant has announced its nodes."""
        return not self.nameless and self.empty <= 0


def _view(node: Node) -> _View:
    endpoints = []
    for name, _ in node.get_topic_names_and_types():
        endpoints += node.get_publishers_info_by_topic(name)
        endpoints += node.get_subscriptions_info_by_topic(name)
    participants, nodes = _participants(node), node.get_node_names_and_namespaces()
    owners = {(info.node_name, info.node_namespace) for info in endpoints}
    busy = {bytes(info.endpoint_gid[:12]) for info in endpoints}
    return _View(
        tuple(sorted(bytes(info.endpoint_gid).hex() for info in endpoints)),
        tuple(sorted(nodes)),
        len(participants),
        any(name == NODE_UNKNOWN for name, _ in owners),
        len(participants - busy) - len(set(nodes) - owners),
    )


def wait_for_graph(node: Node, limit: float = PATIENCE_S) -> None:
    """Wait until all of this machine's participants are discovered and nothing new appears, at most `limit` s.

    Don't wait for stopped processes (Ctrl-Z). If participants are still missing after the wait, print a warning to
    stderr.
    """
    domain_id = node.context.get_domain_id()
    known_before = len(_participants(node)) > 1
    last, view = None, _view(node)
    began = changed = time.monotonic()
    stopped: list[int] = []
    missing, next_look = _missing(domain_id, view), began + _LOOK_EVERY_S
    if view.complete and missing <= 0 and (known_before or view.participants == 1):
        return
    while (now := time.monotonic()) < began + limit:
        if view != last:
            last, changed = view, now
        quiet_s = _QUIET_S if view.complete else _EMPTY_S
        if missing <= len(stopped) and now - changed >= quiet_s:
            break
        if missing > 0 and now >= next_look:
            stopped, next_look = _stopped(_ports_here(domain_id)), now + _LOOK_EVERY_S
        time.sleep(_POLL_S)
        view = _view(node)
        missing = _missing(domain_id, view)
    if missing > 0:
        print(_warning(domain_id, stopped), file=sys.stderr)


def _missing(domain_id: int, view: _View) -> int:
    return len(_ports_here(domain_id)) - view.participants


def _warning(domain_id: int, stopped: list[int]) -> str:
    if not stopped:
        return f"A program on domain {domain_id} did not answer, so nodes may be missing."
    held = ", ".join(map(str, stopped))
    return f"A program on domain {domain_id} is stopped, so its nodes may be missing (process {held})."
