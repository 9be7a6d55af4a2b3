"""Find the ROS domains that processes use, by their DDS ports."""

from collections.abc import Collection, Sequence

from workbook.inside.proc import udp_ports_of
from workbook.ros.domains import domain_of_port


def domains_of(pids: Sequence[int]) -> tuple[int, ...]:
    """Return the ROS domains on which these processes have DDS ports open."""
    return domains_of_ports(udp_ports_of(pids))


def domains_of_ports(ports: Collection[int]) -> tuple[int, ...]:
    """Return the ROS domains whose participants listen on these UDP ports.

    A participant listens on two ports. Discovery uses a port with an even offset of at least 10 in its domain's range;
    messages use the next port. A port without such a neighbor is one that a participant sends from, which the system
    chose.
    """
    found = {
        domain_of_port(port)
        for port in ports
        if (port - 7400) % 250 >= 10 and (port - 7400) % 250 % 2 == 0 and port + 1 in ports
    }
    return tuple(sorted(domain_id for domain_id in found if domain_id is not None))
