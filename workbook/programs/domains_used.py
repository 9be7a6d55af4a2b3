"""Determine from processes' open DDS ports which ROS domains they use."""

from collections.abc import Collection, Sequence

from workbook.inside.proc import udp_ports_of
from workbook.ros.domains import domain_of_port


def domains_of(pids: Sequence[int]) -> tuple[int, ...]:
    """Return the ROS domains on which these processes have DDS ports open."""
    return domains_of_ports(udp_ports_of(pids))


def domains_of_ports(ports: Collection[int]) -> tuple[int, ...]:
    """Return the ROS domains whose DDS participants listen on these UDP ports.

    A participant listens on two neighboring ports. The first port is for discovery: its offset within its domain's port
    range is even and at least 10. The next port is for messages. A port without such a neighbor doesn't count, because
    the system chose it for sending.
    """
    found = {
        domain_of_port(port)
        for port in ports
        if (port - 7400) % 250 >= 10 and (port - 7400) % 250 % 2 == 0 and port + 1 in ports
    }
    return tuple(sorted(domain_id for domain_id in found if domain_id is not None))
